// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/cutter_compensation_c/cutter_compensation_c.h"

#include <cmath>

#include "fast/geometry/angle.h"

namespace toolcomp::fast {
namespace {

Amount amount_of(const Count& offset) {
  const Count amount = offset < Count() ? -offset : offset;
  return {amount, amount.nearest()};
}

// Of I J.
Heading heading_of(const CutterBlock& block) {
  const std::array<Count, 2>& way = block.direction;
  const bool small = way[0].is_small() && way[1].is_small();
  return small ? whole_heading({way[0].small(), way[1].small()}) : whole_heading({way[0].units(), way[1].units()});
}

}  // namespace

CutterCompensationC::CutterCompensationC(const spec::Setup& setup, EventSink& sink)
    : CornerQueue(sink, CutterParameters(setup).still_limit + 2, 4), parameters_(setup), make_(parameters_) {}

Alarm CutterCompensationC::check(const CutterCommand& command) const {
  const CutterSide side = command.word == CutterSide::unchanged ? side_ : command.word;
  const bool asked = side != CutterSide::off && command.d != 0;
  if (command.corner_arc) {
    const bool has_vector = mode_ == Mode::on && !fresh_;
    const bool renumbers = command.d_word && command.d != number_;
    if (!has_vector || !asked || renumbers || command.word != CutterSide::unchanged || command.axis_word ||
        (command.letters && command.letters_zero))
      return AlarmCause::corner_arc;
  }
  return command.arc ? check_arc(command.word, command.d) : AlarmCause::none;
}

void CutterCompensationC::rebase() {
  if (count_ == 0) return;
  const Event& before = held(count_ - 1U).event;
  Event& now = next().event;
  now.programmed.present = before.programmed.present;
  now.point.present = before.point.present;
  now.axes.present = before.axes.present;
  now.machine.present = 0;
  set_corner_move(now);
  move_is_set_ = true;
}

void CutterCompensationC::set_flat(PlanePath& flat, const CutterBlock& block) {
  if (is_arc(block))
    set_arc_path(flat, block);
  else
    set_line(flat, block.start, block.end);
}

[[gnu::always_inline]] inline void CutterCompensationC::set_path(CutterPath& to, const CutterBlock& block) {
  if (!block.path_made) set_flat(to.flat, block);
  const Count& offset = block.offset;
  if (!(offset == value_)) {
    value_ = offset;
    amount_ = amount_of(offset);
  }
  to.side = side_of(block);
  to.offset = amount_;
}

void CutterCompensationC::set_normal(CutterGroup& group, const PlanePath& path, const Heading& heading, int side,
                                     const Amount& offset) const {
  group.corner = {&path, nullptr, &heading, &heading, side, side, &offset, {}};
  group.clear();
  if (offset.nearest != 0) make_.set(group, HeadKind::first_normal);
}

[[gnu::always_inline]] inline void CutterCompensationC::set_corner(CutterGroup& group, const CutterPath* second,
                                                                   CornerRule rule) const {
  Corner& corner = group.corner;
  corner.first = &last_->flat;
  corner.last = &last_->flat.end();
  corner.first_side = last_->side;
  corner.offset = &last_->offset;
  if (second == nullptr) {
    corner.second = nullptr;
    corner.next = corner.last;
    corner.second_side = last_->side;
    corner.turn = {};
    return;
  }
  const bool by_direction = rule == CornerRule::direction;
  corner.second = by_direction ? nullptr : &second->flat;
  corner.next = by_direction ? &second->direction : &second->flat.start;
  corner.second_side = second->side;
  corner.turn = turn(*corner.last, *corner.next);
}

StageEnd CutterCompensationC::block() {
  CutterBlock& block = next();
  before_ = side_;
  side_ = block.side;
  number_ = block.d;
  axis_ = block.axis;
  if (mode_ == Mode::on && (block.motion == CutterMotion::line || block.motion == CutterMotion::arc) && wanted(block))
      [[likely]]
    return next_block(block);
  if (mode_ == Mode::ends && wanted(block)) return undecide(block, "fanuc.cutter-c.restart-before-removal");
  switch (block.motion) {
    case CutterMotion::line:
    case CutterMotion::arc:
      return moving_block(block);
    case CutterMotion::still:
    case CutterMotion::zero:
      return still_block(block);
    case CutterMotion::corner_arc:
      return corner_arc(block);
    case CutterMotion::to_machine:
    case CutterMotion::from_intermediate:
      return leave_path(block);
    case CutterMotion::to_intermediate:
      return to_intermediate(block);
    case CutterMotion::to_reference:
    case CutterMotion::from_reference:
      if (clears_) take_vector_away();
      clears_ = false;
      send_in_force(block);
      return {};
    case CutterMotion::shift:
      return block.named != 0 && mode_ != Mode::off ? shift_in_plane(block) : still_block(block);
  }
  return {};
}

StageEnd CutterCompensationC::moving_block(CutterBlock& block) {
  const bool asked = wanted(block);
  if (mode_ == Mode::starts && !asked)
    if (const StageEnd end = release()) return end;
  switch (mode_) {
    case Mode::off:
      if (asked)
        first_block(block);
      else
        pass(block);
      return {};
    case Mode::starts:
      return second_block(block, new_path());
    case Mode::on:
    case Mode::ends:
      return cancel_block(block);
  }
  return {};
}

[[gnu::always_inline]] inline StageEnd CutterCompensationC::next_block(CutterBlock& block) {
  CutterPath& to = block.path_made ? paths_[path_] : new_path();
  set_path(to, block);
  if (const Alarm a = check_path(to, held_ == Held::path)) return refuse(block, a);
  if (const Alarm a = end_held(to, rule_before(block))) return at_fault(a);
  start_side_ = to.side;
  start_offset_ = &last_->offset;
  hold_path(to, false);
  return {};
}

// The first one that moves behind a lone G41 or G42, whose vector is perpendicular to its start.
StageEnd CutterCompensationC::second_block(CutterBlock& block, CutterPath& to) {
  set_path(to, block);
  if (to.flat.arc && to.flat.ends_in_center) return refuse(block, AlarmCause::arc_ends_in_center);
  if (to.side != start_side_) return refuse(block, AlarmCause::side_change_at_start);
  set_normal(at_start(), to.flat, to.flat.start, start_side_, start_amount_);
  send_start();
  start_offset_ = &start_amount_;
  hold_path(to, false);
  return {};
}

[[gnu::always_inline]] inline void CutterCompensationC::hold_path(const CutterPath& to, bool starts_up) {
  checked_ = !starts_up && !fresh_ && !parameters_.no_interference;
  fresh_ = false;
  after_start_ = starts_up;
  CornerQueue::hold_path(to, starts_up);
}

// From the last head of the corner before it straight to its end, without a vector.
StageEnd CutterCompensationC::cancel_block(CutterBlock& block) {
  CutterPath& to = new_path();
  set_flat(to.flat, block);
  to.side = last_->side;
  CornerRule rule = CornerRule::cancel;
  if (repeated_ || repeats(block)) {
    rule = CornerRule::repeated;
  } else if (block.word == CutterSide::off && block.has_direction &&
             !(block.direction[0].is_zero() && block.direction[1].is_zero())) {
    to.direction = heading_of(block);
    rule = CornerRule::direction;
  }
  if (const Alarm a = end_held(to, rule)) return at_fault(a);
  pass_corner(block);
  remove_vector(block, true);
  return {};
}

[[gnu::always_inline]] inline Alarm CutterCompensationC::end_held(const CutterPath& to, CornerRule rule) {
  if (held_ == Held::path) [[likely]]
    return join(to, rule);
  if (held_ == Held::corner_arc) {
    send_corner_arc(held(0), to.flat.start);
    free_first();
    held_ = Held::nothing;
    send_held(at_start().front().vector);
  }
  return AlarmCause::none;
}

StageEnd CutterCompensationC::release() {
  if (held_ == Held::path) return release_paths();
  // No next block: no vector is made by a lone G41 or G42, and no arc by G39, but what else their blocks change.
  if (held_ == Held::start) mode_ = Mode::off;
  held_ = Held::nothing;
  send_held(at_start().front().vector);
  return {};
}

StageEnd CutterCompensationC::still_block(CutterBlock& block) {
  const bool asked = wanted(block);
  const unsigned limit = parameters_.still_limit;
  const unsigned weight = block.motion == CutterMotion::zero ? limit : 1;
  if (mode_ == Mode::ends && block.motion == CutterMotion::zero) {
    remove_vector(block, block.own);
    return {};
  }
  if (mode_ == Mode::on) {
    if (!asked) {
      if (const StageEnd end = release()) return end;
      cancel_alone(block, parameters_.acts_alone);
      return {};
    }
    if (held_ == Held::corner_arc && still_ + weight >= limit) {
      StageEnd end = end_at(held(0).event, AlarmCause::none);
      end.undecided = "fanuc.cutter-c.corner-arc-without-next-block";
      return end;
    }
    return CornerQueue::still_block(block, weight, limit);
  }
  if (mode_ == Mode::starts) {
    still_ = static_cast<std::uint8_t>(still_ + weight);
    if (asked && still_ < limit) {
      hold();
      return {};
    }
    if (const StageEnd end = release()) return end;
  }
  const bool starts = mode_ == Mode::off && parameters_.acts_alone && asked && is_code(block);
  if (!starts) {
    send_in_force(block);
    return {};
  }
  mode_ = Mode::starts;
  fresh_ = false;
  held_ = Held::start;
  start_side_ = side_of(block);
  start_amount_ = amount_of(block.offset);
  still_ = 0;
  hold();
  return {};
}

// G52 or G92 of the plane: the vector goes for a time, and the block before ends without it.
StageEnd CutterCompensationC::shift_in_plane(CutterBlock& block) {
  if (held_ == Held::path) {
    release_path_without_vector();
  } else {
    if (const StageEnd end = release()) return end;
    if (mode_ == Mode::off) return still_block(block);
    if (!vector_is_zero()) return undecide(block, "fanuc.cutter-c.coordinate-shift-with-vector");
  }
  take_vector_away();
  return still_block(block);
}

StageEnd CutterCompensationC::corner_arc(CutterBlock& block) {
  if (mode_ != Mode::on) {
    send_in_force(block);
    return {};
  }
  if (const StageEnd end = release()) return end;
  if (block.has_direction) {
    direction_ ^= 1U;
    directions_[direction_] = heading_of(block);
    send_corner_arc(block, directions_[direction_]);
    return {};
  }
  held_ = Held::corner_arc;
  still_ = 0;
  hold();
  return {};
}

void CutterCompensationC::send_corner_arc(CutterBlock& block, const Heading& heading) {
  if (last_->offset.nearest == 0) {
    send_in_force(block);
    return;
  }
  // The vector in force is perpendicular to a heading.
  const Turn turned = turn(*at_start().corner.last, heading);
  set_normal(at_start(), last_->flat, heading, last_->side, last_->offset);
  if (turned.c == 0 && turned.k > 0) {
    send_in_force(block);
    return;
  }
  Event& event = block.event;
  event.type = spec::MoveType::arc;
  event.cause = spec::Cause::corner;
  event.feed = block.feed;  // also under G00
  spec::Arc<double>& arc = event.arc.emplace();
  arc.plane = block.plane;
  const bool clockwise = last_->side > 0;
  arc.direction = clockwise ? spec::ArcDirection::cw : spec::ArcDirection::ccw;
  for (const std::size_t axis : block.axis)
    if (axis != spec::Axes::kNone) arc.center.set(axis, event.point.value[axis]);
  if (turned.c == 0) {
    arc.sweep = 180;
  } else {
    const double angle = polar_angle(turned.k, clockwise ? -turned.c : turned.c);
    arc.sweep = angle < 0 ? angle + 360 : angle;
  }
  send(block, at_start().front().vector, true);
}

// G53, and the first move of G29 (clauses fanuc.cutter-c.machine-position, outside-axes-only).
StageEnd CutterCompensationC::leave_path(CutterBlock& block) {
  if (const StageEnd end = release()) return end;
  if (mode_ == Mode::off) {
    send_in_force(block);
    return {};
  }
  const bool ends = mode_ == Mode::ends || !wanted(block);
  if (block.named == 0) {
    if (ends && mode_ == Mode::on)
      cancel_alone(block, parameters_.acts_alone);
    else
      send_in_force(block);
    return {};
  }
  if (ends || !parameters_.keeps_mode) {
    at_start().clear();
    mode_ = Mode::off;
  } else {
    take_vector_away();
  }
  send_in_force(block);
  return {};
}

// The first move of G28 and G30. With CCN = 1 it is a line of the offset mode, and the vector goes on the second one.
StageEnd CutterCompensationC::to_intermediate(CutterBlock& block) {
  const bool stays = mode_ == Mode::on && wanted(block) && parameters_.keeps_mode && block.named != 0;
  if (!stays) return leave_path(block);
  clears_ = true;
  if (block.start[0] == block.end[0] && block.start[1] == block.end[1]) {
    if (const StageEnd end = release()) return end;
    send_in_force(block);
    return {};
  }
  if (const StageEnd end = next_block(block)) return end;
  checked_ = false;
  return release();
}

void CutterCompensationC::take_vector_away() {
  at_start().clear();
  fresh_ = true;
  after_start_ = false;
}

void CutterCompensationC::send_setting(const CutterBlock& block) {
  notice_.kind = spec::EventKind::setting;
  notice_.line = block.event.line;
  notice_.n = block.event.n;
  notice_.setting = block.setting;
  notice_.value = block.setting_value;
  sink_->on(notice_);
}

}  // namespace toolcomp::fast

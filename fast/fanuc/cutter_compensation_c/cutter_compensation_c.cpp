#include "fast/fanuc/cutter_compensation_c/cutter_compensation_c.h"

#include <cmath>

#include "fast/basis/fault.h"
#include "fast/geometry/angle.h"

namespace toolcomp::fast {
namespace {

Amount amount_of(const Count& offset) {
  const Count amount = offset < Count() ? -offset : offset;
  return {amount, amount.nearest()};
}

// A block that makes or removes a vector moves in the coordinates after its G92.
void rename(CutterBlock& block) {
  if (block.motion == CutterMotion::shift) block.event = block.renamed;
}

}  // namespace

CutterCompensationC::CutterCompensationC(const spec::Setup& setup, EventSink& sink)
    : sink_(sink), parameters_(setup), make_(parameters_), axes_(setup.axes.size()) {}

Alarm CutterCompensationC::check(const CutterCommand& command) const {
  const CutterSide side = command.word == CutterSide::unchanged ? side_ : command.word;
  const bool asked = side != CutterSide::off && command.d != 0;
  if (command.corner_arc) {
    const bool has_vector = mode_ == Mode::on && !fresh_;
    const bool renumbers = command.d_word && command.d != number_;
    if (!has_vector || !asked || renumbers || command.word != CutterSide::unchanged || command.axis_word ||
        (command.letters && command.letters_zero))
      return alarm::kCornerArc;
  }
  return command.arc ? check_arc(command.word, command.d) : alarm::kNone;
}

void CutterCompensationC::keep_position(Position& position, const Event& event) const {
  for (std::size_t axis = 0; axis < axes_; ++axis) {
    position.programmed[axis] = event.programmed.value[axis];
    position.point[axis] = event.point.value[axis];
    position.axes[axis] = event.axes.value[axis];
  }
  position.tool_axis = event.tool_axis;
}

void CutterCompensationC::rebase() {
  keep_position(corners_[1U - group_], next().event);
  rebased_ = true;
}

bool CutterCompensationC::make_arc_path(const CutterBlock& block) {
  if (mode_ != Mode::on || !wanted(block)) return false;
  set_arc_path(new_path().path, block);
  return true;
}

void CutterCompensationC::set_path(CompensatedPath& to, const CutterBlock& block) {
  if (block.motion == CutterMotion::arc)
    set_arc_path(to.path, block);
  else
    set_line(to.path, block.start, block.end);
}

[[gnu::always_inline]] inline void CutterCompensationC::set_offset(CompensatedPath& to, const CutterBlock& block) {
  const bool late = fault(Fault::c_offset_one_corner_late) && mode_ == Mode::on;
  const Count& offset = late ? late_offset_ : block.offset;
  if (!(offset == value_)) {
    value_ = offset;
    amount_ = amount_of(offset);
  }
  to.side = side_of(block);
  to.offset = amount_;
  if (fault(Fault::c_offset_one_corner_late)) late_offset_ = block.offset;
}

// The offset to the left of a heading, or to its right.
void CutterCompensationC::set_normal(CutterGroup& group, const PlanePath& path, const Heading& heading, int side,
                                     const Amount& offset) const {
  Corner& corner = group.corner;
  corner.first = &path;
  corner.second = nullptr;
  corner.last = &heading;
  corner.next = &heading;
  corner.first_side = side;
  corner.second_side = side;
  corner.turn = {};
  corner.offset = &offset;
  group.cleared = 0;
  if (offset.nearest == 0)
    group.clear();
  else
    make_.set(group, HeadKind::first_normal);
}

StageEnd CutterCompensationC::block() {
  CutterBlock& block = next();
  before_ = side_;
  side_ = block.side;
  number_ = block.d;
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
      if (clears_ != 0) clear_components(clears_);
      clears_ = 0;
      send(block);
      return {};
    case CutterMotion::shift: {
      // A lone G41 or G42 makes no vector where its mode ends in this very block.
      const bool on = mode_ == Mode::waits_for_block ? wanted(block) : mode_ != Mode::off;
      if (on && block.named != 0) return undecide(block, "fanuc.cutter-c.coordinate-shift");
      return still_block(block);
    }
  }
  return {};
}

StageEnd CutterCompensationC::moving_block(CutterBlock& block) {
  const bool asked = wanted(block);
  if (mode_ == Mode::waits_for_block && !asked)
    if (const StageEnd end = release()) return end;
  switch (mode_) {
    case Mode::off:
      if (asked) return first_block(block);
      if (block.motion == CutterMotion::arc) {
        PlanePath& path = paths_[0].path;  // no corner refers to any
        set_arc_path(path, block);
        set_center(block, path);
        set_programmed_arc(*block.event.arc, path);
      }
      send(block);
      return {};
    case Mode::waits_for_block:
      return next_block(block);
    case Mode::on:
      return asked ? next_block(block) : cancel_block(block);
    case Mode::ends:
      return cancel_block(block);
  }
  return {};
}

// The start-up block: straight from where it starts, without a vector, to the first head at its end.
StageEnd CutterCompensationC::first_block(CutterBlock& block) {
  CompensatedPath& to = new_path();
  set_path(to, block);
  set_offset(to, block);
  at_start().clear();
  mode_ = Mode::on;
  fresh_ = false;
  checked_ = false;
  after_start_ = true;
  block.event.cause = spec::Cause::start_up;
  hold_path(to, true);
  return {};
}

StageEnd CutterCompensationC::next_block(CutterBlock& block) {
  CompensatedPath& to = block.path_made ? paths_[path_] : new_path();
  if (!block.path_made) set_path(to, block);
  return follow(block, to);
}

StageEnd CutterCompensationC::follow(CutterBlock& block, CompensatedPath& to) {
  if (to.path.arc && to.path.ends_in_center) return refuse(block, alarm::kArcCenter);
  set_offset(to, block);
  if (mode_ == Mode::waits_for_block) {
    if (to.side != waiting_side_) return refuse(block, alarm::kDirectionChangeAtStart);
    finish_start(to);
    at_start() = vector_;
    start_side_ = waiting_side_;
    start_offset_ = &waiting_offset_;
    mode_ = Mode::on;
  } else {
    if (after_start_ && to.side != last_->side) return refuse(block, alarm::kDirectionChangeAtStart);
    repeated_ |= block.word != CutterSide::unchanged && block.word == before_;
    const bool repeated = repeated_ && !fault(Fault::c_repeated_ignored);
    const CornerRule rule =
        repeated ? CornerRule::repeated : (starts_up_ ? CornerRule::start_up : CornerRule::ordinary);
    if (const Alarm a = join(to, to.path.start, rule)) return at_fault(a);
    start_side_ = to.side;
    start_offset_ = &last_->offset;
  }
  checked_ = !fresh_;
  fresh_ = false;
  after_start_ = false;
  hold_path(to, false);
  return {};
}

void CutterCompensationC::hold_path(const CompensatedPath& to, bool starts_up) {
  last_ = &to;
  starts_up_ = starts_up;
  plain_ = !starts_up && checked_ && !parameters_.no_interference && at_start().size == 1 && !to.path.arc &&
           to.path.start.narrow && amount_.nearest != 0;
  hold();
  held_ = Held::path;
  still_ = 0;
  repeated_ = false;
}

// From the last head of the corner before it straight to its end, without a vector.
StageEnd CutterCompensationC::cancel_block(CutterBlock& block) {
  CompensatedPath& to = new_path();
  set_path(to, block);
  if (last_ != nullptr) to.side = last_->side;
  CornerRule rule = CornerRule::cancel;
  const Heading* heading = &to.path.start;
  const bool code = block.word == CutterSide::left || block.word == CutterSide::right;
  if (repeated_ || (code && block.word == before_)) {
    rule = CornerRule::repeated;
  } else if (block.word == CutterSide::off && block.has_direction &&
             !(block.direction[0].is_zero() && block.direction[1].is_zero())) {
    const bool small = block.direction[0].is_small() && block.direction[1].is_small();
    to.direction = small ? whole_heading({block.direction[0].small(), block.direction[1].small()})
                         : whole_heading({block.direction[0].units(), block.direction[1].units()});
    rule = CornerRule::direction;
    heading = &to.direction;
  }
  if (const Alarm a = join(to, *heading, rule)) return at_fault(a);
  send_corner_moves(block);
  block.event.cause = spec::Cause::cancel;
  vector_.clear();
  mode_ = Mode::off;
  send(block);
  return {};
}

[[gnu::always_inline]] inline Alarm CutterCompensationC::join(const CompensatedPath& to, const Heading& heading,
                                                              CornerRule rule) {
  switch (held_) {
    case Held::nothing:
    case Held::start:
      at_start() = vector_;
      return alarm::kNone;
    case Held::corner_arc:
      send_corner_arc(ring_[first_], to.path.start);
      send_behind(vector_.front().vector);
      at_start() = vector_;
      return alarm::kNone;
    case Held::path:
      break;
  }
  CutterGroup& group = at_end();
  Corner& corner = group.corner;
  corner.first = &last_->path;
  corner.second = rule == CornerRule::direction ? nullptr : &to.path;
  corner.last = &last_->path.end();
  corner.next = &heading;
  corner.first_side = last_->side;
  corner.second_side = to.side;
  corner.offset = &last_->offset;
  corner.turn = turn(*corner.last, *corner.next);
  group.cleared = 0;
  if (!make_.make(group, rule)) return alarm::kNoIntersection;
  if (group.size > 1) {
    // The block held last is the one before, and its event has no vector yet.
    const Event& before = ring_[(first_ + held_count_ - 1U) % ring_.size()].event;
    Position& position = corners_[1U - group_];
    if (!rebased_) keep_position(position, before);
  }
  if (const Alarm a = finish()) return a;
  group_ ^= 1U;
  return alarm::kNone;
}

[[gnu::always_inline]] inline Alarm CutterCompensationC::finish() {
  CutterBlock& block = ring_[first_];
  const PlanePath& path = last_->path;
  const CheckedBlock checked{&path, start_side_, start_offset_, last_->side, &last_->offset};
  std::optional<double> sweep;
  if (path.arc) {
    set_center(block, path);
    set_tool_arc(*block.event.arc, path, at_start().back().vector, at_end().front().vector,
                 compare_radii(checked, at_start(), at_end()));
    sweep = block.event.arc->sweep;
  }
  if (checked_ && !parameters_.no_interference) {
    switch (check_interference(checked, sweep, at_start(), at_end())) {
      case Interference::none:
        break;
      case Interference::straightened:
        block.event.type = spec::MoveType::linear;
        block.event.arc.reset();
        break;
      case Interference::alarm:
        return alarm::kInterference;
    }
  }
  send_corner_moves(block);
  const Vector2<double>& vector = at_end().front().vector;
  send(block, vector, true);
  send_behind(vector);
  return alarm::kNone;
}

StageEnd CutterCompensationC::release() {
  switch (held_) {
    case Held::nothing:
      return {};
    case Held::path:
      set_normal(at_end(), last_->path, last_->path.end(), last_->side, last_->offset);
      along_ = &last_->path.end();
      vector_ = at_end();  // one vector: the check has none to drop
      if (const Alarm a = finish()) return at_fault(a);
      return {};
    case Held::corner_arc: {
      // No next block: no arc, but what else the block changes.
      CutterBlock& block = ring_[first_];
      send(block);
      send_behind(vector_.front().vector);
      return {};
    }
    case Held::start:
      // No next block: no vector is made.
      mode_ = Mode::off;
      send(ring_[first_]);
      send_behind(vector_.front().vector);
      return {};
  }
  return {};
}

StageEnd CutterCompensationC::still_block(CutterBlock& block) {
  const bool asked = wanted(block);
  const std::uint8_t limit = fault(Fault::c_two_still_as_one) ? 3 : 2;
  const bool code = block.word == CutterSide::left || block.word == CutterSide::right;
  if (mode_ != Mode::off) {
    const int still = still_ + (block.motion == CutterMotion::zero ? 2 : 1);
    still_ = static_cast<std::uint8_t>(still > limit ? limit : still);
  }
  if (mode_ == Mode::waits_for_block && (!asked || still_ >= limit))
    if (const StageEnd end = release()) return end;
  switch (mode_) {
    case Mode::off:
      if (!(parameters_.acts_alone && code && asked)) break;
      mode_ = Mode::waits_for_block;
      fresh_ = false;
      held_ = Held::start;
      waiting_side_ = side_of(block);
      waiting_offset_ = amount_of(block.offset);
      still_ = 0;
      hold();
      return {};
    case Mode::waits_for_block:
      hold();
      return {};
    case Mode::on:
      if (!asked) {
        if (const StageEnd end = release()) return end;
        cancel_alone(block);
        return {};
      }
      repeated_ |= code && block.word == before_;
      if (held_ == Held::corner_arc && still_ >= limit) {
        StageEnd end;
        end.undecided = "fanuc.cutter-c.corner-arc-without-next-block";
        end.line = ring_[first_].event.line;
        end.n = ring_[first_].event.n;
        return end;
      }
      if (held_ == Held::nothing) break;
      hold();
      return still_ >= limit ? release() : StageEnd{};
    case Mode::ends:
      break;
  }
  send(block);
  return {};
}

void CutterCompensationC::cancel_alone(CutterBlock& block) {
  const bool zero = vector_is_zero();
  if (parameters_.acts_alone) {
    if (!zero) rename(block);
    block.event.cause = spec::Cause::cancel;
    vector_.clear();
    mode_ = Mode::off;
    send(block, vector_.front().vector, block.own || !zero);
    return;
  }
  mode_ = zero ? Mode::off : Mode::ends;
  send(block);
}

StageEnd CutterCompensationC::corner_arc(CutterBlock& block) {
  if (mode_ != Mode::on) {
    send(block);
    return {};
  }
  if (const StageEnd end = release()) return end;
  if (block.has_direction) {
    direction_ ^= 1U;
    const bool small = block.direction[0].is_small() && block.direction[1].is_small();
    directions_[direction_] = small ? whole_heading({block.direction[0].small(), block.direction[1].small()})
                                    : whole_heading({block.direction[0].units(), block.direction[1].units()});
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
    send(block);
    return;
  }
  const Turn turned = turn(*along_, heading);
  along_ = &heading;
  set_normal(vector_, last_->path, heading, last_->side, last_->offset);
  if (turned.c == 0 && turned.k > 0) {
    send(block);
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
  send(block, vector_.front().vector, true);
}

void CutterCompensationC::finish_start(const CompensatedPath& to) {
  set_normal(vector_, to.path, to.path.start, waiting_side_, waiting_offset_);
  along_ = &to.path.start;
  CutterBlock& block = ring_[first_];
  if (!vector_is_zero()) rename(block);
  block.event.cause = spec::Cause::start_up;
  send(block, vector_.front().vector, block.own || !vector_is_zero());
  send_behind(vector_.front().vector);
}

// G53, and the first move of G29 (clauses fanuc.cutter-c.machine-position, outside-axes-only).
StageEnd CutterCompensationC::leave_path(CutterBlock& block) {
  if (const StageEnd end = release()) return end;
  if (mode_ == Mode::off) {
    send(block);
    return {};
  }
  const bool ends = mode_ == Mode::ends || !wanted(block);
  if (block.named == 0) {
    if (ends && mode_ == Mode::on)
      cancel_alone(block);
    else
      send(block);
    return {};
  }
  if (ends || !parameters_.keeps_mode) {
    vector_.clear();
    mode_ = Mode::off;
  } else {
    clear_components(block.named);
  }
  send(block);
  return {};
}

// The first move of G28 and G30. With CCN = 1 it is a line of the offset mode, and the vector goes on the second one.
StageEnd CutterCompensationC::to_intermediate(CutterBlock& block) {
  const bool stays = mode_ == Mode::on && wanted(block) && parameters_.keeps_mode && block.named != 0;
  if (!stays) return leave_path(block);
  clears_ = block.named;
  if (block.start[0] == block.end[0] && block.start[1] == block.end[1]) {
    if (const StageEnd end = release()) return end;
    send(block);
    return {};
  }
  if (const StageEnd end = next_block(block)) return end;
  checked_ = false;
  return release();
}

void CutterCompensationC::clear_components(std::uint8_t components) {
  vector_.cleared = static_cast<std::uint8_t>(vector_.cleared | components);
  Vector2<double>& vector = vector_.head[0].vector;
  if ((vector_.cleared & 1U) != 0) vector.x = 0;
  if ((vector_.cleared & 2U) != 0) vector.y = 0;
  fresh_ = true;
  after_start_ = false;
}

bool CutterCompensationC::vector_is_zero() const {
  const Vector2<double>& vector = vector_.front().vector;
  return vector.x == 0 && vector.y == 0;
}

// The blocks before are given as if this block were absent.
StageEnd CutterCompensationC::refuse(const CutterBlock& block, const Alarm& alarm) {
  if (const StageEnd end = release()) return end;
  return end_at(block.event, alarm);
}

StageEnd CutterCompensationC::undecide(const CutterBlock& block, const char* clause) {
  StageEnd end = refuse(block, alarm::kNone);
  if (!end.alarm) end.undecided = clause;
  return end;
}

StageEnd CutterCompensationC::at_fault(const Alarm& alarm) const { return end_at(ring_[first_].event, alarm); }

void CutterCompensationC::send_setting(const CutterBlock& block) {
  notice_.kind = spec::EventKind::setting;
  notice_.line = block.event.line;
  notice_.n = block.event.n;
  notice_.setting = block.setting;
  notice_.value = block.setting_value;
  sink_.on(notice_);
}

// The other axes stay where the block before ended.
void CutterCompensationC::send_corner_moves(const CutterBlock& block) {
  const CutterGroup& group = at_start();
  if (group.size < 2) return;
  const Position& before = corners_[group_];
  const Event& event = block.event;
  corner_move_.line = event.line;
  corner_move_.n = event.n;
  corner_move_.type = event.type == spec::MoveType::rapid ? spec::MoveType::rapid : spec::MoveType::linear;
  corner_move_.cause = spec::Cause::corner;
  corner_move_.feed = event.feed;
  corner_move_.tool_axis = before.tool_axis;
  corner_move_.programmed.present = event.programmed.present;
  corner_move_.point.present = event.point.present;
  corner_move_.axes.present = event.axes.present;
  for (std::size_t i = 1; i < group.size; ++i) {
    for (std::size_t axis = 0; axis < axes_; ++axis) {
      corner_move_.programmed.value[axis] = before.programmed[axis];
      corner_move_.point.value[axis] = before.point[axis];
      corner_move_.axes.value[axis] = before.axes[axis];
    }
    add(corner_move_, block, group.head[i].vector);
    sink_.on(corner_move_);
  }
}

}  // namespace toolcomp::fast

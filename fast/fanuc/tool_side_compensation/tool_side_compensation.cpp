// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_side_compensation/tool_side_compensation.h"

#include <algorithm>

namespace toolcomp::fast {
namespace {

// A corner move in the coordinates of the block that it belongs to, which starts at `place`.
void rename_corner(Event& move, const Event& place) {
  move.programmed.value = place.programmed.value;
  move.point.value = place.point.value;
  move.axes.value = place.axes.value;
  if (move.tool_axis) move.tool_axis = place.tool_axis;
}

}  // namespace

ToolSideCompensation::ToolSideCompensation(const spec::Setup& setup, const Kinematics& kinematics, EventSink& sink)
    : CornerQueue(sink, 2 * SideParameters(setup).still_limit + 1, SideParameters(setup).still_limit + 2),
      parameters_(setup),
      geometry_(kinematics),
      make_(geometry_, parameters_),
      xyz_{setup.axes.index('X'), setup.axes.index('Y'), setup.axes.index('Z')},
      shortest_(parameters_.no_movement.nearest * static_cast<double>(Count::kSmallPerOne) * (1 + 0x1p-40)),
      xyz_first_(xyz_ == std::array<std::size_t, 3>{0, 1, 2}) {}

[[gnu::always_inline]] inline void ToolSideCompensation::set_path(SidePath& to, const ToolSideBlock& block) {
  to.arc = block.arc;
  if (block.arc) {
    set_arc_path(to.flat, block);
    to.in = block.in;
    to.normal = 3 - block.in[0] - block.in[1];
  }
  to.tool = &kept_tool(block);
  to.side = block.side;
  to.offset = value_;
  to.offset_change = value_change_;
}

[[gnu::always_inline]] inline const Direction& ToolSideCompensation::kept_tool(const ToolSideBlock& block) {
  if (block.tool_number != kept_number_) {
    keep_tool(*block.tool);
    kept_number_ = block.tool_number;
  }
  return *kept_;
}

const Direction& ToolSideCompensation::keep_tool(const Direction& tool) {
  kept_ = kept_ == &tools_[path_count_ - 1U] ? tools_.data() : kept_ + 1;
  *kept_ = tool;
  return *kept_;
}

[[gnu::always_inline]] inline bool ToolSideCompensation::moves(const SeenLine& line, const ToolPlane& plane) const {
  return plane.moves(line, parameters_.no_movement);
}

[[gnu::always_inline]] inline bool ToolSideCompensation::next_moves() {
  if (next().arc) return true;
  SidePath& path = next_path();
  const ToolPlane plane = geometry_.plane(*next().tool);
  path.seen = plane.see(path.travel);
  return moves({path.travel, path.seen}, plane);
}

bool ToolSideCompensation::moves_in_plane_of(bool arc, const Travel& travel, const Direction& tool) const {
  if (arc) return true;
  const ToolPlane plane = geometry_.plane(tool);
  return moves({travel, plane.see(travel)}, plane);
}

bool ToolSideCompensation::on_edge(const ToolSideBlock& block, const Direction& tool) const {
  return geometry_.plane(tool).facing(3 - block.in[0] - block.in[1]) == 0;
}

bool ToolSideCompensation::mismatches(const ToolSideBlock& block) const {
  const std::size_t normal = 3 - block.in[0] - block.in[1];
  return !geometry_.plane(*block.tool_before).along(normal) || !geometry_.plane(*block.tool).along(normal);
}

StageEnd ToolSideCompensation::block() {
  ToolSideBlock& block = next();
  if (mode_ == Mode::starts) return second_block(block);
  if (mode_ == Mode::ends && block.wanted) return undecide(block, "fanuc.cutter-c.restart-before-removal");
  keep_without_direction();
  if (mode_ == Mode::off && !block.wanted) {
    // G40 before anything has moved.
    pass(block);
    return {};
  }
  if (mode_ == Mode::off && parameters_.type == StartType::c) {
    // Compensation comes into force: the block has no move.
    mode_ = Mode::starts;
    held_ = Held::start;
    still_ = 0;
    repeated_ = false;
    start_tool_ = *block.tool;
    start_offset_ = value_;
    start_of_path_ = {&start_tool_, block.side, &start_offset_};
    hold();
    return {};
  }
  if (mode_ == Mode::on) return block.wanted ? next_block(block) : cancel_block(block);
  if (!next_moves()) {
    send_in_force(block);
    return {};
  }
  if (mode_ == Mode::ends) return cancel_block(block);
  first_block(block);
  moves_at_end_ = true;
  return {};
}

// The block right after a start of type C.
StageEnd ToolSideCompensation::second_block(ToolSideBlock& block) {
  const int side = block.side;
  const bool moves_at_end = next_moves();
  if (!block.wanted || !next_moves_at(start_tool_) || side != start_of_path_.side ||
      (block.arc && (on_edge(block, start_tool_) || on_edge(block, *block.tool))))
    return release();
  SidePath& to = new_path();
  set_path(to, block);
  if (block.arc && to.flat.ends_in_center) return release();
  SideGroup& group = at_start();
  SideCorner& corner = group.corner;
  corner.first = &to;
  corner.second = &to;
  corner.tool = &start_tool_;
  corner.first_side = corner.second_side = side;
  corner.offset = &start_offset_;
  if (start_offset_.nearest == 0) {
    group.clear();
  } else {
    (void)geometry_.set_turn(corner);
    make_.set(group, HeadKind::second_normal);
  }
  send_start();
  moves_at_end_ = moves_at_end;
  hold_path(to, false);
  return {};
}

[[gnu::always_inline]] inline ToolSideCompensation::Moves ToolSideCompensation::see_moves(const ToolSideBlock& block) {
  const bool at_end = next_moves();
  if (held_ != Held::path) return {at_end, false};
  // The tool stands as it did at the end of the path: asked already.
  const bool stands = last_->tool == kept_ && block.tool_number == kept_number_;
  for (WaitingPath& w : waiting()) w.moves = w.next.path == nullptr && next_moves_at(*w.path->tool);
  return {at_end, stands ? at_end : next_moves_at(*last_->tool)};
}

// What counts is how the block moves at its own end and at the corners that are still to be made.
[[gnu::always_inline]] inline StageEnd ToolSideCompensation::next_block(ToolSideBlock& block) {
  const Moves where = see_moves(block);
  const auto moves_there = [](const WaitingPath& w) { return w.moves; };
  if (!where.at_end && !where.at_path && std::ranges::none_of(waiting(), moves_there)) return still_block(block);
  SidePath& to = new_path();
  set_path(to, block);
  if (const Alarm a = check_path(to, where.at_path)) return refuse(block, a);
  const auto edge_there = [&](const WaitingPath& w) { return w.moves && on_edge(block, *w.path->tool); };
  if (block.arc && ((held_ == Held::path && on_edge(block, *last_->tool)) ||
                    std::ranges::any_of(waiting(), edge_there) || on_edge(block, *block.tool)))
    return undecide(block, "fanuc.tool-side.arc-plane");
  after_start_ = false;
  return path_block(block, to, where);
}

StageEnd ToolSideCompensation::still_block(ToolSideBlock& block) {
  if (held_ == Held::nothing) {
    send_in_force(block);
    return {};
  }
  hold();
  ++still_;
  repeated_ |= block.repeated;
  for (WaitingPath& w : waiting()) w.repeated |= block.repeated;
  if (still_ < parameters_.still_limit) return {};
  joined_ = nullptr;
  if (const Alarm a = release_path()) return at_fault(a);
  if (const Alarm a = settle()) return at_fault(a);
  return {};
}

// A block that moves somewhere.
[[gnu::always_inline]] inline StageEnd ToolSideCompensation::path_block(ToolSideBlock& block, const SidePath& to,
                                                                        const Moves& where) {
  joined_ = nullptr;
  if (held_ == Held::path) {
    for (WaitingPath& w : waiting()) {
      w.repeated |= block.repeated;
      if (w.moves) w.next = {&to, w.repeated ? CornerRule::repeated : CornerRule::ordinary, false};
    }
    if (where.at_path) {
      if (const Alarm a = join(to, rule_before(block))) return at_fault(a);
      joined_ = &to;
      if (const Alarm a = settle()) return at_fault(a);
    } else if (still_ + 1U >= parameters_.still_limit) {
      if (const Alarm a = release_path()) return at_fault(a);
      if (const Alarm a = settle()) return at_fault(a);
    }
  }
  if (held_ == Held::path) {
    // It is passed over by the corner at the end of the path.
    repeated_ |= block.repeated;
    ++still_;
    hold();
    if (where.at_end)
      waiting_[waiting_count_++] = {&to, static_cast<std::uint8_t>(count_ - waits_ - 1U), false, false, {}};
    else if (waiting_count_ > 0 && waiting_[waiting_count_ - 1].next.path == &to)
      waiting_[waiting_count_ - 1].next.keeps = true;
    return {};
  }
  moves_at_end_ = where.at_end;
  // It starts at a corner, in the plane there, where the last path that went out made one with it.
  if (joined_ == &to)
    start_of_path_ = {last_->tool, to.side, &last_->offset};
  else
    start_of_path_ = {to.tool, to.side, &to.offset};
  hold_path(to, false);
  return {};
}

Alarm ToolSideCompensation::settle() {
  while (held_ == Held::path && next_of_path_.path != nullptr) {
    const NextPath next = next_of_path_;
    keeps_ = next.keeps;
    if (const Alarm a = join(*next.path, next.rule)) return a;
    joined_ = keeps_ ? nullptr : next.path;
    if (keeps_ && held_ != Held::path) keep_vector();
    keeps_ = false;
  }
  return AlarmCause::none;
}

[[gnu::always_inline]] inline void ToolSideCompensation::hold_path(const SidePath& to, bool starts_up) {
  checked_ = !starts_up && !parameters_.no_interference;
  treatment_ = next().treatment;
  next_of_path_ = {};
  if (to.arc) next().mismatches = mismatches(next());
  CornerQueue::hold_path(to, starts_up);
}

void ToolSideCompensation::keep_without_direction() {
  if (held_ != Held::path || moves_at_end_) return;
  pass_corner(held(waits_));
  make_.keep_last(at_start());
  held_ = Held::nothing;
  send_held(at_start().front().vector);
}

// From the last head of the corner before it straight to its end, without a vector, where it moves at its own end.
StageEnd ToolSideCompensation::cancel_block(ToolSideBlock& block) {
  const bool at_end = next_moves();
  if (held_ == Held::path) {
    SidePath& to = new_path();
    set_path(to, block);
    while (held_ == Held::path) {
      if (moves_in_plane_of(to.arc, to.travel, *last_->tool)) {
        to.side = last_->side;
        const bool repeated = repeated_ || block.repeated || starts_up_;
        if (const Alarm a = join(to, repeated ? CornerRule::repeated : CornerRule::cancel)) return at_fault(a);
      } else if (const Alarm a = release_path()) {
        return at_fault(a);
      }
      if (const Alarm a = settle()) return at_fault(a);
    }
    const std::size_t head = pass_blocks_before();
    if (block.renamed != nullptr) [[unlikely]]
      rename_corner(corner_move(at_start()), *block.renamed);
    send_corner_moves(block, head);
  }
  if (at_end) {
    remove_vector(block, true);
    return {};
  }
  if (at_start().size > 1) make_.keep_last(at_start());
  cancel_alone(block, parameters_.type == StartType::c);
  return {};
}

// With a second path, make_corner() sees how it turns.
void ToolSideCompensation::set_corner(SideGroup& group, const SidePath* second, CornerRule /*rule*/) const {
  SideCorner& corner = group.corner;
  corner.first = last_;
  corner.second = second;
  corner.tool = last_->tool;
  corner.first_side = last_->side;
  corner.second_side = second == nullptr ? last_->side : second->side;
  corner.offset = &last_->offset;
  if (second == nullptr) (void)geometry_.set_turn(corner);
}

// With the check where the plane changes: where doubles make the corner it turns by less than 90 degrees, and nothing
// is to be checked.
Alarm ToolSideCompensation::make_corner(SideGroup& group, const SidePath& to, CornerRule rule) const {
  if (rule == CornerRule::ordinary && treatment_ == Treatment::none && make_corner_in_doubles(group, to))
    return AlarmCause::none;
  (void)geometry_.set_turn(group.corner);
  if (!make_.make(group, rule, treatment_)) return AlarmCause::no_intersection;
  const SideCorner& corner = group.corner;
  const SidePath& path = *last_;
  const bool plane_change = rule == CornerRule::ordinary && treatment_ == Treatment::none &&
                            corner.offset->nearest != 0 && corner.first_side == corner.second_side &&
                            path.tool != to.tool && !parameters_.no_plane_change;
  const Kinematics& kinematics = geometry_.kinematics();
  if (plane_change && parameters_.tilt.reached(kinematics, *path.tool, *to.tool) &&
      dot_sign(kinematics, path.travel, *path.tool, to.travel, *to.tool) >= 0 &&
      dot_sign(kinematics, path.travel, *path.tool, to.travel, *path.tool) < 0)
    return AlarmCause::interference;
  return AlarmCause::none;
}

// The blocks up to the one that waited run at the last vector; where one of them has made the corner and keeps the
// vector there is no corner behind it.
void ToolSideCompensation::hold_waiting() {
  const WaitingPath path = waiting_[0];
  --waiting_count_;
  for (std::size_t i = 0; i < waiting_count_; ++i) {
    waiting_[i] = waiting_[i + 1];
    waiting_[i].place = static_cast<std::uint8_t>(waiting_[i].place - path.place);
  }
  waits_ = static_cast<std::uint8_t>(path.place - 1U);
  start_of_path_ = {last_->tool, path.path->side, &last_->offset};
  if (keeps_) {
    keep_vector();
    start_of_path_ = {path.path->tool, path.path->side, &path.path->offset};
  } else if (at_start().size == 1) {
    (void)pass_blocks_before();
  }
  last_ = path.path;
  next_of_path_ = path.next;
  moves_at_end_ = true;
  held_ = Held::path;
  starts_up_ = false;
  checked_ = !parameters_.no_interference;
  treatment_ = held(waits_).treatment;
  still_ = static_cast<std::uint8_t>(count_ - waits_ - 1U);
  repeated_ = path.repeated;
}

// Of the corner that has been made the last vector alone is left, behind the blocks that wait for it.
void ToolSideCompensation::keep_vector() {
  (void)pass_blocks_before();
  make_.keep_last(at_start());
}

StageEnd ToolSideCompensation::release() {
  keep_without_direction();
  while (held_ == Held::path) {
    if (const Alarm a = release_path()) return at_fault(a);
    if (const Alarm a = settle()) return at_fault(a);
  }
  if (held_ != Held::start) return {};
  mode_ = Mode::off;
  held_ = Held::nothing;
  count_ = 0;
  return at_fault(AlarmCause::type_c_format);
}

void ToolSideCompensation::warn_of_mismatch(const ToolSideBlock& block) {
  notice_.kind = spec::EventKind::warning;
  notice_.number = "ARC_PLANE_MISMATCH";
  notice_.message = "the plane of the tool is not that of the arc";
  notice_.line = block.event.line;
  notice_.n = block.event.n;
  sink_->on(notice_);
}

}  // namespace toolcomp::fast

#include "fast/fanuc/tool_side_compensation/tool_side_compensation.h"

#include "fast/basis/fault.h"

namespace toolcomp::fast {
namespace {

spec::MoveType straight(spec::MoveType type) {
  return type == spec::MoveType::rapid ? spec::MoveType::rapid : spec::MoveType::linear;
}

}  // namespace

ToolSideCompensation::ToolSideCompensation(const spec::Setup& setup, const Kinematics& kinematics, EventSink& sink)
    : sink_(&sink),
      parameters_(setup),
      geometry_(kinematics),
      make_(geometry_, parameters_),
      xyz_{setup.axes.index('X'), setup.axes.index('Y'), setup.axes.index('Z')},
      shortest_(parameters_.no_movement.nearest() * static_cast<double>(Count::kSmallPerOne) * (1 + 0x1p-40)),
      xyz_first_(xyz_ == std::array<std::size_t, 3>{0, 1, 2}) {}

void ToolSideCompensation::set_path(SidePath& to, const ToolSideBlock& block) {
  to.arc = block.arc;
  if (block.arc) {
    set_arc_path(to.flat, block);
    to.in = block.in;
    to.normal = 3 - block.in[0] - block.in[1];
  }
  to.tool = block.tool;
  to.side = fault(Fault::side_handedness) ? -block.side : block.side;
  to.offset = value_;
  to.offset_change = value_change_;
}

void ToolSideCompensation::keep_tool(std::uint8_t path) {
  const Direction* const tool = paths_[path].tool;
  if (tool == nullptr || tool == &tools_[path]) return;
  tools_[path] = *tool;
  paths_[path].tool = &tools_[path];
  if (start_tool_of_path_ == tool) start_tool_of_path_ = &tools_[path];
  for (SideGroup& group : groups_)
    if (group.corner.tool == tool) group.corner.tool = &tools_[path];
}

// Of the path that is held and the one before it.
void ToolSideCompensation::keep_tools() {
  keep_tool(path_);
  keep_tool(before(path_));
}

bool ToolSideCompensation::moves(bool arc, const Travel& travel, const Direction& tool) const {
  if (arc) return true;
  if (travel.zero) return false;
  if (fault(Fault::side_limit_by_length)) {
    // The length of the block itself, not of its projection.
    const double limit = parameters_.no_movement.nearest() * travel.unit;
    if (parameters_.no_movement < Count() || travel.square < limit * limit) return limit <= 0;
    return geometry_.plane(tool).moves(travel, Count());
  }
  return geometry_.plane(tool).moves(travel, parameters_.no_movement);
}

bool ToolSideCompensation::on_edge(const ToolSideBlock& block, const Direction& tool) const {
  return geometry_.plane(tool).facing(3 - block.in[0] - block.in[1]) == 0;
}

bool ToolSideCompensation::mismatches(const ToolSideBlock& block) const {
  if (!block.arc) return false;
  const std::size_t normal = 3 - block.in[0] - block.in[1];
  return !geometry_.plane(*block.tool_before).along(normal) || !geometry_.plane(*block.tool).along(normal);
}

StageEnd ToolSideCompensation::block() {
  if (line_.taken) complete_line();
  ToolSideBlock& block = next();
  const StageEnd end = any_block(block);
  keep_tools();
  await_line(block);
  return end;
}

StageEnd ToolSideCompensation::any_block(ToolSideBlock& block) {
  if (mode_ == Mode::starts) return second_block(block);
  if (mode_ == Mode::ends && block.wanted) return undecide(block, "fanuc.cutter-c.restart-before-removal");
  keep_without_direction();
  if (mode_ == Mode::off && !block.wanted) {
    // G40 before anything has moved.
    if (block.arc) {
      PlanePath& path = paths_[0].flat;  // no corner refers to any
      set_arc_path(path, block);
      set_center(block, path);
      set_programmed_arc(*block.event.arc, path);
    }
    send(block, {}, block.own);
    return {};
  }
  if (mode_ == Mode::off && parameters_.type == StartType::c) {
    // Compensation comes into force: the block has no move.
    mode_ = Mode::starts;
    held_ = Held::start;
    still_ = 0;
    repeated_ = false;
    start_tool_ = *block.tool;
    start_side_ = fault(Fault::side_handedness) ? -block.side : block.side;
    start_offset_ = value_;
    hold();
    return {};
  }
  if (mode_ == Mode::on) return block.wanted ? next_block(block) : cancel_block(block);
  if (!next_moves(*block.tool)) {
    send(block, at_start().front().vector, block.own);
    return {};
  }
  return mode_ == Mode::off ? first_block(block) : cancel_block(block);
}

// The start-up block of types A and B: straight from where it starts, without a vector, to the first head at its end.
StageEnd ToolSideCompensation::first_block(ToolSideBlock& block) {
  SidePath& to = new_path();
  set_path(to, block);
  at_start().clear();
  mode_ = Mode::on;
  after_start_ = true;
  block.event.cause = spec::Cause::start_up;
  start_tool_of_path_ = to.tool;
  start_offset_of_path_ = &to.offset;
  hold_path(to, true);
  return {};
}

// The block right after a start of type C.
StageEnd ToolSideCompensation::second_block(ToolSideBlock& block) {
  const int side = fault(Fault::side_handedness) ? -block.side : block.side;
  if (!block.wanted || !next_moves(start_tool_) || side != start_side_ ||
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
  corner.first_side = corner.second_side = start_side_;
  corner.offset = &start_offset_;
  if (start_offset_.nearest == 0) {
    group.clear();
  } else {
    (void)geometry_.set_turn(corner);
    make_.set(group, HeadKind::second_normal);
  }
  ToolSideBlock& start = held(0);
  start.event.cause = spec::Cause::start_up;
  held_ = Held::nothing;
  send(start, group.front().vector, start.own || !vector_is_zero());
  count_ = 0;
  mode_ = Mode::on;
  start_tool_of_path_ = &start_tool_;
  start_offset_of_path_ = &start_offset_;
  hold_path(to, false);
  return {};
}

// What counts is how the block moves at its own end and at the corners that are still to be made.
StageEnd ToolSideCompensation::next_block(ToolSideBlock& block) {
  const bool at_end = next_moves(*block.tool);
  const bool leaves_path = held_ == Held::path && next_moves(*last_->tool);
  const bool leaves_waiting = waiting_path_ != nullptr && next_moves(*waiting_path_->tool);
  if (!at_end && !leaves_path && !leaves_waiting) return still_block(block);
  SidePath& to = new_path();
  set_path(to, block);
  if (block.arc && to.flat.ends_in_center) return refuse(block, alarm::kArcCenter);
  if (to.side != last_->side && (after_start_ || (starts_up_ && leaves_path)))
    return refuse(block, alarm::kDirectionChangeAtStart);
  if (block.arc && ((held_ == Held::path && on_edge(block, *last_->tool)) ||
                    (waiting_path_ != nullptr && on_edge(block, *waiting_path_->tool)) || on_edge(block, *block.tool)))
    return undecide(block, "fanuc.tool-side.arc-plane");
  after_start_ = false;
  return path_block(block, to, at_end);
}

// A block that moves somewhere. Of two paths the first one is always out behind it.
StageEnd ToolSideCompensation::path_block(ToolSideBlock& block, const SidePath& to, bool at_end) {
  // Of the corner at its start.
  const Direction* tool = to.tool;
  const Amount* offset = &to.offset;
  while (held_ == Held::path) {
    const SidePath& from = *last_;
    if (moves(to.arc, to.travel, *from.tool)) {
      const bool repeated = repeated_ || block.repeated;
      const CornerRule rule =
          repeated ? CornerRule::repeated : (starts_up_ ? CornerRule::start_up : CornerRule::ordinary);
      if (const StageEnd end = join(to, rule)) return end;
      tool = from.tool;
      offset = &from.offset;
    } else if (still_ > 0) {
      if (const StageEnd end = release_path()) return end;
    } else {
      // It is passed over by the corner at the end of the path.
      repeated_ |= block.repeated;
      ++still_;
      if (at_end && !fault(Fault::side_passed_over_keeps)) waiting_path_ = &to;
      mismatch_[next_] = false;
      hold();
      return {};
    }
  }
  start_tool_of_path_ = tool;
  start_offset_of_path_ = offset;
  start_side_ = to.side;
  hold_path(to, false);
  return {};
}

void ToolSideCompensation::hold_path(const SidePath& to, bool starts_up) {
  last_ = &to;
  starts_up_ = starts_up;
  treatment_ = next().treatment;
  mismatch_[next_] = mismatches(next());
  hold();
  held_ = Held::path;
  still_ = 0;
  repeated_ = false;
}

void ToolSideCompensation::keep_without_direction() {
  if (held_ != Held::path || moves(last_->arc, last_->travel, *last_->tool)) return;
  ToolSideBlock& block = held(waits_);
  pass_corner(&block);
  make_.keep_last(at_start());
  held_ = Held::nothing;
  for (; count_ > 0; free_first()) send(held(0), at_start().front().vector, held(0).own);
}

// From the last head of the corner before it straight to its end, without a vector, where it moves at its own end.
StageEnd ToolSideCompensation::cancel_block(ToolSideBlock& block) {
  const bool at_end = next_moves(*block.tool);
  if (held_ == Held::path) {
    SidePath& to = new_path();
    set_path(to, block);
    while (held_ == Held::path) {
      if (!moves(to.arc, to.travel, *last_->tool)) {
        if (const StageEnd end = release_path()) return end;
        continue;
      }
      to.side = last_->side;
      const bool repeated = repeated_ || block.repeated || starts_up_;
      if (const StageEnd end = join(to, repeated ? CornerRule::repeated : CornerRule::cancel)) return end;
    }
    pass_corner(&block);
  }
  if (!at_end) return cancel_alone(block);
  block.event.cause = spec::Cause::cancel;
  at_start().clear();
  mode_ = Mode::off;
  count_ = 0;
  send(block, {}, true);
  return {};
}

void ToolSideCompensation::set_corner(SideCorner& corner, const SidePath* second) const {
  corner.first = last_;
  corner.second = second;
  corner.tool = last_->tool;
  if (fault(Fault::side_tool_at_start)) corner.tool = start_tool_of_path_;
  if (fault(Fault::side_turned_tool) && count_ > waits_ + 1)
    corner.tool = ring_[(first_ + waits_ + 1U) % ring_.size()].tool;
  corner.first_side = last_->side;
  corner.second_side = second == nullptr ? last_->side : second->side;
  corner.offset = &last_->offset;
}

StageEnd ToolSideCompensation::join(const SidePath& to, CornerRule rule) {
  SideGroup& group = at_end();
  set_corner(group.corner, &to);
  (void)geometry_.set_turn(group.corner);
  if (!make_.make(group, rule, treatment_)) return at_fault(held(waits_), alarm::kNoIntersection);
  const bool plane_change = rule == CornerRule::ordinary && treatment_ == Treatment::none &&
                            group.corner.offset->nearest != 0 && group.corner.first_side == group.corner.second_side &&
                            !parameters_.no_plane_change;
  if (const StageEnd end = finish(plane_change, &to)) return end;
  group_ ^= 1U;
  hold_waiting_path();
  return {};
}

StageEnd ToolSideCompensation::finish(bool plane_change, const SidePath* to) {
  ToolSideBlock& block = held(waits_);
  const SidePath& path = *last_;
  const Kinematics& kinematics = geometry_.kinematics();
  if (plane_change && parameters_.tilt.reached(kinematics, *path.tool, *to->tool) &&
      dot_sign(kinematics, path.travel, *path.tool, to->travel, *to->tool) >= 0 &&
      dot_sign(kinematics, path.travel, *path.tool, to->travel, *path.tool) < 0)
    return at_fault(block, alarm::kPlaneChangeInterference);
  const bool arc = path.arc;
  std::optional<double> sweep;
  if (arc) {
    set_center(block, path.flat);
    set_tool_arc(*block.event.arc, make_, path, at_start(), at_end());
    sweep = block.event.arc->sweep;
  }
  if (!starts_up_ && !parameters_.no_interference) {
    const CheckedSide checked{&path, start_tool_of_path_, start_side_, start_offset_of_path_};
    switch (check_interference(make_, checked, sweep, at_start(), at_end())) {
      case Interference::none:
        break;
      case Interference::straightened:
        block.event.type = spec::MoveType::linear;
        block.event.arc.reset();
        break;
      case Interference::alarm:
        return at_fault(block, alarm::kInterference);
    }
  }
  pass_corner(&block);
  if (at_end().size > 1) {
    corner_move_ = block.event;
    corner_move_.cause = spec::Cause::corner;
    corner_move_.type = straight(block.event.type);
    corner_move_.arc.reset();
  }
  warn_once(block);
  send(block, at_end().front().vector, true);
  free_first();
  send_behind();
  return {};
}

// The blocks behind the path that has just gone out: at its only vector, or later, at the last of several; or one of
// them is the next path.
void ToolSideCompensation::send_behind() {
  held_ = Held::nothing;
  if (waiting_path_ != nullptr) return;
  if (at_end().size > 1) {
    waits_ = count_;
    return;
  }
  for (; count_ > 0; free_first()) send(held(0), at_end().front().vector, held(0).own);
}

void ToolSideCompensation::hold_waiting_path() {
  if (waiting_path_ == nullptr) return;
  start_tool_of_path_ = last_->tool;
  start_offset_of_path_ = &last_->offset;
  last_ = waiting_path_;
  waiting_path_ = nullptr;
  start_side_ = last_->side;
  held_ = Held::path;
  starts_up_ = false;
  treatment_ = held(0).treatment;
  still_ = static_cast<std::uint8_t>(count_ - 1U);
  repeated_ = false;
}

void ToolSideCompensation::pass_corner(ToolSideBlock* owner) {
  SideGroup& group = at_start();
  std::uint8_t head = 1;
  if (group.size > 1) {
    const bool late = fault(Fault::side_stop_owner);
    while (head < group.size && group.head[head].up_to_stop() && !late) send_corner_moves(nullptr, head);
  }
  for (; waits_ > 0; --waits_) {
    ToolSideBlock& still = held(0);
    if (still.own)
      while (head < group.size) send_corner_moves(&still, head);
    send(still, group.back().vector, still.own);
    free_first();
  }
  if (owner == nullptr || head >= group.size) return;
  if (count_ > 0 && &held(0) == owner) warn_once(*owner);
  while (head < group.size) send_corner_moves(owner, head);
}

// One move, to `head`; nullptr: it belongs to the block before the corner.
void ToolSideCompensation::send_corner_moves(const ToolSideBlock* owner, std::uint8_t& head) {
  Event event = corner_move_;
  if (owner != nullptr) {
    event.line = owner->event.line;
    event.n = owner->event.n;
    event.type = straight(owner->event.type);
    event.feed = owner->event.feed;
  }
  add(event, at_start().head[head].vector);
  sink_->on(event);
  ++head;
}

StageEnd ToolSideCompensation::release() {
  if (line_.taken) complete_line();
  line_.awaited = false;
  keep_tools();
  keep_without_direction();
  switch (held_) {
    case Held::nothing:
      return {};
    case Held::start: {
      mode_ = Mode::off;
      held_ = Held::nothing;
      count_ = 0;
      return at_fault(held(0), alarm::kTypeCFormat);
    }
    case Held::path:
      break;
  }
  while (held_ == Held::path)
    if (const StageEnd end = release_path()) return end;
  return {};
}

StageEnd ToolSideCompensation::release_path() {
  SideGroup& group = at_end();
  set_corner(group.corner, nullptr);
  (void)geometry_.set_turn(group.corner);
  if (group.corner.offset->nearest == 0)
    group.clear();
  else
    make_.set(group, HeadKind::first_normal);
  if (const StageEnd end = finish(false, nullptr)) return end;
  group_ ^= 1U;
  hold_waiting_path();
  return {};
}

// In the mode, and nowhere does it move.
StageEnd ToolSideCompensation::still_block(ToolSideBlock& block) {
  if (held_ == Held::nothing) {
    send(block, at_start().front().vector, block.own);
    return {};
  }
  hold();
  if (++still_ >= 2)
    if (const StageEnd end = release_path()) return end;
  repeated_ |= block.repeated;
  return {};
}

// G40 or number 0 in a block that does not move at its own end; what is held is out.
StageEnd ToolSideCompensation::cancel_alone(ToolSideBlock& block) {
  const bool zero = vector_is_zero();
  if (at_start().size > 1) make_.keep_last(at_start());
  if (parameters_.type == StartType::c) {
    block.event.cause = spec::Cause::cancel;
    at_start().clear();
    mode_ = Mode::off;
    send(block, {}, block.own || !zero);
    return {};
  }
  mode_ = zero ? Mode::off : Mode::ends;
  send(block, at_start().front().vector, block.own);
  return {};
}

// The blocks before are given as if this block were absent.
StageEnd ToolSideCompensation::refuse(const ToolSideBlock& block, const Alarm& alarm) {
  if (const StageEnd end = release()) return end;
  return end_at(block.event, alarm);
}

StageEnd ToolSideCompensation::undecide(const ToolSideBlock& block, const char* clause) {
  StageEnd end = refuse(block, alarm::kNone);
  if (!end.alarm) end.undecided = clause;
  return end;
}

// Moves of the corner before it that do not belong to the block go out.
StageEnd ToolSideCompensation::at_fault(const ToolSideBlock& block, const Alarm& alarm) {
  const StageEnd end = end_at(block.event, alarm);
  if (held_ == Held::path) pass_corner(nullptr);
  return end;
}

void ToolSideCompensation::hold() {
  if (count_ == 0) first_ = next_;
  ++count_;
  next_ = after_slot(next_);
}

void ToolSideCompensation::free_first() {
  --count_;
  first_ = after_slot(first_);
}

void ToolSideCompensation::send(ToolSideBlock& block, const Vector3<double>& vector, bool own) {
  if (!own) return;
  add(block.event, vector);
  sink_->on(block.event);
}

// Before the first move of the path that is held; it is the first one in the ring by then.
void ToolSideCompensation::warn_once(const ToolSideBlock& block) {
  if (!mismatch_[first_]) return;
  mismatch_[first_] = false;
  notice_.kind = spec::EventKind::warning;
  notice_.number = "ARC_PLANE_MISMATCH";
  notice_.message = "the plane of the tool is not that of the arc";
  notice_.line = block.event.line;
  notice_.n = block.event.n;
  sink_->on(notice_);
}

}  // namespace toolcomp::fast

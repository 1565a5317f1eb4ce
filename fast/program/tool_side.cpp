// Blocks that pass tool side compensation: what the stage is told about each.
#include "fast/program/interpreter.h"

namespace toolcomp::fast {

CutterSide Interpreter::tool_side(Code code) {
  switch (code) {
    case kNone:
      return CutterSide::unchanged;
    case 412:
    case 416:
      return CutterSide::left;
    case 422:
    case 426:
      return CutterSide::right;
    default:
      return CutterSide::off;  // of the same group
  }
}

// The code of a block, and the value of its number. cutter_number_ is taken already.
void Interpreter::begin_tool_side(const Words& words) {
  const CutterSide word = tool_side(words.code(Words::kCompensation));
  const CutterSide before = tool_side_word_;
  if (word != CutterSide::unchanged) tool_side_word_ = word;
  tool_side_.next().repeated = word == before && word != CutterSide::off;
  tool_side_wanted_ = tool_side_word_ != CutterSide::off && cutter_number_.number != 0;
  if (tool_side_word_ == CutterSide::off) return;
  if (before == CutterSide::off || commanded_number(words) || takes_edited_value()) {
    cutter_offset_ = cutter_value(cutter_number_);
    cutter_edited_ = false;
    tool_side_.set_value(cutter_offset_ < Count() ? -cutter_offset_ : cutter_offset_);
  }
  tool_side_sign_ = (tool_side_word_ == CutterSide::right) == (cutter_offset_ < Count()) ? 1 : -1;
}

// Everything about a line but Q and where it ends.
void Interpreter::start_tool_side_leg(ToolSideBlock& block) const {
  block.wanted = tool_side_wanted_;
  block.side = tool_side_sign_;
  block.treatment = Treatment::none;
  block.arc = false;
}

// The usual block: positions, under G43.5 I J K, and F, or nothing but its number. What begin_tool_side() and
// tool_side_motion() do for any block, without the detours.
Alarm Interpreter::tool_side_move(const Words& words) {
  direction_before_ = direction_;
  const bool directed = by_vector_ && words.has_any(Words::set_of("IJK"));
  ToolSideBlock& block = tool_side_.next();
  const Count& x = programmed_[0];
  const Count& y = programmed_[1];
  const Count& z = programmed_[2];
  const bool small = x.is_small() && y.is_small() && z.is_small();
  if (!small || !letters_.xyz_first || rounded_ != 0 || tool_offset_.live() != 0) [[unlikely]] {
    if (directed && !plans_tool_) direct(words);
    block.repeated = false;
    return tool_side_motion(words, false, std::nullopt, ArcWords{});
  }
  const std::int64_t from_x = x.small();
  const std::int64_t from_y = y.small();
  const std::int64_t from_z = z.small();
  const Mask axes = words.axes();
  if (const Alarm a = place_words(words, axes)) return a;
  block.own = axes != 0 || directed;
  SidePath& to = tool_side_.next_path();
  LineCorner corner;
  bool usual = false;
  if (x.is_small() && y.is_small() && z.is_small()) [[likely]] {
    set_travel(to.travel, x.small() - from_x, y.small() - from_y, z.small() - from_z);
    usual = tool_side_wanted_ && tool_side_.see_line(tool_side_sign_, to, to.travel.value, corner);
  } else {
    std::array<Count, 3> start;
    start[0].set_small(from_x);
    start[1].set_small(from_y);
    start[2].set_small(from_z);
    set_travel(to.travel, start, {x, y, z}, 0);
  }
  // Not earlier: its root is made while those of the corner are, which takes the direction before it.
  if (directed && !plans_tool_) {
    Direction& direction = new_direction();
    if (!read_usual_direction(words, direction)) [[unlikely]]
      read_direction(words, direction);
  }
  fill_here(block.event, straight(), spec::Cause::programmed);
  const Direction& tool = directions_[direction_];
  if (usual && tool_side_.take_line(corner, tool, tool_side_sign_)) [[likely]]
    return alarm::kNone;
  start_tool_side_leg(block);
  block.repeated = false;
  block.tool = &tool;
  block.tool_before = &directions_[direction_before_];
  if (const StageEnd end = tool_side_.block()) end_run(end);
  return alarm::kNone;
}

Alarm Interpreter::tool_side_motion(const Words& words, bool extra, const std::optional<spec::Arc<double>>& arc,
                                    const ArcWords& arc_words) {
  ToolSideBlock& block = tool_side_.next();
  const Mask axes = words.axes();
  start_tool_side_leg(block);
  const std::uint32_t q = words.has('Q') ? whole_number(words['Q'], 3) : 0;
  block.treatment = static_cast<Treatment>(q > 3 ? 0 : q);
  std::array<Count, 3> from;
  std::array<Count, 3> to;
  Mask xyz = 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (xyz_[i] != spec::Axes::kNone) {
      from[i] = programmed_[xyz_[i]];
      xyz = static_cast<Mask>(xyz | bit(xyz_[i]));
    }
  if (arc) {
    block.arc = true;
    block.clockwise = arc_words.clockwise;
    block.by_radius = arc_words.by_radius;
    block.to_center = arc_words.to_center;
    block.radius = arc_words.radius;
    block.axis = plane_axes(plane_);
    for (std::size_t i = 0; i < 2; ++i) {
      block.in[i] = in_plane(plane_, i);
      block.start[i] = actual(block.axis[i]);
    }
  }

  Mask rounded = rounded_;
  if (const Alarm a = place_words(words, axes)) return a;

  rounded = static_cast<Mask>((rounded | rounded_) & axes & xyz);
  for (std::size_t i = 0; i < 3; ++i)
    if (xyz_[i] != spec::Axes::kNone) to[i] = programmed_[xyz_[i]];
  set_travel(tool_side_.next_travel(), from, to, rounded != 0 ? 2 : 0);
  block.tool = &directions_[direction_];
  block.tool_before = &directions_[direction_before_];
  block.own = axes != 0 || extra || arc || (by_vector_ && words.has_any(Words::set_of("IJK")));
  fill(block.event, arc ? spec::MoveType::arc : straight(), spec::Cause::programmed);
  if (arc) {
    block.event.arc = arc;
    for (std::size_t i = 0; i < 2; ++i) block.end[i] = actual(block.axis[i]);
  }
  if (const StageEnd end = tool_side_.block()) end_run(end);
  return alarm::kNone;
}

}  // namespace toolcomp::fast

// Blocks that pass tool side compensation: what the stage is told about each.
#include "fast/fanuc/interpreter/interpreter.h"
#include "fast/fanuc/interpreter/own_move.h"
#include "fast/fanuc/interpreter/usual_words.h"

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

// The code of a block, and the value of its number. The number is taken already.
void Interpreter::begin_tool_side(const Words& words) {
  const CutterSide word = tool_side(words.code(Words::kCompensation));
  const CutterSide before = tool_side_word_;
  if (word != CutterSide::unchanged) tool_side_word_ = word;
  tool_side_.next().repeated = word == before && word != CutterSide::off;
  tool_side_wanted_ = tool_side_word_ != CutterSide::off && cutter_value_.number().number != 0;
  if (tool_side_word_ == CutterSide::off) return;
  if (before == CutterSide::off || cutter_value_.commanded(words) || cutter_value_.takes_edited()) {
    cutter_value_.take_value();
    tool_side_.set_value(cutter_value_.value() < Count() ? -cutter_value_.value() : cutter_value_.value());
  }
  tool_side_sign_ = (tool_side_word_ == CutterSide::right) == (cutter_value_.value() < Count()) ? 1 : -1;
}

// Everything about a line but Q and where it ends.
void Interpreter::start_tool_side_leg(ToolSideBlock& block) const {
  block.wanted = tool_side_wanted_;
  block.side = tool_side_sign_;
  block.treatment = Treatment::none;
  block.arc = false;
}

// Positions, under G43.5 I J K, and F, or nothing but its number.
Alarm Interpreter::tool_side_move(const Words& words) {
  attitude_.directions().begin_block();
  if (modal_.by_vector() && !attitude_.plans_tool()) attitude_.direct(words);
  tool_side_.next().repeated = false;
  return tool_side_motion(words, false, std::nullopt, ArcWords{});
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
    if (axes_.xyz[i] != spec::Axes::kNone) {
      from[i] = positions_.programmed()[axes_.xyz[i]];
      xyz = static_cast<Mask>(xyz | bit(axes_.xyz[i]));
    }
  if (arc) {
    block.arc = true;
    block.clockwise = arc_words.clockwise;
    block.by_radius = arc_words.by_radius;
    block.to_center = arc_words.to_center;
    block.radius = arc_words.radius;
    block.axis = modal_.axes_of(modal_.plane());
    for (std::size_t i = 0; i < 2; ++i) {
      block.in[i] = in_plane(modal_.plane(), i);
      block.start[i] = positions_.actual(block.axis[i]);
    }
  }

  Mask rounded = positions_.rounded();
  if (const Alarm a = place_words(words, axes)) return a;

  rounded = static_cast<Mask>((rounded | positions_.rounded()) & axes & xyz);
  for (std::size_t i = 0; i < 3; ++i)
    if (axes_.xyz[i] != spec::Axes::kNone) to[i] = positions_.programmed()[axes_.xyz[i]];
  set_travel(tool_side_.next_travel(), from, to, rounded != 0 ? 2 : 0);
  block.tool = &attitude_.directions().now();
  block.tool_before = &attitude_.directions().before();
  block.own = axes != 0 || extra || arc || (modal_.by_vector() && words.has_any(Words::set_of("IJK")));
  fill(block.event, arc ? spec::MoveType::arc : modal_.straight(), spec::Cause::programmed);
  if (arc) {
    block.event.arc = arc;
    for (std::size_t i = 0; i < 2; ++i) block.end[i] = positions_.actual(block.axis[i]);
  }
  if (const StageEnd end = tool_side_.block())
    end_run(end);
  else
    await_side_lines();
  return alarm::kNone;
}

}  // namespace toolcomp::fast

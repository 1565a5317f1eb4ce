// Moves of codes that count in their block only: tool offset G45 to G48, measurement G37.
#include <bit>

#include "fast/basis/fault.h"
#include "fast/fanuc/interpreter/interpreter.h"

namespace toolcomp::fast {

// The alarms of G45 to G48, then by how much each axis of the block is shifted, and the tool's arc.
Alarm Interpreter::plan_tool_offset(const Words& words, const ArcWords& arc_words,
                                    std::optional<spec::Arc<double>>& arc, Shifts& shifts) const {
  CutterValue::Number number = cutter_value_.number_after(words);
  if (positions_.tool_offset().number_by_h() && !fault(Fault::tph_ignored)) {
    const ToolLengthOffset::Mode mode = positions_.length().mode_after(words.code(Words::kLength));
    if (mode == ToolLengthOffset::Mode::plus || mode == ToolLengthOffset::Mode::minus) return alarm::kToolOffsetLength;
    number = {words.has('H') ? whole_number(words['H'], memory_.count()) : positions_.length().number(), true};
  }
  if (words.axes() == 0) return arc ? alarm::kToolOffsetArc : alarm::kNone;
  const Count offset = cutter_value_.of(number);
  if (!memory_.fits(offset)) return alarm::kOffsetValue;
  const Count increase = ToolOffset::increase(words.code(Words::kOneShot), offset);

  if (arc) {
    if (arc_words.by_radius) return alarm::kToolOffsetArc;
    const std::array<std::size_t, 2>& axis = modal_.plane_axis();
    std::array<Count, 2> travel;
    for (std::size_t i = 0; i < 2; ++i)
      if (axis[i] != spec::Axes::kNone && (words.axes() & bit(axis[i])) != 0)
        travel[i] = target(words, axis[i]) - positions_.programmed()[axis[i]];
    ToolOffset::Arc made;
    if (const Alarm a = ToolOffset::arc(travel, arc_words.to_center, increase, made)) return a;
    for (std::size_t i = 0; i < 2; ++i) {
      if (axis[i] == spec::Axes::kNone) continue;
      Count center = positions_.actual(axis[i]);
      if (i == made.along) center += made.to_center;
      arc->center.set(axis[i], center.nearest());
    }
    arc->radius.reset();
    if (made.zero) arc->sweep.reset();
  }
  return for_each_axis(static_cast<Mask>(words.axes() & axes_.linear), [&](std::size_t axis) {
    const Count travel = target(words, axis) - positions_.programmed()[axis];
    const int sense = ToolOffset::sense(travel, words.axis(axis), modal_.incremental());
    shifts.by[axis] = sense < 0 ? -increase : increase;
    if (sense != 0) shifts.axes = static_cast<Mask>(shifts.axes | bit(axis));
    return alarm::kNone;
  });
}

// One move of G37 along its axis.
Alarm Interpreter::send_measuring_move(std::size_t axis, const Count& to, double commanded, bool measuring) {
  if (const Alarm a = positions_.place(axis, to)) return a;
  if (const Alarm a = positions_.refresh()) return a;
  Event& event = leading_edge_.next().event;
  if (measuring) {
    fill(event, spec::MoveType::linear, spec::Cause::measure);
    if (measurement_.feed()) event.feed = measurement_.feed();
  } else {
    fill(event, spec::MoveType::rapid, spec::Cause::programmed);
  }
  event.programmed.value[axis] = commanded;
  leading_edge_.pass();
  return alarm::kNone;
}

Alarm Interpreter::measure(const Words& words) {
  if (in_cutter_) {
    retire_cutter();
    if (stopped_) return alarm::kNone;
  }
  const auto axis = static_cast<std::size_t>(std::countr_zero(words.axes()));
  const Count commanded = target(words, axis);
  if (!commanded.in_range()) return alarm::kRange;
  if (commanded == positions_.programmed()[axis]) {
    end_run({alarm::kNone, "fanuc.length-measurement.start-on-the-coordinate", line_, n_});
    return alarm::kNone;
  }
  positions_.clear_rounded(bit(axis));
  const ToolLengthMeasurement::Motion motion = measurement_.measure(
      axis, positions_.programmed()[axis], commanded, positions_.length()[axis] + positions_.tool_offset()[axis]);
  const double coordinate = commanded.nearest();
  if (motion.approaches || !motion.measures)
    if (const Alarm a = send_measuring_move(axis, motion.begin, coordinate, false)) return a;
  if (motion.measures)
    if (const Alarm a = send_measuring_move(axis, motion.end, coordinate, true)) return a;
  if (motion.alarm) return motion.alarm;
  if (fault(Fault::position_stays_commanded))
    if (const Alarm a = positions_.place(axis, commanded)) return a;
  // What G10 L11 would do under G91, without its range.
  const Count difference = fault(Fault::difference_reversed) ? -motion.difference : motion.difference;
  write_offset(
      memory_.plan(fault(Fault::measured_into_geometry) ? 10 : 11, positions_.length().number(), difference, true));
  return alarm::kNone;
}

}  // namespace toolcomp::fast

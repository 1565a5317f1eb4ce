// The alarms of commands about tool center point control G43.4 G43.5.
#include "fast/fanuc/interpreter/interpreter.h"

namespace toolcomp::fast {

// The alarms that words and state alone show (clause fanuc.tool-center-point.alarm-order).
Alarm Interpreter::check_tip_control(const Words& words, const Plan& plan) const {
  const Code length = words.code(Words::kLength);
  const Code one_shot = words.code(Words::kOneShot);
  const bool starts = words.starts_tip_control();
  const bool forbidden = one_shot != kNone && one_shot != 40 && one_shot != 100;
  const bool cutter = words.code(Words::kCompensation) == 410 || words.code(Words::kCompensation) == 420;
  if (plan.along && (forbidden || cutter || words.code(Words::kWorkpiece) != kNone))
    return alarm::kForbiddenUnderDirection;
  if (positions_.along_tool() && (length == 430 || length == 440)) return alarm::kLengthExclusion;
  if (starts)
    if (const Alarm a = check_tip_control_start(words, plan)) return a;
  const bool side = plan.side_before || plan.side_after;
  const bool edge_after = plan.compensation == Compensation::starts || plan.compensation == Compensation::stays;
  if (plan.ends_along && (leading_edge_.active() || edge_after || side)) return alarm::kDirectionFormat;
  if (!plan.along) return alarm::kNone;
  if (attitude_.machine().workpiece_frame() && attitude_.machine().has_table() && (plan.side_after || edge_after))
    return alarm::kCompensationInWorkpiece;
  const bool ijk = words.has_any(Words::set_of("IJK"));
  if (plan.vector) {
    if ((words.axes() & axes_.rotary) != 0) return side ? alarm::kRotaryWord : alarm::kToolDirection;
    if (length == 435 && ijk && attitude_.machine().has_table()) return alarm::kDirectionAtStart;
    if (!ToolAttitude::names_direction(words)) return alarm::kToolDirection;
  }
  if (plan.motion <= 10) return alarm::kNone;
  const Code plane = words.code(Words::kPlane);
  Mask in_plane = 0;
  for (const std::size_t axis : modal_.axes_of(plane == kNone ? modal_.plane() : plane_of(plane)))
    if (axis != spec::Axes::kNone) in_plane = static_cast<Mask>(in_plane | bit(axis));
  const bool turns_alone = (words.axes() & axes_.linear) == 0 &&
                           (plan.vector ? ijk : (words.axes() & axes_.rotary) != 0 && !words.has_any(kArcLetters));
  if (turns_alone || (plan.vector && (words.axes() & in_plane) != 0 && !words.has('R'))) return alarm::kTipControlArc;
  return alarm::kNone;
}

Alarm Interpreter::check_tip_control_start(const Words& words, const Plan& plan) const {
  if (positions_.length().live() != 0) return alarm::kLengthExclusion;
  const bool vector = plan.vector;
  if (!vector && !attitude_.machine().defined()) return alarm::kTipControl;
  if (vector && attitude_.machine().defined() && attitude_.machine().workpiece_frame()) return alarm::kTipControl;
  if (words.has('P') && words.code(Words::kOneShot) == kNone && whole_number(words['P'], 1) > 1)
    return alarm::kTipControlWord;
  if (vector && attitude_.machine().defined()) {
    if (!attitude_.machine().invertible()) return alarm::kTipControl;
    if (!attitude_.machine().ranges_valid()) return alarm::kRotaryLimits;
  }
  if (leading_edge_.active() || plan.compensation == Compensation::starts || plan.side_before || plan.side_after ||
      plan.motion > 10)
    return alarm::kDirectionFormat;
  return alarm::kNone;
}

}  // namespace toolcomp::fast

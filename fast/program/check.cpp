// The alarms of commands, in the order of the specification (clause fanuc.program.alarm-order).
#include "fast/fault.h"
#include "fast/program/interpreter.h"

namespace toolcomp::fast {
namespace {

constexpr std::uint32_t kDirectionLetters = Words::set_of("IJK");
constexpr std::uint32_t kAuxiliaryLetters = Words::set_of("MST");

}  // namespace

Alarm Interpreter::check(const Words& words, Plan& plan) const {
  const Code one_shot = words.code(Words::kOneShot);
  const std::uint32_t list = words.has('L') ? whole_number(words['L'], 99) : 100;
  if (one_shot == 100 && !memory_.has_list(list)) return alarm::kUnknownList;

  if (words.has('H') && whole_number(words['H'], memory_.count()) > memory_.count()) return alarm::kOffsetNumber;
  plan.d = words.has('D') ? whole_number(words['D'], memory_.count()) : d_;
  if (plan.d > memory_.count()) return alarm::kOffsetNumber;

  plan.motion = words.code(Words::kMotion) == kNone ? motion_ : words.code(Words::kMotion);
  const Code length = words.code(Words::kLength);
  plan.along = length == 435 || (along_tool() && length != 490);
  plan.ends_along = along_tool() && length == 490;
  const Code code = words.code(Words::kCompensation);
  const bool active = leading_edge_.active();
  // G41 and G42 do not end leading edge offset, they are forbidden in it.
  const bool cutter_code = code == 410 || code == 420;
  plan.cutter = cutter_code || one_shot == 390 || cutter_active();
  const bool after = (code == kNone || (active && cutter_code) ? active : code == 413) && plan.d != 0;
  if (after)
    plan.compensation = active ? Compensation::stays : Compensation::starts;
  else
    plan.compensation = active ? Compensation::cancels : Compensation::off;

  if (length == 435 || along_tool())
    if (const Alarm a = check_tool_direction(words, plan)) return a;
  if (active || code == 413)
    if (const Alarm a = check_leading_edge(words, plan)) return a;
  if (plan.cutter)
    if (const Alarm a = check_cutter(words, plan)) return a;

  if (one_shot == 100) {
    const std::uint32_t number = words.has('P') ? whole_number(words['P'], memory_.count()) : 0;
    plan.writes = words.has('R');
    // R counts in the units and the mode (G90, G91) of this block.
    const bool inch = words.code(Words::kUnits) == kNone ? inch_program_ : words.code(Words::kUnits) == 200;
    const bool add = words.code(Words::kDistance) == kNone ? incremental_ : words.code(Words::kDistance) == 910;
    plan.write = memory_.plan(list, number, plan.writes ? value(words['R'], true, inch) : Count(), add);
    if (plan.write.alarm) return plan.write.alarm;
  }
  if (one_shot == 300 && words.axes() != 0 && reference_point(words) == 0) return alarm::kReferenceNumber;
  return alarm::kNone;
}

Alarm Interpreter::check_tool_direction(const Words& words, const Plan& plan) const {
  const Code length = words.code(Words::kLength);
  const Code one_shot = words.code(Words::kOneShot);
  const bool ijk = words.has_any(kDirectionLetters);
  const bool forbidden = one_shot != kNone && one_shot != 40 && one_shot != 100;
  const bool cutter = words.code(Words::kCompensation) == 410 || words.code(Words::kCompensation) == 420;
  if (plan.along && (forbidden || cutter || words.code(Words::kWorkpiece) != kNone))
    return alarm::kForbiddenUnderDirection;
  if (along_tool() && (length == 430 || length == 440)) return alarm::kLengthExclusion;
  if (length == 435 && length_.live() != 0) return alarm::kLengthExclusion;
  if (length == 435 && (kinematics_.type() == 12 || kinematics_.type() == 21 || head_offsets_))
    return alarm::kKinematics;
  if (plan.along && words.has('Q')) return alarm::kLeanAngle;
  if ((length == 435 || plan.ends_along) && (leading_edge_.active() || plan.compensation == Compensation::starts))
    return alarm::kDirectionFormat;
  if (plan.along && plan.motion > 10 && (length == 435 || ijk)) return alarm::kDirectionFormat;
  if (plan.along && (words.axes() & rotary_) != 0) return alarm::kToolDirection;
  const auto zero = [&](char letter) { return !words.has(letter) || words[letter].is_zero(); };
  if (plan.along && ijk && zero('I') && zero('J') && zero('K')) return alarm::kToolDirection;
  return alarm::kNone;
}

Alarm Interpreter::check_leading_edge(const Words& words, const Plan& plan) const {
  const bool active = leading_edge_.active();
  const bool code = words.code(Words::kCompensation) == 413;
  const bool moves = words.axes() != 0 || (plan.along && words.has_any(kDirectionLetters));
  // The format of a G41.3 block counts where it starts nothing too: with D0, or in the mode.
  if (code && (moves || words.suppresses_look_ahead())) return alarm::kLeadingEdgeFormat;
  if (plan.compensation == Compensation::cancels && moves) return alarm::kLeadingEdgeFormat;
  if (code && plan.motion > 10) return alarm::kLeadingEdgeStart;
  if (active && (code || plan.motion > 10)) return alarm::kLeadingEdgeCommand;
  if (active && (words.code(Words::kCompensation) == 410 || words.code(Words::kCompensation) == 420))
    return alarm::kForbiddenInCompensation;
  if (plan.compensation != Compensation::starts && plan.compensation != Compensation::stays) return alarm::kNone;
  if (words.code(Words::kOneShot) != kNone || words.code(Words::kWorkpiece) != kNone ||
      words.code(Words::kUnits) != kNone || (moves && words.has_any(kAuxiliaryLetters)))
    return alarm::kForbiddenInCompensation;
  if (plan.compensation == Compensation::starts || words.has('D'))
    if (!memory_.fits(memory_.d(plan.d))) return alarm::kOffsetValue;
  return alarm::kNone;
}

// The alarms of cutter compensation that words and state alone show (clause fanuc.program.alarm-order).
Alarm Interpreter::check_cutter(const Words& words, const Plan& plan) const {
  const Code code = words.code(Words::kCompensation);
  const Code one_shot = words.code(Words::kOneShot);
  const Code plane = words.code(Words::kPlane);
  const bool active = cutter_active();
  const bool on = is_b_ ? cutter_b_.active() : cutter_c_.on();
  if (on && (code == 413 || words.code(Words::kLength) == 435)) return alarm::kForbiddenInCutterCompensation;
  const spec::Plane selected = plane == kNone ? plane_ : plane_of(plane);
  if (on && selected != plane_) return alarm::kPlaneChange;
  if (on && one_shot >= 450 && one_shot <= 480) return alarm::kToolOffsetInCutter;

  const std::optional<OffsetNumber> commanded = commanded_number(words);
  CutterCommand command;
  command.word = cutter_side(code);
  command.corner_arc = one_shot == 390;
  const std::array<std::size_t, 2> axis = plane_axes(selected);
  for (std::size_t i = 0; i < 2; ++i) {
    command.plane_word |= axis[i] != spec::Axes::kNone && (words.axes() & bit(axis[i])) != 0;
    command.direction |= words.has(direction_letter(selected, i));
  }
  command.axis_word = words.axes() != 0;
  command.arc = plan.motion > 10 && one_shot == kNone &&
                (command.plane_word || words.has('R') || words.has_any(kDirectionLetters));
  command.d_word = commanded.has_value();
  command.d = commanded.value_or(cutter_number_).number;
  if (const Alarm a = is_b_ ? cutter_b_.check(command) : cutter_c_.check(command)) return a;

  // The value is applied where the number is commanded, where compensation starts, and after an edit.
  if (commanded || !active || (evr_ && cutter_edited_))
    if (!memory_.fits(cutter_value(commanded.value_or(cutter_number_)))) return alarm::kOffsetValue;
  return alarm::kNone;
}

// The index of the reference position that G28, G30 or G30.1 means; 0 where P of G30 means none.
std::uint32_t Interpreter::reference_point(const Words& words) const {
  if (words.code(Words::kOneShot) != 300) return words.code(Words::kOneShot) == 280 ? 1 : 0;
  const std::uint32_t point = words.has('P') ? whole_number(words['P'], 4) : 2;
  return point >= 2 && point <= 4 ? point : 0;
}

}  // namespace toolcomp::fast

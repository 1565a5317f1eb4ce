// The alarms of commands, in the order of the specification (clause fanuc.program.alarm-order).
#include <bit>

#include "fast/basis/fault.h"
#include "fast/fanuc/interpreter/interpreter.h"

namespace toolcomp::fast {
namespace {

constexpr std::uint32_t kDirectionLetters = Words::set_of("IJK");
constexpr std::uint32_t kAuxiliaryLetters = Words::set_of("MST");

}  // namespace

Alarm Interpreter::check(const Words& words, Plan& plan) const {
  const Code one_shot = words.code(Words::kOneShot);
  const Code code = words.code(Words::kCompensation);
  const bool cutter_code = code == 410 || code == 420;
  // Three-dimensional tool compensation is not built.
  if (cutter_code && !is_b_ && words.has('I') && words.has('J') && words.has('K')) return alarm::kUnknownCode;
  const std::uint32_t list = words.has('L') ? whole_number(words['L'], 99) : 100;
  if (one_shot == 100 && !memory_.has_list(list)) return alarm::kUnknownList;

  if (words.has('H') && whole_number(words['H'], memory_.count()) > memory_.count()) return alarm::kOffsetNumber;
  plan.d = words.has('D') ? whole_number(words['D'], memory_.count()) : d_;
  if (plan.d > memory_.count()) return alarm::kOffsetNumber;

  plan.motion = words.code(Words::kMotion) == kNone ? modal_.motion() : words.code(Words::kMotion);
  const Code length = words.code(Words::kLength);
  plan.along = words.starts_tip_control() || (positions_.along_tool() && length != 490);
  plan.vector = length == 435 || (modal_.by_vector() && length != 434 && length != 490);
  plan.ends_along = positions_.along_tool() && (length == 490 || words.starts_tip_control());
  const bool active = leading_edge_.active();
  // G41 and G42 do not end leading edge offset, they are forbidden in it; with number 0 it ends.
  plan.cutter = cutter_code || one_shot == 390 || cutter_active();
  const bool after =
      (code == kNone || (active && (cutter_code || is_tool_side(code))) ? active : code == 413) && plan.d != 0;
  if (after)
    plan.compensation = active ? Compensation::stays : Compensation::starts;
  else
    plan.compensation = active ? Compensation::cancels : Compensation::off;

  const CutterSide side = tool_side(code) == CutterSide::unchanged ? tool_side_word_ : tool_side(code);
  plan.side_before = tool_side_on();
  plan.side_after = side != CutterSide::off && cutter_value_.number_after(words).number != 0;

  if (words.starts_tip_control() || positions_.along_tool())
    if (const Alarm a = check_tip_control(words, plan)) return a;
  if (active || code == 413)
    if (const Alarm a = check_leading_edge(words, plan)) return a;
  if (plan.side_before || plan.side_after || is_tool_side(code))
    if (const Alarm a = check_tool_side(words, plan)) return a;
  if (plan.cutter)
    if (const Alarm a = check_cutter(words, plan)) return a;

  if (one_shot == 370)
    if (const Alarm a = check_measurement(words)) return a;
  if (one_shot == 100) {
    const std::uint32_t number = words.has('P') ? whole_number(words['P'], memory_.count()) : 0;
    plan.writes = words.has('R');
    // R counts in the units and the mode (G90, G91) of this block.
    const bool inch = words.code(Words::kUnits) == kNone ? units_.inch() : words.code(Words::kUnits) == 200;
    const bool add = words.code(Words::kDistance) == kNone ? modal_.incremental() : words.code(Words::kDistance) == 910;
    // Without R nothing is stored: 0 in its place passes every range.
    plan.write =
        memory_.plan(list, number, plan.writes ? units_.value(words['R'], true, inch) : Count(), plan.writes && add);
    if (plan.write.alarm) return plan.write.alarm;
  }
  if (one_shot == 300 && words.axes() != 0 && reference_point(words) == 0) return alarm::kReferenceNumber;
  return alarm::kNone;
}

Alarm Interpreter::check_leading_edge(const Words& words, const Plan& plan) const {
  const bool active = leading_edge_.active();
  const bool code = words.code(Words::kCompensation) == 413;
  const bool moves = words.axes() != 0 || (plan.vector && words.has_any(kDirectionLetters));
  // The format of a G41.3 block counts where it starts nothing too: with D0, or in the mode.
  if (code && (moves || words.suppresses_look_ahead())) return alarm::kLeadingEdgeFormat;
  if (plan.compensation == Compensation::cancels && moves) return alarm::kLeadingEdgeFormat;
  if (code && plan.motion > 10) return alarm::kLeadingEdgeStart;
  if (active && (code || plan.motion > 10)) return alarm::kLeadingEdgeCommand;
  if (plan.compensation != Compensation::starts && plan.compensation != Compensation::stays) return alarm::kNone;
  const Code compensation = words.code(Words::kCompensation);
  if (compensation == 410 || compensation == 420 || is_tool_side(compensation)) return alarm::kForbiddenInCompensation;
  if (words.code(Words::kOneShot) != kNone || words.code(Words::kWorkpiece) != kNone ||
      words.code(Words::kUnits) != kNone || (moves && words.has_any(kAuxiliaryLetters)))
    return alarm::kForbiddenInCompensation;
  if (plan.compensation == Compensation::starts || words.has('D'))
    if (!memory_.fits(memory_.d(plan.d))) return alarm::kOffsetValue;
  return alarm::kNone;
}

// The alarms of tool side compensation that words and state alone show (clause fanuc.program.alarm-order).
Alarm Interpreter::check_tool_side(const Words& words, const Plan& plan) const {
  const Code code = words.code(Words::kCompensation);
  const Code plane = words.code(Words::kPlane);
  const spec::Plane selected = plane == kNone ? modal_.plane() : plane_of(plane);
  const bool before = plan.side_before;
  const bool after = plan.side_after;
  if (is_tool_side(code) && (code == 412 || code == 422) == plan.vector) return alarm::kToolSideMode;
  if (before && selected != modal_.plane()) return alarm::kPlaneChange;

  const bool letters = words.has_any(kDirectionLetters);
  const bool moves = words.axes() != 0 || (plan.vector && letters);
  Mask in_plane = 0;
  for (const std::size_t axis : modal_.axes_of(selected))
    if (axis != spec::Axes::kNone) in_plane = static_cast<Mask>(in_plane | bit(axis));
  const bool arc = plan.motion > 10 && words.code(Words::kOneShot) == kNone &&
                   ((words.axes() & in_plane) != 0 || words.has('R') || letters);
  if (after && (words.code(Words::kWorkpiece) != kNone || words.code(Words::kUnits) != kNone ||
                ((moves || arc) && words.has_any(kAuxiliaryLetters))))
    return alarm::kForbiddenInCompensation;
  if ((before || after) && words.code(Words::kOneShot) != kNone) return alarm::kForbiddenInCompensation;
  if (before && (code == 410 || code == 420 || code == 413)) return alarm::kForbiddenInCompensation;
  if (after && words.has('Q') && (whole_number(words['Q'], 3) > 3 || words['Q'].is_zero())) return alarm::kTreatment;

  if (tool_side_.type() == StartType::c) {
    const bool starts = after && !before;
    if ((starts || (before && !after)) && (moves || plan.motion > 10 || (starts && words.suppresses_look_ahead())))
      return alarm::kTypeCFormat;
  } else if (arc && after != tool_side_.active()) {
    return alarm::kArcAtStartOrCancel;
  }

  // The value is read where the number is given, where a code comes into force, and after an edit.
  const std::optional<CutterValue::Number> commanded = cutter_value_.commanded(words);
  const bool reads = commanded || (after && tool_side_word_ == CutterSide::off) || cutter_value_.takes_edited();
  if (after && reads && !memory_.fits(cutter_value_.of(cutter_value_.number_after(words)))) return alarm::kOffsetValue;
  return alarm::kNone;
}

// The alarms of cutter compensation that words and state alone show (clause fanuc.program.alarm-order).
Alarm Interpreter::check_cutter(const Words& words, const Plan& plan) const {
  const Code code = words.code(Words::kCompensation);
  const Code one_shot = words.code(Words::kOneShot);
  const Code plane = words.code(Words::kPlane);
  const bool on = cutter_on();
  const CutterSide word = cutter_side(code);
  const bool in_force = cutter_in_force(words);
  const spec::Plane selected = plane == kNone ? modal_.plane() : plane_of(plane);
  const std::array<std::size_t, 2> axis = modal_.axes_of(selected);
  if (in_force && (axis[0] == spec::Axes::kNone || axis[1] == spec::Axes::kNone)) return alarm::kPlaneAxis;
  if (on && selected != modal_.plane()) return alarm::kPlaneChange;
  if ((on && (code == 413 || is_tool_side(code))) || ((on || in_force) && words.starts_tip_control()))
    return alarm::kForbiddenInCutterCompensation;
  if (words.is_tool_offset() && (on || cutter_wanted(words))) return alarm::kToolOffsetInCutter;

  const std::optional<CutterValue::Number> commanded = cutter_value_.commanded(words);
  Mask in_plane = 0;
  for (const std::size_t i : axis)
    if (i != spec::Axes::kNone) in_plane = static_cast<Mask>(in_plane | bit(i));
  CutterCommand command;
  command.word = word;
  command.corner_arc = one_shot == 390;
  command.axis_word = words.axes() != 0;
  command.plane_word = (words.axes() & in_plane) != 0;
  command.outside_word = (words.axes() & ~in_plane) != 0;
  command.letters_zero = true;
  for (std::size_t i = 0; i < 2; ++i) {
    const char letter = direction_letter(selected, i);
    if (!words.has(letter)) continue;
    command.letters = true;
    command.letters_zero &= words[letter].is_zero();
  }
  command.letters_zero &= command.letters;
  command.no_direction =
      command.letters ? command.letters_zero : (!command.plane_word || stays(words, words.axes() & in_plane));
  command.arc = plan.motion > 10 && one_shot == kNone &&
                (command.plane_word || words.has('R') || words.has_any(kDirectionLetters));
  command.d_word = commanded.has_value();
  command.d = cutter_value_.number_after(words).number;
  if (const Alarm a = is_b_ ? cutter_b_.check(command) : cutter_c_.check(command)) return a;

  // The value is read where the number is given, where G41 or G42 comes into force, and after an edit.
  const bool reads = commanded || (in_force && cutter_side_ == CutterSide::off) || cutter_value_.takes_edited();
  if (in_force && reads && !memory_.fits(cutter_value_.of(cutter_value_.number_after(words))))
    return alarm::kOffsetValue;
  return alarm::kNone;
}

// The alarms of G37, in their order.
Alarm Interpreter::check_measurement(const Words& words) const {
  if (words.has('H')) return alarm::kMeasurementNumberInBlock;
  if (positions_.length().number() == 0) return alarm::kMeasurementNumberZero;
  const bool add = words.code(Words::kDistance) == kNone ? modal_.incremental() : words.code(Words::kDistance) == 910;
  if (add || std::popcount(words.axes()) != 1 || (words.axes() & axes_.linear) == 0) return alarm::kMeasurementAxis;
  if (words.code(Words::kLength) != kNone) return alarm::kMeasurementFormat;
  if (cutter_on() || cutter_wanted(words)) return alarm::kMeasurementInCutter;
  return measurement_.parameters();
}

// Whether the axis words in `axes` name the position at which the axes stand, or in G91 no travel.
bool Interpreter::stays(const Words& words, unsigned axes) const {
  const bool add = words.code(Words::kDistance) == kNone ? modal_.incremental() : words.code(Words::kDistance) == 910;
  const bool inch = words.code(Words::kUnits) == kNone ? units_.inch() : words.code(Words::kUnits) == 200;
  const Code system = words.code(Words::kWorkpiece);
  const std::size_t chosen = system == kNone ? positions_.system() : static_cast<std::size_t>((system - 540) / 10);
  for (; axes != 0; axes &= axes - 1) {
    const auto axis = static_cast<std::size_t>(__builtin_ctz(axes));
    const Count word = units_.value(words.axis(axis), (axes_.linear & bit(axis)) != 0, inch);
    const Count position = positions_.in_system(axis, chosen);
    if (add ? !word.is_zero() : !(word == position)) return false;
  }
  return true;
}

// The index of the reference position that G28, G30 or G30.1 means; 0 where P of G30 means none.
std::uint32_t Interpreter::reference_point(const Words& words) const {
  if (words.code(Words::kOneShot) != 300) return words.code(Words::kOneShot) == 280 ? 1 : 0;
  const std::uint32_t point = words.has('P') ? whole_number(words['P'], 4) : 2;
  return point >= 2 && point <= 4 ? point : 0;
}

}  // namespace toolcomp::fast

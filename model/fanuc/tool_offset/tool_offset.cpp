#include "model/fanuc/tool_offset/tool_offset.h"

#include <algorithm>
#include <utility>

#include "model/basis/alarm.h"
#include "model/geometry/plane.h"

namespace toolcomp::model {
namespace {

bool in(AxisMask mask, std::size_t axis) { return (mask >> axis & 1U) != 0; }

Rational magnitude(const Rational& value) { return value < 0 ? Rational(-value) : value; }
Real magnitude(const Real& value) { return value.sign() == Sign::negative ? -value : value; }

}  // namespace

ToolOffset::ToolOffset(const spec::Setup& setup, const OffsetMemory& memory, Recorder& recorder)
    : memory_(memory),
      recorder_(recorder),
      axes_(setup.axes),
      by_length_number_(setup.bit(5001, 5) && !setup.bit(5001, 2)),
      offset_(setup, memory, recorder) {}

void ToolOffset::put(Leg& leg) const {
  if (!shifted_) return;
  leg.shift = shift_;
}

Leg ToolOffset::shifted(Leg leg) const {
  put(leg);
  return leg;
}

void ToolOffset::take_away(AxisMask axes) {
  bool taken = false;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (!in(axes, i) || shift_.at(i) == 0) continue;
    shift_.at(i) = 0;
    taken = true;
  }
  recorder_.decide(Clause::fanuc_tool_offset_machine_position, taken);
  shifted_ = std::ranges::any_of(shift_, [](const Rational& shift) { return shift != 0; });
}

Rational ToolOffset::lengthening(const Command& command, const LengthState& length) const {
  const OneShot code = command.codes.one_shot;
  const OffsetNumber number = by_length_number_ ? OffsetNumber{length.number, length.number != 0} : offset_.number();
  const bool by_h = recorder_.decide(Clause::fanuc_tool_offset_number, number.of_h);
  const Rational value = by_h ? memory_.h(number.number) : memory_.d(number.number);
  const bool increase = code == OneShot::increase || code == OneShot::double_increase;
  const bool twice = code == OneShot::double_increase || code == OneShot::double_decrease;
  const Rational once = recorder_.decide(Clause::fanuc_tool_offset_increase, increase) ? value : Rational(-value);
  return recorder_.decide(Clause::fanuc_tool_offset_double, twice) ? once * 2 : once;
}

int ToolOffset::sense(const Command& command, std::size_t axis, const Real& travel) const {
  if (!recorder_.decide(Clause::fanuc_tool_offset_linear_axes, spec::is_linear_axis(axes_.letter(axis)))) return 0;
  const Sign sign = travel.sign();
  if (!recorder_.decide(Clause::fanuc_tool_offset_zero_travel, sign == Sign::zero))
    return recorder_.decide(Clause::fanuc_tool_offset_direction, sign == Sign::positive) ? 1 : -1;
  if (recorder_.decide(Clause::fanuc_tool_offset_zero_travel_absolute, !command.incremental)) return 0;
  const bool minus = command.words.find(axes_.letter(axis))->negative;
  return recorder_.decide(Clause::fanuc_tool_offset_sign_of_zero, minus) ? -1 : 1;
}

void ToolOffset::lengthen(const Command& command, const Interpreter& interpreter, const Rational& by,
                          spec::Arc<Real>& arc, const Leg& leg) const {
  const PlaneLetters in_plane = letters(command.plane);
  const auto to_center = [&](char letter) {
    const spec::Decimal* const word = command.words.find(letter);
    return word == nullptr ? Rational(0) : interpreter.numbers().length(*word);
  };
  const Rational first = to_center(in_plane.first_center);
  const Rational second = to_center(in_plane.second_center);
  const PlanePoint travel = in_plane_of(command.plane, leg.travel);
  const bool along_first = second == 0;  // the centre lies on the first axis of the plane, seen from the start
  const Rational& radius_word = along_first ? first : second;
  const Real& along = travel[along_first ? 0 : 1];
  const Real& across = travel[along_first ? 1 : 0];
  const bool allowed = !command.words.has('R') && (first == 0) != (second == 0) && along == Real(radius_word) &&
                       magnitude(across) == Real(magnitude(radius_word));
  if (!recorder_.decide(Clause::fanuc_tool_offset_arc_form, allowed))
    throw Alarm("G45_ARC", "G45 to G48 with an arc that is no quarter or three-quarter circle by I J K");

  recorder_.reach(Clause::fanuc_tool_offset_arc);
  const Rational radius = magnitude(radius_word);
  const Sign side =
      recorder_.decide(Clause::fanuc_tool_offset_arc_radius, Real(radius + by), Real(radius + magnitude(by)));
  if (side == Sign::negative) throw Alarm("PS0038", "G45 to G48 make the radius of the arc smaller than zero");
  if (side == Sign::zero) arc.sweep.reset();
  arc.radius.reset();
  const std::size_t axis = axes_.index(along_first ? in_plane.first : in_plane.second);
  arc.center.set(axis, arc.center[axis] + Real(radius_word < 0 ? Rational(-by) : by));
}

void ToolOffset::apply(const Command& command, const Interpreter& interpreter, const LengthState& length,
                       std::vector<Leg>& legs) {
  offset_.take(command.codes);
  const std::array<Rational, spec::kMaxAxes> before = shift_;
  const bool was_shifted = shifted_;
  if (is_tool_offset(command.codes.one_shot)) {
    if (by_length_number_ && length.active)
      raise(recorder_, Clause::fanuc_tool_offset_number_by_h, "G45_LENGTH_OFFSET",
            "G45 to G48 by H number while G43 or G44 is in force");
    if (command.axes == 0) {
      recorder_.reach(Clause::fanuc_tool_offset_without_axis_word);
      if (!legs.empty() && legs.front().arc) {
        recorder_.decide(Clause::fanuc_tool_offset_arc_form, false);
        throw Alarm("G45_ARC", "G45 to G48 with a full circle");
      }
    } else {
      recorder_.reach(Clause::fanuc_tool_offset_travel);
      const Rational by = lengthening(command, length);
      Leg& leg = legs.front();
      if (leg.arc) lengthen(command, interpreter, by, *leg.arc, leg);
      for (std::size_t i = 0; i < axes_.size(); ++i) {
        if (!in(command.axes, i)) continue;
        const Real travel = (leg.end.at(i) - interpreter.position().at(i)).value();
        const int sense_of_travel = sense(command, i, travel);
        if (sense_of_travel == 0) continue;
        recorder_.decide(Clause::fanuc_tool_offset_reversal, (magnitude(travel) + Real(by)).sign() == Sign::negative);
        shift_.at(i) += sense_of_travel * by;
      }
      shifted_ = std::ranges::any_of(shift_, [](const Rational& shift) { return shift != 0; });
    }
  }
  if (!was_shifted && !shifted_) return;

  for (Leg& leg : legs) {
    // A reference return keeps the shift up to its intermediate point.
    if (&leg == &legs.back() && goes_by_machine_coordinates(command.codes.one_shot)) take_away(command.axes);
    put(leg);
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      const char letter = axes_.letter(i);
      if (is_space_axis(letter)) component(leg.travel, space_index(letter)) += Real(shift_.at(i) - before.at(i));
      if (leg.arc && leg.arc->center.has(i)) leg.arc->center.set(i, leg.arc->center[i] + Real(before.at(i)));
    }
  }
}

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_offset/tool_offset.h"

#include "model/basis/alarm.h"
#include "model/geometry/plane.h"

namespace toolcomp::model {
// fanuc.tool-offset.travel: In a block with G45, G46, G47 or G48 the travel of every linear axis named is made longer
// or shorter by the offset value or by twice the offset value, on every axis alike. In G90 the travel is the one from
// the programmed position before the block to the commanded one.
Rational ToolOffset::lengthening(OneShot code, const Rational& value) const {
  const bool increase = code == OneShot::increase || code == OneShot::double_increase;
  const bool twice = code == OneShot::double_increase || code == OneShot::double_decrease;
  // fanuc.tool-offset.increase: G45 and G47 increase the travel by the offset, G46 and G48 decrease it. With a negative
  // offset it is the other way round.
  const Rational once = recorder_.decide(Clause::fanuc_tool_offset_increase, increase) ? value : Rational(-value);
  // fanuc.tool-offset.double: G47 and G48 count the offset twice.
  return recorder_.decide(Clause::fanuc_tool_offset_double, twice) ? once * 2 : once;
}

// fanuc.tool-offset.direction: The travel keeps its sense: the offset is added to its magnitude.
Rational ToolOffset::shift_by(const Command& command, char axis, const Real& travel, const Rational& by) const {
  // fanuc.tool-offset.linear-axes: The linear axes X Y Z U V W take the offset; a rotary axis in the block moves as
  // programmed.
  if (!recorder_.decide(Clause::fanuc_tool_offset_linear_axes, spec::is_linear_axis(axis))) return 0;
  const Sign sign = travel.sign();
  int sense = 0;
  // fanuc.tool-offset.zero-travel: With a travel of zero in G91 the axis moves by the offset alone. In G90 a commanded
  // position that is the programmed one does not move the axis, and the shift stays.
  // fanuc.tool-offset.zero-travel-absolute: A travel of zero does nothing in G90, and moves by the offset in G91.
  if (!recorder_.decide(Clause::fanuc_tool_offset_zero_travel, sign == Sign::zero))
    sense = recorder_.decide(Clause::fanuc_tool_offset_direction, sign == Sign::positive) ? 1 : -1;
  else if (recorder_.decide(Clause::fanuc_tool_offset_zero_travel_absolute, !command.incremental))
    return 0;
  // fanuc.tool-offset.sign-of-zero: In G91 the sign written before a zero is the sense of the travel: X0 is positive,
  // X-0 negative.
  else
    sense = recorder_.decide(Clause::fanuc_tool_offset_sign_of_zero, command.words.find(axis)->negative) ? -1 : 1;
  // fanuc.tool-offset.reversal: If the travel is decreased below zero, the axis goes in the opposite sense.
  recorder_.decide(Clause::fanuc_tool_offset_reversal, (magnitude(travel) + Real(by)).sign() == Sign::negative);
  return sense * by;
}

// fanuc.tool-offset.arc: On an arc the radius changes with the end point. The component I, J or K that gives the
// centre, and both components of the end in the plane, are lengthened alike. The tool's arc begins where the tool
// stands. It has the direction and the sweep of the programmed arc, and one radius. An axis out of the plane goes by
// the rule for straight moves.
void ToolOffset::lengthen_arc(const Command& command, const Numbers& numbers, const Rational& by, Leg& leg) const {
  const PlaneLetters in_plane = letters(command.plane);
  const Rational first = numbers.length(command.words.find(in_plane.first_center));
  const Rational second = numbers.length(command.words.find(in_plane.second_center));
  const PlanePoint end = in_plane_of(command.plane, leg.travel);
  const bool along_first = second == 0;  // the centre lies on the first axis of the plane, seen from the start
  const Rational& radius_word = along_first ? first : second;
  const Real& along = end[along_first ? 0 : 1];
  const Real& across = end[along_first ? 1 : 0];
  const bool allowed = !command.words.has('R') && (first == 0) != (second == 0) && along == Real(radius_word) &&
                       magnitude(across) == Real(abs(radius_word));
  // fanuc.tool-offset.arc-form: Only quarter and three-quarter circles given by I J K are allowed. Of the two letters
  // of the plane exactly one is not zero, its value is the component of the end on its axis, and the other component
  // has the same magnitude. Any other arc, R and full circles included, raises G45_ARC, after the alarms of the arc
  // itself (PS0022, PS0020).
  if (!recorder_.decide(Clause::fanuc_tool_offset_arc_form, allowed)) throw Alarm(AlarmCause::tool_offset_arc);

  recorder_.reach(Clause::fanuc_tool_offset_arc);
  const Rational radius = abs(radius_word);
  // fanuc.tool-offset.arc-radius: If the offset would make the radius smaller than zero, PS0038 is raised. A radius of
  // exactly zero is an arc whose ends lie in its centre, without a sweep.
  const Sign side = recorder_.decide(Clause::fanuc_tool_offset_arc_radius, Real(radius + by), Real(radius + abs(by)));
  if (side == Sign::negative) throw Alarm(AlarmCause::arc_ends_in_center);
  spec::Arc<Real>& arc = *leg.arc;
  if (side == Sign::zero) arc.sweep.reset();
  arc.radius.reset();
  const std::size_t axis = axes_.index(along_first ? in_plane.first : in_plane.second);
  arc.center.set(axis, arc.center[axis] + Real(radius_word < 0 ? Rational(-by) : by));
}

}  // namespace toolcomp::model

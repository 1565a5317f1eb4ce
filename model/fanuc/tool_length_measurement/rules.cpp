// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_length_measurement/rules.h"

#include "model/basis/alarm.h"

namespace toolcomp::model {
namespace {

// The parameter, or a length given in mm.
Rational length_parameter(const spec::Setup& setup, std::uint32_t number, int mm) {
  if (const auto given = setup.parameter(number)) return plain(*given);
  return setup.units == spec::Units::mm ? Rational(mm) : Rational(mm) / Rational(254, 10);
}

}  // namespace

void ToolLengthMeasurement::read(const Command& command, std::uint32_t number, bool cutter) const {
  const Codes& codes = command.codes;
  // fanuc.length-measurement.number-in-block: An H word in the block with G37 raises PS0082, whatever OFH says and
  // whatever else the block has (G43, G44 and G49 too). The number must be given in an earlier block.
  if (codes.h)
    raise(recorder_, Clause::fanuc_length_measurement_number_in_block, AlarmCause::measurement_number_in_block);
  // fanuc.length-measurement.number-zero: G37 raises PS0081 if the H number of the length offset is 0. This is the
  // number that fanuc.length-offset.one-number keeps. G43 or G44 need not be in force.
  if (number == 0)
    raise(recorder_, Clause::fanuc_length_measurement_number_zero, AlarmCause::measurement_without_number);
  const bool one_axis = std::popcount(command.axes) == 1 && spec::is_linear_axis(axes_.letter(axis(command)));
  // fanuc.length-measurement.axis: G37 needs exactly one axis word, of a linear axis, and G90 in force. No axis word,
  // two or more, a rotary axis, and G91 raise PS0083. That U V W count like the fourth axis of the manual is our
  // definition.
  if (!one_axis || command.incremental)
    raise(recorder_, Clause::fanuc_length_measurement_axis, AlarmCause::measurement_axis);
  // fanuc.length-measurement.with-length-code: G43, G44 or G49 in the block with G37 raises MEASUREMENT_FORMAT, if the
  // block raises none of PS0082, PS0081 and PS0083.
  if (codes.length && !is_tip_control(*codes.length))
    raise(recorder_, Clause::fanuc_length_measurement_with_length_code, AlarmCause::measurement_format);
  // fanuc.length-measurement.in-cutter-compensation: G37 raises PS0036 if cutter compensation B or C is on
  // (fanuc.cutter.on) before or after the block. The other code that moves up to a signal raises it too.
  if (cutter)
    raise(recorder_, Clause::fanuc_length_measurement_in_cutter_compensation,
          AlarmCause::measurement_in_cutter_compensation);
  const bool ordered = deceleration_ > half_zone_ && half_zone_ >= 0 && (!feed_ || *feed_ > 0);
  // fanuc.length-measurement.parameters-in-order: 6251 > 6254 >= 0 must hold, and 6241 must be above 0 if the setup
  // gives it. Otherwise G37 raises MEASUREMENT_PARAMETERS. Setups of programs without G37 may have other values.
  if (recorder_.decide(Clause::fanuc_length_measurement_parameters_in_order, !ordered))
    throw Alarm(AlarmCause::measurement_parameters);
}

// fanuc.length-measurement.feed: 6241 is the measuring feed, in setup units per minute. The second move carries it, and
// F in force stays what it is. If the setup does not give 6241, the second move carries F in force, as other straight
// moves do (our definition).
std::optional<Rational> ToolLengthMeasurement::feed() const {
  return recorder_.decide(Clause::fanuc_length_measurement_feed, feed_.has_value()) ? feed_ : std::nullopt;
}

// fanuc.length-measurement.zones: 6251 is the distance before the commanded coordinate at which the measuring feed
// begins. 6254 is half the width of the zone around that coordinate in which the signal is expected. Both are in setup
// units. If the setup does not give them, they are 20 mm and 5 mm, in inch setups the same lengths (20/25.4 and 5/25.4
// inch). That inch setups take the same lengths is our definition.
ToolLengthMeasurement::ToolLengthMeasurement(const spec::Setup& setup, Recorder& recorder)
    : recorder_(recorder),
      axes_(setup.axes),
      deceleration_(length_parameter(setup, 6251, 20)),
      half_zone_(length_parameter(setup, 6254, 5)) {
  if (const auto feed = setup.parameter(6241)) feed_ = plain(*feed);
  for (const auto& [letter, position] : setup.measurement)
    if (axes_.has(letter)) signal_.at(axes_.index(letter)) = plain(position);
}

// fanuc.length-measurement.coordinate: All coordinates of the measurement are programmed coordinates of the axis in the
// workpiece system in force. They are the position of the axis less its length offset in force in this block and less
// the shift of G45 to G48. An edited value, or a vector, that comes into force in this block by EVO is included. So a
// length offset that is right and in force measures a difference of 0. While none is in force, the usual case when H
// alone gives the number, the coordinates are the position of the axis itself.
// fanuc.length-measurement.signal: The approach-end signal comes on when the axis reaches the position T that
// [measurement] of the setup gives for it. T is in coordinates of the workpiece system in force (G54 to G59 and G92
// included), without offsets. From T on in the direction of the motion the signal stays on. T is the position of the
// axis itself, under G43 and G44 too. The signal is not looked at before the measuring part. If the setup has no entry
// for the axis, the signal never comes.
std::optional<Real> ToolLengthMeasurement::signal(std::size_t axis, const Leg& leg, int sense,
                                                  const Rational& length) const {
  const std::optional<Rational>& position = signal_.at(axis);
  if (!recorder_.decide(Clause::fanuc_length_measurement_signal, position.has_value())) return std::nullopt;
  return sense * (Coordinate(Rational(*position - length - leg.shift_of(axis))) - leg.end.at(axis)).value();
}

// fanuc.length-measurement.start-on-the-coordinate: If the block starts on the commanded coordinate (A = D), there is
// no direction of measuring. The run then ends undecided, without a move.
int ToolLengthMeasurement::sense(const Real& travel) const {
  const Sign ahead = travel.sign();
  if (recorder_.decide(Clause::fanuc_length_measurement_start_on_the_coordinate, ahead == Sign::zero))
    throw LeftOpen(Clause::fanuc_length_measurement_start_on_the_coordinate,
                   "G37 starts on the commanded coordinate, so there is no direction in which to measure");
  return ahead == Sign::positive ? 1 : -1;
}

// fanuc.length-measurement.rapid-part: The axis goes in rapid traverse to B. If A is B or lies between B and D, there
// is no rapid part, and the measuring part begins at A (our definition). In this case B is A.
bool ToolLengthMeasurement::has_rapid_part(const Real& a, const Real& scale) const {
  return recorder_.decide(Clause::fanuc_length_measurement_rapid_part, -a - Real(deceleration_), scale) ==
         Sign::positive;
}

// fanuc.length-measurement.signal-from-the-start: If the signal is already on at B, the position reached is B, and
// there is no measuring move.
ToolLengthMeasurement::Stop ToolLengthMeasurement::stop(const std::optional<Real>& signal, const Real& b,
                                                        const Real& scale) const {
  Stop result{half_zone_};
  if (!signal) return result;
  result.measures =
      recorder_.decide(Clause::fanuc_length_measurement_signal_from_the_start, *signal - b, scale) == Sign::positive;
  const Real p = result.measures ? *signal : b;
  // fanuc.length-measurement.too-late: If the signal has not come up to F, the axis stops at F and PS0080 is raised.
  // That F itself is allowed is our definition. If the setup gives no signal, the axis stops at F too.
  if (recorder_.decide(Clause::fanuc_length_measurement_too_late, Real(half_zone_) - p, scale) == Sign::negative)
    return result;
  result.at = p;
  // fanuc.length-measurement.too-early: A signal between B and C raises PS0080. That C itself is allowed is our
  // definition.
  result.in_zone =
      recorder_.decide(Clause::fanuc_length_measurement_too_early, p + Real(half_zone_), scale) != Sign::negative;
  return result;
}

// fanuc.length-measurement.moves: The rapid part is a rapid move of cause programmed that ends at B. The measuring part
// is a linear move of cause measure that ends at the position reached, or at F. Both carry the commanded coordinate in
// `programmed`. `point` is where the move ends (with the shift of G45 to G48), and `axes` adds the length offset in
// force. A block that would have neither part makes the rapid move without travel, because it has an axis word.
Measurement ToolLengthMeasurement::measure(const Command& command, const Position& from, const Leg& leg,
                                           const Rational& length, bool minus) const {
  Measurement result;
  const std::size_t axis = ToolLengthMeasurement::axis(command);
  const Coordinate& commanded = leg.end.at(axis);
  const Real travel = (commanded - from.at(axis)).value();
  const int s = sense(travel);
  const Real a = -magnitude(travel);
  const std::optional<Rational>& position = signal_.at(axis);
  const Real scale = magnitude(commanded.value()) + magnitude(travel) + Real(deceleration_ + half_zone_) +
                     (position ? magnitude(*position) : Real(0)) + magnitude(length) + magnitude(leg.shift_of(axis));
  const bool rapid = has_rapid_part(a, scale);
  const Real b = rapid ? Real(-deceleration_) : a;
  const Stop stop = this->stop(signal(axis, leg, s, length), b, scale);
  // A start at an irrational place (behind G43.5) on which the signal is on already: no number of a memory is
  // irrational.
  if (!b.is_rational() && !stop.measures) throw exact::Undecided();

  const auto stops_at = [&](spec::MoveType type, spec::Cause cause, const Rational& along) {
    Leg part = leg;
    part.type = type;
    part.cause = cause;
    if (!part.shift) part.shift.emplace();
    part.shift->at(axis) += s * along;
    result.legs.push_back(part);
  };
  if (rapid || !stop.measures) stops_at(spec::MoveType::rapid, spec::Cause::programmed, b.rational());
  if (stop.measures) stops_at(spec::MoveType::linear, spec::Cause::measure, stop.at.rational());
  result.difference = s * stop.at.rational();
  result.in_zone = stop.in_zone;
  if (!result.in_zone) return result;
  // fanuc.length-measurement.value: The coordinate reached less the commanded one is added to the offset of the H
  // number.
  recorder_.reach(Clause::fanuc_length_measurement_value);
  // fanuc.length-measurement.sign: The same formula holds under G44. The manual makes no exception, though the offset
  // then does not reach the position touched.
  recorder_.decide(Clause::fanuc_length_measurement_sign, minus);
  return result;
}

}  // namespace toolcomp::model

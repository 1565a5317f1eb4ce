#include "model/fanuc/tool_length_measurement/tool_length_measurement.h"

#include <bit>

#include "model/basis/alarm.h"

namespace toolcomp::model {
namespace {

// The parameter, or a length given in mm.
Rational length_parameter(const spec::Setup& setup, std::uint32_t number, int mm) {
  if (const auto given = setup.parameter(number)) return plain(*given);
  return setup.units == spec::Units::mm ? Rational(mm) : Rational(mm) / Rational(254, 10);
}

Real magnitude(const Real& value) { return value.sign() == Sign::negative ? -value : value; }

bool sets_length_offset(const std::optional<LengthCode>& code) {
  return code == LengthCode::plus || code == LengthCode::minus || code == LengthCode::cancel;
}

}  // namespace

ToolLengthMeasurement::ToolLengthMeasurement(const spec::Setup& setup, Recorder& recorder)
    : recorder_(recorder),
      axes_(setup.axes),
      deceleration_(length_parameter(setup, 6251, 20)),
      half_zone_(length_parameter(setup, 6254, 5)) {
  if (const auto feed = setup.parameter(6241)) feed_ = plain(*feed);
  for (const auto& [letter, position] : setup.measurement)
    if (axes_.has(letter)) signal_.at(axes_.index(letter)) = plain(position);
}

void ToolLengthMeasurement::read(const Command& command, std::uint32_t number, bool cutter) const {
  const Codes& codes = command.codes;
  if (codes.h)
    raise(recorder_, Clause::fanuc_length_measurement_number_in_block, "PS0082", "an H word in the block with G37");
  if (number == 0)
    raise(recorder_, Clause::fanuc_length_measurement_number_zero, "PS0081", "G37 while the H number is 0");
  const bool one_axis = std::popcount(command.axes) == 1 && spec::is_linear_axis(axes_.letter(axis(command)));
  if (!one_axis || command.incremental)
    raise(recorder_, Clause::fanuc_length_measurement_axis, "PS0083",
          "G37 needs G90 and exactly one axis, a linear one");
  if (sets_length_offset(codes.length))
    raise(recorder_, Clause::fanuc_length_measurement_with_length_code, "MEASUREMENT_FORMAT",
          "G43, G44 or G49 in the block with G37");
  if (cutter)
    raise(recorder_, Clause::fanuc_length_measurement_in_cutter_compensation, "PS0036",
          "G37 while cutter compensation is on");
  const bool ordered = deceleration_ > half_zone_ && half_zone_ >= 0 && (!feed_ || *feed_ > 0);
  if (recorder_.decide(Clause::fanuc_length_measurement_parameters_in_order, !ordered))
    throw Alarm("MEASUREMENT_PARAMETERS", "6241, 6251 or 6254 gives no zones for G37");
}

std::size_t ToolLengthMeasurement::axis(const Command& command) const {
  return static_cast<std::size_t>(std::countr_zero(command.axes));
}

std::optional<Rational> ToolLengthMeasurement::feed() const {
  return recorder_.decide(Clause::fanuc_length_measurement_feed, feed_.has_value()) ? feed_ : std::nullopt;
}

Measurement ToolLengthMeasurement::measure(const Command& command, const Position& from, const Leg& leg,
                                           const MeasurementStart& start) const {
  Measurement result;
  result.axis = axis(command);
  const Coordinate& commanded = leg.end.at(result.axis);
  const Real travel = (commanded - from.at(result.axis)).value();
  const Sign ahead = travel.sign();
  if (recorder_.decide(Clause::fanuc_length_measurement_start_on_the_coordinate, ahead == Sign::zero))
    throw LeftOpen(Clause::fanuc_length_measurement_start_on_the_coordinate,
                   "G37 starts on the commanded coordinate: there is no direction to measure in");
  const int s = ahead == Sign::positive ? 1 : -1;

  // Along the motion, counted from the commanded coordinate D: A where the block starts, B where the measuring part
  // begins, the signal, and where the axis stops.
  const Real a = -magnitude(travel);
  const std::optional<Rational>& position = signal_.at(result.axis);
  const Real scale = magnitude(commanded.value()) + magnitude(travel) + Real(deceleration_ + half_zone_) +
                     (position ? magnitude(*position) : Real(0)) + magnitude(start.length) + magnitude(start.shift);
  const bool rapid =
      recorder_.decide(Clause::fanuc_length_measurement_rapid_part, -a - Real(deceleration_), scale) == Sign::positive;
  const Real b = rapid ? Real(-deceleration_) : a;
  bool measures = true;
  Real stop = half_zone_;
  if (recorder_.decide(Clause::fanuc_length_measurement_signal, position.has_value())) {
    const Real comes_on = s * (Coordinate(Rational(*position - start.length - start.shift)) - commanded).value();
    measures =
        recorder_.decide(Clause::fanuc_length_measurement_signal_from_the_start, comes_on - b, scale) == Sign::positive;
    const Real p = measures ? comes_on : b;
    if (recorder_.decide(Clause::fanuc_length_measurement_too_late, Real(half_zone_) - p, scale) != Sign::negative) {
      stop = p;
      result.in_zone =
          recorder_.decide(Clause::fanuc_length_measurement_too_early, p + Real(half_zone_), scale) != Sign::negative;
    }
  }
  // A start at an irrational place (behind G43.5) on which the signal is on already: no number of a memory is
  // irrational.
  if (!b.is_rational() && !measures) throw exact::Undecided();

  const auto stops_at = [&](spec::MoveType type, spec::Cause cause, const Rational& along) {
    Leg move = leg;
    move.type = type;
    move.cause = cause;
    if (!move.shift) move.shift.emplace();
    move.shift->at(result.axis) += s * along;
    result.legs.push_back(move);
  };
  if (rapid || !measures) stops_at(spec::MoveType::rapid, spec::Cause::programmed, b.rational());
  if (measures) stops_at(spec::MoveType::linear, spec::Cause::measure, stop.rational());
  result.difference = s * stop.rational();
  if (!result.in_zone) return result;
  recorder_.reach(Clause::fanuc_length_measurement_value);
  recorder_.decide(Clause::fanuc_length_measurement_sign, start.minus);
  return result;
}

}  // namespace toolcomp::model

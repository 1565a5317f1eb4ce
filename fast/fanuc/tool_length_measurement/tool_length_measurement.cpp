// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_length_measurement/tool_length_measurement.h"

#include <string>

#include "spec/language/input_error.h"

namespace toolcomp::fast {
namespace {

std::optional<Count> parameter(const spec::Setup& setup, std::uint32_t number) {
  const auto value = setup.parameter(number);
  if (!value) return std::nullopt;
  if (!fits_count(*value))
    throw spec::InputError("setup", 0, 0, "parameters.\"" + std::to_string(number) + "\": too large");
  return Count::of(*value);
}

}  // namespace

ToolLengthMeasurement::ToolLengthMeasurement(const spec::Setup& setup) {
  const Factor factor = setup.units == spec::Units::inch ? Factor::mm_to_inch : Factor::one;
  const std::optional<Count> feed = parameter(setup, 6241);
  deceleration_ = parameter(setup, 6251).value_or(Count::of(spec::decimal(20), factor));
  zone_ = parameter(setup, 6254).value_or(Count::of(spec::decimal(5), factor));
  if (feed) feed_ = feed->nearest();
  const bool usable = zone_ < deceleration_ && !(zone_ < Count()) && (!feed || Count() < *feed);
  if (!usable) parameters_ = AlarmCause::measurement_parameters;
  for (const auto& [letter, decimal] : setup.measurement) {
    const std::size_t axis = setup.axes.index(letter);
    if (axis == spec::Axes::kNone) continue;
    if (!fits_count(decimal))
      throw spec::InputError("setup", 0, 0, std::string("measurement.") + letter + ": too large");
    touch_[axis] = Count::of(decimal);
  }
}

ToolLengthMeasurement::Motion ToolLengthMeasurement::measure(std::size_t axis, const Count& start,
                                                             const Count& commanded, const Count& offset) const {
  // Along the motion: every coordinate counts from the commanded one, ahead is positive.
  const bool positive = start < commanded;
  const auto ahead = [&](const Count& coordinate) {
    return positive ? coordinate - commanded : commanded - coordinate;
  };
  const auto coordinate = [&](const Count& along) { return positive ? commanded + along : commanded - along; };

  Motion motion;
  Count at = ahead(start);
  if (at < -deceleration_) {
    motion.approaches = true;
    at = -deceleration_;
  }
  motion.begin = coordinate(at);
  Count end = zone_;
  bool reached = false;
  if (touch_[axis]) {
    Count touch = ahead(*touch_[axis] - offset);
    if (touch < at) touch = at;
    reached = !(zone_ < touch);
    if (reached) end = touch;
  }
  motion.measures = at < end;
  motion.end = coordinate(end);
  motion.difference = motion.end - commanded;
  const bool early = end < -zone_;
  if (!reached || early) motion.alarm = AlarmCause::no_signal;
  return motion;
}

}  // namespace toolcomp::fast

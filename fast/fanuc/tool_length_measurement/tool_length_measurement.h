// SPDX-License-Identifier: Apache-2.0
// Automatic tool length measurement G37 (chapter 14.2): zones, signal, what is reached.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "fast/arithmetic/count.h"
#include "fast/basis/alarm.h"
#include "spec/language/axes.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// All coordinates are programmed ones of one axis, setup units, exact.
class ToolLengthMeasurement {
 public:
  // Throws spec::InputError for values no control could hold.
  explicit ToolLengthMeasurement(const spec::Setup& setup);

  // MEASUREMENT_PARAMETERS, or nothing.
  [[nodiscard]] const Alarm& parameters() const { return parameters_; }
  // 6241, where the setup gives it.
  [[nodiscard]] const std::optional<double>& feed() const { return feed_; }

  // What a G37 block does.
  struct Motion {
    bool approaches = false;  // a rapid part, to `begin`
    bool measures = false;    // a measuring part, to `end`
    Count begin;
    Count end;         // the position reached, or the end of the zone
    Count difference;  // reached less commanded
    Alarm alarm;       // PS0080, after the motion
  };
  // From `start` towards `commanded`, which differ; `offset` is what the position of the axis is more than the
  // programmed one.
  [[nodiscard]] Motion measure(std::size_t axis, const Count& start, const Count& commanded, const Count& offset) const;

 private:
  Alarm parameters_;
  std::optional<double> feed_;
  Count deceleration_;                                      // 6251
  Count zone_;                                              // 6254
  std::array<std::optional<Count>, spec::kMaxAxes> touch_;  // positions of the axis at which the signal comes on
};

}  // namespace toolcomp::fast

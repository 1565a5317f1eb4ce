// SPDX-License-Identifier: Apache-2.0
// The rules of automatic tool length measurement: G37. The section is nothing but them.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/basis/recorder.h"
#include "model/fanuc/program/interpreter.h"
#include "model/fanuc/program/step.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// What came of a measurement.
struct Measurement {
  std::vector<Leg> legs;  // a rapid and a measuring one, or one of them; end: the commanded coordinate
  Rational difference;    // programmed coordinate at which the tool stands, less the commanded one
  bool in_zone = false;   // else PS0080, once the moves are made
};

// Clauses: fanuc.length-measurement.*.
class ToolLengthMeasurement {
 public:
  ToolLengthMeasurement(const spec::Setup& setup, Recorder& recorder);

  // The alarms that the words of a G37 block raise. `number`: H in force; `cutter`: cutter compensation is on. Throws
  // Alarm PS0082, PS0081, PS0083, MEASUREMENT_FORMAT, PS0036 or MEASUREMENT_PARAMETERS.
  void read(const Command& command, std::uint32_t number, bool cutter) const;

  // The axis the block names, after read().
  [[nodiscard]] static std::size_t axis(const Command& command) {
    return static_cast<std::size_t>(std::countr_zero(command.axes));
  }
  // Goes from the programmed position `from` towards the end of `leg` (shifted as the tool offset says) until the
  // signal comes on. `length`: the length offset in force on the axis in this block; `minus`: G44 is in force. Throws
  // LeftOpen where the block starts on the commanded coordinate.
  [[nodiscard]] Measurement measure(const Command& command, const Position& from, const Leg& leg,
                                    const Rational& length, bool minus) const;
  // The feed of the measuring move, if a parameter gives it.
  [[nodiscard]] std::optional<Rational> feed() const;

 private:
  // Along the motion, counted from the commanded coordinate D: where the axis stops.
  struct Stop {
    Real at;
    bool measures = true;  // there is a measuring part
    bool in_zone = false;
  };

  // +1 or −1 along the axis.
  [[nodiscard]] int sense(const Real& travel) const;
  // Where the signal comes on, counted like that; nothing where it never does.
  [[nodiscard]] std::optional<Real> signal(std::size_t axis, const Leg& leg, int sense, const Rational& length) const;
  // A is where the block starts, B where the measuring part begins.
  [[nodiscard]] bool has_rapid_part(const Real& a, const Real& scale) const;
  [[nodiscard]] Stop stop(const std::optional<Real>& signal, const Real& b, const Real& scale) const;

  Recorder& recorder_;
  spec::Axes axes_;
  std::optional<Rational> feed_;                                // 6241, setup units a minute
  Rational deceleration_;                                       // 6251, setup units
  Rational half_zone_;                                          // 6254, setup units
  std::array<std::optional<Rational>, spec::kMaxAxes> signal_;  // axis position where the signal comes on
};

}  // namespace toolcomp::model

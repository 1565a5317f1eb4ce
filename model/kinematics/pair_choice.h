// The choice between the computed angles of a direction (type 2, I J K), and the ranges of the rotary axes.
#pragma once

#include <array>
#include <optional>

#include "model/kinematics/inverse.h"
#include "model/kinematics/machine.h"
#include "model/recorder.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Limits of one rotary axis, inclusive; degrees.
struct RotaryRange {
  Rational lower;
  Rational upper;
};

// Parameters 19741-19744 and 19608#5. Clauses: fanuc.tool-center-point.*.
class PairChoice {
 public:
  PairChoice(const spec::Setup& setup, const Machine& machine, Recorder& recorder);

  // Type 2 starts. Throws the alarm PS5459 where a lower limit is above its upper limit.
  void require_ranges() const;
  // Both axes of the pose are in their ranges.
  [[nodiscard]] bool inside(const Pose& pose) const;
  // Throws the alarm PS5459 where they are not.
  void require_inside(const Pose& pose) const;

  // The pair that the rules take from `present` to a direction in the table frame, whole turns included. Throws the
  // alarm PS5459 where the direction is out of reach or no pair is in range.
  [[nodiscard]] Pose choose(const Direction& direction, const Pose& present) const;

 private:
  // What an axis may be sent to for one basic angle: the nearest value in its range, or the two equally near.
  struct Values {
    std::array<Angle, 2> at;
    std::size_t count = 0;
  };

  const Machine& machine_;
  Recorder& recorder_;
  std::optional<RotaryRange> tool_;
  std::optional<RotaryRange> work_;
  bool work_first_ = true;  // the work-side axis is judged first
};

}  // namespace toolcomp::model

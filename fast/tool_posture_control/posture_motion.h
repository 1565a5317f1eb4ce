// The law by which rotary axes and tool move inside a block, and its samples.
#pragma once

#include <array>
#include <cstdint>

#include "fast/kinematics/machine.h"

namespace toolcomp::fast {

struct PostureSample {
  std::array<double, 2> degrees{};  // of the 1st and 2nd rotary axis, whole turns included
  Turns<double> turns;              // their sines and cosines
  Vector3<double> tool;             // programming coordinate system, unit
};

// Holds everything it needs: blocks that wait in the look-ahead of compensation keep a copy.
class PostureMotion {
 public:
  enum class Law : std::uint8_t {
    still,         // nothing turns
    linear,        // both rotary axes linear: conventional control, and passing a singular posture
    great_circle,  // V(t) on the great circle, rotary axes on the continuous branch
  };
  [[nodiscard]] Law law() const { return law_; }
  // The sample at t = numerator / denominator. Samples of one block are cheapest in ascending order.
  void at(std::uint32_t numerator, std::uint32_t denominator, PostureSample& sample);

 private:
  friend class ToolPostureControl;
  Law law_ = Law::still;
};

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
// The great circle from one direction to another, at an even rate.
#pragma once

#include <cstdint>

#include "fast/geometry/vector3.h"
#include "fast/kinematics/kinematics.h"

namespace toolcomp::fast {

// Sine and cosine of k/n of an angle, cheapest for k in ascending order.
class EvenAngle {
 public:
  void set(double radians) {
    radians_ = radians;
    denominator_ = 0;
  }
  [[nodiscard]] SineCosine<double> at(std::uint32_t numerator, std::uint32_t denominator) {
    // From one sample to the next by the addition theorem, afresh every eighth time: at most 12 roundings.
    constexpr std::uint32_t kAfresh = 8;
    const bool next = denominator == denominator_ && numerator == numerator_ + 1 && numerator % kAfresh != 0;
    numerator_ = numerator;
    if (!next) return last_ = afresh(numerator, denominator);
    last_ = {last_.sine - (last_.sine * versine_ - last_.cosine * sine_),
             last_.cosine - (last_.cosine * versine_ + last_.sine * sine_)};
    return last_;
  }

 private:
  [[nodiscard]] SineCosine<double> afresh(std::uint32_t numerator, std::uint32_t denominator);

  double radians_ = 0;
  std::uint32_t numerator_ = 0;
  std::uint32_t denominator_ = 0;
  SineCosine<double> last_{0, 1};
  double sine_ = 0;     // of one step,
  double versine_ = 0;  // 1 - cosine
};

// V(t) = cos(t Theta) start + sin(t Theta) side.
struct Circle {
  Vector3<double> start{0, 0, 1};
  Vector3<double> side{};
  [[nodiscard]] Vector3<double> at(const SineCosine<double>& angle) const {
    return start * angle.cosine + side * angle.sine;
  }
};

// The unit vector at right angles to s in the plane of s and e, unit vectors, on the side of e; `radians`: the angle
// from s to e. They may not be parallel; double serves unless they are nearly opposite.
Vector3<double> side_of(const Vector3<double>& s, const Vector3<double>& e, double& radians);
Vector3<double> side_of(const Vector3<DoubleDouble>& s, const Vector3<DoubleDouble>& e, double& radians);
// Nearer to opposite than this (the length of s x e) the double-double one is to be asked.
inline constexpr double kNearlyOpposite = 0x1p-6;

// The motion of a direction without rotary axes (19680 = 0): the great circle; equal or opposite: it stands until the
// end.
class DirectionMotion {
 public:
  DirectionMotion() = default;
  DirectionMotion(const Kinematics& kinematics, const Direction& start, const Direction& end);
  [[nodiscard]] Vector3<double> at(std::uint32_t numerator, std::uint32_t denominator);

 private:
  bool turns_ = false;
  Circle circle_;
  EvenAngle angle_;
};

}  // namespace toolcomp::fast

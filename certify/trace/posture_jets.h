// SPDX-License-Identifier: Apache-2.0
// The rotary axes of a machine and their motions inside a block (model/kinematics/posture_motion.h), in intervals.
#pragma once

#include <cstddef>
#include <utility>

#include "certify/trace/jet.h"
#include "model/exact/vector.h"
#include "model/kinematics/machine.h"
#include "model/kinematics/posture_motion.h"

namespace toolcomp::certify {

// Exact numbers are enclosed before an object of Rounding exists, because their libraries may rely on rounding to
// nearest.
Interval enclosed(const exact::Real& x);
IntervalVector enclosed(const exact::Vector3& v);
Interval radians(const Interval& degrees);

// A rotary axis.
class RotaryAxis {
 public:
  explicit RotaryAxis(const model::Turn& turn) : about_(turn.about), line_(enclosed(turn.line)) {}

  [[nodiscard]] const IntervalVector& line() const { return line_; }
  // The part of a vector at right angles to the axis.
  [[nodiscard]] JetVector across(const JetVector& v) const;
  [[nodiscard]] JetVector turned(const JetVector& v, const Turned& by) const;

 private:
  std::size_t about_;  // 0, 1, 2: X, Y, Z; 3: another line
  IntervalVector line_;
};
// The right-handed turn of a position.
Turned turn_at(const model::Turn& turn, const model::Angle& position);

// Turns of both axes, as they act on the tool.
struct Turns {
  Turned tool;
  Turned work;
};

// EvenTurns, and a level LiftedSwing.
class Even {
 public:
  Even(const model::Machine& machine, const model::EvenTurns& turns);
  // A swing at right angles to the work-side axis, in which only this axis turns. The tool-side axis may be at the edge
  // of its reach, where its rate has no bound.
  Even(const model::Machine& machine, const model::LiftedSwing& level);
  [[nodiscard]] Turns at(const Interval& t) const;

 private:
  Turns start_;
  Interval tool_;  // radians
  Interval work_;
};

// DirectionSwing.
class Swing {
 public:
  explicit Swing(const model::DirectionSwing& swing);
  [[nodiscard]] JetVector at(const Interval& t) const;
  [[nodiscard]] const IntervalVector& from() const { return from_; }
  [[nodiscard]] const IntervalVector& ahead() const { return ahead_; }
  [[nodiscard]] const Interval& rate() const { return rate_; }

 private:
  IntervalVector from_;
  IntervalVector ahead_;
  Interval rate_;  // radians
};

// LiftedSwing, by inverse kinematics (model/kinematics/inverse.h). C is the height of the direction over the mean one,
// ρ its greatest. Where a pole is in reach ρ - C = 1 - u_w·V (ρ + C = 1 + u_w·V) is taken from the distance h of the
// direction from the work-side axis, so that it keeps its relative width near the pole.
class Lifted {
 public:
  Lifted(const model::Machine& machine, const model::LiftedSwing& swing);
  [[nodiscard]] Turns at(const Interval& t) const;

 private:
  Swing swing_;
  RotaryAxis axis_;
  IntervalVector along_;
  IntervalVector across_;
  IntervalVector ahead_;
  Interval mean_;
  Interval a_;
  Interval b_;
  Interval swing2_;
  bool upper_pole_;
  bool lower_pole_;
  double branch_;
};

// LiftedSwing in the plane of the work-side axis, on a machine whose tool reaches the pole p u_w, p = 1 or -1, but
// whose axes are not at right angles. φ is the signed angle from the direction to the pole, α that of u_t and t0, which
// is also that of u_t and the pole. In the isosceles triangle of u_t, the pole and the tilted direction, which stands
// by the turn δ from the pole,
//   sin(δ/2) = ± sin(φ/2) / sin α,   tan ψ = cos α tan(δ/2),
// where ψ is the angle between the base and its direction at the pole: the azimuth that the tilted direction has swung
// about p u_w. The work-side axis turns back by it; where the direction passes the pole both azimuths change by 180
// degrees, and the axis does not. From φ: cos²ψ = (1 - sin²(δ/2)) / cos²(φ/2).
class Meridian {
 public:
  Meridian(const model::Machine& machine, const model::LiftedSwing& swing, int pole);
  [[nodiscard]] Turns at(const Interval& t) const;

 private:
  // δ and ψ.
  [[nodiscard]] std::pair<Turned, Turned> swung(const Interval& t) const;

  int pole_;
  Turned tool_;         // at the pole
  Turned work_;         // at the start
  Turned turned_back_;  // ψ there
  Interval phi_ = 0.0;  // there
  Interval rate_;       // radians
  Interval cosine_;     // of α
  Interval scale_;      // 1 / sin α, with the sign of the branch
};

}  // namespace toolcomp::certify

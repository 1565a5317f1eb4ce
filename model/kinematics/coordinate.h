// SPDX-License-Identifier: Apache-2.0
// A coordinate that does not chain: sums over any number of blocks stay as small as one number.
#pragma once

#include <array>
#include <optional>

#include "model/exact/real.h"
#include "model/kinematics/angle.h"
#include "spec/language/axes.h"

namespace toolcomp::model {

using exact::Rational;
using exact::Real;

// A rational, and apart from it an irrational rest. Programs and setups give rationals only. On a linear axis a rest
// appears where G49 ends tool center point control and the tool's length along an inclined axis becomes part of the
// position; on a rotary axis where inverse kinematics has turned it; and in what is measured from such a position
// (G92). Setup units, or degrees.
class Coordinate {
 public:
  Coordinate() = default;
  Coordinate(const Rational& value) : rational_(value) {}  // NOLINT(google-explicit-constructor): every rational is one
  explicit Coordinate(const Real& value) { (value.is_rational() ? rational_ : rest_) = value; }
  // Of a rotary axis.
  explicit Coordinate(const Angle& angle) {
    if (angle.is_rational())
      rational_ = angle.rational();
    else
      turned_ = angle;
  }

  [[nodiscard]] bool is_rational() const { return rest_.is_rational() && !turned_; }
  // For output where inverse kinematics has turned a rotary axis.
  [[nodiscard]] Real value() const {
    if (turned_) return angle().degrees();
    return rational_ + rest_;
  }
  // Of a rotary axis.
  [[nodiscard]] Angle angle() const {
    return turned_ ? Angle(rational_.rational()) + *turned_ : Angle(rational_.rational());
  }

  friend Coordinate operator+(const Coordinate& a, const Coordinate& b) {
    if (b.is_rational()) return a.shifted(b.rational_);
    if (a.turned_ || b.turned_) return Coordinate(a.angle() + b.angle());
    return Coordinate(a.rest_ + b.rest_).shifted(a.rational_ + b.rational_);
  }
  friend Coordinate operator-(const Coordinate& a, const Coordinate& b) {
    if (b.is_rational()) return a.shifted(-b.rational_);
    if (a.turned_ || b.turned_) return Coordinate(a.angle() - b.angle());
    return Coordinate(a.rest_ - b.rest_).shifted(a.rational_ - b.rational_);
  }
  // Certified; throws exact::Undecided.
  friend bool operator==(const Coordinate& a, const Coordinate& b) {
    if (a.turned_ || b.turned_) return a.angle() == b.angle();
    return (a - b).value().sign() == exact::Sign::zero;
  }

 private:
  [[nodiscard]] Coordinate shifted(const Real& by) const {
    Coordinate result(*this);
    result.rational_ += by;
    return result;
  }

  Real rational_;                // counted, not copied
  Real rest_;                    // 0 or irrational
  std::optional<Angle> turned_;  // added to the rational; not known to be rational
};

// One coordinate for each controlled axis, by axis index.
using Position = std::array<Coordinate, spec::kMaxAxes>;

}  // namespace toolcomp::model

// A coordinate that does not chain: sums over any number of blocks stay as small as one number.
#pragma once

#include <array>
#include <utility>

#include "model/exact/real.h"
#include "spec/language/axes.h"

namespace toolcomp::model {

using exact::Rational;
using exact::Real;

// A rational, and apart from it an irrational rest. Programs and setups give rationals only; a rest appears where G49
// ends G43.5 and the tool's length along an inclined axis becomes part of the position, or in what is measured from
// such a position (G92). Setup units, or degrees.
class Coordinate {
 public:
  Coordinate() = default;
  Coordinate(Rational value)
      : rational_(std::move(value)) {}  // NOLINT(google-explicit-constructor): every rational is one
  explicit Coordinate(const Real& value) {
    if (value.is_rational())
      rational_ = value.rational();
    else
      rest_ = value;
  }

  [[nodiscard]] bool is_rational() const { return rest_.is_rational(); }
  [[nodiscard]] Real value() const { return is_rational() ? Real(rational_) : Real(rational_) + rest_; }

  friend Coordinate operator+(const Coordinate& a, const Coordinate& b) {
    if (b.is_rational()) return a.shifted(b.rational_);
    return Coordinate(a.rest_ + b.rest_).shifted(a.rational_ + b.rational_);
  }
  friend Coordinate operator-(const Coordinate& a, const Coordinate& b) {
    if (b.is_rational()) return a.shifted(-b.rational_);
    return Coordinate(a.rest_ - b.rest_).shifted(a.rational_ - b.rational_);
  }

 private:
  [[nodiscard]] Coordinate shifted(const Rational& by) const {
    Coordinate result(*this);
    result.rational_ += by;
    return result;
  }

  Rational rational_;
  Real rest_;  // 0 or irrational
};

// One coordinate for each controlled axis, by axis index.
using Position = std::array<Coordinate, spec::kMaxAxes>;

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
// Sums of cosines of rational degrees with integer coefficients: the ring in which sines and cosines are multiplied out
// and proven zero.
#pragma once

#include <cstdint>
#include <vector>

#include "model/exact/real.h"
#include "model/exact/work.h"

namespace toolcomp::exact {

/// The angles of one proof: whole multiples of a full turn / order.
class Circle {
 public:
  /// The coarsest circle with 360 degrees that contains all angles whose denominators divide `denominator`. Throws
  /// OutOfWork if it does not fit a machine word (angles of more than 15 decimals) or has a prime factor above 1000.
  explicit Circle(const Integer& denominator);

  [[nodiscard]] std::int64_t order() const { return order_; }
  [[nodiscard]] std::int64_t degrees(std::int64_t d) const { return order_ / 360 * d; }
  /// The multiple that stands for an angle in degrees, at least 0 and less than 360.
  [[nodiscard]] std::int64_t multiple(const Rational& degrees) const;
  /// The odd primes that divide the order.
  [[nodiscard]] const std::vector<std::int64_t>& odd_primes() const { return odd_primes_; }
  /// The order divided by the product of its primes.
  [[nodiscard]] std::int64_t classes() const { return classes_; }

 private:
  std::int64_t order_ = 0;
  std::int64_t classes_ = 0;
  std::vector<std::int64_t> odd_primes_;
};

/// coefficient * 2 cos(angle), or just the coefficient if the angle is 0.
struct CosineTerm {
  std::int64_t angle;  ///< a multiple on the circle, from 0 to below a quarter turn
  Integer coefficient;
  friend bool operator==(const CosineTerm&, const CosineTerm&) = default;
};

/// A sum of terms with distinct rising angles and coefficients other than zero. Empty is zero, but zero need not be
/// empty: see vanishes.
using CosineSum = std::vector<CosineTerm>;

CosineSum cosine_sum(const Integer& constant);
/// 2 cos of an angle, any multiple on the circle.
CosineSum twice_cosine(const Circle& circle, std::int64_t angle);
CosineSum add(const CosineSum& a, const CosineSum& b, Work& work);
CosineSum multiply(const Circle& circle, const CosineSum& a, const CosineSum& b, Work& work);
void multiply_by(CosineSum& a, const Integer& factor, Work& work);
/// Whether the sum is zero as a number, decided completely in the cyclotomic field of the circle.
bool vanishes(const Circle& circle, const CosineSum& a, Work& work);

}  // namespace toolcomp::exact

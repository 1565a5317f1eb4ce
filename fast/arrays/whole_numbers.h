// SPDX-License-Identifier: Apache-2.0
// Whole numbers by doubles alone, for vector code, which has no products of 64 bits: sums of products are rounded once.
#pragma once

#include "fast/arithmetic/trigonometry.h"

namespace toolcomp::fast {

// A whole number up to 2^30 as high * 2^15 + low: products of parts, and sums of a few of them, are exact.
struct Parts {
  double high, low;
};
inline constexpr double kPart = 0x1p15;
[[gnu::always_inline]] inline Parts parts_of(double whole) {
  const double high = nearest_whole(whole * (1 / kPart));
  return {high, whole - high * kPart};
}

// a b - c d. The first sum is a multiple of 2^15 below 2^63: it is exact.
[[gnu::always_inline]] inline double difference(const Parts& a, const Parts& b, const Parts& c, const Parts& d) {
  const double high = a.high * b.high - c.high * d.high;
  const double middle = (a.high * b.low + a.low * b.high) - (c.high * d.low + c.low * d.high);
  const double low = a.low * b.low - c.low * d.low;
  return (high * (kPart * kPart) + middle * kPart) + low;
}
// a b + c d.
[[gnu::always_inline]] inline double sum(const Parts& a, const Parts& b, const Parts& c, const Parts& d) {
  const double high = a.high * b.high + c.high * d.high;
  const double middle = (a.high * b.low + a.low * b.high) + (c.high * d.low + c.low * d.high);
  const double low = a.low * b.low + c.low * d.low;
  return (high * (kPart * kPart) + middle * kPart) + low;
}

}  // namespace toolcomp::fast

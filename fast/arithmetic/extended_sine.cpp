// SPDX-License-Identifier: Apache-2.0
#include "fast/arithmetic/extended_sine.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "fast/arithmetic/count.h"

namespace toolcomp::fast {
namespace {

constexpr std::int64_t kUnitsPerDegree = Count::kSmallPerOne;
constexpr std::size_t kLastDegree = 45;

// Of 0, 1 … 45 degrees.
using DegreeTable = std::array<SineCosine<DoubleDouble>, kLastDegree + 1>;
const DegreeTable& degree_table() {
  static const DegreeTable table = [] {
    DegreeTable made{};
    Count angle;
    for (std::size_t i = 0; i < made.size(); ++i) {
      angle.set_small(static_cast<std::int64_t>(i) * kUnitsPerDegree);
      made[i] = fine_sine_cosine(angle);
    }
    return made;
  }();
  return table;
}

// A sum of two doubles, whatever their sizes.
struct TwoParts {
  double hi, lo;
};

// a + a * change + b * sine, |a| and |b| at most 1, `change` and `sine` those of half a degree at most.
DoubleDouble sum_of_angles(const DoubleDouble& a, const TwoParts& change, const DoubleDouble& b, const TwoParts& sine) {
  const DoubleDouble across = two_product(b.hi, sine.hi);
  const DoubleDouble along = two_product(a.hi, change.hi);
  const DoubleDouble first = two_sum(a.hi, across.hi);
  const DoubleDouble both = two_sum(first.hi, along.hi);
  const double rest = (first.lo + both.lo) + (across.lo + along.lo) + (a.lo + b.lo * sine.hi + a.lo * change.hi) +
                      (a.hi * change.lo + b.hi * sine.lo);
  return quick_two_sum(both.hi, rest);
}

}  // namespace

// The degree next to the angle from a table, and the sine of what is left, h <= half a degree: terms behind h^7 and h^8
// are below 2^-80, and those behind the first two are below 2^-22, so that their roundings are below 2^-74.
SineCosine<DoubleDouble> extended_sine_cosine(std::int64_t small) {
  constexpr auto kUnitsPerQuarterTurn = static_cast<double>(90 * kUnitsPerDegree);
  constexpr auto kOneDegree = static_cast<double>(kUnitsPerDegree);
  const auto angle = static_cast<double>(small);
  const double quarter = nearest_whole(angle * (1 / kUnitsPerQuarterTurn));
  const double remainder = angle - quarter * kUnitsPerQuarterTurn;
  const double degree = nearest_whole(std::abs(remainder) * (1 / kOneDegree));
  const double left = std::abs(remainder) - degree * kOneDegree;
  // pi / 180e6 in two parts, of which the first has 27 bits: its product is exact.
  constexpr double kRadiansHigh = 0x1.2bd8644000000p-26;
  constexpr double kRadiansLow = 0x1.60df76ae5cc06p-53;
  const DoubleDouble h = quick_two_sum(left * kRadiansHigh, left * kRadiansLow);
  const DoubleDouble square = two_product(h.hi, h.hi);
  const double z = square.hi;
  const TwoParts sine{h.hi, h.lo - h.hi * z * (1.0 / 6 - z * (1.0 / 120 - z * (1.0 / 5040)))};
  const TwoParts change{-0.5 * z,
                        z * z * (1.0 / 24 - z * (1.0 / 720 - z * (1.0 / 40320))) - (0.5 * square.lo + h.hi * h.lo)};
  const SineCosine<DoubleDouble>& at = degree_table()[static_cast<std::size_t>(degree)];
  DoubleDouble s = sum_of_angles(at.sine, change, at.cosine, sine);
  const DoubleDouble c = sum_of_angles(at.cosine, change, -at.sine, sine);
  if (remainder < 0) s = -s;
  switch (static_cast<unsigned>(static_cast<std::int64_t>(quarter)) % 4) {
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    case 3:
      return {-c, s};
    default:
      return {s, c};
  }
}

}  // namespace toolcomp::fast

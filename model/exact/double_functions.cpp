// SPDX-License-Identifier: Apache-2.0
// Sines, cosines and arc tangents in double: from the nearest entry of a table, which Arb fills, by a series whose rest
// is enclosed too.
#include <array>
#include <cmath>
#include <cstddef>

#include "model/exact/double_enclosure.h"
#include "model/exact/trigonometry.h"

namespace toolcomp::exact {
namespace {

constexpr DoubleEnclosure unit = point(1);
constexpr DoubleEnclosure inverse(double whole) { return divide(unit, point(whole)); }

// c0 - x (c1 - x (c2 - ... - x rest)): an alternating series whose terms fall in size, for x >= 0. What is left out
// begins with its first term and is no larger.
template <std::size_t Size>
DoubleEnclosure alternating(const DoubleEnclosure& x, const std::array<DoubleEnclosure, Size>& coefficients) {
  DoubleEnclosure sum{0, coefficients.back().upper};
  for (std::size_t i = Size - 1; i-- > 0;) sum = subtract(coefficients[i], multiply(x, sum));
  return sum;
}

// Of sin(x) / x and cos(x) in x^2, for |x| < 1, and of arctan(x) / x.
constexpr std::array sine_series{unit, inverse(6), inverse(120), inverse(5040)};
constexpr std::array cosine_series{unit, inverse(2), inverse(24), inverse(720), inverse(40'320)};
constexpr std::array arctangent_series{unit, inverse(3), inverse(5), inverse(7), inverse(9)};

constexpr int quarter_turn = 90;
constexpr DoubleEnclosure degree = divide(pi_in_double, point(180));  // in radians

struct SineAndCosine {
  DoubleEnclosure sine;
  DoubleEnclosure cosine;
};

// Of 0 to 90 degrees.
const std::array<SineAndCosine, quarter_turn + 1>& table_of_sines() {
  static const auto table = [] {
    std::array<SineAndCosine, quarter_turn + 1> entries;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      InlineInterval sine;
      InlineInterval cosine;
      const Rational degrees(static_cast<int>(i));
      sine_and_cosine(&sine, &cosine, degrees.raw());
      entries[i] = {enclosing(sine), enclosing(cosine)};
    }
    return entries;
  }();
  return table;
}

SineAndCosine at_whole_degrees(int degrees) {
  const int quarters = degrees / quarter_turn;
  const SineAndCosine& entry = table_of_sines()[static_cast<std::size_t>(degrees % quarter_turn)];
  switch (quarters) {
    case 0:
      return entry;
    case 1:
      return {entry.cosine, negate(entry.sine)};
    case 2:
      return {negate(entry.sine), negate(entry.cosine)};
    default:
      return {negate(entry.cosine), entry.sine};
  }
}

// A whole number of degrees, without full turns, and the rest in radians.
struct Reduced {
  int degrees;
  DoubleEnclosure rest;
};
std::optional<Reduced> reduced(const DoubleEnclosure& angle) {
  constexpr double greatest = 1e6;  // beyond, nothing is gained
  constexpr double widest = 1;
  if (std::fabs(angle.lower) >= greatest || angle.upper - angle.lower >= widest) return std::nullopt;
  const double whole = std::nearbyint(angle.lower);
  constexpr int turn = 4 * quarter_turn;
  const int degrees = (static_cast<int>(whole) % turn + turn) % turn;
  const DoubleEnclosure rest = whole == 0 ? angle : subtract(angle, point(whole));
  return Reduced{degrees, multiply(rest, degree)};
}

DoubleEnclosure within_one(const DoubleEnclosure& x) { return intersection(x, {-1, 1}); }

// Of |s| < 1 in radians.
DoubleEnclosure small_sine(const DoubleEnclosure& s) { return multiply(s, alternating(square(s), sine_series)); }
DoubleEnclosure small_cosine(const DoubleEnclosure& s) { return alternating(square(s), cosine_series); }

// The degrees of the tangents k / tangent_steps.
constexpr int tangent_steps = 64;
const std::array<DoubleEnclosure, tangent_steps + 1>& table_of_arctangents() {
  static const auto table = [] {
    std::array<DoubleEnclosure, tangent_steps + 1> entries;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      InlineInterval tangent;
      InlineInterval angle;
      mpfr_set_ui(tangent.lower, i, MPFR_RNDD);
      mpfr_div_ui(tangent.lower, tangent.lower, tangent_steps, MPFR_RNDD);
      mpfr_set(tangent.upper, tangent.lower, MPFR_RNDU);  // exact
      arctangent_degrees(angle, tangent);
      entries[i] = enclosing(angle);
    }
    return entries;
  }();
  return table;
}

// Of 0 <= tangent.lower <= 1: arctan(t) = arctan(c) + arctan((t - c) / (1 + c t)).
DoubleEnclosure arctangent_from_table(const DoubleEnclosure& tangent) {
  const double nearest = std::nearbyint(tangent.lower * tangent_steps);
  const DoubleEnclosure entry = point(nearest / tangent_steps);
  const DoubleEnclosure rest =
      nearest == 0 ? tangent : divide(subtract(tangent, entry), add(unit, multiply(entry, tangent)));
  const DoubleEnclosure angle = divide(multiply(rest, alternating(square(rest), arctangent_series)), degree);
  return nearest == 0 ? angle : add(table_of_arctangents()[static_cast<std::size_t>(nearest)], angle);
}

}  // namespace

DoubleEnclosure sine(const DoubleEnclosure& angle) {
  const auto parts = reduced(angle);
  if (!parts) return {-1, 1};
  const DoubleEnclosure of_rest = small_sine(parts->rest);
  if (parts->degrees == 0) return of_rest;
  const SineAndCosine entry = at_whole_degrees(parts->degrees);
  return within_one(add(multiply(entry.sine, small_cosine(parts->rest)), multiply(entry.cosine, of_rest)));
}

DoubleEnclosure cosine(const DoubleEnclosure& angle) {
  const auto parts = reduced(angle);
  if (!parts) return {-1, 1};
  const SineAndCosine entry = at_whole_degrees(parts->degrees);
  return within_one(
      subtract(multiply(entry.cosine, small_cosine(parts->rest)), multiply(entry.sine, small_sine(parts->rest))));
}

DoubleEnclosure arctangent(const DoubleEnclosure& tangent) {
  constexpr double widest = 0x1p-6;
  if (!is_finite(tangent) || tangent.upper - tangent.lower > widest) return {-quarter_turn, quarter_turn};
  if (tangent.lower < 0) {
    if (tangent.upper < 0) return negate(arctangent(negate(tangent)));
    // About zero; there no tangent is steeper than its angle in radians, and the size is that of the larger end.
    const DoubleEnclosure most = divide(point(std::max(-tangent.lower, tangent.upper)), degree);
    return {-most.upper, most.upper};
  }
  if (tangent.lower <= 1) return arctangent_from_table(tangent);
  return subtract(point(quarter_turn), arctangent_from_table(divide(unit, tangent)));
}

}  // namespace toolcomp::exact

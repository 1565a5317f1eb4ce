// SPDX-License-Identifier: Apache-2.0
// What is read out of a value: bounds, doubles and decimals.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "model/exact/node.h"
#include "model/exact/refinement.h"
#include "model/exact/sign.h"

namespace toolcomp::exact {
namespace {

__extension__ typedef unsigned __int128 TwoWords;  // NOLINT(modernize-use-using): the attribute needs a typedef

// Bounds are for people and verdicts, never for decisions: they may cost more than a decision.
constexpr std::int64_t readout_work = 250'000;
constexpr mpfr_prec_t greatest_readout_precision = mpfr_prec_t{1} << 18;

Rational rational_of(const mpfr_t x) {
  Rational result;
  mpfr_get_q(result.raw(), x);
  return result;
}

bool is_finite(const Interval& x) { return mpfr_number_p(x.lower) != 0 && mpfr_number_p(x.upper) != 0; }

// The same, told by two limbs: none where the ends are no numbers of one sign and exponent.
std::optional<bool> is_narrow_by_limbs(const Interval& x, int bits) {
  if (x.precision() != base_precision || mpfr_regular_p(x.lower) == 0 || mpfr_regular_p(x.upper) == 0 ||
      mpfr_get_exp(x.lower) != mpfr_get_exp(x.upper) || mpfr_signbit(x.lower) != mpfr_signbit(x.upper))
    return std::nullopt;
  const auto digits = [](mpfr_srcptr end) {
    const auto* const limbs = static_cast<const mp_limb_t*>(mpfr_custom_get_significand(end));
    return TwoWords{limbs[1]} << GMP_NUMB_BITS | limbs[0];
  };
  const TwoWords a = digits(x.lower);
  const TwoWords b = digits(x.upper);
  return (a < b ? b - a : a - b) <= (bits < base_precision ? std::min(a, b) >> bits : 0);
}

// Whether the width is at most 2^-bits of the size.
bool is_narrow(const Interval& x, int bits) {
  if (const auto known = is_narrow_by_limbs(x, bits)) return *known;
  if (!is_finite(x)) return false;
  if (mpfr_equal_p(x.lower, x.upper) != 0) return true;
  if (mpfr_sgn(x.lower) <= 0 && mpfr_sgn(x.upper) >= 0) return false;
  HeapInterval width(x.precision());
  mpfr_sub(width.upper, x.upper, x.lower, MPFR_RNDU);
  mpfr_mul_2si(width.upper, width.upper, bits, MPFR_RNDU);
  return mpfr_cmpabs(width.upper, x.lower) <= 0 && mpfr_cmpabs(width.upper, x.upper) <= 0;
}

// The same, told by double alone.
bool is_narrow(const DoubleEnclosure& x, int bits) {
  if (!is_finite(x) || (x.lower <= 0 && x.upper >= 0)) return false;
  return std::ldexp(above(x.upper - x.lower), bits) <= std::min(std::fabs(x.lower), std::fabs(x.upper));
}

// The best enclosure to be had, of relative width 2^-bits if the work reaches. The node is no rational.
const Interval& narrowed(Node& node, int bits) {
  if (is_narrow(node.base_enclosure(), bits)) return node.base_enclosure();
  Work work(readout_work);
  try {
    for (mpfr_prec_t precision = 2 * base_precision; precision <= greatest_readout_precision; precision *= 2) {
      if (node.refined && is_narrow(*node.refined, bits)) break;
      refine(node, precision, work);
    }
  } catch (const OutOfWork&) {
    return node.best_enclosure();  // wider, but holds the value, too
  }
  return node.best_enclosure();
}

Integer half_to_even(const Rational& x) {
  const Rational shifted = x + Rational(1, 2);
  Integer n = floor(shifted);
  if (Rational(n) == shifted && n % 2 != 0) n -= 1;
  return n;
}

// In size. Spares making a rational of 2^-1e9.
bool is_below_a_quarter(const mpfr_t x) { return mpfr_zero_p(x) != 0 || mpfr_get_exp(x) < -1; }

// x rounded to the nearest integer, ties to even.
Integer rounded(const Real& x) {
  if (x.is_rational()) return half_to_even(x.rational());
  Node& node = *Node::of(x);
  const auto nearest = [](const Rational& end) { return floor(end + Rational(1, 2)); };
  Work work(readout_work);
  try {
    for (mpfr_prec_t precision = base_precision; precision <= greatest_readout_precision; precision *= 2) {
      if (precision > base_precision) refine(node, precision, work);
      const Interval& bounds = node.best_enclosure();
      if (!is_finite(bounds)) continue;
      if (is_below_a_quarter(bounds.lower) && is_below_a_quarter(bounds.upper)) return 0;
      const Rational low = rational_of(bounds.lower);
      const Rational high = rational_of(bounds.upper);
      if (high - low >= Rational(1, 2)) continue;
      // At most one tie lies within such bounds, and the value may be just there.
      const Rational tie = Rational(nearest(high)) - Rational(1, 2);
      if (low > tie) return nearest(high);
      switch ((x - Real(tie)).sign()) {
        case Sign::negative:
          return nearest(high) - 1;
        case Sign::positive:
          return nearest(high);
        case Sign::zero:
          return half_to_even(tie);
      }
    }
  } catch (const OutOfWork&) {
    throw Undecided();
  }
  throw Undecided();
}

std::string digits_of(Integer scaled, int digits) {
  const bool negative = scaled < 0;
  if (negative) scaled = -scaled;
  std::string text = scaled.str();
  const auto places = static_cast<std::size_t>(digits);
  if (places > 0) {
    if (text.size() <= places) text.insert(0, places + 1 - text.size(), '0');
    text.insert(text.size() - places, 1, '.');
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return negative ? "-" + text : text;
}

}  // namespace

Enclosure Real::enclosure(int bits) const {
  if (is_rational()) return {rational(), rational()};
  if (const DoubleEnclosure& rough = node_->bounds(); is_narrow(rough, bits))
    return {Rational(rough.lower), Rational(rough.upper)};
  const auto known = try_decide(*node_);
  if (known == Sign::zero) return {};
  // Around a zero that is not proven there is no relative width to be had.
  const Interval& bounds = known ? narrowed(*node_, bits) : node_->best_enclosure();
  if (!is_finite(bounds)) throw Undecided();
  return {rational_of(bounds.lower), rational_of(bounds.upper)};
}

DoubleEnclosure Real::double_enclosure() const {
  if (node_ == nullptr) return {};
  if (is_rational()) {
    // Of short numbers these are two neighbours, or a point.
    const DoubleEnclosure& bounds = node_->bounds();
    return bounds.upper <= above(bounds.lower) ? bounds : enclosing(node_->base_enclosure());
  }
  const bool known = try_decide(*node_).has_value();
  if (is_rational()) return {};
  return enclosing(known ? narrowed(*node_, 64) : node_->best_enclosure());
}

DoubleEnclosure Real::rough_enclosure() const { return node_ == nullptr ? DoubleEnclosure{} : node_->bounds(); }

std::string Real::decimal(int digits) const {
  return digits_of(rounded(*this * Real(Rational(power_of_ten(static_cast<unsigned>(digits))))), digits);
}

}  // namespace toolcomp::exact

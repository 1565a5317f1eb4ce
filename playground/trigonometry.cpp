// SPDX-License-Identifier: Apache-2.0
// model/exact/trigonometry.h by MPFR alone: WebAssembly has no Arb. Slower than there, and as certain.
#include "model/exact/trigonometry.h"

#include <algorithm>
#include <array>

namespace toolcomp::exact {
namespace {

constexpr unsigned long kFullTurn = 360;
// An angle is rounded to so many bits more than its sine.
constexpr mpfr_prec_t kGuardBits = 32;

class Number {
 public:
  explicit Number(mpfr_prec_t precision) { mpfr_init2(value_, precision); }
  ~Number() { mpfr_clear(value_); }
  Number(const Number&) = delete;
  Number& operator=(const Number&) = delete;
  Number(Number&&) = delete;
  Number& operator=(Number&&) = delete;
  mpfr_ptr get() { return value_; }

 private:
  mpfr_t value_;
};

// mpfr_sinu or mpfr_cosu.
using Function = int (*)(mpfr_ptr, mpfr_srcptr, unsigned long, mpfr_rnd_t);

// Of an interval in which the function only rises or only falls.
void between_ends(Interval& result, mpfr_srcptr low, mpfr_srcptr high, Function function) {
  Number other(result.precision());
  function(result.lower, low, kFullTurn, MPFR_RNDD);
  function(other.get(), high, kFullTurn, MPFR_RNDD);
  mpfr_min(result.lower, result.lower, other.get(), MPFR_RNDD);
  function(result.upper, low, kFullTurn, MPFR_RNDU);
  function(other.get(), high, kFullTurn, MPFR_RNDU);
  mpfr_max(result.upper, result.upper, other.get(), MPFR_RNDU);
}

// The degrees less whole turns, rounded both ways: between the two is no multiple of 90, for such are not rounded.
void of_rational(Interval& result, const mpq_t degrees, Function function) {
  Rational turns;
  mpq_set(turns.raw(), degrees);
  turns /= Rational(360);
  Rational rest;
  mpq_set(rest.raw(), degrees);
  rest -= Rational(floor(turns)) * Rational(360);
  Number low(result.precision() + kGuardBits);
  Number high(result.precision() + kGuardBits);
  mpfr_set_q(low.get(), rest.raw(), MPFR_RNDD);
  mpfr_set_q(high.get(), rest.raw(), MPFR_RNDU);
  between_ends(result, low.get(), high.get(), function);
}

// Which multiple of half a turn behind `first` is the first not before the place, or the last not behind it.
void half_turns(mpfr_ptr result, mpfr_srcptr degrees, long first, mpfr_rnd_t towards) {
  mpfr_sub_si(result, degrees, first, towards);
  mpfr_div_ui(result, result, kFullTurn / 2, towards);
  if (towards == MPFR_RNDD)
    mpfr_ceil(result, result);
  else
    mpfr_floor(result, result);
}

// `first`: where the function is 1 first; half a turn behind it is -1.
void of_interval(Interval& result, const Interval& degrees, Function function, long first) {
  const auto all = [&result] {
    mpfr_set_si(result.lower, -1, MPFR_RNDD);
    mpfr_set_si(result.upper, 1, MPFR_RNDU);
  };
  if (mpfr_inf_p(degrees.lower) != 0 || mpfr_inf_p(degrees.upper) != 0) {
    all();
    return;
  }
  const mpfr_prec_t precision = degrees.precision() + kGuardBits;
  Number begin(precision);
  Number end(precision);
  half_turns(begin.get(), degrees.lower, first, MPFR_RNDD);
  half_turns(end.get(), degrees.upper, first, MPFR_RNDU);
  if (mpfr_greater_p(begin.get(), end.get()) != 0) {
    between_ends(result, degrees.lower, degrees.upper, function);
    return;
  }
  if (mpfr_equal_p(begin.get(), end.get()) == 0 || mpfr_fits_slong_p(begin.get(), MPFR_RNDN) == 0) {
    all();
    return;
  }
  between_ends(result, degrees.lower, degrees.upper, function);
  if (mpfr_get_si(begin.get(), MPFR_RNDN) % 2 == 0)
    mpfr_set_si(result.upper, 1, MPFR_RNDU);
  else
    mpfr_set_si(result.lower, -1, MPFR_RNDD);
}

// Both functions of the angles asked last at base_precision: two rotary axes, before and after a block.
struct Remembered {
  Rational degrees;
  InlineInterval sine;
  InlineInterval cosine;
  bool used = false;
};

const Remembered& remembered(const mpq_t degrees) {
  constexpr std::size_t kAngles = 4;
  thread_local std::array<Remembered, kAngles> memory;
  thread_local std::size_t oldest = 0;
  for (const Remembered& entry : memory)
    if (entry.used && mpq_equal(entry.degrees.raw(), degrees) != 0) return entry;
  Remembered& entry = memory.at(oldest);
  oldest = (oldest + 1) % kAngles;
  of_rational(entry.sine, degrees, mpfr_sinu);
  of_rational(entry.cosine, degrees, mpfr_cosu);
  mpq_set(entry.degrees.raw(), degrees);
  entry.used = true;
  return entry;
}

}  // namespace

void sine_and_cosine(Interval* sine, Interval* cosine, const mpq_t degrees) {
  if ((sine != nullptr ? sine : cosine)->precision() != base_precision) {
    if (sine != nullptr) of_rational(*sine, degrees, mpfr_sinu);
    if (cosine != nullptr) of_rational(*cosine, degrees, mpfr_cosu);
    return;
  }
  const Remembered& entry = remembered(degrees);
  if (sine != nullptr) set(*sine, entry.sine);
  if (cosine != nullptr) set(*cosine, entry.cosine);
}

void sine_of_degrees(Interval& result, const Interval& degrees) { of_interval(result, degrees, mpfr_sinu, 90); }
void cosine_of_degrees(Interval& result, const Interval& degrees) { of_interval(result, degrees, mpfr_cosu, 0); }

void arctangent_degrees(Interval& result, const Interval& tangent) {
  mpfr_atanu(result.lower, tangent.lower, kFullTurn, MPFR_RNDD);
  mpfr_atanu(result.upper, tangent.upper, kFullTurn, MPFR_RNDU);
}

void free_trigonometry() {}

}  // namespace toolcomp::exact

// SPDX-License-Identifier: Apache-2.0
#include "model/exact/trigonometry.h"

#include <arb.h>
#include <flint/flint.h>
#include <flint/fmpq.h>

#include <array>

namespace toolcomp::exact {
namespace {

// Arb's balls carry a radius of 30 bits; with guard bits the ends of the interval lose nothing visible.
constexpr mpfr_prec_t guard_bits = 16;

// The temporaries of one computation.
struct Balls {
  fmpq_t turns;  // half turns
  arb_t sine;
  arb_t cosine;
  Balls() {
    fmpq_init(turns);
    arb_init(sine);
    arb_init(cosine);
  }
  ~Balls() {
    fmpq_clear(turns);
    arb_clear(sine);
    arb_clear(cosine);
  }
  Balls(const Balls&) = delete;
  Balls& operator=(const Balls&) = delete;
  Balls(Balls&&) = delete;
  Balls& operator=(Balls&&) = delete;
};

void compute(Interval* sine, Interval* cosine, const mpq_t degrees, mpfr_prec_t precision) {
  Balls balls;
  fmpq_set_mpq(balls.turns, degrees);
  fmpz_t half_turn;
  fmpz_init_set_ui(half_turn, 180);
  fmpq_div_fmpz(balls.turns, balls.turns, half_turn);
  fmpz_clear(half_turn);
  arb_sin_cos_pi_fmpq(balls.sine, balls.cosine, balls.turns, precision + guard_bits);
  // Both ends are rounded outwards at the precision of the interval.
  if (sine != nullptr) arb_get_interval_mpfr(sine->lower, sine->upper, balls.sine);
  if (cosine != nullptr) arb_get_interval_mpfr(cosine->lower, cosine->upper, balls.cosine);
}

// A function of half turns, at a whole interval of degrees.
void of_degrees(Interval& result, const Interval& degrees, void (*function)(arb_t, const arb_t, slong)) {
  if (mpfr_inf_p(degrees.lower) || mpfr_inf_p(degrees.upper)) {
    mpfr_set_si(result.lower, -1, MPFR_RNDD);
    mpfr_set_si(result.upper, 1, MPFR_RNDU);
    return;
  }
  const mpfr_prec_t precision = result.precision() + guard_bits;
  constexpr unsigned long half_turn = 180;
  Balls balls;
  arb_set_interval_mpfr(balls.sine, degrees.lower, degrees.upper, precision);
  arb_div_ui(balls.sine, balls.sine, half_turn, precision);
  function(balls.cosine, balls.sine, precision);
  arb_get_interval_mpfr(result.lower, result.upper, balls.cosine);
}

// The degrees of one end, rounded outwards. Arb takes a twentieth of the time of mpfr_atanu.
void arctangent_of_end(mpfr_ptr result, mpfr_srcptr tangent, mpfr_rnd_t outwards) {
  constexpr long right_angle = 90;
  const int sign = mpfr_sgn(tangent);
  if (mpfr_inf_p(tangent) != 0) {
    mpfr_set_si(result, sign * right_angle, outwards);
    return;
  }
  // Besides 0 the only rational tangents of rational degrees.
  if (mpfr_cmp_si(tangent, sign) == 0) {
    mpfr_set_si(result, sign * right_angle / 2, outwards);
    return;
  }
  const mpfr_prec_t precision = mpfr_get_prec(result) + guard_bits;
  constexpr unsigned long half_turn = 180;
  Balls balls;
  arb_t& angle = balls.cosine;
  arf_set_mpfr(arb_midref(balls.sine), tangent);
  arb_atan(angle, balls.sine, precision);
  arb_mul_ui(angle, angle, half_turn, precision);
  arb_const_pi(balls.sine, precision);
  arb_div(angle, angle, balls.sine, precision);
  arf_t end;
  arf_init(end);
  (outwards == MPFR_RNDD ? arb_get_lbound_arf : arb_get_ubound_arf)(end, angle, precision);
  arf_get_mpfr(result, end, outwards);
  arf_clear(end);
}

struct Remembered {
  mpq_t degrees;
  InlineInterval sine;
  InlineInterval cosine;
  bool used = false;
  Remembered() { mpq_init(degrees); }
  ~Remembered() { mpq_clear(degrees); }
  Remembered(const Remembered&) = delete;
  Remembered& operator=(const Remembered&) = delete;
  Remembered(Remembered&&) = delete;
  Remembered& operator=(Remembered&&) = delete;
};

const Remembered& remembered(const mpq_t degrees) {
  // Two rotary axes, before and after a block.
  constexpr std::size_t angles = 4;
  thread_local std::array<Remembered, angles> memory;
  thread_local std::size_t oldest = 0;
  for (const Remembered& entry : memory)
    if (entry.used && mpq_equal(entry.degrees, degrees) != 0) return entry;
  Remembered& entry = memory[oldest];
  oldest = (oldest + 1) % angles;
  entry.used = false;
  compute(&entry.sine, &entry.cosine, degrees, base_precision);
  mpq_set(entry.degrees, degrees);
  entry.used = true;
  return entry;
}

}  // namespace

void sine_and_cosine(Interval* sine, Interval* cosine, const mpq_t degrees) {
  const mpfr_prec_t precision = (sine != nullptr ? sine : cosine)->precision();
  if (precision != base_precision) {
    compute(sine, cosine, degrees, precision);
    return;
  }
  const Remembered& entry = remembered(degrees);
  if (sine != nullptr) set(*sine, entry.sine);
  if (cosine != nullptr) set(*cosine, entry.cosine);
}

void sine_of_degrees(Interval& result, const Interval& degrees) { of_degrees(result, degrees, arb_sin_pi); }
void cosine_of_degrees(Interval& result, const Interval& degrees) { of_degrees(result, degrees, arb_cos_pi); }

void arctangent_degrees(Interval& result, const Interval& tangent) {
  arctangent_of_end(result.lower, tangent.lower, MPFR_RNDD);
  arctangent_of_end(result.upper, tangent.upper, MPFR_RNDU);
}

void free_trigonometry() { flint_cleanup(); }

}  // namespace toolcomp::exact

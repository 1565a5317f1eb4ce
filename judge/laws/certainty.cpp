// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/certainty.h"

namespace toolcomp::judge::laws {

namespace {

// Bounds of 1 + 2^40 times the value: a value that is zero needs no refinement, and one of 1e-27 is told from it.
exact::DoubleEnclosure beside_one(const Real& value) {
  static thread_local const Real scale(exact::Integer(1) << 40U);
  static thread_local const Real one(1);
  return (scale * value + one).double_enclosure();
}

int rational_sign(const Real& value) {
  const Rational r = value.rational();
  return r < 0 ? -1 : r > 0 ? 1 : 0;
}

}  // namespace

bool certainly_positive(const Real& value) {
  return value.is_rational() ? rational_sign(value) > 0 : beside_one(value).lower > 1;
}
bool certainly_negative(const Real& value) {
  return value.is_rational() ? rational_sign(value) < 0 : beside_one(value).upper < 1;
}
bool certainly_not_zero(const Real& value) {
  if (value.is_rational()) return rational_sign(value) != 0;
  const exact::DoubleEnclosure e = beside_one(value);
  return e.lower > 1 || e.upper < 1;
}

std::string amount(const Real& value) {
  constexpr int bits = 100;
  const exact::Enclosure e = value.enclosure(bits);
  constexpr int digits = 20;
  return Real((e.lower + e.upper) / 2).decimal(digits);
}

}  // namespace toolcomp::judge::laws

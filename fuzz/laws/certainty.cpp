#include "fuzz/laws/certainty.h"

namespace toolcomp::fuzz::laws {

// Relative to one, so that a value that is zero needs no refinement.
exact::Enclosure bounds(const Real& value) {
  if (value.is_rational()) return {value.rational(), value.rational()};
  constexpr int bits = 100;
  exact::Enclosure e = (value + Real(1)).enclosure(bits);
  e.lower -= 1;
  e.upper -= 1;
  return e;
}

bool certainly_positive(const Real& value) { return bounds(value).lower > 0; }
bool certainly_negative(const Real& value) { return bounds(value).upper < 0; }
bool certainly_not_zero(const Real& value) {
  const exact::Enclosure e = bounds(value);
  return e.lower > 0 || e.upper < 0;
}

std::string amount(const Real& value) {
  const exact::Enclosure e = bounds(value);
  constexpr int digits = 20;
  return Real((e.lower + e.upper) / 2).decimal(digits);
}

}  // namespace toolcomp::fuzz::laws

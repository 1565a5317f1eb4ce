// SPDX-License-Identifier: Apache-2.0
#include "model/basis/print.h"

#include "spec/language/event_map.h"

namespace toolcomp::model {
namespace {

// Whether the fraction has a finite decimal expansion of at most `digits` decimals.
bool is_decimal(const exact::Rational& value, int digits) {
  return exact::power_of_ten(static_cast<unsigned>(digits)) % denominator(value) == 0;
}

}  // namespace

void append_number(std::string& out, const Real& value, int digits) { out += value.decimal(digits); }

spec::NumberText number_text(const Real& value, int digits) {
  spec::NumberText text;
  text.v = value.decimal(digits);
  text.r = "5e-" + std::to_string(digits + 1);
  if (value.is_rational()) {
    const exact::Rational exactly = value.rational();
    text.q = exactly.str();
    if (denominator(exactly) == 1) text.q += "/1";
    if (is_decimal(exactly, digits)) text.r = "0";
  }
  return text;
}

spec::TextEvent text_event(const Event& event, int digits) {
  return spec::map_numbers<spec::NumberText>(event, [digits](const Real& value) { return number_text(value, digits); });
}

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
#include "certify/view/number_words.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "model/basis/print.h"

namespace toolcomp::certify {
namespace {

// Doubles in their order as whole numbers.
std::int64_t place_of(double value) {
  const auto bits = std::bit_cast<std::int64_t>(value);
  return bits < 0 ? INT64_MIN - bits : bits;
}

}  // namespace

std::string number_words(const model::Real& value, int digits) {
  constexpr std::size_t kLongest = 48;
  try {
    const spec::NumberText text = model::number_text(value, digits);
    if (text.q.empty()) return text.v + '~';
    if (text.r == "0") return text.v;
    return text.q.size() <= kLongest ? text.v + '=' + text.q : fmt::format("{}#{}", text.v, text.q.size());
  } catch (const exact::Undecided&) {
    try {
      const exact::DoubleEnclosure enclosure = value.double_enclosure();
      return fmt::format("{:.17g}?", enclosure.lower / 2 + enclosure.upper / 2);
    } catch (const exact::Undecided&) {
      return "?";
    }
  }
}

std::optional<std::int64_t> ulps_off(double value, const model::Real& exact) {
  if (!std::isfinite(value)) return std::nullopt;
  try {
    const exact::DoubleEnclosure enclosure = exact.double_enclosure();
    if (value < enclosure.lower) return place_of(value) - place_of(enclosure.lower);
    if (value > enclosure.upper) return place_of(value) - place_of(enclosure.upper);
    return 0;
  } catch (const exact::Undecided&) {
    return std::nullopt;
  }
}

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
// Parts of setups and programs as plain data, the same in both dialects.
#pragma once

#include <cstdint>

#include "spec/language/axes.h"
#include "spec/language/decimal.h"
#include "spec/language/setup.h"
#include "spec_engine/data.h"

namespace toolcomp::spec_engine {

// A decimal: its digits, how many of them stand behind the point.
inline Data number(const spec::Decimal& decimal) {
  const auto digits = static_cast<std::int64_t>(decimal.digits);
  return List{decimal.negative ? -digits : digits, std::int64_t{decimal.decimals}};
}
inline Data flag(bool value) { return std::int64_t{value ? 1 : 0}; }
inline Data whole(std::size_t value) { return static_cast<std::int64_t>(value); }
// The place of a letter in the alphabet.
inline Data letter(char c) { return whole(static_cast<std::size_t>(c - 'A')); }

inline Data axis_data(const spec::AxisTable& table, const spec::Axes& axes) {
  List values;
  for (const char axis : axes.letters()) {
    const auto given = table.find(axis);
    values.push_back(number(given == table.end() ? spec::Decimal{} : given->second));
  }
  return values;
}

}  // namespace toolcomp::spec_engine

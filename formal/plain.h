// Parts of setups and programs as plain data, the same in both dialects.
#pragma once

#include "formal/data.h"
#include "spec/language/axes.h"
#include "spec/language/decimal.h"
#include "spec/language/setup.h"

namespace toolcomp::formal {

inline exact::Rational exactly(const spec::Decimal& decimal) {
  exact::Rational value(decimal.digits);
  for (int i = 0; i < decimal.decimals; ++i) value /= 10;
  return decimal.negative ? exact::Rational(-value) : value;
}

inline Data number(const spec::Decimal& decimal) { return exact::Real(exactly(decimal)); }
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

}  // namespace toolcomp::formal

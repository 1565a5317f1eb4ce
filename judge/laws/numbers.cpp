// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/numbers.h"

namespace toolcomp::judge::laws {

Rational rational(const spec::Decimal& value) {
  Rational r(value.digits, exact::power_of_ten(value.decimals));
  if (value.negative) r = -r;
  return r;
}

std::optional<spec::Decimal> decimal(const Rational& value) {
  constexpr int most = 12;
  auto read = spec::parse_decimal(Real(value).decimal(most));
  if (!read || rational(*read) != value) return std::nullopt;
  read->point = true;
  return read;
}

std::optional<Vector> xyz(const spec::Axes& axes, const spec::AxisValues<Real>& values) {
  Vector v;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const std::size_t axis = axes.index("XYZ"[i]);
    if (axis == spec::Axes::kNone || !values.has(axis)) return std::nullopt;
    v.at(i) = values[axis];
  }
  return v;
}

}  // namespace toolcomp::judge::laws

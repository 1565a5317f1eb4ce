// SPDX-License-Identifier: Apache-2.0
// Converts numbers of programs and events to exact numbers.
#pragma once

#include <optional>

#include "judge/laws/certainty.h"
#include "spec/language/axes.h"
#include "spec/language/decimal.h"

namespace toolcomp::judge::laws {

Rational rational(const spec::Decimal& value);
// The decimal with a point, and with as few digits as possible; std::nullopt if 12 decimals are not enough.
std::optional<spec::Decimal> decimal(const Rational& value);

// X, Y and Z of the values; std::nullopt if one is missing.
std::optional<Vector> xyz(const spec::Axes& axes, const spec::AxisValues<Real>& values);

}  // namespace toolcomp::judge::laws

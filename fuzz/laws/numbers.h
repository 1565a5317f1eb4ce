// SPDX-License-Identifier: Apache-2.0
// Numbers of programs and events as exact ones.
#pragma once

#include <optional>

#include "fuzz/laws/certainty.h"
#include "spec/language/axes.h"
#include "spec/language/decimal.h"

namespace toolcomp::fuzz::laws {

Rational rational(const spec::Decimal& value);
// With a point, and as few digits as there can be; nothing where 12 decimals do not say it.
std::optional<spec::Decimal> decimal(const Rational& value);

// X, Y and Z of the values; nothing where one is missing.
std::optional<Vector> xyz(const spec::Axes& axes, const spec::AxisValues<Real>& values);

}  // namespace toolcomp::fuzz::laws

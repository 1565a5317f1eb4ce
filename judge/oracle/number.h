// SPDX-License-Identifier: Apache-2.0
// Distances between an exact value and a number of an engine or a controller.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/exact/real.h"
#include "spec/language/decimal.h"

namespace toolcomp::judge {

// The distance of `actual` from the enclosure of `exact`, rounded up; 0 inside, infinity for NaN and infinities.
double outside(const exact::Real& exact, double actual);
double outside(const exact::Real& exact, const exact::Rational& actual);

// An upper bound of outside() that needs no finer enclosure; infinity if there is none.
double outside_at_most(const exact::Real& exact, double actual);
double outside_at_most(const exact::Real& exact, const exact::Rational& actual);

// `actual` less `exact`, to double precision; NaN for NaN.
double signed_distance(const exact::Real& exact, double actual);
double signed_distance(const exact::Real& exact, const exact::Rational& actual);

bool is_finite(double x);
bool is_finite(const exact::Rational& x);

// The value to double precision, for scales and conditions.
double approximate(const exact::Real& exact);
double approximate(const spec::Decimal& value);
// The same for sizes, with an error of some ulps (policy.h). It needs no finer enclosure if nothing cancels.
double roughly(const exact::Real& exact);

// For people: 15 decimals of an exact value, the shortest text of a double, the decimals of a rational.
std::string text(const exact::Real& exact);
std::string text(double actual);
std::string text(const exact::Rational& actual);

// Whether it is a decimal with finitely many digits.
bool is_decimal(const exact::Rational& value);

// The exact value of a decimal number in the form of JSON ("-0.5", "1e-7"); std::nullopt for other text and for
// exponents beyond ±400.
std::optional<exact::Rational> parse_number(std::string_view text);

}  // namespace toolcomp::judge

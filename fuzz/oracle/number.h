// SPDX-License-Identifier: Apache-2.0
// Distances between an exact value and a number an engine or a controller gave.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/exact/real.h"
#include "spec/language/decimal.h"

namespace toolcomp::fuzz {

// How far `actual` lies outside the enclosure of `exact`, rounded up; 0 inside, infinity for NaN and infinities.
double outside(const exact::Real& exact, double actual);
double outside(const exact::Real& exact, const exact::Rational& actual);

// No less than outside(), and told without a finer enclosure; infinity where it is not known.
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
// The same for sizes, to some numbers of double (policy.h): it needs no finer enclosure where nothing cancels.
double roughly(const exact::Real& exact);

// For people: 15 decimals of an exact value, the shortest text of a double, the decimals of a rational.
std::string text(const exact::Real& exact);
std::string text(double actual);
std::string text(const exact::Rational& actual);

// Whether finitely many decimals write it.
bool is_decimal(const exact::Rational& value);

// A decimal number as JSON writes it ("-0.5", "1e-7"), exactly; nothing for other text and for exponents beyond ±400.
std::optional<exact::Rational> parse_number(std::string_view text);

}  // namespace toolcomp::fuzz

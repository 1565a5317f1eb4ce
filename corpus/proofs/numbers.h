// Numbers, vectors of space and names as Coq writes them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "model/exact/real.h"
#include "spec/language/case.h"

namespace toolcomp::corpus {

using exact::Rational;

// The value of the decimal, and as Coq writes it.
Rational value_of(const spec::Decimal& decimal);
std::string coq(const Rational& value);
std::string coq(const spec::Decimal& decimal);

// The recorded number as a fraction, where it is one.
std::optional<Rational> fraction_of(const spec::NumberText& number);
// v and r as Coq writes them.
std::string coq_decimal(std::string_view text);

using Exact3 = std::array<Rational, 3>;

Rational dot(const Exact3& a, const Exact3& b);
Exact3 cross(const Exact3& a, const Exact3& b);
Exact3 difference(const Exact3& to, const Exact3& from);
std::string coq(const Exact3& v);

// The root, where it is rational.
std::optional<Rational> square_root(const Rational& value);

// An identifier of Coq from a vector's id.
std::string identifier(std::string_view id);

}  // namespace toolcomp::corpus

#include "corpus/proofs/numbers.h"

#include <fmt/format.h>

#include <algorithm>

namespace toolcomp::corpus {

Rational value_of(const spec::Decimal& decimal) {
  exact::Integer unit = 1;
  for (int i = 0; i < decimal.decimals; ++i) unit *= 10;
  const Rational value(exact::Integer(decimal.digits), unit);
  return decimal.negative ? Rational(-value) : value;
}

std::string coq(const Rational& value) {
  const exact::Integer above = numerator(value);
  const exact::Integer below = denominator(value);
  return below == 1 ? fmt::format("({})", above.str()) : fmt::format("({} / {})", above.str(), below.str());
}

std::string coq(const spec::Decimal& decimal) { return coq(value_of(decimal)); }

std::optional<Rational> fraction_of(const spec::NumberText& number) {
  if (number.q.empty()) return std::nullopt;
  return Rational(number.q);
}

// -12.5, or 5e-16.
std::string coq_decimal(std::string_view text) {
  const std::size_t e = text.find('e');
  if (e == std::string_view::npos) return fmt::format("({})", text);
  return fmt::format("({} / 10 ^ {})", text.substr(0, e), text.substr(e + 2));
}

Rational dot(const Exact3& a, const Exact3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Exact3 cross(const Exact3& a, const Exact3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Exact3 difference(const Exact3& to, const Exact3& from) { return {to[0] - from[0], to[1] - from[1], to[2] - from[2]}; }

std::string coq(const Exact3& v) { return fmt::format("(Vec {} {} {})", coq(v[0]), coq(v[1]), coq(v[2])); }

std::optional<Rational> square_root(const Rational& value) {
  const exact::Integer above = sqrt(exact::Integer(numerator(value)));
  const exact::Integer below = sqrt(exact::Integer(denominator(value)));
  Rational root(above, below);
  if (root * root != value) return std::nullopt;
  return root;
}

std::string identifier(std::string_view id) {
  std::string name(id);
  std::ranges::replace_if(name, [](char c) { return c == '.' || c == '-'; }, '_');
  return name;
}

}  // namespace toolcomp::corpus

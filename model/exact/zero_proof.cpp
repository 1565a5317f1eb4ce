// SPDX-License-Identifier: Apache-2.0
// An expression is brought into the form numerator / denominator, where the numerator is a polynomial in square roots
// and unknowns over sums of cosines and the denominator is certainly not zero; then the numerator is decided.
#include "model/exact/zero_proof.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "model/exact/numbering.h"
#include "model/exact/root_tower.h"
#include "model/exact/sign.h"

namespace toolcomp::exact {
namespace {

Sign product(Sign a, Sign b) { return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b)); }

// A divisor that is no integer. It is not zero, and its sign is known.
struct Divisor {
  Element value;
  Sign sign;
};

struct Power {
  std::size_t divisor;
  unsigned exponent;
};

// numerator / (denominator * powers of divisors), denominator > 0.
struct Fraction {
  Element numerator;
  Integer denominator = 1;
  std::vector<Power> divisors;  // rising
};

// Merges two lists of powers by a function of two exponents, 0 standing for absent.
template <class Merge>
std::vector<Power> merge(const std::vector<Power>& a, const std::vector<Power>& b, Merge exponent_of) {
  std::vector<Power> result;
  auto x = a.begin();
  auto y = b.begin();
  while (x != a.end() || y != b.end()) {
    const std::size_t divisor =
        std::min(x == a.end() ? y->divisor : x->divisor, y == b.end() ? x->divisor : y->divisor);
    const unsigned of_a = x != a.end() && x->divisor == divisor ? (x++)->exponent : 0;
    const unsigned of_b = y != b.end() && y->divisor == divisor ? (y++)->exponent : 0;
    if (const unsigned exponent = exponent_of(of_a, of_b); exponent != 0) result.push_back({divisor, exponent});
  }
  return result;
}
unsigned excess(unsigned a, unsigned b) { return a > b ? a - b : 0; }

class Proof {
 public:
  Proof(const Numbering& numbers, Circle circle, Work& work)
      : numbers_(numbers), work_(work), tower_(std::move(circle), work), fractions_(numbers.size()) {}

  // Zeros by their numbers are not among the nodes.
  bool vanishes(const std::vector<Node*>& operands_first) {
    for (Node* node : operands_first) {
      std::optional<Fraction>& known = fractions_[numbers_.of(*node)];
      if (known) continue;
      known = fraction(*node);
      // Zeros inside are found where they arise: carried along they would grow.
      if (may_be_zero(*node) && tower_.vanishes(known->numerator)) known = Fraction{};
    }
    return of(operands_first.back()).numerator.empty();
  }

 private:
  static bool may_be_zero(Node& node) {
    return (node.kind == Kind::sum || node.kind == Kind::difference) && !enclosed_sign(node) &&
           node.knowledge == Knowledge::none;
  }

  const Fraction& of(const Node* node) const {
    static const Fraction zero;
    const std::optional<Fraction>& known = fractions_[numbers_.of(*node)];
    return known ? *known : zero;
  }

  Fraction fraction(Node& node) {
    work_.spend(1);
    switch (node.kind) {
      case Kind::rational:
        return rational(node.value);
      case Kind::sine:
        return cosine(tower_.circle().degrees(90) - angle(node.value));
      case Kind::cosine:
        return cosine(angle(node.value));
      case Kind::negation:
        return negated(of(node.left));
      case Kind::sum:
        return sum(of(node.left), of(node.right));
      case Kind::difference:
        return sum(of(node.left), negated(of(node.right)));
      case Kind::product:
        return product_of(of(node.left), of(node.right));
      case Kind::quotient:
        return quotient(of(node.left), of(node.right), sign_of(*node.right));
      case Kind::root:
        return root(of(node.left));
      case Kind::arctangent:
      case Kind::sine_of:
      case Kind::cosine_of:
      case Kind::pi:
        return unknown(node);
    }
    throw OutOfWork{};
  }

  // Functions of equal operands are one unknown.
  Fraction unknown(Node& node) {
    const auto known = std::ranges::find_if(unknowns_, [&](const Node* other) {
      if (other->kind != node.kind) return false;
      return node.kind == Kind::pi || tower_.vanishes(sum(of(other->left), negated(of(node.left))).numerator);
    });
    if (known != unknowns_.end()) return of(*known);
    unknowns_.push_back(&node);
    return {tower_.unknown(node), 1, {}};
  }

  std::int64_t angle(const RationalValue& degrees) const { return tower_.circle().multiple(degrees.rational()); }

  // Divisors were certified when the quotient was made, so this costs nothing.
  static Sign sign_of(Node& divisor) {
    if (auto sign = try_decide(divisor)) return *sign;
    throw OutOfWork{};
  }

  [[nodiscard]] Fraction rational(const RationalValue& given) const {
    const Rational value = given.rational();
    return {tower_.constant(numerator(value)), denominator(value), {}};
  }

  [[nodiscard]] Fraction cosine(std::int64_t angle) const { return {tower_.twice_cosine(angle), 2, {}}; }

  static Fraction negated(Fraction x) {
    negate(x.numerator);
    return x;
  }

  // Multiplies by powers of divisors.
  Element expanded(Element e, const std::vector<Power>& powers) {
    for (const Power& power : powers)
      for (unsigned i = 0; i < power.exponent; ++i) e = tower_.multiply(e, divisors_[power.divisor].value);
    return e;
  }

  // Takes common integer factors out, so that the numbers stay short.
  static Fraction reduced(Fraction x) {
    if (x.numerator.empty()) return {};
    if (x.denominator == 1) return x;
    Integer divisor = gcd(content(x.numerator), x.denominator);
    divide_by(x.numerator, divisor);
    x.denominator /= divisor;
    return x;
  }

  Fraction sum(const Fraction& x, const Fraction& y) {
    if (x.numerator.empty()) return y;
    if (y.numerator.empty()) return x;
    const Integer denominator = lcm(x.denominator, y.denominator);
    Element a = expanded(x.numerator, merge(y.divisors, x.divisors, excess));
    Element b = expanded(y.numerator, merge(x.divisors, y.divisors, excess));
    tower_.multiply_by(a, denominator / x.denominator);
    tower_.multiply_by(b, denominator / y.denominator);
    return reduced({tower_.add(a, b), denominator,
                    merge(x.divisors, y.divisors, [](unsigned s, unsigned t) { return std::max(s, t); })});
  }

  // Where x is, but for an integer, one of the divisors of y, both go out: no other polynomials are cancelled.
  void cancel(Fraction& x, Fraction& y) const {
    if (y.divisors.empty() || integer_value(x.numerator)) return;
    Element factor = x.numerator;
    Integer integer = content(factor);
    divide_by(factor, integer);
    const auto find = [&] {
      return std::ranges::find_if(y.divisors, [&](const Power& p) { return divisors_[p.divisor].value == factor; });
    };
    auto power = find();
    if (power == y.divisors.end()) {
      negate(factor);
      integer = -integer;
      power = find();
    }
    if (power == y.divisors.end()) return;
    x.numerator = tower_.constant(integer);
    if (--power->exponent == 0) y.divisors.erase(power);
  }

  Fraction product_of(Fraction x, Fraction y) {
    cancel(x, y);
    cancel(y, x);
    return reduced({tower_.multiply(x.numerator, y.numerator), x.denominator * y.denominator,
                    merge(x.divisors, y.divisors, [](unsigned s, unsigned t) { return s + t; })});
  }

  Fraction quotient(const Fraction& x, const Fraction& y, Sign sign_of_y) {
    Fraction result;
    result.numerator = expanded(x.numerator, merge(y.divisors, x.divisors, excess));
    tower_.multiply_by(result.numerator, y.denominator);
    result.denominator = x.denominator;
    result.divisors = merge(x.divisors, y.divisors, excess);
    Element divisor = y.numerator;
    Sign sign = sign_of_y;
    for (const Power& power : y.divisors)
      if (power.exponent % 2 != 0) sign = product(sign, divisors_[power.divisor].sign);
    const Integer common = content(divisor);
    divide_by(divisor, common);
    result.denominator *= common;
    if (const auto integer = integer_value(divisor)) {  // 1 or -1 after the division
      if (*integer < 0) negate(result.numerator);
    } else {
      const Power power{number_of(std::move(divisor), sign), 1};
      result.divisors = merge(result.divisors, {power}, [](unsigned s, unsigned t) { return s + t; });
    }
    return reduced(std::move(result));
  }

  std::size_t number_of(Element divisor, Sign sign) {
    const auto known =
        std::find_if(divisors_.begin(), divisors_.end(), [&](const Divisor& d) { return d.value == divisor; });
    const auto number = static_cast<std::size_t>(known - divisors_.begin());
    if (known == divisors_.end()) divisors_.push_back({std::move(divisor), sign});
    return number;
  }

  // sqrt(n / (d p)) = sqrt(n d p') / (d |p''|), where p' holds the divisors of odd exponent once and p'' makes p p' a
  // square.
  Fraction root(const Fraction& x) {
    Fraction result;
    std::vector<Power> odd;
    Sign sign = Sign::positive;
    for (const Power& power : x.divisors) {
      if (power.exponent % 2 != 0) odd.push_back({power.divisor, 1});
      const unsigned half = (power.exponent + 1) / 2;
      result.divisors.push_back({power.divisor, half});
      if (half % 2 != 0) sign = product(sign, divisors_[power.divisor].sign);
    }
    Element radicand = expanded(x.numerator, odd);
    tower_.multiply_by(radicand, x.denominator);
    result.denominator = x.denominator;
    Integer factor = square_factor(content(radicand));
    divide_by(radicand, factor * factor);
    if (sign == Sign::negative) factor = -factor;
    const auto integer = integer_value(radicand);
    result.numerator = integer && *integer == 1 ? tower_.constant(1) : tower_.root_of(radicand);
    tower_.multiply_by(result.numerator, factor);
    return reduced(std::move(result));
  }

  // A number whose square divides `n`: all of n's small primes and, if what is left is a square, its root.
  static Integer square_factor(Integer n) {
    if (n.is_zero()) return 1;
    Integer factor = 1;
    for (const int p : {2, 3, 5, 7, 11, 13})
      while (n % (p * p) == 0) {
        n /= p * p;
        factor *= p;
      }
    if (mpz_perfect_square_p(n.raw()) != 0) factor *= sqrt(n);
    return factor;
  }

  const Numbering& numbers_;
  Work& work_;
  RootTower tower_;
  std::vector<Divisor> divisors_;
  std::vector<Node*> unknowns_;
  std::vector<std::optional<Fraction>> fractions_;  // by number
};

// The circle on which all angles of the expression lie.
Circle circle_of(const std::vector<Node*>& nodes) {
  Integer common = 1;
  for (const Node* node : nodes)
    if (node->kind == Kind::sine || node->kind == Kind::cosine)
      common = lcm(common, denominator(node->value.rational()));
  return Circle(common);
}

}  // namespace

ZeroProof prove_zero(Node& node, std::int64_t units) {
  Work work(units);
  try {
    std::vector<Node*> nodes;
    operands_first(&node, nodes, [&](const Node& /*any*/) {
      work.spend(1);
      return true;
    });
    Numbering numbers;
    for (const Node* each : nodes) numbers.add(*each);
    if (numbers.is_zero(node)) return ZeroProof::zero;
    // What zeros by their numbers are made of may be beyond any work.
    nodes.clear();
    operands_first(&node, nodes, [&](const Node& each) { return !numbers.is_zero(each); });
    return Proof(numbers, circle_of(nodes), work).vanishes(nodes) ? ZeroProof::zero : ZeroProof::nonzero;
  } catch (const OutOfWork&) {
    return ZeroProof::none;
  }
}

}  // namespace toolcomp::exact

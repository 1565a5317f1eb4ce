// SPDX-License-Identifier: Apache-2.0
// Random expressions that different arithmetics evaluate independently of each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "model/exact/real.h"

namespace toolcomp::exact::test {

enum class Operation : std::uint8_t {
  rational,
  sine,
  cosine,
  pi,
  arctangent,  ///< in degrees
  negate,
  add,
  subtract,
  multiply,
  divide,
  root
};

/// One step; operands are earlier steps. `value` is the rational, or the degrees of a sine or cosine.
struct Step {
  Operation operation = Operation::rational;
  Rational value = 0;
  std::size_t left = 0;
  std::size_t right = 0;
};

/// The last step is the value.
using Expression = std::vector<Step>;

/// Evaluates an expression, step by step. An arithmetic has a type Value and a function for each operation.
template <class Arithmetic>
std::vector<typename Arithmetic::Value> replay(Arithmetic& arithmetic, const Expression& expression) {
  std::vector<typename Arithmetic::Value> values;
  values.reserve(expression.size());
  for (const Step& step : expression) {
    switch (step.operation) {
      case Operation::rational:
        values.push_back(arithmetic.rational(step.value));
        break;
      case Operation::sine:
        values.push_back(arithmetic.sine(step.value));
        break;
      case Operation::cosine:
        values.push_back(arithmetic.cosine(step.value));
        break;
      case Operation::pi:
        values.push_back(arithmetic.pi());
        break;
      case Operation::arctangent:
        values.push_back(arithmetic.arctangent(values[step.left]));
        break;
      case Operation::negate:
        values.push_back(arithmetic.negate(values[step.left]));
        break;
      case Operation::add:
        values.push_back(arithmetic.add(values[step.left], values[step.right]));
        break;
      case Operation::subtract:
        values.push_back(arithmetic.subtract(values[step.left], values[step.right]));
        break;
      case Operation::multiply:
        values.push_back(arithmetic.multiply(values[step.left], values[step.right]));
        break;
      case Operation::divide:
        values.push_back(arithmetic.divide(values[step.left], values[step.right]));
        break;
      case Operation::root:
        values.push_back(arithmetic.root(values[step.left]));
        break;
    }
  }
  return values;
}

/// The arithmetic under test.
struct RealArithmetic {
  using Value = Real;
  static Real rational(const Rational& value) { return value; }
  static Real sine(const Rational& degrees) { return sin_degrees(degrees); }
  static Real cosine(const Rational& degrees) { return cos_degrees(degrees); }
  static Real pi() { return exact::pi(); }
  static Real arctangent(const Real& a) { return arctangent_degrees(a); }
  static Real negate(const Real& a) { return -a; }
  static Real add(const Real& a, const Real& b) { return a + b; }
  static Real subtract(const Real& a, const Real& b) { return a - b; }
  static Real multiply(const Real& a, const Real& b) { return a * b; }
  static Real divide(const Real& a, const Real& b) { return a / b; }
  static Real root(const Real& a) { return sqrt(a); }
};

/// Numbers below a bound, the same with every standard library.
class Choices {
 public:
  explicit Choices(std::uint64_t seed) : bits_(seed) {}
  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(bits_() % bound); }
  long between(long low, long high) { return low + static_cast<long>(below(static_cast<std::size_t>(high - low + 1))); }

 private:
  std::mt19937_64 bits_;
};

/// Makes an expression step by step. Values are kept beside, as Real, only to steer clear of roots of negative numbers
/// and divisions by zero; the arithmetics that replay the expression check that the steering was right.
class Builder {
 public:
  explicit Builder(Choices& choices) : choices_(choices) {}

  [[nodiscard]] const Expression& expression() const { return steps_; }
  [[nodiscard]] const Real& value(std::size_t step) const { return values_[step]; }

  std::size_t rational(const Rational& value) { return push({Operation::rational, value}, value); }
  std::size_t sine(const Rational& d) { return push({Operation::sine, d}, sin_degrees(d)); }
  std::size_t cosine(const Rational& d) { return push({Operation::cosine, d}, cos_degrees(d)); }
  std::size_t pi() { return push({Operation::pi}, exact::pi()); }
  std::size_t arctangent(std::size_t a) { return push({Operation::arctangent, 0, a}, arctangent_degrees(values_[a])); }
  std::size_t negate(std::size_t a) { return push({Operation::negate, 0, a}, -values_[a]); }
  std::size_t add(std::size_t a, std::size_t b) { return push({Operation::add, 0, a, b}, values_[a] + values_[b]); }
  std::size_t subtract(std::size_t a, std::size_t b) {
    return push({Operation::subtract, 0, a, b}, values_[a] - values_[b]);
  }
  std::size_t multiply(std::size_t a, std::size_t b) {
    return push({Operation::multiply, 0, a, b}, values_[a] * values_[b]);
  }
  /// Of the absolute value; of 1 should it be zero. (The root of a zero that is not known to be one costs an interval
  /// arithmetic half its digits, too many to judge tiny differences by.)
  std::size_t root(std::size_t a) {
    a = nonzero(a);
    if (values_[a].sign() == Sign::negative) a = negate(a);
    return push({Operation::root, 0, a}, sqrt(values_[a]));
  }
  /// By b, or by b + 1 should b be zero (which then is not).
  std::size_t divide(std::size_t a, std::size_t b) {
    b = nonzero(b);
    return push({Operation::divide, 0, a, b}, values_[a] / values_[b]);
  }

  /// A decimal with up to `digits` places.
  Rational decimal(long bound, int digits) {
    long scale = 1;
    for (std::size_t i = choices_.below(static_cast<std::size_t>(digits) + 1); i > 0; --i) scale *= 10;
    return {choices_.between(-bound * scale, bound * scale), scale};
  }

  /// A tree of the given depth at most.
  std::size_t tree(int depth) {
    if (depth == 0 || choices_.below(8) == 0) return leaf();
    const std::size_t operation = choices_.below(7);
    const std::size_t a = tree(depth - 1);
    if (operation == 0) return root(a);
    if (operation == 1) return negate(a);
    const std::size_t b = tree(depth - 1);
    switch (operation) {
      case 2:
        return add(a, b);
      case 3:
        return subtract(a, b);
      case 4:
        return divide(a, b);
      default:
        return multiply(a, b);
    }
  }

  std::size_t leaf() {
    switch (choices_.below(10)) {
      case 0:
        return pi();
      case 1:
        return arctangent(root(rational(choices_.between(2, 9))));
      case 2:
      case 3:
        return sine(decimal(400, 3));
      case 4:
      case 5:
        return cosine(decimal(400, 3));
      case 6:
      case 7:
        return cosine(Rational(choices_.between(0, 12) * 15));
      default:
        return rational(decimal(20, 3));
    }
  }

  /// An expression that is zero, by an identity.
  std::size_t zero(int depth) {
    switch (choices_.below(8)) {
      case 0: {  // sin(s + t) = sin s cos t + cos s sin t
        const Rational s = decimal(360, 6);
        const Rational t = decimal(360, 6);
        const std::size_t sine_s = sine(s);
        const std::size_t cosine_s = cosine(s);
        const std::size_t sine_t = sine(t);
        const std::size_t first = multiply(sine_s, cosine(t));
        const std::size_t expanded = add(first, multiply(cosine_s, sine_t));
        return subtract(sine(s + t), expanded);
      }
      case 1: {  // sqrt(y^2) = |y|
        const std::size_t y = tree(depth);
        const bool negative = values_[y].sign() == Sign::negative;
        const std::size_t size = root(multiply(y, copy(y)));
        return subtract(size, negative ? negate(y) : y);
      }
      case 2: {  // sqrt(a) sqrt(b) = sqrt(a b)
        const std::size_t a = positive(tree(depth));
        const std::size_t b = positive(tree(depth));
        const std::size_t root_a = root(a);
        const std::size_t roots = multiply(root_a, root(b));
        return subtract(roots, root(multiply(a, b)));
      }
      case 3: {  // (a + b) (a - b) = a^2 - b^2
        const std::size_t a = tree(depth);
        const std::size_t b = tree(depth);
        const std::size_t sum = add(a, b);
        const std::size_t factored = multiply(sum, subtract(a, b));
        const std::size_t a_squared = multiply(a, a);
        return subtract(factored, subtract(a_squared, multiply(b, b)));
      }
      case 4: {  // a / b - c / d = (a d - b c) / (b d)
        const std::size_t a = tree(depth);
        const std::size_t c = tree(depth);
        const std::size_t b = nonzero(tree(depth));
        const std::size_t d = nonzero(tree(depth));
        const std::size_t first = divide(a, b);
        const std::size_t apart = subtract(first, divide(c, d));
        const std::size_t a_d = multiply(a, d);
        const std::size_t numerator = subtract(a_d, multiply(b, c));
        return subtract(apart, divide(numerator, multiply(b, d)));
      }
      case 5: {  // sqrt(p + q + 2 sqrt(p q)) = sqrt(p) + sqrt(q)
        const std::size_t p = rational(choices_.between(1, 30));
        const std::size_t q = rational(choices_.between(1, 30));
        const std::size_t two = rational(2);
        const std::size_t mixed = multiply(two, root(multiply(p, q)));
        const std::size_t nested = root(add(add(p, q), mixed));
        const std::size_t rest = subtract(nested, root(p));
        return subtract(rest, root(q));
      }
      case 6: {  // sin^2 + cos^2 = 1
        const Rational s = decimal(360, 6);
        const std::size_t a = sine(s);
        const std::size_t b = cosine(s);
        const std::size_t squared = multiply(a, a);
        const std::size_t sum = add(squared, multiply(b, b));
        return subtract(sum, rational(1));
      }
      default: {  // 4 sin(s) sin(60 - s) sin(60 + s) = sin(3 s)
        const Rational s = decimal(360, 4);
        const std::size_t first = sine(s);
        const std::size_t two_factors = multiply(first, sine(60 - s));
        const std::size_t product = multiply(two_factors, sine(60 + s));
        const std::size_t fourfold = multiply(product, rational(4));
        return subtract(fourfold, sine(3 * s));
      }
    }
  }

  /// Half of the time just a tree, up to `depth` deep; else an identity, at times off by a tiny amount or hidden in
  /// further operations.
  std::size_t any(int depth) {
    if (choices_.below(2) == 0) return tree(static_cast<int>(choices_.between(1, depth)));
    const std::size_t z = zero(static_cast<int>(choices_.between(0, depth / 3)));
    switch (choices_.below(4)) {
      case 0:
        return add(z, rational(tiny()));
      case 1:
        return multiply(z, tree(1));
      case 2:
        return add(z, zero(0));
      default:
        return z;
    }
  }

 private:
  std::size_t push(Step step, const Real& value) {
    steps_.push_back(std::move(step));
    values_.push_back(value);
    return steps_.size() - 1;
  }
  // The same value as another step, so that nothing is folded for being one node.
  std::size_t copy(std::size_t a) {
    const std::size_t two = rational(2);
    const std::size_t twice = multiply(a, root(rational(2)));
    return divide(twice, root(two));
  }
  std::size_t nonzero(std::size_t a) { return values_[a].sign() == Sign::zero ? add(a, rational(1)) : a; }
  std::size_t positive(std::size_t a) {
    a = nonzero(a);
    return values_[a].sign() == Sign::negative ? negate(a) : a;
  }
  Rational tiny() {
    Rational power = 1;
    for (std::size_t i = choices_.below(300); i > 0; --i) power /= 10;
    return choices_.below(2) == 0 ? power : Rational(-power);
  }

  Choices& choices_;
  Expression steps_;
  std::vector<Real> values_;
};

}  // namespace toolcomp::exact::test

// SPDX-License-Identifier: Apache-2.0
// A second arithmetic, MPFI with its own sines and cosines in radians at 1536 bits, evaluates 10,000 random expressions
// step by step; its enclosures and signs must agree with those of exact::Real.
#include <gtest/gtest.h>
#include <mpfi.h>

#include <cstdio>
#include <memory>

#include "tests/effort.h"
#include "tests/support/exact/random_expression.h"

namespace toolcomp::exact::test {
namespace {

constexpr mpfr_prec_t precision = 1536;
const int expressions = static_cast<int>(toolcomp::test::random_cases(10'000));

class Number {
 public:
  Number() { mpfi_init2(value_, precision); }
  ~Number() { mpfi_clear(value_); }
  Number(const Number&) = delete;
  Number& operator=(const Number&) = delete;
  mpfi_ptr get() { return value_; }

 private:
  mpfi_t value_;
};

// Enclosures by MPFI; rationals enter through mpfi_set_q only.
struct MpfiArithmetic {
  using Value = std::shared_ptr<Number>;
  static Value make() { return std::make_shared<Number>(); }

  static Value rational(const Rational& value) {
    Value result = make();
    mpfi_set_q(result->get(), value.raw());
    return result;
  }
  static Value radians(const Rational& degrees) {
    Value result = rational(degrees / 180);
    Number pi;
    mpfi_const_pi(pi.get());
    mpfi_mul(result->get(), result->get(), pi.get());
    return result;
  }
  static Value sine(const Rational& degrees) {
    Value result = make();
    mpfi_sin(result->get(), radians(degrees)->get());
    return result;
  }
  static Value cosine(const Rational& degrees) {
    Value result = make();
    mpfi_cos(result->get(), radians(degrees)->get());
    return result;
  }
  static Value pi() {
    Value result = make();
    mpfi_const_pi(result->get());
    return result;
  }
  static Value arctangent(const Value& a) {
    Value result = make();
    mpfi_atan(result->get(), a->get());
    mpfi_mul_ui(result->get(), result->get(), 180);
    mpfi_div(result->get(), result->get(), pi()->get());
    return result;
  }
  static Value negate(const Value& a) {
    Value result = make();
    mpfi_neg(result->get(), a->get());
    return result;
  }
  static Value add(const Value& a, const Value& b) {
    Value result = make();
    mpfi_add(result->get(), a->get(), b->get());
    return result;
  }
  static Value subtract(const Value& a, const Value& b) {
    Value result = make();
    mpfi_sub(result->get(), a->get(), b->get());
    return result;
  }
  static Value multiply(const Value& a, const Value& b) {
    Value result = make();
    mpfi_mul(result->get(), a->get(), b->get());
    return result;
  }
  static Value divide(const Value& a, const Value& b) {
    EXPECT_FALSE(mpfi_has_zero(b->get())) << "a divisor certified by Real";
    Value result = make();
    mpfi_div(result->get(), a->get(), b->get());
    return result;
  }
  static Value root(const Value& a) {
    EXPECT_GE(mpfr_sgn(&a->get()->right), 0) << "a radicand certified by Real";
    Value result = make();
    // A radicand that is zero may be enclosed from below zero on.
    if (mpfr_sgn(&a->get()->left) < 0) mpfr_set_zero(&a->get()->left, +1);
    mpfi_sqrt(result->get(), a->get());
    return result;
  }
};

bool overlap(const Enclosure& bounds, mpfi_ptr x) {
  return mpfr_cmp_q(&x->left, bounds.upper.raw()) <= 0 && mpfr_cmp_q(&x->right, bounds.lower.raw()) >= 0;
}

// 0 stands for an enclosure that holds zero.
int sign_of(mpfi_ptr x) {
  if (mpfr_sgn(&x->left) > 0) return 1;
  return mpfr_sgn(&x->right) < 0 ? -1 : 0;
}

TEST(SecondArithmetic, AgreesOnRandomExpressions) {
  int zeros = 0;
  int undecided = 0;
  for (int i = 0; i < expressions; ++i) {
    Choices choices(static_cast<std::uint64_t>(i));
    Builder builder(choices);
    try {
      builder.any(4);
    } catch (const Undecided&) {
      ++undecided;
      continue;
    }
    RealArithmetic real;
    MpfiArithmetic mpfi;
    const std::vector<Real> values = replay(real, builder.expression());
    const auto enclosures = replay(mpfi, builder.expression());
    constexpr int rough = 20;  // bits that double has
    for (std::size_t step = 0; step < values.size(); ++step) {
      ASSERT_TRUE(overlap(values[step].enclosure(rough), enclosures[step]->get()))
          << "expression " << i << " step " << step;
      ASSERT_TRUE(overlap(values[step].enclosure(), enclosures[step]->get())) << "expression " << i << " step " << step;
    }
    try {
      const Sign sign = values.back().sign();
      ASSERT_EQ(static_cast<int>(sign), sign_of(enclosures.back()->get())) << "expression " << i;
      if (sign == Sign::zero) ++zeros;
      const DoubleEnclosure doubles = values.back().double_enclosure();
      ASSERT_TRUE(overlap({Rational(doubles.lower), Rational(doubles.upper)}, enclosures.back()->get()))
          << "expression " << i;
    } catch (const Undecided&) {
      ++undecided;
    }
  }
  std::printf("%d expressions: %d zero, %d undecided\n", expressions, zeros, undecided);
  EXPECT_GT(zeros, expressions / 4);
  EXPECT_LT(undecided, expressions / 100);
}

}  // namespace
}  // namespace toolcomp::exact::test

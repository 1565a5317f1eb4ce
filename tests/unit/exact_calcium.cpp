// SPDX-License-Identifier: Apache-2.0
// program: calcium
// link: toolcomp_calcium_shim
// Calcium as a second opinion: wherever it decides the sign of one of 10,000 random expressions (200 under
// AddressSanitizer), exact::Real agrees.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/effort.h"
#include "tests/support/exact/calcium_shim.h"
#include "tests/support/exact/random_expression.h"

namespace toolcomp::exact::test {
namespace {

const int expressions = toolcomp::test::effort(200, 10'000);

// Values are slots of the machine, one a step.
class CalciumArithmetic {
 public:
  using Value = int;

  explicit CalciumArithmetic(std::size_t steps) : machine_(calcium_new(static_cast<int>(steps))) {}
  ~CalciumArithmetic() { calcium_delete(machine_); }
  CalciumArithmetic(const CalciumArithmetic&) = delete;
  CalciumArithmetic& operator=(const CalciumArithmetic&) = delete;

  int rational(const Rational& value) { return calcium_rational(machine_, next_, value.str().c_str()), next_++; }
  int sine(const Rational& degrees) { return calcium_sine_of_degrees(machine_, next_, degrees.str().c_str()), next_++; }
  int cosine(const Rational& degrees) {
    return calcium_cosine_of_degrees(machine_, next_, degrees.str().c_str()), next_++;
  }
  int pi() { return calcium_pi(machine_, next_), next_++; }
  int arctangent(int a) { return calcium_arctangent_degrees(machine_, next_, a), next_++; }
  int negate(int a) { return calcium_negate(machine_, next_, a), next_++; }
  int add(int a, int b) { return calcium_add(machine_, next_, a, b), next_++; }
  int subtract(int a, int b) { return calcium_subtract(machine_, next_, a, b), next_++; }
  int multiply(int a, int b) { return calcium_multiply(machine_, next_, a, b), next_++; }
  int divide(int a, int b) { return calcium_divide(machine_, next_, a, b), next_++; }
  int root(int a) { return calcium_root(machine_, next_, a), next_++; }

  calcium_sign sign() { return calcium_sign_of(machine_, next_ - 1); }

 private:
  calcium_machine* machine_;
  int next_ = 0;
};

TEST(Calcium, AgreesWhereItDecides) {
  int zeros = 0;
  int unknown = 0;
  int undecided = 0;
  for (int i = 0; i < expressions; ++i) {
    Choices choices(1'000'000 + static_cast<std::uint64_t>(i));
    Builder builder(choices);
    try {
      const std::size_t last = builder.any(2);
      const int sign = static_cast<int>(builder.value(last).sign());
      CalciumArithmetic calcium(builder.expression().size());
      replay(calcium, builder.expression());
      const calcium_sign opinion = calcium.sign();
      if (opinion == calcium_unknown) {
        ++unknown;
        continue;
      }
      ASSERT_EQ(sign, static_cast<int>(opinion)) << "expression " << i;
      if (sign == 0) ++zeros;
    } catch (const Undecided&) {
      ++undecided;
    }
  }
  std::printf("%d expressions: Calcium proves %d zero, leaves %d unknown; Real leaves %d undecided\n", expressions,
              zeros, unknown, undecided);
  EXPECT_GT(zeros, expressions / 50);
  EXPECT_LT(unknown, expressions / 2);
  EXPECT_LT(undecided, expressions / 100);
}

}  // namespace
}  // namespace toolcomp::exact::test

// SPDX-License-Identifier: Apache-2.0
// Enclosures in double contain what they must, against MPFR on random numbers, and are few numbers of double wide.
#include "model/exact/double_enclosure.h"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <bit>
#include <cmath>
#include <random>

#include "model/exact/interval.h"
#include "tests/effort.h"

namespace toolcomp::exact {
namespace {

constexpr mpfr_prec_t precision = 256;
const int numbers = static_cast<int>(toolcomp::test::random_cases(100'000));
constexpr unsigned long full_turn = 360;

class Random {
 public:
  // Any finite number: subnormal ones, zeros and the greatest among them.
  double any() {
    for (;;) {
      const double x = std::bit_cast<double>(bits_());
      if (std::isfinite(x)) return bits_() % 64 == 0 ? 0 : x;
    }
  }
  // Of about the size of program numbers, and sometimes with few bits, so that results are exact.
  double usual() {
    const double x = static_cast<double>(static_cast<std::int64_t>(bits_() >> (bits_() % 2 == 0 ? 10 : 50))) -
                     (bits_() % 2 == 0 ? 0 : 10'000);
    return std::ldexp(x, -static_cast<int>(bits_() % 60));
  }
  double between(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(bits_() >> 11), -53);
  }
  std::uint64_t word() { return bits_() >> (bits_() % 64); }

 private:
  std::mt19937_64 bits_{1};
};

// A number, rounded by MPFR to one side.
class Number {
 public:
  explicit Number(double x = 0) {
    mpfr_init2(value_, precision);
    mpfr_set_d(value_, x, MPFR_RNDN);
  }
  ~Number() { mpfr_clear(value_); }
  Number(const Number&) = delete;
  Number& operator=(const Number&) = delete;
  Number(Number&&) = delete;
  Number& operator=(Number&&) = delete;
  mpfr_ptr get() { return value_; }

 private:
  mpfr_t value_;
};

// `compute(result, rounding)` gives the value that the enclosure must hold.
template <class Compute>
bool holds(const DoubleEnclosure& x, Compute compute) {
  Number low;
  Number high;
  compute(low.get(), MPFR_RNDD);
  compute(high.get(), MPFR_RNDU);
  return mpfr_cmp_d(low.get(), x.lower) >= 0 && mpfr_cmp_d(high.get(), x.upper) <= 0;
}

bool is_tight(const DoubleEnclosure& x) { return above(above(x.lower)) >= x.upper; }

TEST(DoubleEnclosure, NeighboursAreThoseOfTheStandardLibrary) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Random random;
  for (int i = 0; i < numbers; ++i) {
    const double x = random.any();
    ASSERT_EQ(below(x), std::nextafter(x, -infinity)) << x;
    ASSERT_EQ(above(x), std::nextafter(x, infinity)) << x;
  }
  EXPECT_EQ(below(infinity), std::numeric_limits<double>::max());
  EXPECT_EQ(above(infinity), infinity);
  EXPECT_EQ(below(-infinity), -infinity);
  EXPECT_EQ(below(std::nan("")), -infinity);
  EXPECT_EQ(above(std::nan("")), infinity);
}

template <class Next>
void operations_hold(Next next) {
  for (int i = 0; i < numbers; ++i) {
    const double a = next();
    const double b = next();
    Number x(a);
    Number y(b);
    using Compute = int(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
    const auto check = [&](const DoubleEnclosure& result, Compute* compute) {
      ASSERT_TRUE(holds(result, [&](mpfr_ptr z, mpfr_rnd_t rounding) { compute(z, x.get(), y.get(), rounding); }))
          << a << ' ' << b;
      ASSERT_TRUE(is_tight(result)) << a << ' ' << b;
    };
    check(add(point(a), point(b)), mpfr_add);
    check(subtract(point(a), point(b)), mpfr_sub);
    check(multiply(point(a), point(b)), mpfr_mul);
    if (b != 0) check(divide(point(a), point(b)), mpfr_div);
    ASSERT_TRUE(holds(square(point(a)), [&](mpfr_ptr z, mpfr_rnd_t rounding) { mpfr_sqr(z, x.get(), rounding); })) << a;
    const double size = std::fabs(a);
    mpfr_set_d(x.get(), size, MPFR_RNDN);
    const DoubleEnclosure of_root = root(point(size));
    ASSERT_TRUE(holds(of_root, [&](mpfr_ptr z, mpfr_rnd_t rounding) { mpfr_sqrt(z, x.get(), rounding); })) << a;
    ASSERT_TRUE(is_tight(of_root)) << a;
  }
}
TEST(DoubleEnclosure, OperationsOnAnyNumbersHoldTheirValue) {
  Random random;
  operations_hold([&] { return random.any(); });
}
TEST(DoubleEnclosure, OperationsOnUsualNumbersHoldTheirValue) {
  Random random;
  operations_hold([&] { return random.usual(); });
}

// Small whole numbers: the extremes are attained at the ends, and a value inside must be held.
TEST(DoubleEnclosure, OperationsOnIntervalsHoldAllValues) {
  const auto within = [](double value, const DoubleEnclosure& x) { return x.lower <= value && value <= x.upper; };
  for (int a = -3; a <= 3; ++a)
    for (int b = a; b <= 3; ++b)
      for (int c = -3; c <= 3; ++c)
        for (int d = c; d <= 3; ++d) {
          const DoubleEnclosure x{static_cast<double>(a), static_cast<double>(b)};
          const DoubleEnclosure y{static_cast<double>(c), static_cast<double>(d)};
          for (int p = a; p <= b; ++p)
            for (int q = c; q <= d; ++q) {
              EXPECT_TRUE(within(p + q, add(x, y)));
              EXPECT_TRUE(within(p - q, subtract(x, y)));
              EXPECT_TRUE(within(p * q, multiply(x, y)));
              EXPECT_TRUE(within(p * p, square(x)));
              EXPECT_TRUE(within(-p, negate(x)));
              if (q != 0) {
                EXPECT_TRUE(within(static_cast<double>(p) / q, divide(x, y)));
              }
              if (p >= 0) {
                EXPECT_TRUE(within(std::sqrt(p), root(x)));
              }
            }
          EXPECT_EQ(is_finite(divide(x, y)), c > 0 || d < 0);
        }
}

TEST(DoubleEnclosure, InfiniteEndsGiveNoNumberThatIsNone) {
  const DoubleEnclosure half{1, whole_line.upper};
  for (const DoubleEnclosure& x : {add(half, negate(half)), multiply(point(0), half), divide(half, half),
                                   add(whole_line, whole_line), sine(half), cosine(whole_line), arctangent(half)}) {
    EXPECT_LE(x.lower, -1);
    EXPECT_GE(x.upper, 1);
  }
}

double rounded(const Rational& value, mpfr_rnd_t direction) {
  Number number;
  mpfr_set_q(number.get(), value.raw(), direction);
  return mpfr_get_d(number.get(), direction);
}

TEST(DoubleEnclosure, RationalsAreHeld) {
  Random random;
  const auto check = [](const Rational& value) {
    const DoubleEnclosure x = enclosing(mpq_numref(value.raw()), mpq_denref(value.raw()));
    ASSERT_TRUE(holds(x, [&](mpfr_ptr z, mpfr_rnd_t rounding) { mpfr_set_q(z, value.raw(), rounding); })) << value;
  };
  for (int i = 0; i < numbers; ++i) {
    const Integer a = Integer(random.word()) * (i % 3 == 0 ? Integer(random.word()) : 1);
    const Integer b = Integer(random.word() | 1) * (i % 5 == 0 ? Integer(random.word() | 1) : 1);
    const Rational value = i % 2 == 0 ? Rational(a, b) : Rational(-a, b);
    check(value);
    ASSERT_TRUE(is_tight(enclosing(mpq_numref(value.raw()), mpq_denref(value.raw())))) << value;
    const DoubleEnclosure read = Real(value).double_enclosure();
    ASSERT_EQ(read.lower, rounded(value, MPFR_RNDD)) << value;
    ASSERT_EQ(read.upper, rounded(value, MPFR_RNDU)) << value;
  }
  for (const int bits : {60, 1000, 1022, 1023, 1024, 1050, 1074, 1075, 5000}) {
    const Rational large = Rational(Integer(3) << static_cast<unsigned>(bits));
    for (const Rational& value : {large, Rational(-large), Rational(1 / large), Rational(-1 / large)}) check(value);
  }
}

TEST(DoubleEnclosure, EnclosuresOfMoreBitsAreRoundedOutwards) {
  InlineInterval third;
  set(third, mpq_numref(Rational(1, 3).raw()), mpq_denref(Rational(1, 3).raw()));
  const DoubleEnclosure x = enclosing(third);
  EXPECT_LT(mpfr_cmp_d(third.lower, x.lower) * mpfr_cmp_d(third.upper, x.upper), 0);
  EXPECT_EQ(above(x.lower), x.upper);
}

TEST(DoubleEnclosure, EnclosuresOfMoreBitsAreRoundedAsByMpfr) {
  Random random;
  for (int i = 0; i < numbers; ++i) {
    InlineInterval x;
    const mpfr_exp_t exponent = i % 2 == 0 ? static_cast<mpfr_exp_t>(random.word() % 100) - 50
                                           : static_cast<mpfr_exp_t>(random.word() % 4000) - 2000;
    // Sums of few words: exact in double, or just beside a number of double, among them.
    for (mpfr_ptr end : {x.lower, x.upper}) {
      mpfr_set_d(end, random.any(), MPFR_RNDN);
      if (i % 3 != 0) mpfr_add_si(end, end, static_cast<long>(random.word() >> 1), MPFR_RNDN);
      if (i % 5 == 0) mpfr_nextabove(end);
      if (mpfr_zero_p(end) == 0 && i % 7 != 0) mpfr_set_exp(end, exponent);
    }
    if (mpfr_cmp(x.lower, x.upper) > 0) mpfr_swap(x.lower, x.upper);
    const DoubleEnclosure rounded = enclosing(x);
    ASSERT_EQ(rounded.lower, mpfr_get_d(x.lower, MPFR_RNDD));
    ASSERT_EQ(rounded.upper, mpfr_get_d(x.upper, MPFR_RNDU));
  }
}

// Of points, and of a number inside of an interval.
using Function = int(mpfr_ptr, mpfr_srcptr, unsigned long, mpfr_rnd_t);
void function_holds(DoubleEnclosure (*enclosure)(const DoubleEnclosure&), Function* function, double low, double high) {
  constexpr double widest = 1e-14;  // relative, or of an angle's cosine
  Random random;
  for (int i = 0; i < numbers / 5; ++i) {  // MPFR takes its time
    const double whole = std::nearbyint(random.between(low, high));
    const double a = i % 4 == 0   ? whole
                     : i % 4 == 1 ? whole + std::ldexp(random.usual(), -60)
                                  : random.between(low, high);
    Number x(a);
    const auto compute = [&](mpfr_ptr z, mpfr_rnd_t rounding) { function(z, x.get(), full_turn, rounding); };
    const DoubleEnclosure result = enclosure(point(a));
    ASSERT_TRUE(holds(result, compute)) << a;
    ASSERT_LT(result.upper - result.lower, widest * std::max(1.0, std::fabs(result.upper))) << a;
    const double width = std::ldexp(1, -static_cast<int>(random.word() % 50));
    ASSERT_TRUE(holds(enclosure({a - width * random.between(0, 1), a + width * random.between(0, 1)}), compute)) << a;
  }
}
TEST(DoubleEnclosure, SinesAreHeld) { function_holds(sine, mpfr_sinu, -400, 400); }
TEST(DoubleEnclosure, CosinesAreHeld) { function_holds(cosine, mpfr_cosu, -400, 400); }
TEST(DoubleEnclosure, ArcTangentsAreHeld) {
  function_holds(arctangent, mpfr_atanu, -1.1, 1.1);
  function_holds(arctangent, mpfr_atanu, -1e6, 1e6);
}
TEST(DoubleEnclosure, SmallAnglesKeepTheirSign) {
  for (const double x : {1e-3, 1e-30, 1e-300}) {
    EXPECT_EQ(certain_sign(sine(point(x))), Sign::positive);
    EXPECT_EQ(certain_sign(arctangent(point(-x))), Sign::negative);
  }
}

TEST(DoubleEnclosure, SignsAreCertainOrNone) {
  EXPECT_EQ(certain_sign(DoubleEnclosure{1, 2}), Sign::positive);
  EXPECT_EQ(certain_sign(DoubleEnclosure{-2, -1}), Sign::negative);
  EXPECT_EQ(certain_sign(DoubleEnclosure{0, 0}), Sign::zero);
  EXPECT_EQ(certain_sign(DoubleEnclosure{0, 2}), std::nullopt);
  EXPECT_EQ(certain_sign(DoubleEnclosure{-2, 0}), std::nullopt);
}

TEST(DoubleEnclosure, PiIsHeld) { EXPECT_TRUE(holds(pi_in_double, mpfr_const_pi)); }

}  // namespace
}  // namespace toolcomp::exact

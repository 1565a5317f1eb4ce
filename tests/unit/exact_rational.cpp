// SPDX-License-Identifier: Apache-2.0
// Integers and rationals, held against those of Boost that have an arithmetic of their own (cpp_int, no GMP).
#include "model/exact/rational.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

namespace toolcomp::exact {
namespace {

using Whole = boost::multiprecision::cpp_int;
using Fraction = boost::multiprecision::cpp_rational;

// A number of a few to some hundred digits, often a small one.
std::string digits(std::mt19937_64& bits) {
  const std::size_t length = bits() % 3 == 0 ? 1 + bits() % 200 : 1 + bits() % 3;
  std::string text = bits() % 2 == 0 ? "" : "-";
  text += static_cast<char>('1' + bits() % 9);
  for (std::size_t i = 1; i < length; ++i) text += static_cast<char>('0' + bits() % 10);
  return bits() % 16 == 0 ? "0" : text;
}

// Boost makes no rational of a negative denominator; ours are tried below.
std::string magnitude(std::mt19937_64& bits) {
  const std::string text = digits(bits);
  return text.starts_with('-') ? text.substr(1) : text;
}

TEST(ExactInteger, ComputesAsBoostDoes) {
  std::mt19937_64 bits(1);
  for (int i = 0; i < 2000; ++i) {
    const std::string a = digits(bits);
    const std::string b = digits(bits);
    const Integer x(a);
    const Integer y(b);
    const Whole u(a);
    const Whole v(b);
    ASSERT_EQ(x.str(), u.str());
    ASSERT_EQ((x + y).str(), Whole(u + v).str());
    ASSERT_EQ((x - y).str(), Whole(u - v).str());
    ASSERT_EQ((x * y).str(), Whole(u * v).str());
    ASSERT_EQ((-x).str(), Whole(-u).str());
    ASSERT_EQ(abs(x).str(), Whole(abs(u)).str());
    ASSERT_EQ(gcd(x, y).str(), Whole(gcd(u, v)).str());
    ASSERT_EQ(lcm(x, y).str(), Whole(lcm(u, v)).str());
    ASSERT_EQ(x < y, u < v);
    ASSERT_EQ(x == y, u == v);
    ASSERT_EQ(x.sign(), u.sign());
    ASSERT_EQ((x << 70).str(), Whole(u << 70).str());
    if (v == 0) {
      ASSERT_THROW(static_cast<void>(x / y), std::overflow_error);
      ASSERT_THROW(static_cast<void>(x % y), std::overflow_error);
    } else {
      ASSERT_EQ((x / y).str(), Whole(u / v).str()) << a << '/' << b;
      ASSERT_EQ((x % y).str(), Whole(u % v).str()) << a << '%' << b;
    }
  }
}

TEST(ExactInteger, ConvertsToTheNearestValueOfAType) {
  EXPECT_EQ(static_cast<std::uint32_t>(Integer(7)), 7U);
  EXPECT_EQ(static_cast<std::uint32_t>(Integer(-7)), 0U);
  EXPECT_EQ(static_cast<std::uint32_t>(Integer(1) << 40), std::numeric_limits<std::uint32_t>::max());
  EXPECT_EQ(static_cast<std::int64_t>(-(Integer(1) << 90)), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(static_cast<std::int64_t>(Integer(std::numeric_limits<std::int64_t>::min())),
            std::numeric_limits<std::int64_t>::min());
}

TEST(ExactRational, ComputesAsBoostDoes) {
  std::mt19937_64 bits(2);
  for (int i = 0; i < 2000; ++i) {
    const std::string a = digits(bits);
    const std::string b = magnitude(bits);
    const std::string c = digits(bits);
    const std::string d = magnitude(bits);
    if (b == "0" || d == "0") {
      ASSERT_THROW(Rational(Integer(a), Integer(0)), std::overflow_error);
      continue;
    }
    const Rational x{Integer(a), Integer(b)};
    const Rational y{Integer(c), Integer(d)};
    const Fraction u{Whole(a), Whole(b)};
    const Fraction v{Whole(c), Whole(d)};
    ASSERT_EQ(x.str(), u.str());
    ASSERT_EQ(Rational(x.str()), x);
    ASSERT_EQ((x + y).str(), Fraction(u + v).str());
    ASSERT_EQ((x - y).str(), Fraction(u - v).str());
    ASSERT_EQ((x * y).str(), Fraction(u * v).str());
    ASSERT_EQ(abs(x).str(), Fraction(abs(u)).str());
    ASSERT_EQ(x < y, u < v);
    ASSERT_EQ(x == y, u == v);
    ASSERT_EQ(numerator(x).str(), numerator(u).str());
    ASSERT_EQ(denominator(x).str(), denominator(u).str());
    ASSERT_LE(Rational(floor(x)), x);
    ASSERT_GT(Rational(floor(x)) + 1, x);
    if (v == 0)
      ASSERT_THROW(static_cast<void>(x / y), std::overflow_error);
    else
      ASSERT_EQ((x / y).str(), Fraction(u / v).str());
  }
}

TEST(ExactRational, HasAPositiveDenominatorInLowestTerms) {
  EXPECT_EQ(Rational(6, -4).str(), "-3/2");
  EXPECT_EQ(Rational(-6, -3).str(), "2");
  EXPECT_EQ(denominator(Rational(1, 2) / Rational(-3, 2)), 3);
}

// The nearest double is at least as near as both of its neighbours.
TEST(ExactRational, GivesTheNearestDouble) {
  std::mt19937_64 bits(3);
  for (int i = 0; i < 2000; ++i) {
    const std::string b = digits(bits);
    if (b == "0") continue;
    const Rational x{Integer(digits(bits)), Integer(b)};
    const double nearest = x.to_double();
    const Rational off = abs(x - Rational(nearest));
    for (const double end : {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()})
      ASSERT_LE(off, abs(x - Rational(std::nextafter(nearest, end)))) << x;
  }
}

TEST(ExactRational, ReadsNothingButFractions) {
  for (const char* const text : {"", "x", "1/0", "1/", "/2", " 1", "1 2", "0x1", "1.5", "1/-2"})
    EXPECT_THROW(Rational{std::string(text)}, std::invalid_argument) << text;
  EXPECT_EQ(Rational(std::string("010")), 10);
  EXPECT_THROW(Integer(std::string("--1")), std::invalid_argument);
}

}  // namespace
}  // namespace toolcomp::exact

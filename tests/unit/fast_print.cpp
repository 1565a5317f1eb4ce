// SPDX-License-Identifier: Apache-2.0
// Numbers of the fast engine as text: shortest, plain, and read back to the same double.
#include "fast/basis/print.h"
#include "tests/effort.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>

namespace toolcomp::fast {
namespace {

std::string text(double value) {
  std::string out = "<";
  append_number(out, value);
  return out.substr(1);
}

double read(const std::string& number) {
  double value = 0;
  std::from_chars(number.data(), number.data() + number.size(), value);
  return value;
}

TEST(Print, PlainShortestDecimals) {
  EXPECT_EQ(text(0), "0");
  EXPECT_EQ(text(-0.0), "0");
  EXPECT_EQ(text(0.1), "0.1");
  EXPECT_EQ(text(-36), "-36");
  EXPECT_EQ(text(100.25), "100.25");
  EXPECT_EQ(text(-0.000001), "-0.000001");
  EXPECT_EQ(text(1.0 / 3), "0.3333333333333333");
  EXPECT_EQ(text(5.9999999999999964), "5.9999999999999964");
  EXPECT_EQ(text(1e15), "1000000000000000");
  EXPECT_EQ(text(1e20), "100000000000000000000");
  EXPECT_EQ(text(9.9e-8), "9.9e-08");
  EXPECT_EQ(text(1e300), "1e+300");
  EXPECT_EQ(text(123456.789), "123456.789");
  EXPECT_EQ(text(0.3), "0.3");
  EXPECT_EQ(text(0.1 + 0.2), "0.30000000000000004");
}

// Against std::to_chars: the same length, the same double.
TEST(Print, ShortestOfAll) {
  std::mt19937_64 random(1);
  const auto check = [](double value) {
    const std::string number = text(value);
    ASSERT_EQ(read(number), value) << number;
    ASSERT_LE(number.size(), kNumberText);
    if (std::abs(value) >= 1e-7 && std::abs(value) < 1e15) {
      char buffer[64];
      const auto shortest = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed);
      ASSERT_EQ(number, std::string(buffer, shortest.ptr));
    }
  };
  for (std::uint64_t i = 0; i < test::random_cases(200'000); ++i) {
    const double any = std::bit_cast<double>(random());
    if (std::isfinite(any) && any != 0) check(any);
    // Decimals of all lengths, and the doubles next to them.
    const auto places = static_cast<int>(random() % 9);
    const double decimal =
        static_cast<double>(static_cast<std::int64_t>(random() % 2'000'000'000'000) - 1'000'000'000'000) /
        std::pow(10.0, places);
    if (decimal == 0) continue;
    check(decimal);
    check(std::nextafter(decimal, 1e300));
    check(std::nextafter(decimal, -1e300));
  }
}

// The doubles around decimals of 15 to 17 digits and around halves of them, where the shortest text is hard to tell
// from others, in the whole range of the product and at its ends.
TEST(Print, ShortestNearTies) {
  std::mt19937_64 random(2);
  for (std::uint64_t i = 0; i < test::random_cases(300'000); ++i) {
    const auto exponent = static_cast<int>(random() % 80) - 64;  // from 2^-12 to 2^68
    std::uint64_t mantissa = random() >> 11U | std::uint64_t{1} << 52U;
    const auto cleared = random() % 53;
    if (i % 2 == 0) mantissa = mantissa >> cleared << cleared;
    const double value = std::ldexp(static_cast<double>(mantissa), exponent);
    char buffer[64];
    const auto shortest = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed);
    ASSERT_EQ(text(value), std::string(buffer, shortest.ptr));
  }
}

TEST(NumberWriter, WritesTheSameAgain) {
  std::mt19937_64 random(3);
  NumberWriter writer;
  for (std::uint64_t i = 0; i < test::random_cases(10'000); ++i) {
    const double value = static_cast<double>(random() % 40) / (i % 2 == 0 ? 3 : -4);
    std::array<char, kNumberText> written{};
    char* const end = writer.write(written.data(), value);
    ASSERT_EQ(std::string(written.data(), end), text(value));
  }
}

}  // namespace
}  // namespace toolcomp::fast

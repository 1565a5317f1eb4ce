// SPDX-License-Identifier: Apache-2.0
#include "certify/kit/marks.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace toolcomp::certify::kit {
namespace {

// Rests that count: those at the place of the marks with a length of marks.
struct Sign {
  std::size_t rest = 0;
  unsigned length = 0;
  bool above = false;
};

std::vector<Sign> signs_of(std::span<const Rest> rests) {
  std::vector<Sign> signs;
  for (std::size_t i = 0; i < rests.size(); ++i)
    if (const auto length = length_of(rests[i]); length && rests[i].at_place)
      signs.push_back({i, *length, rests[i].above});
  return signs;
}

// The number whose mark begins with this sign.
std::optional<unsigned> mark_at(std::span<const Sign> signs, std::size_t begin) {
  if (signs.size() < begin + kDigits) return std::nullopt;
  std::array<unsigned, kDigits> digits{};
  for (std::size_t i = 0; i < kDigits; ++i) {
    const Sign& sign = signs[begin + i];
    if (sign.length >= kCaseEnd || sign.above != (i % 2 == 1)) return std::nullopt;
    digits.at(i) = (sign.length - digit_length(0)) / (digit_length(1) - digit_length(0));
  }
  return number_of(digits);
}

}  // namespace

std::array<unsigned, kDigits> digits_of(unsigned number) {
  if (number > kMostNumber) throw std::logic_error("the kit has too many programs");
  std::array<unsigned, kDigits> digits{};
  for (std::size_t i = kDigits - 1; i-- > 0; number /= kBase) digits.at(i) = number % kBase;
  unsigned check = 1;
  for (std::size_t i = 0; i + 1 < kDigits; ++i) check += (i % 2 == 0 ? 1 : 3) * digits.at(i);
  digits.back() = check % kBase;
  return digits;
}

std::optional<unsigned> number_of(std::span<const unsigned> digits) {
  if (digits.size() != kDigits) return std::nullopt;
  unsigned number = 0;
  for (const unsigned digit : digits.first(kDigits - 1)) {
    if (digit >= kBase) return std::nullopt;
    number = number * kBase + digit;
  }
  if (digits_of(number).back() != digits.back()) return std::nullopt;
  return number;
}

std::optional<unsigned> length_of(const Rest& rest) {
  constexpr double kNear = 200;  // ms
  const double length = (rest.end - rest.begin) * 1000;
  for (const unsigned expected :
       {digit_length(0), digit_length(1), digit_length(2), digit_length(3), kCaseEnd, kProgramEnd})
    if (std::abs(length - expected) <= kNear) return expected;
  return std::nullopt;
}

std::vector<Found> find_programs(std::span<const Rest> rests) {
  const std::vector<Sign> signs = signs_of(rests);
  std::vector<Found> programs;
  bool open = false;
  for (std::size_t i = 0; i < signs.size(); ++i) {
    if (const auto number = mark_at(signs, i)) {
      programs.push_back({*number, signs[i].rest, std::nullopt, {}});
      open = true;
      i += kDigits - 1;
    } else if (open && signs[i].length == kCaseEnd && !signs[i].above) {
      programs.back().case_ends.push_back(signs[i].rest);
    } else if (open && signs[i].length == kProgramEnd && !signs[i].above) {
      programs.back().end_rest = signs[i].rest;
      open = false;
    }
  }
  return programs;
}

}  // namespace toolcomp::certify::kit

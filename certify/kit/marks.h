// SPDX-License-Identifier: Apache-2.0
// Marks: rests of certain lengths. By them a recording with a time column shows which program it is, and where its
// cases end.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace toolcomp::certify::kit {

// A program begins with kDigits rests at the place of the marks, with the mark axis alternately at this place and one
// unit (mm or inch) above. Their lengths give the digits of its number in the kit to the base kBase. The last digit is
// a check digit.
inline constexpr std::size_t kDigits = 6;
inline constexpr unsigned kBase = 4;
inline constexpr unsigned kMostNumber = 1023;  // kBase to the power of kDigits - 1, less one

// Milliseconds. Two lengths are half a second apart, and no rest of a mark is shorter than a second.
constexpr unsigned digit_length(unsigned digit) { return 1000 + 500 * digit; }
inline constexpr unsigned kCaseEnd = 3500;     // after a case, at the place of the marks
inline constexpr unsigned kProgramEnd = 4500;  // after the last case

// The digits of a program, the most significant first, the check digit last: the sum of the digits before it with
// alternate weights 1 and 3, plus 1, modulo kBase. One wrong digit is always found.
std::array<unsigned, kDigits> digits_of(unsigned number);
// The number with these digits; std::nullopt if the check digit is wrong.
std::optional<unsigned> number_of(std::span<const unsigned> digits);

// A rest, as a recording shows it.
struct Rest {
  double begin = 0;  // seconds
  double end = 0;
  double at = 0;          // position of the mark axis
  bool at_place = false;  // all other axes are at the place of the marks, and this axis is there or one unit above
  bool above = false;     // one unit above it
  std::size_t first = 0;  // samples
  std::size_t last = 0;
};

// A program found in a recording.
struct Found {
  unsigned number = 0;
  std::size_t first_rest = 0;           // of its mark
  std::optional<std::size_t> end_rest;  // the rest after its last case; std::nullopt if the recording ends before it
  std::vector<std::size_t> case_ends;   // rests after its cases
};

// Which length of a mark the rest has, to within 0.2 s; std::nullopt if it has none.
std::optional<unsigned> length_of(const Rest& rest);

// The programs that the rests show, in order. A rest that is not at the place of the marks, or has no length of a mark,
// is part of a case and is ignored.
std::vector<Found> find_programs(std::span<const Rest> rests);

}  // namespace toolcomp::certify::kit

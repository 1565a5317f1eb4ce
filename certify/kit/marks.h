// SPDX-License-Identifier: Apache-2.0
// Marks: rests of distinct lengths by which a recording with a time column shows which program it is, and where its
// cases end.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace toolcomp::certify::kit {

// A program begins with kDigits rests at the place of the marks, the mark axis alternately there and one unit (mm or
// inch) above. Their lengths are the digits of its number in the kit to the base kBase, the last one a check digit.
inline constexpr std::size_t kDigits = 6;
inline constexpr unsigned kBase = 4;
inline constexpr unsigned kMostNumber = 1023;  // kBase to the power of kDigits - 1, less one

// Milliseconds. Two lengths are half a second apart, and no rest of a mark is shorter than a second.
constexpr unsigned digit_length(unsigned digit) { return 1000 + 500 * digit; }
inline constexpr unsigned kCaseEnd = 3500;     // behind a case, at the place of the marks
inline constexpr unsigned kProgramEnd = 4500;  // behind the last one's

// The digits of a program, the most significant first, the check digit last: a sum of those before it with weights
// 1 and 3 by turns, plus 1, to the base kBase: one wrong digit is always found.
std::array<unsigned, kDigits> digits_of(unsigned number);
// The number whose digits they are; nothing where the check digit is another.
std::optional<unsigned> number_of(std::span<const unsigned> digits);

// Lengths of rests as a recording shows them.
struct Rest {
  double begin = 0;  // seconds
  double end = 0;
  double at = 0;          // position of the mark axis
  bool at_place = false;  // all other axes stand at the place of the marks, and this one there or one unit above
  bool above = false;     // one unit above it
  std::size_t first = 0;  // samples
  std::size_t last = 0;
};

// A program found in a recording.
struct Found {
  unsigned number = 0;
  std::size_t first_rest = 0;           // of its mark
  std::optional<std::size_t> end_rest;  // the rest behind its last case; nothing: the recording ends before it
  std::vector<std::size_t> case_ends;   // rests behind its cases
};

// Which of the lengths of marks the rest has, to within 0.2 s; nothing where none.
std::optional<unsigned> length_of(const Rest& rest);

// The programs that the rests show, in order. A rest away from the place of the marks, or of no length of marks, is
// part of a case and means nothing.
std::vector<Found> find_programs(std::span<const Rest> rests);

}  // namespace toolcomp::certify::kit

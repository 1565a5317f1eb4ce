// SPDX-License-Identifier: Apache-2.0
// Numbers of the fast engine as text: ours, because std::to_chars takes three to five times as long
// (tests/bench/print_bench.cpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace toolcomp::fast {

// Room enough for any double write_number() writes, and for the rest of its last word.
inline constexpr std::size_t kNumberText = 48;

// The shortest text that reads back as `value`, without exponent between 1e-7 and 1e21; never -0. Writes at most
// kNumberText characters at `to` and returns the end. `value` must be finite.
char* write_number(char* to, double value);

// The same, appended.
void append_number(std::string& text, double value);

// The same again for the numbers of a path, most of which it says more than once: coordinates that stay or that no
// offset changes, the feed. What was written lately is copied.
class NumberWriter {
 public:
  char* write(char* to, double value);

 private:
  struct Written {
    std::uint64_t bits = 0;  // of the value
    std::size_t size = 1;    // 0: it came once, and its text is not kept
    std::array<char, kNumberText> text{'0'};
  };
  static constexpr unsigned kIndexBits = 4;
  std::array<Written, std::size_t{1} << kIndexBits> lately_;
};

}  // namespace toolcomp::fast

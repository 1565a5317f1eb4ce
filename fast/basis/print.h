// SPDX-License-Identifier: Apache-2.0
// Writes numbers of the fast engine as text. We use our own code because std::to_chars takes three to five times as
// long (tests/bench/print_bench.cpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace toolcomp::fast {

// Enough room for any double that write_number() writes, and for the rest of its last word.
inline constexpr std::size_t kNumberText = 48;

// The shortest text that reads back as `value`, without exponent between 1e-7 and 1e21; never -0. Writes at most
// kNumberText characters at `to` and returns the end. `value` must be finite.
char* write_number(char* to, double value);

// The same, appended.
void append_number(std::string& text, double value);

// The same for the numbers of a path, most of which come more than once: coordinates that stay or that no offset
// changes, the feed. Recently written texts are copied.
class NumberWriter {
 public:
  char* write(char* to, double value);

 private:
  struct Written {
    std::uint64_t bits = 0;  // of the value
    std::size_t size = 1;    // 0: the value came only once, and its text is not kept
    std::array<char, kNumberText> text{'0'};
  };
  static constexpr unsigned kIndexBits = 4;
  std::array<Written, std::size_t{1} << kIndexBits> lately_;
};

}  // namespace toolcomp::fast

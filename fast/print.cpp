#include "fast/print.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace toolcomp::fast {

namespace {

// Most numbers of a path are decimals of at most six places. If value = k / 10^6 for a whole k of at most 15 digits,
// then k with its trailing zeros dropped is the shortest text: decimals of 15 digits or fewer that differ lie nearest
// to different doubles, so no shorter one reads back as the same.
constexpr double kSmall = 1e6;
constexpr double kMost = 1e15;

// Two digits at a time.
constexpr auto kPairs = [] {
  std::array<char, 200> pairs{};
  for (std::size_t i = 0; i < 100; ++i) {
    pairs[2 * i] = static_cast<char>('0' + i / 10);
    pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
  }
  return pairs;
}();

char* write_whole(char* to, std::uint64_t whole) {
  std::array<char, 20> digits;  // NOLINT(cppcoreguidelines-pro-type-member-init): written from the end
  std::size_t at = digits.size();
  while (whole >= 100) {
    const auto pair = static_cast<std::size_t>(whole % 100) * 2;
    whole /= 100;
    digits[--at] = kPairs[pair + 1];
    digits[--at] = kPairs[pair];
  }
  if (whole >= 10) {
    digits[--at] = kPairs[static_cast<std::size_t>(whole) * 2 + 1];
    digits[--at] = kPairs[static_cast<std::size_t>(whole) * 2];
  } else {
    digits[--at] = static_cast<char>('0' + whole);
  }
  std::memcpy(to, digits.data() + at, digits.size() - at);
  return to + (digits.size() - at);
}

char* write_millionths(char* to, std::uint64_t millionths) {
  to = write_whole(to, millionths / 1'000'000);
  auto rest = static_cast<std::uint32_t>(millionths % 1'000'000);
  if (rest == 0) return to;
  *to++ = '.';
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t divisor = i == 0 ? 10'000 : (i == 1 ? 100 : 1);
    const auto pair = static_cast<std::size_t>(rest / divisor) * 2;
    rest %= divisor;
    std::memcpy(to, kPairs.data() + pair, 2);
    to += 2;
  }
  while (to[-1] == '0') --to;
  return to;
}

}  // namespace

char* write_number(char* to, double value) {
  const double magnitude = std::abs(value);
  const double scaled = magnitude * kSmall;
  if (scaled < kMost) {
    // A wrong guess is found out by the division.
    const auto whole = static_cast<std::int64_t>(scaled + 0.5);  // NOLINT(bugprone-incorrect-roundings)
    if (static_cast<double>(whole) / kSmall == magnitude) {
      if (value < 0) *to++ = '-';
      return write_millionths(to, static_cast<std::uint64_t>(whole));
    }
  }
  // Shortest digits padded with zeros: below 1e21 at most 21 and a sign, above 1e-7 at most 25 behind "0.".
  const auto format = magnitude >= 1e-7 && magnitude < 1e21 ? std::chars_format::fixed : std::chars_format::scientific;
  return std::to_chars(to, to + kNumberText, value, format).ptr;
}

void append_number(std::string& text, double value) {
  char buffer[kNumberText];
  text.append(buffer, write_number(buffer, value));
}

}  // namespace toolcomp::fast

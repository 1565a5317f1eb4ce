#include "fast/print.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "fast/arithmetic/int128.h"

namespace toolcomp::fast {

namespace {

// A decimal that is not negative: whole + fraction / 10^19. At most 16 digits before the point, and below 10^19 behind.
struct Decimal {
  std::uint64_t whole = 0;
  std::uint64_t fraction = 0;
};
constexpr unsigned kMostPlaces = 19;

constexpr auto kPowers = [] {
  std::array<std::uint64_t, kMostPlaces + 1> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = 10 * powers[i - 1];
  return powers;
}();

// Digits are made and written eight at a time, as text in a word whose lowest byte comes first.
static_assert(std::endian::native == std::endian::little);
constexpr std::uint64_t kEightZeros = 0x3030303030303030;
constexpr std::uint64_t kEightDigits = 100'000'000;

// Of a number below 10^8: halves, then pairs, then single digits, all of them in one multiplication. The quotients by
// 100 and 10 are those of 10486 / 2^20 and 103 / 2^10, right for numbers below 10^4 and 10^2.
constexpr std::uint64_t eight_digits(std::uint64_t number) {
  const std::uint64_t halves = number / 10'000 | (number % 10'000) << 32U;
  const std::uint64_t hundreds = (halves * 10'486 >> 20U) & 0x0000'007F'0000'007F;
  const std::uint64_t pairs = hundreds | (halves - 100 * hundreds) << 16U;
  const std::uint64_t tens = (pairs * 103 >> 10U) & 0x000F'000F'000F'000F;
  return kEightZeros + (tens | (pairs - 10 * tens) << 8U);
}

int leading_zeros(std::uint64_t eight) { return std::countr_zero(eight ^ kEightZeros) / 8; }
int trailing_zeros(std::uint64_t eight) { return std::countl_zero(eight ^ kEightZeros) / 8; }

// These write whole words; the end they return is that of the digits which count.
char* write_eight(char* to, std::uint64_t eight) {
  std::memcpy(to, &eight, sizeof eight);
  return to + sizeof eight;
}

// Without leading zeros.
char* write_whole(char* to, std::uint64_t whole) {
  const std::uint64_t first = whole >= kEightDigits ? whole / kEightDigits : whole;
  const std::uint64_t digits = eight_digits(first);
  const int zeros = std::min(leading_zeros(digits), 7);
  to = write_eight(to, digits >> 8 * zeros) - zeros;
  return whole >= kEightDigits ? write_eight(to, eight_digits(whole % kEightDigits)) : to;
}

// The point and fraction / 10^19 behind it, without trailing zeros.
char* write_fraction(char* to, std::uint64_t fraction) {
  if (fraction == 0) return to;
  *to++ = '.';
  std::uint64_t digits = eight_digits(fraction / kPowers[11]);
  to = write_eight(to, digits);
  if (const std::uint64_t behind = fraction % kPowers[11]; behind != 0) {
    digits = eight_digits(behind / kPowers[3]);
    to = write_eight(to, digits);
    if (const std::uint64_t last = behind % kPowers[3]; last != 0) {
      digits = eight_digits(last * kPowers[5]);
      to = write_eight(to, digits);
    }
  }
  return to - trailing_zeros(digits);
}

// Signs come in no order a processor could foresee: no branch.
char* write_sign(char* to, double value) {
  *to = '-';
  return to + (value < 0 ? 1 : 0);
}

inline char* write_decimal(char* to, const Decimal& decimal) {
  return write_fraction(write_whole(to, decimal.whole), decimal.fraction);
}

// A positive double: mantissa / 2^shift, both whole.
struct Binary {
  static constexpr std::uint64_t kHidden = std::uint64_t{1} << 52U;
  static constexpr std::uint64_t kFraction = kHidden - 1;

  explicit Binary(double value)
      : mantissa((std::bit_cast<std::uint64_t>(value) & kFraction) | kHidden),
        shift(1075 - static_cast<unsigned>(std::bit_cast<std::uint64_t>(value) >> 52U)) {}

  std::uint64_t mantissa;
  unsigned shift;
};

// What shortest() takes: 2^-11 to 2^52, but no power of two, whose neighbours are not equally far.
constexpr bool is_usual(const Binary& value) {
  return value.shift >= 1 && value.shift <= 63 && value.mantissa != Binary::kHidden;
}

// The shortest of the decimals that are nearer to `value` than to any other double, and of several the nearest to it.
// With the fewest places whose unit is not above the distance of the doubles, one to ten multiples of the unit are
// nearer: if one of them ends in 0 it is the shortest (of further digits 0 none is written), otherwise all are equally
// long. A decimal halfway between two doubles is read as the even one.
Decimal shortest(const Binary& value) {
  const unsigned places = (value.shift * 1233 >> 12U) + 1;  // 10^(places - 1) < 2^shift < 10^places
  const std::uint64_t one = kPowers[places];
  // In units of 10^-places / 2^64: the value behind its point, and what is nearer to it on either side.
  const std::uint64_t behind = value.mantissa << (64 - value.shift);
  const UInt128 scaled = static_cast<UInt128>(behind) * one;
  const UInt128 half = (static_cast<UInt128>(one) << 63U >> value.shift) - (value.mantissa & 1U);
  // In units of 10^-places.
  const auto most = static_cast<std::uint64_t>((scaled + half) >> 64U);
  const std::uint64_t round = most - most % 10;
  const auto below = static_cast<std::uint64_t>(scaled >> 64U);
  const auto rest = static_cast<std::uint64_t>(scaled);
  const bool tie = rest == std::uint64_t{1} << 63U;
  const std::uint64_t nearest = below + (rest >> 63U) - (tie ? 1 - below % 2 : 0);
  const bool has_round = (static_cast<UInt128>(round) << 64U) + half >= scaled;
  // Which it is cannot be foreseen: no branch.
  const std::uint64_t digits = nearest ^ ((nearest ^ round) & (0 - static_cast<std::uint64_t>(has_round)));
  const std::uint64_t whole = value.mantissa >> value.shift;
  if (digits == one) return {whole + 1, 0};
  return {whole, digits * kPowers[kMostPlaces - places]};
}

// Most numbers of a path are decimals of at most six places. If value = k / 10^6 for a whole k of at most 15 digits,
// then k with its trailing zeros dropped is the shortest text: decimals of 15 digits or fewer that differ lie nearest
// to different doubles, so no shorter one reads back as the same.
constexpr std::uint64_t kMillion = 1'000'000;
constexpr double kMost = 1e15;

Decimal millionths(std::uint64_t count) {
  return {count / kMillion, count % kMillion * (kPowers[kMostPlaces] / kMillion)};
}

}  // namespace

char* write_number(char* to, double value) {
  const double magnitude = std::abs(value);
  const double scaled = magnitude * kMillion;
  if (scaled < kMost) {
    // A wrong guess is found out by the division, most of them without.
    const auto count = static_cast<std::int64_t>(scaled + 0.5);  // NOLINT(bugprone-incorrect-roundings)
    const auto whole = static_cast<double>(count);
    if (std::abs(scaled - whole) <= 0x1p-51 * scaled && whole / kMillion == magnitude)
      return write_decimal(write_sign(to, value), millionths(static_cast<std::uint64_t>(count)));
  }
  if (const Binary binary(magnitude); is_usual(binary)) return write_decimal(write_sign(to, value), shortest(binary));
  // Shortest digits padded with zeros: below 1e21 at most 21 and a sign, above 1e-7 at most 25 behind "0.".
  const auto format = magnitude >= 1e-7 && magnitude < 1e21 ? std::chars_format::fixed : std::chars_format::scientific;
  return std::to_chars(to, to + kNumberText, value, format).ptr;
}

void append_number(std::string& text, double value) {
  char buffer[kNumberText];
  text.append(buffer, write_number(buffer, value));
}

char* NumberWriter::write(char* to, double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  // Any odd factor spreads the values; 0, which every place holds at first, belongs to the first one.
  Written& written = lately_[bits * 0x9E37'79B9'7F4A'7C15 >> (64 - kIndexBits)];
  if (written.bits == bits && written.size != 0) {
    std::memcpy(to, written.text.data(), kNumberText);
    return to + written.size;
  }
  char* const end = write_number(to, value);
  // Most numbers come once: kept is the text of one that comes again.
  const bool again = written.bits == bits;
  written.bits = bits;
  written.size = 0;
  if (again) {
    written.size = static_cast<std::size_t>(end - to);
    std::memcpy(written.text.data(), to, kNumberText);
  }
  return end;
}

}  // namespace toolcomp::fast

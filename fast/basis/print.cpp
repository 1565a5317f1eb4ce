// SPDX-License-Identifier: Apache-2.0
#include "fast/basis/print.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

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

// Three digits, and how many of them count.
struct Three {
  std::array<char, 3> text{};
  std::uint8_t size = 0;
};
constexpr std::uint64_t kThousand = 1000;
using Threes = std::array<Three, kThousand>;
constexpr std::array<char, 3> three_digits(std::size_t number) {
  return {static_cast<char>('0' + number / 100), static_cast<char>('0' + number / 10 % 10),
          static_cast<char>('0' + number % 10)};
}
// Before the point: without leading zeros.
constexpr Threes kWholes = [] {
  Threes wholes;
  for (std::size_t i = 0; i < kThousand; ++i) {
    const std::size_t zeros = i < 10 ? 2 : i < 100 ? 1 : 0;
    const std::array<char, 3> digits = three_digits(i);
    for (std::size_t j = zeros; j < 3; ++j) wholes[i].text[j - zeros] = digits[j];
    wholes[i].size = static_cast<std::uint8_t>(3 - zeros);
  }
  return wholes;
}();
// Behind it: without trailing zeros.
constexpr Threes kTails = [] {
  Threes tails;
  for (std::size_t i = 0; i < kThousand; ++i)
    tails[i] = {three_digits(i), static_cast<std::uint8_t>(i == 0 ? 0 : i % 100 == 0 ? 1 : i % 10 == 0 ? 2 : 3)};
  return tails;
}();

// These write whole words; the end they return is that of the digits which count.
char* write_eight(char* to, std::uint64_t eight) {
  std::memcpy(to, &eight, sizeof eight);
  return to + sizeof eight;
}

char* write_long_whole(char* to, std::uint64_t whole) {
  const std::uint64_t first = whole >= kEightDigits ? whole / kEightDigits : whole;
  const std::uint64_t digits = eight_digits(first);
  const int zeros = leading_zeros(digits);
  to = write_eight(to, digits >> 8 * zeros) - zeros;
  return whole >= kEightDigits ? write_eight(to, eight_digits(whole % kEightDigits)) : to;
}

// Without leading zeros.
inline char* write_whole(char* to, std::uint64_t whole) {
  if (whole >= kThousand) [[unlikely]]
    return write_long_whole(to, whole);
  const Three& three = kWholes[whole];
  std::memcpy(to, &three, sizeof three);
  return to + three.size;
}

// Writes sixteen digits, those of two numbers below 10^8, and says how many stand before the zeros at their end.
#ifdef __SSE2__
// As eight_digits(), both numbers at once. The quotients by 10^4, 100 and 10 are those of 3518437209 / 2^45, right
// below 2^32, of 5243 / 2^19 and of 6554 / 2^16.
inline unsigned write_sixteen(char* to, std::uint64_t first, std::uint64_t second) {
  const __m128i eights = _mm_set_epi64x(static_cast<std::int64_t>(second), static_cast<std::int64_t>(first));
  const __m128i fours = _mm_srli_epi64(_mm_mul_epu32(eights, _mm_set1_epi64x(3'518'437'209)), 45);
  const __m128i low_fours = _mm_sub_epi32(eights, _mm_mul_epu32(fours, _mm_set1_epi64x(10'000)));
  const __m128i halves = _mm_or_si128(fours, _mm_slli_epi64(low_fours, 32));
  const __m128i twos = _mm_srli_epi16(_mm_mulhi_epu16(halves, _mm_set1_epi16(5'243)), 3);
  const __m128i low_twos = _mm_sub_epi16(halves, _mm_mullo_epi16(twos, _mm_set1_epi16(100)));
  const __m128i pairs = _mm_or_si128(twos, _mm_slli_epi32(low_twos, 16));
  const __m128i tens = _mm_mulhi_epu16(pairs, _mm_set1_epi16(6'554));
  const __m128i ones = _mm_sub_epi16(pairs, _mm_mullo_epi16(tens, _mm_set1_epi16(10)));
  const __m128i digits = _mm_or_si128(tens, _mm_slli_epi16(ones, 8));
  _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm_add_epi8(digits, _mm_set1_epi8('0')));
  const auto zeros = static_cast<unsigned>(_mm_movemask_epi8(_mm_cmpeq_epi8(digits, _mm_setzero_si128())));
  return static_cast<unsigned>(std::bit_width(zeros ^ 0xFFFFU));
}
#else
unsigned trailing_zeros(std::uint64_t eight) {
  return static_cast<unsigned>(std::countl_zero(eight ^ kEightZeros)) / 8;
}

inline unsigned write_sixteen(char* to, std::uint64_t first, std::uint64_t second) {
  const std::uint64_t first_digits = eight_digits(first);
  const std::uint64_t second_digits = eight_digits(second);
  write_eight(to, first_digits);
  write_eight(to + 8, second_digits);
  return second != 0 ? 16 - trailing_zeros(second_digits) : 8 - trailing_zeros(first_digits);
}
#endif

// The point and fraction / 10^19 behind it, without trailing zeros. How many of them count follows no pattern: no
// branch.
inline char* write_fraction(char* to, std::uint64_t fraction) {
  if (fraction == 0) return to;
  *to++ = '.';
  const std::uint64_t sixteen = fraction / kThousand;
  const Three& tail = kTails[fraction - sixteen * kThousand];
  const std::uint64_t first = sixteen / kEightDigits;
  const unsigned count = write_sixteen(to, first, sixteen - first * kEightDigits);
  std::memcpy(to + 16, &tail, sizeof tail);
  const unsigned all = 16U + tail.size;
  return to + count + ((all - count) & (0U - (tail.size + 3U) / 4U));
}

// Signs come in no order a processor could foresee: no branch.
inline char* write_sign(char* to, double value) {
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

// By the shift of a double: the unit of its last place.
struct Unit {
  std::uint64_t one = 0;    // 1 in it: 10^places, 10^(places - 1) < 2^shift < 10^places
  std::uint64_t align = 0;  // it in 10^-19
  UInt128 half = 0;         // half the distance of two doubles, by 2^64
};
constexpr auto kUnitsByShift = [] {
  std::array<Unit, 64> units;
  for (unsigned shift = 1; shift < units.size(); ++shift) {
    const unsigned places = (shift * 1233 >> 12U) + 1;
    units[shift] = {kPowers[places], kPowers[kMostPlaces - places],
                    static_cast<UInt128>(kPowers[places]) << 63U >> shift};
  }
  return units;
}();

// The shortest of the decimals that are nearer to `value` than to any other double, and of several the nearest to it.
// With the fewest places whose unit is not above the distance of the doubles, one to ten multiples of the unit are
// nearer: if one of them ends in 0 it is the shortest (of further digits 0 none is written), otherwise all are equally
// long. A decimal halfway between two doubles is read as the even one.
inline Decimal shortest(const Binary& value) {
  const Unit& unit = kUnitsByShift[value.shift];
  // In units of 10^-places / 2^64: the value behind its point, and what is nearer to it on either side.
  const std::uint64_t behind = value.mantissa << (64 - value.shift);
  const UInt128 scaled = static_cast<UInt128>(behind) * unit.one;
  const UInt128 half = unit.half - (value.mantissa & 1U);
  // In units of 10^-places.
  const auto most = static_cast<std::uint64_t>((scaled + half) >> 64U);
  const std::uint64_t round = most - most % 10;
  const auto below = static_cast<std::uint64_t>(scaled >> 64U);
  const auto rest = static_cast<std::uint64_t>(scaled);
  const std::uint64_t tie = rest == std::uint64_t{1} << 63U ? 1 : 0;
  const std::uint64_t nearest = below + (rest >> 63U) - (tie & ~below);
  const bool has_round = (static_cast<UInt128>(round) << 64U) + half >= scaled;
  // Which it is cannot be foreseen: no branch.
  const std::uint64_t digits = nearest ^ ((nearest ^ round) & (0 - static_cast<std::uint64_t>(has_round)));
  const std::uint64_t whole = value.mantissa >> value.shift;
  if (digits == unit.one) [[unlikely]]
    return {whole + 1, 0};
  return {whole, digits * unit.align};
}

// Most numbers of a path are decimals of at most six places. If value = k / 10^6 for a whole k of at most 15 digits,
// then k with its trailing zeros dropped is the shortest text: decimals of 15 digits or fewer that differ lie nearest
// to different doubles, so no shorter one reads back as the same.
constexpr std::uint64_t kMillion = 1'000'000;
constexpr double kMostPrinted = 1e15;

Decimal millionths(std::uint64_t count) {
  return {count / kMillion, count % kMillion * (kPowers[kMostPlaces] / kMillion)};
}

}  // namespace

char* write_number(char* to, double value) {
  const double magnitude = std::abs(value);
  const double scaled = magnitude * kMillion;
  if (scaled < kMostPrinted) {
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

// SPDX-License-Identifier: Apache-2.0
// Reads letters, numbers and values of a Klartext text. Every function takes a place and returns the place after what
// it has read, or nullptr if something else is there. Internal to the reader.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "spec/language/digits.h"
#include "spec/language/heidenhain/klartext_block.h"

namespace toolcomp::spec::klartext {

// A program may be written in lower case.
constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

// The characters that may follow a word: a blank, the begin of a comment, the end of the line, or the ~ of a
// continuation.
inline constexpr std::array<bool, 256> kEndsWords = [] {
  std::array<bool, 256> ends{};
  for (const char c : std::string_view(" \t\r\n;~")) ends[static_cast<unsigned char>(c)] = true;
  return ends;
}();
inline bool at_word_end(const char* at) { return kEndsWords[static_cast<unsigned char>(*at)]; }

// Reads this word, which is given in upper case.
inline const char* read_word(const char* at, std::string_view word) {
  for (const char c : word)
    if (upper(*at++) != c) return nullptr;
  return at_word_end(at) ? at : nullptr;
}

// Reads + or a minus sign, if there is one. Never nullptr.
inline const char* read_sign(const char* at, bool& negative) {
  const char c = *at;
  negative = c == '-';
  at += static_cast<int>(c == '-') + static_cast<int>(c == '+');
  if (c == '\xE2') [[unlikely]] {
    const std::string_view sign(at, 3);
    if (sign == "\u2212" || sign == "\u2013") negative = true, at += 3;
  }
  return at;
}

// Reads a number of up to Decimal::kMaxDigits digits, without sign.
inline const char* read_long_number(const char* at, Decimal& value) {
  int count = 0;
  int decimals = 0;
  std::uint64_t digits = 0;
  bool point = false;
  for (;; ++at) {
    if (is_digit(*at)) {
      if (++count > Decimal::kMaxDigits) return nullptr;
      digits = digits * 10 + static_cast<std::uint64_t>(*at - '0');
      if (point) ++decimals;
    } else if ((*at == '.' || *at == ',') && !point) {
      point = true;
    } else {
      break;
    }
  }
  if (count == 0) return nullptr;
  value.digits = digits;
  value.decimals = static_cast<std::uint8_t>(decimals);
  value.point = point;
  return at;
}

// [sign] digits [. [digits]] or [sign] . digits; a comma is a point.
inline const char* read_number(const char* at, Decimal& value) {
  at = read_sign(at, value.negative);
  const Digits before = digits_at(at);
  const char* const point = at + before.count;
  if (before.count > 7) [[unlikely]]
    return read_long_number(at, value);
  if (*point == '.' || *point == ',') {
    const Digits behind = digits_at(point + 1);
    if (behind.count > 7) [[unlikely]]
      return read_long_number(at, value);
    if (before.count + behind.count == 0) return nullptr;
    value.digits = before.number * kPowersOfTen[behind.count] + behind.number;
    value.decimals = static_cast<std::uint8_t>(behind.count);
    value.point = true;
    return point + 1 + behind.count;
  }
  if (before.count == 0) return nullptr;
  value.digits = before.number;
  value.decimals = 0;
  value.point = false;
  return point;
}

// Reads digits only, of a number up to `most`.
inline const char* read_integer(const char* at, std::uint64_t most, std::uint64_t& value) {
  value = 0;
  const char* const first = at;
  for (; is_digit(*at); ++at) {
    if (at - first == Decimal::kMaxDigits) return nullptr;
    value = value * 10 + static_cast<std::uint64_t>(*at - '0');
  }
  return at == first || value > most ? nullptr : at;
}

// Qn, QLn, QRn.
inline const char* read_parameter(const char* at, Parameter& parameter) {
  if (upper(*at) != 'Q') return nullptr;
  const char kind = upper(*++at);
  parameter.kind = kind == 'L' ? ParameterKind::ql : kind == 'R' ? ParameterKind::qr : ParameterKind::q;
  if (parameter.kind != ParameterKind::q) ++at;
  std::uint64_t index = 0;
  const char* const end = read_integer(at, parameter.kind == ParameterKind::q ? kMostQ : kMostLocal, index);
  parameter.index = static_cast<std::uint16_t>(index);
  return end;
}

// The place after the word, or after a ~ that does not join lines.
inline const char* word_end(const char* at) {
  if (*at == '~') return at + 1;
  while (!at_word_end(at)) ++at;
  return at;
}

// Reads a number, or a parameter with or without sign. Blanks are permitted before it and after its sign.
inline const char* read_value(const char* at, Value& value) {
  if (const char* const end = read_number(at, value.number)) [[likely]] {
    value.parameter = {};
    return end;
  }
  const auto blanks = [&at] {
    while (is_blank(*at)) ++at;
  };
  value = {};
  blanks();
  bool negative = false;
  at = read_sign(at, negative);
  blanks();
  const char* end = nullptr;
  if (is_digit(*at) || *at == '.' || *at == ',') end = read_number(at, value.number);
  if (end == nullptr) end = read_parameter(at, value.parameter);
  value.number.negative = negative;
  return end;
}

}  // namespace toolcomp::spec::klartext

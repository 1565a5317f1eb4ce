// SPDX-License-Identifier: Apache-2.0
// Statements and words that have a name here and no more: what would move, turn or mirror the path, and arithmetic.
#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "spec/language/heidenhain/klartext_parser.h"

namespace toolcomp::spec::klartext {
namespace {

struct Named {
  std::string_view first;
  std::string_view second;  // empty: any
  const char* message;
};

// A statement is the first of these whose words it begins with.
constexpr auto kStatements = std::to_array<Named>({
    {"APPR", "", "APPR (approach of a contour) is not supported"},
    {"C", "", "C (circle) is not supported"},
    {"CALL", "SELECTED", "CALL SELECTED PGM is not supported"},
    {"CC", "", "CC (centre of a circle, pole) is not supported"},
    {"CHF", "", "CHF (chamfer) is not supported"},
    {"CONTOUR", "DEF", "CONTOUR DEF is not supported"},
    {"CP", "", "CP (polar coordinates, helix) is not supported"},
    {"CR", "", "CR (circle by its radius) is not supported"},
    {"CT", "", "CT (tangential circle) is not supported"},
    {"CTP", "", "CTP (tangential circle, polar coordinates) is not supported"},
    {"CYCL", "CALL", "CYCL CALL (machining cycles) is not supported"},
    {"DECLARE", "STRING", "DECLARE STRING (string parameters) is not supported"},
    {"DEP", "", "DEP (departure from a contour) is not supported"},
    {"FC", "", "FC (free contour) is not supported"},
    {"FCT", "", "FCT (free contour) is not supported"},
    {"FL", "", "FL (free contour) is not supported"},
    {"FLT", "", "FLT (free contour) is not supported"},
    {"FPOL", "", "FPOL (free contour) is not supported"},
    {"FUNCTION", "DRESS", "FUNCTION DRESS is not supported"},
    {"FUNCTION", "FILE", "FUNCTION FILE is not supported"},
    {"FUNCTION", "MODE", "FUNCTION MODE other than MILL is not supported"},
    {"FUNCTION", "PARAXCOMP", "FUNCTION PARAXCOMP (parallel axes) is not supported"},
    {"FUNCTION", "PARAXMODE", "FUNCTION PARAXMODE (parallel axes) is not supported"},
    {"FUNCTION", "POLARKIN", "FUNCTION POLARKIN (polar kinematics) is not supported"},
    {"FUNCTION", "TURNDATA", "FUNCTION TURNDATA (turning) is not supported"},
    {"LP", "", "LP (polar coordinates) is not supported"},
    {"PATTERN", "DEF", "PATTERN DEF is not supported"},
    {"PLANE", "AXIAL", "PLANE AXIAL is not supported"},
    {"PLANE", "EULER", "PLANE EULER is not supported"},
    {"PLANE", "POINTS", "PLANE POINTS is not supported"},
    {"PLANE", "PROJECTED", "PLANE PROJECTED is not supported"},
    {"PLANE", "RELATIV", "PLANE RELATIV is not supported"},
    {"PLANE", "RELATIVE", "PLANE RELATIVE is not supported"},
    {"PLANE", "VECTOR", "PLANE VECTOR is not supported"},
    {"POLARKIN", "", "POLARKIN (polar kinematics) is not supported"},
    {"PRESET", "CORR", "PRESET CORR is not supported"},
    {"PRESET", "COPY", "PRESET COPY is not supported"},
    {"RND", "", "RND (rounding) is not supported"},
    {"SEL", "PGM", "SEL PGM is not supported"},
    {"TCH", "PROBE", "TCH PROBE (touch probe cycles) is not supported"},
    {"TRANS", "MIRROR", "TRANS MIRROR is not supported"},
    {"TRANS", "ROTATION", "TRANS ROTATION is not supported"},
    {"TRANS", "SCALE", "TRANS SCALE is not supported"},
});

struct Numbered {
  std::uint64_t number;
  const char* message;
};
constexpr auto kFunctions = std::to_array<Numbered>({
    {1, "FN 1 (addition) is not supported"},
    {2, "FN 2 (subtraction) is not supported"},
    {3, "FN 3 (multiplication) is not supported"},
    {4, "FN 4 (division) is not supported"},
    {5, "FN 5 (square root) is not supported"},
    {6, "FN 6 (sine) is not supported"},
    {7, "FN 7 (cosine) is not supported"},
    {8, "FN 8 (root of a sum of squares) is not supported"},
    {9, "FN 9 (jump if equal) is not supported"},
    {10, "FN 10 (jump if not equal) is not supported"},
    {11, "FN 11 (jump if greater) is not supported"},
    {12, "FN 12 (jump if less) is not supported"},
    {13, "FN 13 (angle) is not supported"},
    {14, "FN 14 (error message) is not supported"},
    {15, "FN 15 (print) is not supported"},
    {16, "FN 16 (formatted print) is not supported"},
    {18, "FN 18 (system data) is not supported"},
    {19, "FN 19 (values to the PLC) is not supported"},
    {20, "FN 20 (wait) is not supported"},
    {23, "FN 23 (circle from three points) is not supported"},
    {24, "FN 24 (circle from four points) is not supported"},
    {25, "FN 25 (set a preset) is not supported"},
    {26, "FN 26 (open a table) is not supported"},
    {27, "FN 27 (write to a table) is not supported"},
    {28, "FN 28 (read from a table) is not supported"},
    {29, "FN 29 (values to the PLC) is not supported"},
    {37, "FN 37 (export) is not supported"},
    {38, "FN 38 (send) is not supported"},
});

// M functions that move something by themselves: the run ends there.
constexpr auto kMoving = std::to_array<Numbered>({
    {89, "M89 (cycle call) is not supported"},
    {99, "M99 (cycle call) is not supported"},
    {140, "M140 (retraction along the tool axis) is not supported"},
});
// Those that change what others do: they are read, and nothing more.
constexpr auto kPassedOver = std::to_array<Numbered>({
    {94, "M94 (reduced display of rotary axes) is not supported"},
    {97, "M97 (small contour steps) is not supported"},
    {98, "M98 (open contour corners) is not supported"},
    {103, "M103 (feed factor for plunging) is not supported"},
    {114, "M114 (compensation of the machine geometry) is not supported"},
    {120, "M120 (look-ahead of the radius compensation) is not supported"},
    {124, "M124 (points that are left out) is not supported"},
    {130, "M130 (positions in the untilted system) is not supported"},
    {144, "M144 (compensation of the kinematics) is not supported"},
    {197, "M197 (rounding of corners) is not supported"},
});

// Cycles that act where they are defined.
constexpr auto kCycles = std::to_array<Numbered>({
    {8, "CYCL DEF 8 (mirroring) is not supported"},
    {10, "CYCL DEF 10 (rotation) is not supported"},
    {11, "CYCL DEF 11 (scaling) is not supported"},
    {26, "CYCL DEF 26 (scaling by axis) is not supported"},
    {220, "CYCL DEF 220 (pattern on a circle) is not supported"},
    {221, "CYCL DEF 221 (pattern on lines) is not supported"},
    {224, "CYCL DEF 224 (pattern of a code) is not supported"},
    {800, "CYCL DEF 800 (turning: rotary coordinate system) is not supported"},
});

template <std::size_t count>
const char* message_of(const std::array<Numbered, count>& table, std::uint64_t number) {
  const auto found = std::ranges::find(table, number, &Numbered::number);
  return found == table.end() ? nullptr : found->message;
}

// The key and a literal of this value, nothing behind it.
bool is_one_literal(const char* at, std::string_view key, std::uint64_t value, const char*& behind) {
  for (const char c : key)
    if (upper(*at++) != c) return false;
  while (is_blank(*at)) ++at;
  Decimal number;
  behind = read_number(at, number);
  return behind != nullptr && at_word_end(behind) && number.digits == value * kPowersOfTen[number.decimals] &&
         (!number.negative || value == 0);
}

// FN 1 to FN 4 have a word +, -, * or DIV in their line.
bool has_operator(const char* at) {
  for (; *at != '\n' && *at != ';'; ++at)
    if (is_blank(at[-1]) && (read_word(at, "DIV") != nullptr ||
                             (std::string_view("+-*").find(*at) != std::string_view::npos && at_word_end(at + 1))))
      return true;
  return false;
}

// Behind the word, or behind a ~ that joins no lines.
const char* word_end(const char* at) {
  if (*at == '~') return at + 1;
  while (!at_word_end(at)) ++at;
  return at;
}

}  // namespace

const char* BlockParser::refuse_by_name(Block& block, const char* at) {
  if (const char* const function = words(at, "FN")) {
    std::uint64_t number = 0;
    const char* const end = read_integer(function, std::numeric_limits<std::uint64_t>::max(), number);
    const bool whole = end != nullptr && *end == ':' && (number > 4 || has_operator(end));
    const char* const message = whole ? message_of(kFunctions, number) : nullptr;
    return message == nullptr ? bad_word(block, function) : refuse(block, at, message);
  }
  for (const Named& named : kStatements)
    if (words(at, named.first, named.second) != nullptr) return refuse(block, at, named.message);
  return bad_word(block, at);
}

const char* BlockParser::words_of_function(Block& block, const char* at, std::uint64_t number, const char* function) {
  if (const char* const message = message_of(kMoving, number)) return refuse(block, function, message);
  if (block.passed_over == nullptr) block.passed_over = message_of(kPassedOver, number);
  Value ignored;
  switch (number) {
    case 103:
    case 128:  // of the compensating movements
      return upper(*at) == 'F' ? keyed_value(block, at, 1, ignored) : at;
    case 124:
      return upper(*at) == 'T' ? keyed_value(block, at, 1, ignored) : at;
    case 94:
    case 118:
    case 120:
    case 138:
      return words_without_effect(block, at);
    default:
      return at;
  }
}

// A cycle but the datum shift. The first part only names it; values that change nothing are taken.
const char* BlockParser::path_cycle(Block& block, const char* at) {
  const char* behind = nullptr;
  const char* const word = upper(*at) == 'I' ? at + 1 : at;
  const bool opens = block.cycle_part == 0 && block.cycle < 200;
  switch (block.cycle) {
    case 10:
      if (!opens && is_one_literal(word, "ROT", 0, behind) && gap(behind) == text_.stop) return free_text();
      break;
    case 11:
      if (!opens && is_one_literal(at, "SCL", 1, behind) && gap(behind) == text_.stop) return free_text();
      break;
    case 19:
      for (; at != text_.stop; at = gap(at)) {
        const char letter = upper(*at);
        if ((letter == 'A' || letter == 'B' || letter == 'C') && !opens) {
          Value angle;
          const char* const end = read_value(at + 1, angle);
          if (end != nullptr && (angle.number.digits != 0 || angle.parameter.kind != ParameterKind::none))
            block.passed_over = "CYCL DEF 19 (working plane) is not supported";
        }
        at = word_end(at);
      }
      return free_text();
    case 247:
      for (; at != text_.stop; at = gap(at)) {
        Value number;
        if (std::string_view(at, 4) == "Q339" && at[4] == '=' && read_value(at + 5, number) != nullptr)
          select_preset(block, number);
        at = word_end(at);
      }
      return free_text();
    default:
      break;
  }
  const char* const message = opens || at == text_.stop ? nullptr : message_of(kCycles, block.cycle);
  return message == nullptr ? free_text() : refuse(block, at, message);
}

// Positions count from the preset, so the first to be selected is that of the setup.
void BlockParser::select_preset(Block& block, const Value& number) {
  if (!preset_) preset_ = number;
  if (!(*preset_ == number)) block.passed_over = "another preset than the first is not supported";
}

// PRESET SELECT: #number, or a name in quotes.
const char* BlockParser::preset(Block& block, const char* at) {
  Value number;
  if (*at == '#' && read_value(at + 1, number) != nullptr)
    select_preset(block, number);
  else if (*at != '"')
    return bad_word(block, at);
  return without_effect(block);
}

// TRANS DATUM: what cycle 7 does, in one block.
const char* BlockParser::transformation(Block& block, const char* at) {
  block.statement = Statement::cycle;
  block.cycle = 7;
  block.cycle_part = 1;
  block.axes = block.incremental = 0;
  if (const char* const axes = words(at, "AXIS")) return datum_shift(block, axes);
  if (const char* const reset = words(at, "RESET")) {
    for (const char letter : std::string_view("XYZUVW")) {
      const unsigned slot = slot_[static_cast<unsigned char>(letter)];
      if (slot == kNoSlot) continue;
      block.axis[slot] = {};
      block.axes = static_cast<std::uint16_t>(block.axes | 1U << slot);
    }
    return reset;
  }
  return words(at, "TABLE") != nullptr ? refuse(block, at, "TRANS DATUM TABLE is not supported") : bad_word(block, at);
}

const char* BlockParser::without_effect(Block& block) {
  block.statement = Statement::without_effect;
  return free_text();
}

}  // namespace toolcomp::spec::klartext

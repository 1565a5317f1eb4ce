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
    {"CHF", "", "CHF (chamfer) is not supported"},
    {"CONTOUR", "DEF", "CONTOUR DEF is not supported"},
    {"CP", "", "CP (polar coordinates, helix) is not supported"},
    {"CR", "", "CR (circle by radius) is not supported"},
    {"CT", "", "CT (tangential circle) is not supported"},
    {"CTP", "", "CTP (tangential circle, polar coordinates) is not supported"},
    {"DECLARE", "STRING", "DECLARE STRING (string parameters) is not supported"},
    {"DEP", "", "DEP (departure from a contour) is not supported"},
    {"FC", "", "FC (free contour) is not supported"},
    {"FCT", "", "FCT (free contour) is not supported"},
    {"FL", "", "FL (free contour) is not supported"},
    {"FLT", "", "FLT (free contour) is not supported"},
    {"FPOL", "", "FPOL (free contour) is not supported"},
    {"FUNCTION", "DRESS", "FUNCTION DRESS is not supported"},
    {"FUNCTION", "FILE", "FUNCTION FILE is not supported"},
    {"FUNCTION", "MODE", "FUNCTION MODE (other than MILL) is not supported"},
    {"FUNCTION", "PARAXCOMP", "FUNCTION PARAXCOMP (parallel axes) is not supported"},
    {"FUNCTION", "PARAXMODE", "FUNCTION PARAXMODE (parallel axes) is not supported"},
    {"FUNCTION", "POLARKIN", "FUNCTION POLARKIN (polar kinematics) is not supported"},
    {"FUNCTION", "TURNDATA", "FUNCTION TURNDATA (turning) is not supported"},
    {"LP", "", "LP (polar coordinates) is not supported"},
    {"PATTERN", "DEF", "PATTERN DEF is not supported"},
    {"PLANE", "AXIAL", "PLANE AXIAL (tilted working plane) is not judged"},
    {"PLANE", "EULER", "PLANE EULER (tilted working plane) is not judged"},
    {"PLANE", "POINTS", "PLANE POINTS (tilted working plane) is not judged"},
    {"PLANE", "PROJECTED", "PLANE PROJECTED (tilted working plane) is not judged"},
    {"PLANE", "RELATIV", "PLANE RELATIV (tilted working plane) is not judged"},
    {"PLANE", "RELATIVE", "PLANE RELATIVE (tilted working plane) is not judged"},
    {"PLANE", "VECTOR", "PLANE VECTOR (tilted working plane) is not judged"},
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

// Those after which positions are not known.
constexpr auto kNotJudged = std::to_array<Numbered>({
    {114, "M114 (compensation of the machine geometry) is not judged"},
    {124, "M124 (suppression of points) is not judged"},
    {144, "M144 (compensation of the kinematics) is not judged"},
});
// Those that change corners of RL and RR, which have a path here under TCPM alone.
constexpr auto kOfCorners = std::to_array<Numbered>({
    {97, "M97 (small contour steps) is not judged"},
    {98, "M98 (open contour corners) is not judged"},
    {120, "M120 (look-ahead of the radius compensation) is not judged"},
    {197, "M197 (rounding of corners) is not judged"},
});

// Cycles that act where they are defined.
constexpr auto kCycles = std::to_array<Numbered>({
    {8, "CYCL DEF 8 (mirroring) is not supported"},
    {10, "CYCL DEF 10 (rotation) is not supported"},
    {11, "CYCL DEF 11 (scaling) is not supported"},
    {26, "CYCL DEF 26 (scaling by axis) is not supported"},
    {220, "CYCL DEF 220 (pattern on a circle) is not supported"},
    {221, "CYCL DEF 221 (pattern on lines) is not supported"},
    {224, "CYCL DEF 224 (pattern of a DataMatrix code) is not supported"},
    {800, "CYCL DEF 800 (turning: rotary coordinate system) is not supported"},
});

// Of a contour, with a path of their own only where there is no radius compensation (BlockParser::contour).
bool is_beside_the_path(std::string_view statement) {
  constexpr std::array<std::string_view, 7> kOfContours{"APPR", "C", "CHF", "CR", "CT", "DEP", "RND"};
  return std::ranges::find(kOfContours, statement) != kOfContours.end();
}

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

}  // namespace

// FN n: and FNn:.
const char* BlockParser::numbered_function(Block& block, const char* at) {
  const char* const function = gap(at + 2);
  std::uint64_t number = 0;
  const char* end = read_integer(function, std::numeric_limits<std::uint64_t>::max(), number);
  if (end == nullptr || *end != ':') return bad_word(block, function);
  end = gap(end + 1);
  constexpr std::string_view kOperations = "0+-*/";
  if (number < kOperations.size()) return assignment(block, end, kOperations[number]);
  if (number == 18) return system_data(block, end);
  const char* const message = message_of(kFunctions, number);
  return message == nullptr ? bad_word(block, function) : refuse(block, at, message);
}

const char* BlockParser::refuse_by_name(Block& block, const char* at) {
  if (const char* const center = words(at, "CC")) {
    const char* const end = contour_words(block, center);
    return end == nullptr ? nullptr : end != text_.stop ? bad_word(block, end) : without_effect(block);
  }
  for (const Named& named : kStatements)
    if (const char* const behind = words(at, named.first, named.second)) {
      if (is_beside_the_path(named.first)) return contour(block, at, behind, named.message);
      return raise(block, at, named.first == "PLANE" ? AlarmCause::not_judged : AlarmCause::not_supported,
                   named.message);
    }
  return bad_word(block, at);
}

// Axis words, the radius, length and sense of an arc, in any order: up to the first other word.
const char* BlockParser::contour_words(Block& block, const char* at) {
  block.axes = block.incremental = 0;
  block.many_digits = false;
  Value ignored;
  for (;;) {
    const char* const word = at;
    const bool increment = upper(*at) == 'I';
    const unsigned slot = slot_[static_cast<unsigned char>(at[increment ? 1 : 0])];
    const char next = at[1];
    if (slot != kNoSlot && read_word(at, "CCA") == nullptr && !(upper(*at) == 'C' && upper(next) == 'C')) {
      if (block.has_axis(slot)) return bad_word(block, word);
      at = keyed_value(block, at, increment ? 2 : 1, block.axis[slot]);
      block.axes = static_cast<std::uint16_t>(block.axes | 1U << slot);
      if (increment) block.incremental = static_cast<std::uint16_t>(block.incremental | 1U << slot);
    } else if (upper(*at) == 'D' && upper(next) == 'R' && (at[2] == '+' || at[2] == '-') && at_word_end(at + 3)) {
      at = gap(at + 3);
    } else if (upper(*at) == 'R' && (next == '+' || next == '-' || next == '.' || upper(next) == 'Q' ||
                                     (is_digit(next) && !(next == '0' && at_word_end(at + 2))))) {
      at = keyed_value(block, at, 1, ignored);
    } else if ((upper(*at) == 'L' && upper(next) == 'E' && upper(at[2]) == 'N') ||
               (upper(*at) == 'C' && upper(next) == 'C' && upper(at[2]) == 'A')) {
      at = keyed_value(block, at, 3, ignored);
    } else {
      return at;
    }
    if (at == nullptr) return nullptr;
  }
}

// Under RL or RR without TCPM nothing of a contour is modelled but where its blocks end: arcs and approaches end as
// lines do, roundings and chamfers lie between two of them, and departures without coordinates end nobody knows where.
const char* BlockParser::contour(Block& block, const char* at, const char* behind, const char* message) {
  const char* const initiator = at;
  const bool between = read_word(at, "RND") != nullptr || read_word(at, "CHF") != nullptr;
  if (between && beside_ && !tcpm_) return without_effect(block);
  if (between) return refuse(block, initiator, message);
  at = behind;
  bool without_end = false;
  const bool departs = read_word(initiator, "DEP") != nullptr;
  if (departs || read_word(initiator, "APPR") != nullptr) {
    const char* form = words(at, "LCT");  // of the departures the one that says where it ends
    without_end = departs && form == nullptr;
    for (const std::string_view each : {"LT", "LN", "CT"})
      if (form == nullptr) form = words(at, each);
    if (form == nullptr) return refuse(block, initiator, message);
    at = form;
  }
  block.statement = Statement::line;
  block.departs = without_end;
  at = contour_words(block, at);
  if (at != nullptr) at = tail(block, at);
  if (at != nullptr && at != text_.stop) at = bad_word(block, at);
  if (!beside_ || tcpm_ || (without_end && lateral_) || (at != nullptr && (block.axes == 0) != without_end))
    return refuse(block, initiator, message);
  return at;
}

// A text where positions are not known after an M function; nullptr where they are.
const char* BlockParser::not_judged(std::uint64_t function) const {
  const char* const corners = tcpm_ && beside_ ? message_of(kOfCorners, function) : nullptr;
  return corners != nullptr ? corners : message_of(kNotJudged, function);
}

// M140 MB n, M140 MB MAX, and its feed. In a block with axis words it acts at the start, which is not followed.
const char* BlockParser::retraction(Block& block, const char* at, const char* function) {
  const bool alone = block.statement == Statement::miscellaneous;
  if ((!alone && block.statement != Statement::line) || (!alone && (block.axes != 0 || block.departs)))
    return refuse(block, function, "M140 (retraction along the tool axis) in a block that moves is not supported");
  if (upper(*at) != 'M' || upper(at[1]) != 'B') return bad_word(block, at);
  const char* const word = at;
  at = gap(at + 2);
  if (const char* const end = read_word(at, "MAX")) {
    block.retraction = Retraction::to_limit;
    at = gap(end);
  } else {
    block.retraction = Retraction::by;
    at = keyed_value(block, word, static_cast<std::size_t>(at - word), block.retraction_by);
    if (at == nullptr) return nullptr;
  }
  if (alone) {
    block.statement = Statement::line;
    block.axes = block.incremental = 0;
    block.many_digits = block.departs = false;
    block.radius = RadiusWord::none;
    block.feed = FeedWord::none;
  }
  return upper(*at) == 'F' && block.feed == FeedWord::none ? feed(block, at) : at;
}

const char* BlockParser::words_of_function(Block& block, const char* at, std::uint64_t number, const char* function) {
  if (number == 89) return refuse(block, function, "M89 (cycle call after every block) is not supported");
  if (number == 99) {
    block.calls_cycle = true;
    call_at_ = function;
  }
  if (const char* const message = not_judged(number)) return raise(block, function, AlarmCause::not_judged, message);
  if (number == 94) renamed_ = ~0U;
  if (number == 128 || number == 129) tcpm_ = number == 128;
  lateral_ = lateral_ || (tcpm_ && beside_);
  Value ignored;
  switch (number) {
    case 140:
      return retraction(block, at, function);
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
            return raise(block, at, AlarmCause::not_judged, "CYCL DEF 19 (tilted working plane) is not judged");
        }
        at = word_end(at);
      }
      return free_text();
    case 247:
      for (; at != text_.stop; at = gap(at)) {
        Value number;
        if (std::string_view(at, 4) == "Q339" && at[4] == '=' && read_value(at + 5, number) != nullptr &&
            !is_first_preset(number))
          return raise(block, at, AlarmCause::not_judged, "CYCL DEF 247 (a preset other than the first) is not judged");
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
bool BlockParser::is_first_preset(const Value& number) {
  if (!preset_) preset_ = number;
  return *preset_ == number;
}

// PRESET SELECT: #number, or a name in quotes.
const char* BlockParser::preset(Block& block, const char* at) {
  Value number;
  if (*at == '#' && read_value(at + 1, number) != nullptr) {
    if (!is_first_preset(number))
      return raise(block, at, AlarmCause::not_judged, "PRESET SELECT (a preset other than the first) is not judged");
  } else if (*at != '"') {
    return bad_word(block, at);
  }
  return without_effect(block);
}

// TRANS DATUM: what cycle 7 does, in one block.
const char* BlockParser::transformation(Block& block, const char* at) {
  block.statement = Statement::cycle;
  block.cycle = 7;
  block.cycle_part = 1;
  block.axes = block.incremental = 0;
  block.cycle_values.clear();
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

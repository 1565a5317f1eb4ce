// SPDX-License-Identifier: Apache-2.0
#include "spec/language/heidenhain/klartext_parser.h"

#include <limits>

namespace toolcomp::spec::klartext {
namespace {

// Columns of the vector words of LN in the order of the grammar: X Y Z, NX NY NZ, TX TY TZ.
constexpr unsigned kCoordinates = 0b000'000'111;
constexpr unsigned kNormal = 0b000'111'000;
constexpr unsigned kToolVector = 0b111'000'000;
constexpr unsigned kNoRank = 9;

constexpr unsigned kRotarySlots = 0b000'111'000;  // A, B, C

// A rotary axis is sent elsewhere than to 0, or may be.
bool turns(const Block& block) {
  for (std::size_t slot = 3; slot < 6; ++slot)
    if (block.has_axis(slot) && (block.axis[slot].number.digits != 0 || block.is_incremental(slot) ||
                                 block.axis[slot].parameter.kind != ParameterKind::none))
      return true;
  return false;
}

// More than 5 decimals, or beyond 99999.99999.
bool many_axis_digits(const Decimal& number) {
  return number.decimals > 5 || number.digits >= kPowersOfTen[5U + number.decimals];
}

// Components beyond 9.99999999; the first is that of a number without decimals.
constexpr std::array<std::uint64_t, Decimal::kMaxDigits + 1> kMostComponent = [] {
  std::array<std::uint64_t, Decimal::kMaxDigits + 1> most{};
  for (std::size_t decimals = 0; decimals < most.size(); ++decimals)
    most[decimals] = decimals <= 8 ? kPowersOfTen[decimals + 1] - 1 : 999'999'999 * kPowersOfTen[decimals - 8];
  return most;
}();

unsigned rank_of(const char* at) {
  const char first = upper(*at);
  const bool vector = first == 'N' || first == 'T';
  const unsigned letter = static_cast<unsigned char>(vector ? upper(at[1]) : first) - unsigned{'X'};
  if (letter > 2) return kNoRank;
  return letter + (vector ? first == 'N' ? 3U : 6U : 0U);
}

}  // namespace

BlockParser::BlockParser(const Setup& setup, const std::string& file)
    : setup_(setup), file_(file), units_(setup.units) {
  slot_.fill(kNoSlot);
  for (std::size_t slot = 0; slot < kAxisLetters.size(); ++slot) {
    const char letter = kAxisLetters[slot];
    if (!setup.axes.has(letter)) continue;
    slot_[static_cast<unsigned char>(letter)] = static_cast<std::uint8_t>(slot);
    slot_[static_cast<unsigned char>(letter - 'A' + 'a')] = static_cast<std::uint8_t>(slot);
  }
}

BlockParser::Place BlockParser::place(const char* at) const {
  const char* start = text_.begin;
  std::uint64_t line = text_.line;
  for (const char* c = start; c < at; ++c)
    if (*c == '\n') start = c + 1, ++line;
  return {line, static_cast<std::uint32_t>(static_cast<std::size_t>(at - start) + 1 +
                                           (start == text_.begin ? text_.mark : 0))};
}

const char* BlockParser::raise(Block& block, const char* at, AlarmCause cause, const char* message) {
  const Place fault = place(at);
  block.alarm = ReadAlarm{cause, fault.line, fault.column, message};
  passed_over_ = true;
  return nullptr;
}

const char* BlockParser::refuse(Block& block, const char* at, const char* message) {
  return raise(block, at, AlarmCause::not_supported, message);
}

const char* BlockParser::bad_word(Block& block, const char* at) {
  if (at != text_.stop) return raise(block, at, AlarmCause::syntax, "this word cannot be read here");
  while (at != text_.begin && is_blank(at[-1])) --at;
  return raise(block, at, AlarmCause::syntax, "the block ends too early");
}

const char* BlockParser::wide_gap(const char* at) {
  for (;;) {
    if (is_blank(*at)) {
      ++at;
    } else if (*at == ';') {
      passed_over_ = true;
      while (*at != '\n') ++at;
    } else if (*at == '\n') {
      if (at == text_.stop) return at;
      ++at;
    } else if (*at == '~') {
      const char* end = at + 1;
      while (is_blank(*end)) ++end;
      if (*end != '\n') return at;
      at = end;
    } else {
      return at;
    }
  }
}

const char* BlockParser::finish(Block& block, const char* at) {
  if (at != text_.stop) return bad_word(block, at);
  if (fifth_function_ != nullptr)
    return raise(block, fifth_function_, AlarmCause::too_many_functions, "more than four M functions in the block");
  return at;
}

BlockParser::Head BlockParser::parse_head(Block& block, const BlockText& text) {
  text_ = text;
  passed_over_ = false;
  fifth_function_ = nullptr;
  begins_in_tcpm_ = tcpm_;
  block.calls_cycle = false;
  block.line = text.line;
  block.n.reset();
  block.alarm.reset();
  Head head;
  const auto slash = [&](const char* at) {
    while (is_blank(*at)) ++at;
    if (*at != '/') return at;
    head.slash = true;
    return gap(at + 1);
  };
  const char* at = slash(gap(text.begin));
  if (is_digit(*at)) {
    std::uint64_t n = 0;
    const char* const end = read_integer(at, std::numeric_limits<std::uint64_t>::max(), n);
    if (end == nullptr || (!at_word_end(end) && *end != '/' && *end != '*')) {
      block.statement = Statement::miscellaneous;
      bad_word(block, at);
      block.column = place(at).column;
      return head;
    }
    block.n = n;
    at = gap(end);
    if (!head.slash) at = slash(at);
  }
  head.statement = at;
  block.column = place(at).column;
  return head;
}

bool BlockParser::admits_any_byte(const char* statement) const {
  return *statement == '*' || read_word(statement, "BEGIN") != nullptr || read_word(statement, "END") != nullptr;
}

void BlockParser::refuse_long(Block& block, const char* statement) {
  block.statement = Statement::miscellaneous;
  raise(block, statement, AlarmCause::syntax, "a block longer than 65535 bytes");
  first_ = false;
}

bool BlockParser::parse_statement(Block& block, const char* at) {
  if (at == text_.stop || *at == '*') {
    passed_over_ = true;
    return false;
  }
  const bool l = upper(*at) == 'L';
  if (l && upper(at[1]) == 'N' && at_word_end(at + 2))
    line_with_vectors(block, at);
  else if (l && at_word_end(at + 1))
    line(block, at);
  else
    rare_statement(block, at);
  if (block.calls_cycle && !block.alarm)
    if (const char* const beyond = call_beyond(block)) refuse(block, call_at_, beyond);
  if (unknown_ && !block.alarm && takes_unknown(block))
    raise(block, at, AlarmCause::not_supported, "Q (set by FN 18) is not supported");
  first_ = false;
  return true;
}

const char* BlockParser::line(Block& block, const char* at) {
  const char* const initiator = at;
  block.statement = Statement::line;
  unsigned axes = 0;
  unsigned incremental = 0;
  bool many_digits = false;
  for (at = gap(at + 1);; at = gap(at)) {
    const char* const word = at;
    const bool increment = upper(*at) == 'I';
    if (increment) ++at;
    const unsigned slot = slot_[static_cast<unsigned char>(*at)];
    if (slot == kNoSlot) {
      at = word;
      break;
    }
    const unsigned bit = 1U << slot;
    Value& value = block.axis[slot];
    at = read_value(at + 1, value);
    if (at == nullptr || !at_word_end(at) || (axes & bit) != 0) [[unlikely]]
      return bad_word(block, word);
    axes |= bit;
    incremental |= increment ? bit : 0;
    many_digits |= many_axis_digits(value.number);
  }
  block.axes = static_cast<std::uint16_t>(axes);
  block.incremental = static_cast<std::uint16_t>(incremental);
  block.many_digits = many_digits;
  block.departs = false;
  if ((axes & kRotarySlots) != 0) [[unlikely]] {
    turned_ = turned_ || turns(block);
    if ((axes & incremental & renamed_) != 0)
      return raise(block, initiator, AlarmCause::not_judged,
                   "M94 (removal of whole turns of rotary axes) is not judged");
    renamed_ &= ~axes;
  }
  at = tail(block, at);
  return at == nullptr ? nullptr : finish(block, at);
}

const char* BlockParser::vector_word(Block& block, const char* at, unsigned rank) {
  Decimal& component = rank < 6 ? block.normal[rank - 3] : block.tool_vector[rank - 6];
  const char* const end = read_number(at + 2, component);
  if (end == nullptr) return nullptr;
  if (rank == 3) normal_ = at;
  if (rank == 6) tool_vector_ = at;
  block.many_digits |= component.decimals > 8;
  if (component.digits > kMostComponent[component.decimals] && out_of_range_ == nullptr) out_of_range_ = at;
  return end;
}

const char* BlockParser::line_with_vectors(Block& block, const char* at) {
  block.statement = Statement::line_with_vectors;
  block.many_digits = false;
  out_of_order_ = out_of_range_ = nullptr;
  const char* const initiator = at;
  unsigned keys = 0;  // bit i: the key of rank i
  unsigned least = 0;
  for (at = gap(at + 2);; at = gap(at)) {
    const char* const word = at;
    const unsigned rank = rank_of(word);
    if (rank == kNoRank) break;
    if (rank < 3) {
      Value& value = block.axis[rank];
      at = read_value(word + 1, value);
      block.many_digits |= at != nullptr && many_axis_digits(value.number);
    } else {
      at = vector_word(block, word, rank);
    }
    if (at == nullptr || !at_word_end(at)) [[unlikely]]
      return bad_word(block, word);
    if (rank < least && out_of_order_ == nullptr) out_of_order_ = word;
    least = rank + 1;
    keys |= 1U << rank;
  }
  at = tail(block, at);
  if (at == nullptr || finish(block, at) == nullptr) return nullptr;
  return check_vectors(block, keys, initiator);
}

const char* BlockParser::check_vectors(Block& block, unsigned keys, const char* initiator) {
  block.axes = static_cast<std::uint16_t>(kCoordinates);
  block.incremental = 0;
  block.has_normal = (keys & kNormal) != 0;
  block.has_tool_vector = (keys & kToolVector) != 0;
  const auto is_zero = [](const std::array<Decimal, 3>& vector) {
    return (vector[0].digits | vector[1].digits | vector[2].digits) == 0;
  };
  if (out_of_order_ != nullptr)
    return raise(block, out_of_order_, AlarmCause::vector_order,
                 "the order must be X Y Z, NX NY NZ, TX TY TZ, each once");
  if ((keys & kCoordinates) != kCoordinates)
    return raise(block, initiator, AlarmCause::vector_coordinates, "LN needs X, Y and Z");
  if ((block.has_normal && (keys & kNormal) != kNormal) ||
      (block.has_tool_vector && (keys & kToolVector) != kToolVector))
    return raise(block, initiator, AlarmCause::vector_incomplete, "a vector needs all three components");
  if (!block.has_normal && !block.has_tool_vector)
    return raise(block, initiator, AlarmCause::syntax, "LN needs a vector, NX NY NZ or TX TY TZ");
  if (out_of_range_ != nullptr)
    return raise(block, out_of_range_, AlarmCause::vector_range, "a vector component is larger than 9.99999999");
  if (block.has_normal && is_zero(block.normal))
    return raise(block, normal_, AlarmCause::vector_zero, "the vector has no direction");
  if (block.has_tool_vector && is_zero(block.tool_vector))
    return raise(block, tool_vector_, AlarmCause::vector_zero, "the vector has no direction");
  return text_.stop;
}

const char* BlockParser::tail(Block& block, const char* at) {
  block.radius = RadiusWord::none;
  block.feed = FeedWord::none;
  block.functions = 0;
  if (upper(*at) == 'R') {
    at = radius(block, at);
    if (at == nullptr) return nullptr;
  }
  if (upper(*at) == 'F') {
    at = feed(block, at);
    if (at == nullptr) return nullptr;
  }
  return functions(block, at);
}

// R, F and M alone, which old controls show where nothing was entered, say nothing.
const char* BlockParser::radius(Block& block, const char* at) {
  if (at_word_end(at + 1)) return gap(at + 1);
  const char kind = upper(at[1]);
  if ((kind != '0' && kind != 'L' && kind != 'R') || !at_word_end(at + 2)) return bad_word(block, at);
  block.radius = kind == '0' ? RadiusWord::r0 : kind == 'L' ? RadiusWord::rl : RadiusWord::rr;
  beside_ = kind != '0';
  lateral_ = beside_ && (lateral_ || tcpm_);
  return gap(at + 2);
}

const char* BlockParser::feed(Block& block, const char* at) {
  const char* const word = at++;
  const bool stands_alone = at_word_end(at);
  if (stands_alone) at = gap(at);  // F MAX, F AUTO
  const auto is = [&](std::string_view key, FeedWord kind) {
    const char* const end = read_word(at, key);
    if (end == nullptr) return false;
    block.feed = kind;
    at = gap(end);
    return true;
  };
  if (is("MAX", FeedWord::f_max) || is("AUTO", FeedWord::f_auto)) return at;
  if (stands_alone && !is_digit(*at) && upper(*at) != 'Q') return at;
  const char key = upper(*at);
  block.feed = key == 'Z' ? FeedWord::f_z : key == 'U' ? FeedWord::f_u : FeedWord::f;
  return keyed_value(block, word, block.feed == FeedWord::f ? 1 : 2, block.feed_value);
}

const char* BlockParser::functions(Block& block, const char* at) {
  block.retraction = Retraction::none;
  while (upper(*at) == 'M') {
    const char* const word = at;
    if (at_word_end(at + 1)) {
      at = gap(at + 1);
      continue;
    }
    std::uint64_t number = 0;
    at = read_integer(at + 1, 9999, number);
    if (at == nullptr || !at_word_end(at)) return bad_word(block, word);
    if (block.functions < Block::kMostFunctions)
      block.function[block.functions++] = static_cast<std::uint16_t>(number);
    else if (fifth_function_ == nullptr)
      fifth_function_ = word;
    at = words_of_function(block, gap(at), number, word);
    if (at == nullptr) return nullptr;
  }
  return at;
}

// X Y Z of M118, LA of M120, the axes of M94 and M138.
const char* BlockParser::words_without_effect(Block& block, const char* at) {
  for (char letter = upper(*at); is_linear_axis(letter) || is_rotary_axis(letter) || letter == 'L';
       letter = upper(*at)) {
    const char* const word = at;
    const bool look_ahead = letter == 'L';
    if (look_ahead && upper(*++at) != 'A') return bad_word(block, word);
    ++at;
    if (look_ahead || !at_word_end(at)) {
      Value ignored;
      at = read_value(at, ignored);
      if (at == nullptr || !at_word_end(at)) return bad_word(block, word);
    }
    at = gap(at);
  }
  return at;
}

const char* BlockParser::keyed_value(Block& block, const char* at, std::size_t key, Value& value) {
  const char* const end = read_value(at + key, value);
  return end == nullptr || !at_word_end(end) ? bad_word(block, at) : gap(end);
}

}  // namespace toolcomp::spec::klartext

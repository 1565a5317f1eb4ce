// SPDX-License-Identifier: Apache-2.0
// LBL, CALL LBL, CALL PGM: the words. Where the program goes on is known to klartext_calls.h.
#include "spec/language/heidenhain/klartext_parser.h"

namespace toolcomp::spec::klartext {
namespace {

constexpr std::uint64_t kMostLabel = 65535;
constexpr std::uint64_t kMostRepeats = 65534;
constexpr std::size_t kLongestLabel = 32;

}  // namespace

const char* BlockParser::label(Block& block, const char* at) {
  const char* const named = words(at, "LBL");
  if (named == nullptr) return refuse_by_name(block, at);
  block.statement = Statement::label;
  block.jumps = false;
  return label_word(block, named);
}

// A number, or a name in quotes.
const char* BlockParser::label_word(Block& block, const char* at) {
  const char* const word = at;
  if (*at == '"') {
    std::string_view name;
    at = quoted(block, at, name);
    if (at == nullptr) return nullptr;
    if (name.empty() || name.size() > kLongestLabel)
      return raise(block, word, AlarmCause::syntax, "the name of a label must have 1 to 32 characters");
    block.label = std::string_view(word, name.size() + 2);
    return at;
  }
  if (upper(*at) == 'Q') return refuse(block, word, "LBL Q (a label given by a parameter) is not supported");
  std::uint64_t number = 0;
  at = read_integer(at, kMostLabel, number);
  if (at == nullptr || !at_word_end(at)) return bad_word(block, word);
  block.label = std::string_view(std::to_string(number));
  return gap(at);
}

const char* BlockParser::call(Block& block, const char* at) {
  if (const char* const label = words(at, "LBL")) return called_label(block, label);
  if (const char* const program = words(at, "PGM")) return called_program(block, program);
  if (words(at, "SELECTED") != nullptr) return refuse(block, at, "CALL SELECTED PGM is not supported");
  return bad_word(block, at);
}

// REP n, and the count that some controls show behind it: REP n/n.
const char* BlockParser::called_label(Block& block, const char* at) {
  block.statement = Statement::call_label;
  block.repeats = 0;
  block.jumps = false;
  const char* const word = at;
  at = label_word(block, at);
  if (at == nullptr) return nullptr;
  if (block.label == "0") return raise(block, word, AlarmCause::syntax, "LBL 0 ends a subprogram; it cannot be called");
  if (upper(at[0]) != 'R' || upper(at[1]) != 'E' || upper(at[2]) != 'P') return at;
  const char* const repeat = at;
  at += 3;
  if (at_word_end(at)) at = gap(at);
  if (at == text_.stop) return at;  // nothing was entered
  if (upper(*at) == 'Q') return refuse(block, at, "REP Q (a number of repeats given by a parameter) is not supported");
  std::uint64_t count = 0;
  std::uint64_t left = 0;
  at = read_integer(at, kMostRepeats, count);
  if (at != nullptr && *at == '/') at = read_integer(at + 1, kMostRepeats, left);
  if (at == nullptr || !at_word_end(at) || count == 0) return bad_word(block, repeat);
  block.repeats = static_cast<std::uint16_t>(count);
  return gap(at);
}

const char* BlockParser::called_program(Block& block, const char* at) {
  block.statement = Statement::call_program;
  beside_ = false;
  passed_over_ = true;
  const char* const word = at;
  std::string_view name;
  if (*at == '"') {
    at = quoted(block, at, name);
    if (at == nullptr) return nullptr;
  } else {
    while (!at_word_end(at)) ++at;
    name = {word, static_cast<std::size_t>(at - word)};
    at = gap(at);
  }
  if (name.empty()) return bad_word(block, word);
  if (name.size() > Name::kCapacity)
    return raise(block, word, AlarmCause::syntax, "the name of a program must have at most 63 characters");
  block.program = name;
  return at;
}

}  // namespace toolcomp::spec::klartext

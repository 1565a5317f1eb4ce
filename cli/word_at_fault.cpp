// SPDX-License-Identifier: Apache-2.0
#include "cli/word_at_fault.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "spec/language/byte_source.h"
#include "spec/language/fanuc/g_codes.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/printable.h"

namespace toolcomp::cli {
namespace {

constexpr std::size_t kLongest = 40;  // characters of a word that are shown

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
char upper(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }

// The letter O beside a digit or a point, or after the letter of an address.
bool has_letter_o(std::string_view word) {
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (upper(word[i]) != 'O') continue;
    const auto numeric = [](char c) { return is_digit(c) || c == '.' || c == '+' || c == '-' || c == ','; };
    if (i > 0 && numeric(word[i - 1])) return true;
    if (i == 1 && is_letter(word[0]) && (word.size() == 2 || numeric(word[2]))) return true;
  }
  return false;
}

bool has_decimal_comma(std::string_view word) {
  for (std::size_t i = 1; i + 1 < word.size(); ++i)
    if (word[i] == ',' && is_digit(word[i - 1]) && is_digit(word[i + 1])) return true;
  return false;
}

// X+5Y+6: a letter right after a digit.
bool runs_on(std::string_view word) {
  for (std::size_t i = 1; i < word.size(); ++i)
    if (is_letter(word[i]) && is_digit(word[i - 1])) return true;
  return false;
}

// A ; before that place, outside parentheses.
bool after_semicolon(std::string_view before) {
  bool comment = false;
  for (const char c : before) {
    comment = c == '(' || (comment && c != ')');
    if (c == ';' && !comment) return true;
  }
  return false;
}

// ( ( ) before that place: the inner ) ended the comment.
bool after_nested_comment(std::string_view before) {
  const std::size_t close = before.rfind(')');
  if (close == std::string_view::npos) return false;
  const std::string_view comment = before.substr(0, close);
  const std::size_t before_it = comment.rfind(')');
  return std::ranges::count(comment.substr(before_it == std::string_view::npos ? 0 : before_it), '(') > 1;
}

// `at`: the character of the word that cannot be read; `before`: what stands before the word.
std::string_view meant_in_fanuc(std::string_view word, char at, std::string_view before) {
  if (after_nested_comment(before)) return "the comment ends at its first ); comments cannot be nested";
  if (after_semicolon(before)) return "; ends a block; a comment is written in ( )";
  if (has_letter_o(word)) return "the letter O; the digit 0 may be meant";
  if (has_decimal_comma(word) || at == ',') return "a comma; a number has a decimal point";
  if (at == ')') return "a ) without a (";
  if (at == ']' || at == '}' || at == '{') return "a stray bracket";
  if (at == '=') return "a = without a macro variable before it";
  if (!word.empty() && is_digit(word[0])) return "a number without its letter";
  return {};
}

std::string_view meant_in_klartext(std::string_view word) {
  if (word.size() > 1 && upper(word[0]) == 'G' && is_digit(word[1])) return "a G code in a Klartext program";
  if (has_letter_o(word)) return "the letter O; the digit 0 may be meant";
  if (std::ranges::count_if(word, [](char c) { return c == '.' || c == ','; }) > 1) return "a second decimal point";
  if (runs_on(word)) return "words must be separated by blanks";
  if (word.starts_with('(')) return "a comment begins with ;";
  if (word.starts_with(')') || word.starts_with(']') || word.starts_with('[')) return "a stray bracket";
  if (!word.empty() && (is_digit(word[0]) || word[0] == '+' || word[0] == '-')) return "a number without its letter";
  return {};
}

// An alarm of a word that cannot be read, as it stands.
bool is_of_reading(spec::AlarmCause cause) {
  switch (cause) {
    case spec::AlarmCause::number_too_long:
    case spec::AlarmCause::address_missing:
    case spec::AlarmCause::digit_missing:
    case spec::AlarmCause::sign:
    case spec::AlarmCause::decimal_point:
    case spec::AlarmCause::unknown_address:
    case spec::AlarmCause::syntax:
      return true;
    default:
      return false;
  }
}

}  // namespace

std::string word_at_fault(std::string_view line, std::uint64_t column, spec::Control control) {
  if (column == 0 || column > line.size()) return {};
  const bool klartext = control == spec::Control::heidenhain;
  auto begin = static_cast<std::size_t>(column - 1);
  // The number that a fault stands in belongs to it, with its letter.
  const char at = line[begin];
  const bool in_number = !klartext && (!is_letter(at) || upper(at) == 'O');
  if (in_number) {
    const auto of_number = [](char c) { return is_digit(c) || c == '.' || c == '+' || c == '-' || upper(c) == 'O'; };
    while (begin > 0 && of_number(line[begin - 1])) --begin;
    if (begin > 0 && is_letter(line[begin - 1])) --begin;
  }
  std::size_t end = begin;
  while (end < line.size() && !is_blank(line[end])) ++end;
  const std::string_view word = line.substr(begin, std::min(end - begin, kLongest));
  if (word.empty()) return {};
  const std::string_view meant = klartext ? meant_in_klartext(word) : meant_in_fanuc(word, at, line.substr(0, begin));
  std::string text = '"' + spec::printable(word) + '"';
  if (!meant.empty()) text.append(": ").append(meant);
  return text;
}

std::optional<CodeAt> code_not_allowed(std::string_view line, const spec::Axes& axes) {
  using enum spec::GCode;
  constexpr std::array<std::uint64_t, 23> kTenths{kG10,   kG28, kG29, kG30, kG30_1, kG37, kG39, kG41,
                                                  kG42,   kG45, kG46, kG47, kG48,   kG52, kG53, kG54,
                                                  kG54_1, kG55, kG56, kG57, kG58,   kG59, kG92};
  spec::ProgramReader reader(spec::text_source(line), axes);
  spec::Block block;
  while (reader.next(block))
    for (const spec::Word& word : block.words()) {
      const std::uint64_t tenths = word.value.decimals == 0 ? word.value.digits * 10 : word.value.digits;
      if (word.address != 'G' || word.value.decimals > 1 || std::ranges::find(kTenths, tenths) == kTenths.end())
        continue;
      return CodeAt{"G" + spec::to_string(word.value), word.column};
    }
  return std::nullopt;
}

AtFault at_fault(spec::AlarmCause cause, std::string_view line, std::uint64_t column, const spec::Setup& setup) {
  if (is_of_reading(cause)) {
    const std::string word = word_at_fault(line, column, setup.control);
    return {word.empty() ? word : ", " + word, column};
  }
  if (cause == spec::AlarmCause::forbidden_under_tool_direction)
    if (const auto found = code_not_allowed(line, setup.axes)) return {": " + found->code, found->column};
  return {{}, column};
}

}  // namespace toolcomp::cli

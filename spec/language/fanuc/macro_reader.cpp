// SPDX-License-Identifier: Apache-2.0
// Custom macros in program text: numbers by variables and expressions, and the statements that set them, jump and call
// (clauses fanuc.program.macro-variable and fanuc.program.macro-statement).
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "spec/language/digits.h"
#include "spec/language/fanuc/block_reader.h"

namespace toolcomp::spec {
namespace {

constexpr int kDeepestMacro = 5;       // brackets in brackets
constexpr int kMaxMacroDigits = 15;    // of a number
constexpr unsigned kSafeDecimals = 3;  // a control in mm or inches keeps so many, whatever its increments
constexpr std::uint64_t kMostSequenceNumber = 99'999'999;

constexpr bool is_digit(int c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(int c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
constexpr char upper(int c) { return static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c); }

// The local variable that an argument of G65 sets (argument specification I); 0: none.
constexpr std::uint64_t variable_of(char letter) {
  constexpr std::string_view kLetters = "ABCIJKDEF.H.M...QRSTUVWXYZ";
  const std::size_t at = kLetters.find(letter);
  return letter == '.' || at == std::string_view::npos ? 0 : at + 1;
}

Decimal without_trailing_zeros(Decimal number) {
  for (; number.decimals > 0 && number.digits % 10 == 0; --number.decimals) number.digits /= 10;
  return number;
}

// Arguments whose number means the same with a point and without, whatever the least input increment.
constexpr bool is_count(char letter) { return std::string_view("DHMST").find(letter) != std::string_view::npos; }

}  // namespace

int BlockReader::next_of_macro() {
  while (peek() == ' ' || peek() == '\t' || peek() == '\r') take();
  return peek();
}

// The rest of the block is not read; where macros are passed over it has no fault.
bool BlockReader::not_followed(Block& block, std::uint32_t start, const char* message) {
  if (!scanning_) return raise(block, start, AlarmCause::not_supported, message);
  skip_block();
  return false;
}

std::string_view BlockReader::read_letters() {
  passed_size_ = 0;
  while (is_letter(peek()) && passed_size_ < 5) {
    passed_[passed_size_++] = upper(peek());
    take();
  }
  return {passed_.data(), passed_size_};
}

std::optional<std::uint64_t> BlockReader::variable_number() {
  std::uint64_t number = 0;
  int digits = 0;
  for (int byte = next_of_macro(); is_digit(byte) && digits < 4; take(), byte = peek(), ++digits)
    number = number * 10 + static_cast<std::uint64_t>(byte - '0');
  if (digits == 0 || !MacroVariables::is_one(number)) return std::nullopt;
  return number;
}

// A number as it stands there.
std::optional<MacroValue> BlockReader::macro_number() {
  Decimal value;
  int digits = 0;
  for (int byte = peek(); is_digit(byte) || (byte == '.' && !value.point); take(), byte = peek()) {
    if (byte == '.') {
      value.point = true;
      continue;
    }
    if (++digits > kMaxMacroDigits) return std::nullopt;
    value.digits = value.digits * 10 + static_cast<std::uint64_t>(byte - '0');
    value.decimals = static_cast<std::uint8_t>(value.decimals + (value.point ? 1 : 0));
  }
  if (digits == 0) return std::nullopt;
  return macro_literal(value);
}

// A variable, [ ] in [ ], a function of [ ], a number.
std::optional<MacroValue> BlockReader::macro_operand(int depth) {
  const int byte = next_of_macro();
  if (byte == '-' || byte == '+') {
    take();
    const auto operand = macro_operand(depth);
    return operand && byte == '-' ? negated(*operand) : operand;
  }
  if (byte == '#') {
    take();
    const auto number = variable_number();
    return number ? variables_.value(*number) : std::nullopt;
  }
  if (byte == '[' || is_letter(byte)) {
    const std::string function(read_letters());
    if (depth == 0 || next_of_macro() != '[') return std::nullopt;
    take();
    auto inner = macro_sum(depth - 1);
    if (!inner || next_of_macro() != ']') return std::nullopt;
    take();
    return function.empty() ? inner : macro_function(function, *inner);
  }
  return macro_number();
}

std::optional<MacroValue> BlockReader::macro_product(int depth) {
  auto value = macro_operand(depth);
  for (int sign = next_of_macro(); value && (sign == '*' || sign == '/'); sign = next_of_macro()) {
    take();
    const auto factor = macro_operand(depth);
    if (!factor) return std::nullopt;
    value = sign == '*' ? product(*value, *factor) : quotient(*value, *factor);
  }
  return value;
}

std::optional<MacroValue> BlockReader::macro_sum(int depth) {
  auto value = macro_product(depth);
  for (int sign = next_of_macro(); value && (sign == '+' || sign == '-'); sign = next_of_macro()) {
    take();
    const auto summand = macro_product(depth);
    if (!summand) return std::nullopt;
    value = sum(*value, sign == '-' ? negated(*summand) : *summand);
  }
  return value;
}

// A number, #1 or [ ]: whole, at least 0.
std::optional<std::uint64_t> BlockReader::macro_integer(std::uint64_t most) {
  next_of_macro();
  const auto value = macro_operand(kDeepestMacro);
  if (!value) return std::nullopt;
  const auto number = rounded(*value, 0);
  if (!number || number->negative || number->digits > most || compare(macro_literal(*number), *value) != 0)
    return std::nullopt;
  return number->digits;
}

std::optional<bool> BlockReader::macro_condition() {
  if (next_of_macro() != '[') return std::nullopt;
  take();
  const auto first = macro_sum(kDeepestMacro);
  next_of_macro();
  const std::string comparison(read_letters());
  const auto second = macro_sum(kDeepestMacro);
  if (!first || !second || next_of_macro() != ']') return std::nullopt;
  take();
  const auto sign = compare(*first, *second);
  if (!sign) return std::nullopt;
  if (comparison == "EQ") return *sign == 0;
  if (comparison == "NE") return *sign != 0;
  if (comparison == "GT") return *sign > 0;
  if (comparison == "LT") return *sign < 0;
  if (comparison == "GE") return *sign >= 0;
  if (comparison == "LE") return *sign <= 0;
  return std::nullopt;
}

// What the control makes of a number in a word: it rounds it to the least input increment.
std::optional<Decimal> BlockReader::macro_word(const MacroValue& value, const Address& admitted) const {
  constexpr double kHalfIncrement = 4e-6;  // of the finest: 0.00001 inch
  std::optional<Decimal> number = value.exact;
  if (number) number = without_trailing_zeros(*number);
  const bool as_it_is = number && number->decimals <= (admitted.point ? kSafeDecimals : 0);
  if (as_it_is && value.error >= kHalfIncrement) return std::nullopt;
  if (!as_it_is) {
    const bool length = std::string_view("IJKR").find(letter_) != std::string_view::npos || is_linear_axis(letter_);
    if (options_.decimals == 0 || (!length && !is_rotary_axis(letter_))) return std::nullopt;
    number = rounded(value, options_.decimals + (length && variables_.inch ? 1U : 0U));
    if (!number) return std::nullopt;
    number = without_trailing_zeros(*number);
  }
  if ((number->negative && number->digits != 0 && !admitted.sign) || number->digits >= kPowersOfTen[kMaxMacroDigits])
    return std::nullopt;
  number->point = admitted.point && letter_ != 'P';
  return number;
}

bool BlockReader::read_macro(Block& block, const Address& admitted, std::uint32_t start, Decimal& value) {
  const bool negative = value.negative;
  const bool variable = peek() == '#';
  has_variables_ = true;
  const auto found = macro_operand(kDeepestMacro);
  if (!found)
    return not_followed(block, start,
                        variable ? "# (a macro variable without a known value) is not supported"
                                 : "[ (a macro expression that toolcomp does not evaluate) is not supported");
  const auto word = macro_word(negative ? negated(*found) : *found, admitted);
  if (!word)
    return not_followed(block, start, "# (a macro variable whose value this address does not accept) is not supported");
  value = *word;
  return true;
}

bool BlockReader::begins_statement(Block& block, std::uint32_t start) {
  if (block.size != 0) return not_followed(block, start, "# (a macro statement after other words) is not supported");
  if (scanning_ || text_.data() != nullptr) return true;
  jump_ = Jump::keep;
  text_n_ = block.n;
  return false;
}

bool BlockReader::ends_statement() {
  const int end = next_of_macro();
  started_ = true;
  return end == kEnd || end == '\n' || end == ';' || end == '(';
}

bool BlockReader::read_assignment(Block& block) {
  const std::uint32_t start = column();
  if (!begins_statement(block, start)) return false;
  take();
  const auto number = variable_number();
  std::optional<MacroValue> value;
  if (next_of_macro() == '=') {
    take();
    value = macro_sum(kDeepestMacro);
  }
  if (!number || !value || !ends_statement())
    return not_followed(
        block, start,
        "# (a macro statement other than a variable set to an expression that toolcomp evaluates) is not "
        "supported");
  if (!scanning_) variables_.set(*number, *value);
  return true;
}

bool BlockReader::at_statement() {
  const std::string_view text = ahead();
  std::array<char, 5> letters{};
  const std::size_t size = std::min(text.size(), letters.size());
  std::ranges::transform(text.substr(0, size), letters.begin(), upper);
  const std::string_view read(letters.data(), size);
  return std::ranges::any_of(std::array{"IF", "GOTO", "WHILE", "DO", "END"},
                             [read](const char* word) { return read.starts_with(word); });
}

bool BlockReader::read_statement(Block& block) {
  const std::uint32_t start = column();
  const Place at = here();
  if (!begins_statement(block, start)) return false;
  const std::string word(read_letters());
  if (word == "IF") return read_if(block, start);
  if (word == "GOTO") return read_goto(block, start);
  if (word == "END") return read_end(block, start);
  return read_loop(block, start, word == "WHILE", at);
}

bool BlockReader::read_if(Block& block, std::uint32_t start) {
  if (scanning_) return not_followed(block, start, "");
  const auto holds = macro_condition();
  if (!holds)
    return not_followed(block, start,
                        "IF (a comparison that toolcomp does not evaluate, or whose result depends on the digits of "
                        "the control) is not "
                        "supported");
  next_of_macro();
  const std::string word(read_letters());
  if (word != "GOTO" && word != "THEN") return not_followed(block, start, "IF (without GOTO or THEN) is not supported");
  if (!*holds) {
    started_ = true;
    skip_block();
    return true;
  }
  if (word == "GOTO") return read_goto(block, start);
  if (next_of_macro() == '#') return read_assignment(block);
  return not_followed(block, start, "IF (THEN without a variable) is not supported");
}

bool BlockReader::read_goto(Block& block, std::uint32_t start) {
  if (scanning_) return not_followed(block, start, "");
  const auto number = macro_integer(kMostSequenceNumber);
  if (!number || !ends_statement()) return not_followed(block, start, "GOTO (without a whole number) is not supported");
  const auto place = place_of(*number);
  if (!place)
    return not_followed(block, start,
                        "GOTO (no block after the first macro statement has this number) is not supported");
  if (!jump(*place)) return not_followed(block, start, "GOTO (more jumps than toolcomp follows) is not supported");
  return true;
}

// WHILE [a LT b] DO 1, and DO 1 alone.
bool BlockReader::read_loop(Block& block, std::uint32_t start, bool condition, const Place& at) {
  if (scanning_) return not_followed(block, start, "");
  const std::optional<bool> holds = condition ? macro_condition() : true;
  if (!holds)
    return not_followed(block, start,
                        "WHILE (a comparison that toolcomp does not evaluate, or whose result depends on the digits of "
                        "the control) is not "
                        "supported");
  next_of_macro();
  if (condition && read_letters() != "DO") return not_followed(block, start, "WHILE (without DO) is not supported");
  const auto number = macro_integer(loops_.size());
  if (!number || *number == 0 || !ends_statement())
    return not_followed(block, start, "DO (other than 1, 2 and 3) is not supported");
  if (*holds)
    loops_.at(*number - 1) = at;
  else if (!pass_loop(*number))
    return not_followed(block, start, "WHILE (without its END) is not supported");
  return true;
}

bool BlockReader::pass_loop(std::uint64_t number) {
  const Place end = here();
  Block block;
  scanning_ = true;
  for (passed_end_ = 0; !done_ && passed_end_ != number;) read_block(block);
  scanning_ = false;
  moved_ = passed_end_ == number;
  if (!moved_) seek(end);
  jump_ = Jump::none;
  return moved_;
}

bool BlockReader::read_end(Block& block, std::uint32_t start) {
  const auto number = macro_integer(loops_.size());
  if (!number || *number == 0 || !ends_statement())
    return not_followed(block, start, "END (other than 1, 2 and 3) is not supported");
  if (scanning_) {
    passed_end_ = *number;
    return true;
  }
  const std::optional<Place>& loop = loops_.at(*number - 1);
  if (!loop) return not_followed(block, start, "END (without DO) is not supported");
  if (!jump(*loop)) return not_followed(block, start, "END (more jumps than toolcomp follows) is not supported");
  return true;
}

// G65 P9012 X0. F160: the program of this number, with local variables of its own.
bool BlockReader::read_macro_call(Block& block, std::uint32_t start) {
  if (block.size != 0) return not_followed(block, start, "G65 (after other words) is not supported");
  macro_call_ = {};
  macro_call_.column = start;
  while (!ends_statement() || peek() == '(') {
    if (peek() == '(') {
      skip_comment();
    } else if (!read_argument(block)) {
      if (!block.alarm) not_followed(block, start, "G65 (with this argument) is not supported");
      break;
    }
  }
  if (block.alarm) return false;
  jump_ = Jump::macro;
  return true;
}

bool BlockReader::read_argument(Block& block) {
  if (!is_letter(peek())) return false;
  const char letter = upper(peek());
  const std::uint32_t start = column();
  take();
  if (letter == 'P') {
    const auto program = macro_integer(99'999'999);
    macro_call_.program = program.value_or(0);
    return program.has_value();
  }
  const std::uint64_t variable = variable_of(letter);
  const int sign = next_of_macro();
  if (sign == '-' || sign == '+') take();
  const int first = next_of_macro();
  if (variable == 0 || macro_call_.arguments.contains(variable) || first == '-' || first == '+') return false;
  const bool written = is_digit(first) || first == '.';
  const auto value = macro_operand(kDeepestMacro);
  if (!value) return false;
  // A number without a point counts increments, by its letter and the units.
  const bool plain = !written || value->exact->point || value->exact->is_zero() || is_count(letter) ||
                     (letter == 'F' && !variables_.per_revolution);
  if (!plain) return not_followed(block, start, "G65 (an argument without a decimal point) is not supported");
  macro_call_.arguments[variable] = sign == '-' ? negated(*value) : *value;
  return true;
}

void BlockReader::note_code(const Decimal& code) {
  if (scanning_ || code.decimals != 0) return;
  if (code.digits == 20 || code.digits == 21) variables_.inch = code.digits == 20;
  if (code.digits == 94 || code.digits == 95) variables_.per_revolution = code.digits == 95;
}

void BlockReader::seek(const Place& place) {
  source_ = text_source(text_.substr(place.offset - text_begin_.offset));
  position_ = end_ = buffer_.data();
  buffer_[0] = 0;
  consumed_ = place.offset;
  line_ = place.line;
  line_start_ = place.line_start;
  exhausted_ = done_ = false;
}

bool BlockReader::jump(const Place& place) {
  if (++variables_.jumps > options_.most_repeated) return false;
  seek(place);
  moved_ = true;
  return true;
}

void BlockReader::find_numbers() {
  const Place back = here();
  const Jump jump_here = jump_;
  numbers_.emplace();
  if (text_n_) (*numbers_)[*text_n_].push_back(text_begin_);
  scanning_ = true;
  seek(text_begin_);
  for (Block block; !done_;) {
    const Place place = here();
    read_block(block);
    if (block.n) (*numbers_)[*block.n].push_back(place);
  }
  scanning_ = false;
  jump_ = jump_here;
  seek(back);
}

std::optional<BlockReader::Place> BlockReader::place_of(std::uint64_t sequence_number) {
  if (!numbers_) find_numbers();
  const auto found = numbers_->find(sequence_number);
  if (found == numbers_->end()) return std::nullopt;
  const auto ahead = std::ranges::lower_bound(found->second, offset(), {}, &Place::offset);
  return ahead == found->second.end() ? found->second.front() : *ahead;
}

}  // namespace toolcomp::spec

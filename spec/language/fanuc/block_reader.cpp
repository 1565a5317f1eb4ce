// SPDX-License-Identifier: Apache-2.0
#include "spec/language/fanuc/block_reader.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>

#include "spec/language/decimal_arithmetic.h"
#include "spec/language/digits.h"
#include "spec/language/fanuc/not_supported.h"
#include "spec/language/input_error.h"

namespace toolcomp::spec {
namespace {

constexpr int kMaxProgramDigits = 15;  // one more raises PS0003
constexpr std::uint64_t kMacroCall = 65;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // of UTF-8

// What a byte may be where an address can stand.
enum class Kind : std::uint8_t {
  blank,
  line_end,
  letter,
  number,
  sign,
  block_end,
  open,
  name,
  percent,
  slash,
  colon,
  other,
  substitute,
  bad
};

constexpr std::array<Kind, 256> kKinds = [] {
  std::array<Kind, 256> kinds{};
  kinds.fill(Kind::bad);
  for (unsigned c = 0x21; c < 0x7F; ++c) kinds[c] = Kind::other;
  for (unsigned c = 'A'; c <= 'Z'; ++c) kinds[c] = kinds[c - 'A' + 'a'] = Kind::letter;
  for (unsigned c = '0'; c <= '9'; ++c) kinds[c] = Kind::number;
  kinds['.'] = Kind::number;
  kinds['+'] = kinds['-'] = Kind::sign;
  kinds[' '] = kinds['\t'] = kinds['\r'] = Kind::blank;
  kinds['\n'] = Kind::line_end;
  kinds[';'] = Kind::block_end;
  kinds['('] = Kind::open;
  kinds['<'] = Kind::name;
  kinds['%'] = Kind::percent;
  kinds['/'] = Kind::slash;
  kinds[':'] = Kind::colon;
  kinds[0x1A] = Kind::substitute;
  return kinds;
}();

constexpr bool is_digit(int c) { return c >= '0' && c <= '9'; }
constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::array<Address, 256> addresses(const Axes& axes) {
  std::array<Address, 256> table{};
  const auto admit = [&table](std::string_view letters, Address address) {
    for (const char c : letters) table[static_cast<unsigned char>(c)] = address;
  };
  admit("NOMTDHL", {.known = true, .sign = false, .point = false});
  admit("G", {.known = true, .sign = false, .point = true});
  admit("FSPQRIJK", {.known = true, .sign = true, .point = true});
  admit(axes.letters(), {.known = true, .sign = true, .point = true});
  return table;
}

std::uint32_t letters_of_lines(const Axes& axes) {
  std::uint32_t letters = 0;
  for (const char c : axes.letters()) letters |= place_bit(word_place(c));
  for (const char c : {'I', 'J', 'K'}) letters |= place_bit(word_place(c));
  return letters;
}

}  // namespace

BlockReader::BlockReader(std::unique_ptr<ByteSource> bytes, const Axes& axes, ReaderOptions options,
                         MacroVariables& variables, std::uint64_t first_line)
    : options_(std::move(options)),
      variables_(variables),
      address_(addresses(axes)),
      line_letters_(letters_of_lines(axes)) {
  start(std::move(bytes), first_line);
}

BlockReader::BlockReader(std::string_view text, const Axes& axes, ReaderOptions options, MacroVariables& variables,
                         std::uint64_t first_line)
    : options_(std::move(options)),
      variables_(variables),
      address_(addresses(axes)),
      line_letters_(letters_of_lines(axes)) {
  begin(text, first_line);
}

void BlockReader::begin(std::string_view text, std::uint64_t first_line) {
  start(text_source(text), first_line);
  text_ = text;
  text_begin_ = here();
}

void BlockReader::start(std::unique_ptr<ByteSource> bytes, std::uint64_t first_line) {
  source_ = std::move(bytes);
  position_ = end_ = buffer_.data();
  buffer_[0] = 0;
  consumed_ = line_start_ = 0;
  line_ = first_line;
  at_start_ = true;
  started_ = begun_ = exhausted_ = done_ = false;
  letter_ = 0;
  jump_ = Jump::none;
  name_size_ = passed_size_ = 0;
  text_ = {};
  text_n_.reset();
  numbers_.reset();
  loops_ = {};
}

bool BlockReader::next(Block& block) {
  while (!done_)
    if (read_block(block)) return true;
  return false;
}

bool BlockReader::find(std::uint64_t sequence_number) {
  Block block;
  Place place;
  const bool scanned = std::exchange(scanning_, true);
  do {
    place = here();
    read_block(block);
  } while (!done_ && block.n != sequence_number);
  scanning_ = scanned;
  if (block.n != sequence_number) return false;
  seek(place);
  return true;
}

std::string BlockReader::take_rest() {
  std::string rest(position_, static_cast<std::size_t>(end_ - position_));
  consumed_ = offset();
  position_ = end_ = buffer_.data();
  while (!exhausted_) {
    const std::size_t size = source_->read(buffer_.data(), kBufferSize);
    rest.append(buffer_.data(), size);
    exhausted_ = size == 0;
  }
  buffer_[0] = 0;
  return rest;
}

void BlockReader::go_on(std::string_view text) {
  source_ = text_source(text);
  exhausted_ = false;
  text_ = text;
  text_begin_ = here();
}

std::uint32_t BlockReader::column_of(const char* at) const {
  constexpr std::uint64_t kLast = std::numeric_limits<std::uint32_t>::max();
  return static_cast<std::uint32_t>(std::min(offset_of(at) - line_start_ + 1, kLast));
}

bool BlockReader::refill() {
  if (exhausted_) return false;
  const bool first = std::exchange(at_start_, false);
  consumed_ += static_cast<std::uint64_t>(end_ - buffer_.data());
  position_ = end_ = buffer_.data();
  end_ += source_->read(buffer_.data(), kBufferSize);
  exhausted_ = position_ == end_;
  if (first) skip_byte_order_mark();
  buffer_[static_cast<std::size_t>(end_ - buffer_.data())] = 0;
  if (exhausted_) return false;
  return position_ != end_ || refill();
}

std::string_view BlockReader::ahead() {
  constexpr std::size_t kMost = 6;
  auto size = static_cast<std::size_t>(end_ - position_);
  if (size < kMost && !exhausted_) {
    consumed_ = offset();
    std::copy(position_, end_, buffer_.data());
    position_ = buffer_.data();
    for (std::size_t more = 1; size < kMost && more != 0; size += more)
      more = source_->read(buffer_.data() + size, kBufferSize - size);
    end_ = position_ + size;
    buffer_[size] = 0;
  }
  return {position_, std::min(size, kMost)};
}

void BlockReader::skip_byte_order_mark() {
  const auto size = [this] { return static_cast<std::size_t>(end_ - buffer_.data()); };
  for (std::size_t more = size(); more > 0 && size() < kByteOrderMark.size(); end_ += more)
    more = source_->read(buffer_.data() + size(), kBufferSize - size());
  if (std::string_view(buffer_.data(), size()).starts_with(kByteOrderMark)) position_ += kByteOrderMark.size();
}

// Attaches the fault; the rest of the block is not read as words.
bool BlockReader::raise(Block& block, std::uint32_t column, AlarmCause cause, const char* message) {
  block.alarm = ReadAlarm{cause, column, message};
  started_ = true;
  // A word of a macro begins with the letter that was taken for an address.
  const char* const word = block.alarm->cause == AlarmCause::digit_missing ? &letter_ : nullptr;
  passed_size_ = 0;
  if (word != nullptr) passed_[passed_size_++] = *word;
  skip_block();
  if (cause == AlarmCause::not_supported) return false;
  if (const char* const macro = text_not_supported({passed_.data(), passed_size_}); macro != nullptr) {
    block.alarm->cause = AlarmCause::not_supported;
    block.alarm->message = macro;
  }
  return false;
}

void BlockReader::refuse(int byte) {
  done_ = true;
  constexpr std::string_view kHex = "0123456789ABCDEF";
  const auto value = static_cast<unsigned>(byte);
  const std::string name = {'0', 'x', kHex[value >> 4], kHex[value & 15]};
  throw InputError(options_.file, line_, column(),
                   value >= 0x80 ? "byte " + name + " outside a comment; a program is ASCII text"
                                 : "control character " + name + "; a program is ASCII text");
}

// A Ctrl-Z pads the end of files from old systems; elsewhere it is a control character like any other.
void BlockReader::end_file() {
  const std::uint32_t first = column();
  while (peek() == 0x1A) take();
  if (peek() == kEnd) return;
  done_ = true;
  throw InputError(options_.file, line_, first, "Ctrl-Z (0x1A) before the end of the file");
}

void BlockReader::end_line() {
  take();
  ++line_;
  line_start_ = offset();
}

void BlockReader::end_percent() {
  take();
  if (started_ || begun_)
    done_ = true;
  else
    begun_ = true;
}

// Up to and with the ), or up to the end of the line.
void BlockReader::skip_comment() {
  take();
  for (;;) {
    const int byte = peek();
    if (byte == kEnd || byte == '\n') return;
    if (byte == 0x1A) {
      end_file();
      return;
    }
    if (byte < 0x80 && kKinds[static_cast<std::size_t>(byte)] == Kind::bad) refuse(byte);
    take();
    if (byte == ')') return;
  }
}

// Up to what ends the block; only bytes and comments are looked at.
void BlockReader::skip_block() {
  for (;;) {
    const int byte = peek();
    if (byte == kEnd) return;
    switch (kKinds[static_cast<std::size_t>(byte)]) {
      case Kind::line_end:
      case Kind::block_end:
        return;
      case Kind::open:
        skip_comment();
        break;
      case Kind::substitute:
        end_file();
        break;
      case Kind::bad:
        refuse(byte);
      default:
        if (passed_size_ < passed_.size() && kKinds[static_cast<std::size_t>(byte)] != Kind::blank)
          passed_[passed_size_++] = upper(static_cast<char>(byte));
        take();
    }
  }
}

// At the / that begins a block: the switch number, and the whole block where blocks are to be skipped.
bool BlockReader::read_slash(Block& block) {
  if (block.size != 0 || block.n)
    return raise(block, column(), AlarmCause::address_missing, "/ is allowed only at the beginning of a block");
  started_ = true;
  take();
  const int byte = peek();
  if (byte >= '1' && byte <= '9') take();
  if (options_.block_skip) skip_block();
  return true;
}

// An address, whose letter peek() still shows, and its number.
bool BlockReader::read_word(Block& block, char letter) {
  const std::uint32_t start = column();
  const Address& admitted = address_[static_cast<unsigned char>(letter)];
  if (!admitted.known)
    return raise(block, start, AlarmCause::unknown_address, "this letter is not an address of this control");
  if (letter != 'N' && block.size == Block::kMaxWords)
    return raise(block, start, AlarmCause::too_many_words, "the block has too many words");
  started_ = true;
  take();
  letter_ = letter;
  Decimal value;
  if (const char* const end = read_usual(position_, admitted, value))
    position_ = end;
  else if (!read_number(block, admitted, start, value))
    return false;
  if (letter == 'N') {
    block.n = value.digits;
    return true;
  }
  if (letter == 'G') {
    if (value.digits == kMacroCall && value.decimals == 0) return read_macro_call(block, start);
    if (const char* const what = code_not_supported(value)) return raise(block, start, AlarmCause::not_supported, what);
    note_code(value);
  }
  if (letter == 'L' && value.decimals == 0 && (value.digits == 3 || (value.digits >= 50 && value.digits <= 52)) &&
      std::ranges::any_of(block.words(), [](const Word& word) {
        return word.address == 'G' && word.value.decimals == 0 && word.value.digits == 10;
      }))
    return raise(block, start, AlarmCause::not_supported, "G10 L (tool life and parameters) is not supported");
  if (letter == 'M' && value.digits == 198)
    return raise(block, start, AlarmCause::not_supported,
                 "M198 (call of a program in another memory) is not supported");
  if (letter == 'M' && (value.digits == 98 || value.digits == 99)) jump_ = value.digits == 98 ? Jump::call : Jump::back;
  block.word[block.size++] = {letter, value, start};
  return true;
}

// <NAME> at the head of a program says nothing; behind M98 it is what is called.
bool BlockReader::read_name(Block& block) {
  const std::uint32_t start = column();
  const bool called = jump_ == Jump::call && block.size != 0 && block.word[block.size - 1].address == 'M';
  if (!called && (block.size != 0 || block.n))
    return raise(block, start, AlarmCause::address_missing, "a program name in < > is not an address");
  started_ = true;
  take();
  name_size_ = 0;
  for (int byte = peek(); byte != '>'; byte = peek()) {
    if (byte == kEnd || byte == '\n' || byte < 0x20 || byte > 0x7E || name_size_ == kLongestName)
      return raise(block, start, AlarmCause::address_missing, "a program name must have 1 to 32 characters in < >");
    name_[name_size_++] = static_cast<char>(byte);
    take();
  }
  take();
  if (!called) name_size_ = 0;
  return true;
}

// What stands behind the address, which began at `start`.
bool BlockReader::read_number(Block& block, const Address& admitted, std::uint32_t start, Decimal& value) {
  int byte = peek();
  while (byte == ' ' || byte == '\t' || byte == '\r') take(), byte = peek();
  value = {};
  if (byte == '-' || byte == '+') {
    if (!admitted.sign) return raise(block, column(), AlarmCause::sign, "this address takes no sign");
    value.negative = byte == '-';
    take();
    byte = peek();
    if (byte == '-' || byte == '+') return raise(block, column(), AlarmCause::sign, "a second sign");
  }
  if (byte == '#' || byte == '[') return read_macro(block, admitted, start, value);
  int digits = 0;
  for (;; take(), byte = peek()) {
    if (is_digit(byte)) {
      if (++digits > kMaxProgramDigits)
        return raise(block, column(), AlarmCause::number_too_long, "a number with more than 15 digits");
      value.digits = value.digits * 10 + static_cast<std::uint64_t>(byte - '0');
      value.decimals = static_cast<std::uint8_t>(value.decimals + (value.point ? 1 : 0));
    } else if (byte == '.') {
      if (value.point) return raise(block, column(), AlarmCause::decimal_point, "a second decimal point");
      if (!admitted.point)
        return raise(block, column(), AlarmCause::decimal_point, "this address takes no decimal point");
      value.point = true;
    } else {
      break;
    }
  }
  if (digits == 0) return raise(block, start, AlarmCause::digit_missing, "an address without a digit");
  if (byte == '-' && value.negative) return raise(block, column(), AlarmCause::sign, "a second minus sign");
  return true;
}

// The place is at hand, not in the reader: what is written of a word would have to be waited for there.
bool BlockReader::read_usual_words(Block& block) {
  const char* at = position_;
  for (;;) {
    const char letter = upper(*at);
    const Address& admitted = address_[static_cast<unsigned char>(letter)];
    // M may call a program, and what G10 writes is by L.
    if (!admitted.known || letter == 'M' || letter == 'L' || block.size == Block::kMaxWords) break;
    // Written in its place, part by part: a copy of what has just been written in parts would be waited for.
    Word& word = block.word[block.size];
    Decimal& value = word.value;
    value.decimals = 0;
    const char* const end = read_usual(at + 1, admitted, value);
    if (end == nullptr) break;
    constexpr std::uint64_t kInUse = 4;  // G00 to G04 stand in most blocks
    if (letter == 'G' && (value.digits > kInUse || value.decimals != 0)) {
      if (code_not_supported(value) != nullptr) break;
      note_code(value);
    }
    if (letter == 'N') {
      block.n = value.digits;
    } else {
      word.address = letter;
      word.column = column_of(at);
      ++block.size;
    }
    at = *end == ' ' ? end + 1 : end;
  }
  if (at == position_) return false;
  started_ = true;
  position_ = at;
  return true;
}

[[gnu::always_inline]] inline const char* BlockReader::read_usual(const char* at, const Address& admitted,
                                                                  Decimal& value) const {
  // Without a branch: signs follow no pattern.
  value.negative = *at == '-';
  const bool has_sign = value.negative || *at == '+';
  at += has_sign ? 1 : 0;
  unsigned count = 1;
  if (const ShortDecimal number = short_decimal_at(at); number.size != 0) [[likely]] {
    at += number.size;
    value.point = true;
    value.digits = number.digits;
    value.decimals = static_cast<std::uint8_t>(number.decimals);
  } else {
    const Digits before = digits_at(at);
    if (before.count > 7) return nullptr;
    at += before.count;
    value.point = *at == '.';
    value.digits = before.number;
    count = before.count;
    if (value.point) {
      const Digits behind = digits_at(++at);
      if (behind.count > 7) return nullptr;
      at += behind.count;
      value.digits = value.digits * kPowersOfTen[behind.count] + behind.number;
      value.decimals = static_cast<std::uint8_t>(behind.count);
      count += behind.count;
    }
  }
  // A number that reaches the end of the buffer may go on behind it.
  if (count == 0 || at == end_ || *at == '.' || *at == '-' || (has_sign && !admitted.sign) ||
      (value.point && !admitted.point))
    return nullptr;
  return at;
}

bool BlockReader::read_block(Block& block) {
  block.line = line_;
  block.n.reset();
  block.size = 0;
  block.alarm.reset();
  jump_ = Jump::none;
  name_size_ = 0;
  has_variables_ = false;
  const auto content = [this, &block] { return block.size != 0 || block.alarm || jump_ == Jump::macro; };
  while (!done_) {
    const int byte = peek();
    if (byte == kEnd) {
      done_ = true;
      break;
    }
    switch (kKinds[static_cast<std::size_t>(byte)]) {
      case Kind::blank:
        take();
        break;
      case Kind::letter:
        if (read_usual_words(block)) break;
        if (at_statement())
          read_statement(block);
        else
          read_word(block, upper(*position_));
        break;
      case Kind::colon:
        read_word(block, 'O');
        break;
      case Kind::line_end:
        end_line();
        return content();
      case Kind::block_end:
        take();
        return content();
      case Kind::open:
        skip_comment();
        break;
      case Kind::name:
        read_name(block);
        break;
      case Kind::percent:
        end_percent();
        break;
      case Kind::slash:
        read_slash(block);
        break;
      case Kind::number:
        raise(block, column(), AlarmCause::address_missing, "expected an address, found a number");
        break;
      case Kind::sign:
        raise(block, column(), AlarmCause::address_missing, "expected an address, found a sign");
        break;
      case Kind::other:
        if (byte == '#')
          read_assignment(block);
        else
          raise(block, column(), AlarmCause::address_missing, "this character is not an address");
        break;
      case Kind::substitute:
        end_file();
        break;
      case Kind::bad:
        refuse(byte);
    }
    if (jump_ == Jump::keep) [[unlikely]]
      return true;
    if (std::exchange(moved_, false)) [[unlikely]]
      return content();
  }
  return content();
}

}  // namespace toolcomp::spec

// SPDX-License-Identifier: Apache-2.0
// Reads the blocks of a piece of FANUC program text in the order of the text. ProgramReader puts them in the order in
// which they run.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spec/language/axes.h"
#include "spec/language/byte_source.h"
#include "spec/language/digits.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/fanuc/macro_variables.h"
#include "spec/language/line_columns.h"
#include "spec/language/reader_options.h"

namespace toolcomp::spec {

// What the number of an address may have.
struct Address {
  bool known = false;
  bool sign = false;
  bool point = false;
};

// Needs constant memory, whatever the length of a line.
class BlockReader {
 public:
  // Where the program goes on after a block: M98, M99, G65. `keep`: the caller must keep the text from here on, because
  // it may be read again; no block was read.
  enum class Jump : std::uint8_t { none, call, back, macro, keep };
  // The call of G65.
  struct MacroCall {
    std::uint32_t column = 1;
    std::uint64_t program = 0;
    MacroVariables::Values arguments;
  };

  // The text sets and reads `variables`.
  BlockReader(std::unique_ptr<ByteSource> bytes, const Axes& axes, ReaderOptions options, MacroVariables& variables,
              std::uint64_t first_line = 1);

  // The same for a text in memory, in which macro statements may jump.
  BlockReader(std::string_view text, const Axes& axes, ReaderOptions options, MacroVariables& variables,
              std::uint64_t first_line = 1);

  // Begins again, with another text, which must outlive its blocks.
  void begin(std::string_view text, std::uint64_t first_line);
  // From here on macro statements are skipped: no variable is set, and nothing jumps.
  void scan() { scanning_ = true; }
  // The next block with at least one word (or an alarm); false at the end of the text or at the `%` that ends it.
  // Throws InputError for bytes that are no text. Does not allocate.
  bool next(Block& block);
  // The lines after the block read last, at most `most`, that have the same usual words: axis words and I J K of at
  // most seven digits before the point and six after it, G00 G01 and N, nothing else. There may be none. They are still
  // to be read.
  void lines(LineColumns& to, std::size_t most);
  // Goes past the first `count` of the lines given last.
  void pass_lines(std::size_t count);
  // Goes to the next block with this sequence number, in a text in memory; false if there is none.
  bool find(std::uint64_t sequence_number);
  // The jump of the block read last, if it has no alarm.
  [[nodiscard]] Jump jump() const { return jump_; }
  [[nodiscard]] bool calls() const { return jump_ == Jump::call || jump_ == Jump::macro; }
  // The name in angle brackets after M98 in that block, or empty.
  [[nodiscard]] std::string_view called_name() const { return {name_.data(), name_size_}; }

  // Ends the text: no further blocks.
  void end() { done_ = true; }
  // G65 of the block read last.
  [[nodiscard]] const MacroCall& macro_call() const { return macro_call_; }
  // Whether a word of the block read last has its number from a variable.
  [[nodiscard]] bool has_variables() const { return has_variables_; }
  // The text after the block read last. This reader no longer reads it. go_on() continues in this text, or in a part of
  // it, and jumps do not go back before it.
  std::string take_rest();
  void go_on(std::string_view text);
  // The line of the next block.
  [[nodiscard]] std::uint64_t line() const { return line_; }

 private:
  static constexpr std::size_t kBufferSize = 65536;
  static constexpr std::size_t kLongestName = 32;

  // The next byte, or kEnd, without taking it.
  int peek() {
    if (position_ != end_ || refill()) [[likely]]
      return static_cast<unsigned char>(*position_);
    return kEnd;
  }
  void take() { ++position_; }
  // At most six bytes, beginning with the one that peek() shows.
  std::string_view ahead();
  bool refill();
  void start(std::unique_ptr<ByteSource> bytes, std::uint64_t first_line);
  void skip_byte_order_mark();

  // The number of bytes before a byte in the buffer, and before the next byte.
  [[nodiscard]] std::uint64_t offset_of(const char* at) const {
    return consumed_ + static_cast<std::uint64_t>(at - buffer_.data());
  }
  [[nodiscard]] std::uint64_t offset() const { return offset_of(position_); }
  // The column of a byte in the buffer, and of the byte that peek() shows.
  [[nodiscard]] std::uint32_t column_of(const char* at) const;
  [[nodiscard]] std::uint32_t column() const { return column_of(position_); }

  // A place in the text.
  struct Place {
    std::uint64_t offset = 0;
    std::uint64_t line = 1;
    std::uint64_t line_start = 0;
  };

  // Reads one block, including its end; false if it has no word other than N and no alarm.
  bool read_block(Block& block);
  // These return whether there was no fault. After a fault the rest of the block has been skipped.
  bool read_word(Block& block, char letter);
  bool read_number(Block& block, const Address& admitted, std::uint32_t start, Decimal& value);
  // Macros (macro_reader.cpp): #100, [#100+2.] after an address and its sign. An expression that toolcomp does not
  // evaluate is not supported.
  bool read_macro(Block& block, const Address& admitted, std::uint32_t start, Decimal& value);
  [[nodiscard]] std::optional<Decimal> macro_word(const MacroValue& value, const Address& admitted) const;
  // Statements: #100=5. IF WHILE DO END GOTO G65. Each is a block of the text, and the caller does not get it as a
  // block.
  bool read_assignment(Block& block);
  bool at_statement();  // except #100=5.
  bool read_statement(Block& block);
  bool read_if(Block& block, std::uint32_t start);
  bool read_loop(Block& block, std::uint32_t start, bool condition, const Place& at);
  bool read_end(Block& block, std::uint32_t start);
  bool read_goto(Block& block, std::uint32_t start);
  bool read_macro_call(Block& block, std::uint32_t start);
  bool read_argument(Block& block);
  // False if something stands before the statement, or if the text from here on must be kept first. Then no statement
  // is read.
  bool begins_statement(Block& block, std::uint32_t start);
  bool ends_statement();
  // At most five letters from here on.
  std::string_view read_letters();
  bool not_followed(Block& block, std::uint32_t start, const char* message);
  // [a EQ b]; std::nullopt if toolcomp does not evaluate it.
  std::optional<bool> macro_condition();
  // A sum of products, with brackets up to `depth` deep; std::nullopt if it is anything else, or if a value is not
  // known.
  std::optional<MacroValue> macro_sum(int depth);
  std::optional<MacroValue> macro_product(int depth);
  std::optional<MacroValue> macro_operand(int depth);
  std::optional<MacroValue> macro_number();
  std::optional<std::uint64_t> variable_number();  // after #
  std::optional<std::uint64_t> macro_integer(std::uint64_t most);
  int next_of_macro();                  // peek() after blanks
  void note_code(const Decimal& code);  // G20, G21, G94, G95

  [[nodiscard]] Place here() const { return {offset(), line_, line_start_}; }
  void seek(const Place& place);
  // False if there were more jumps than toolcomp follows.
  bool jump(const Place& place);
  // The next block with this number, or else the first one.
  std::optional<Place> place_of(std::uint64_t sequence_number);
  void find_numbers();
  // Goes past the END with this number; false if there is none.
  bool pass_loop(std::uint64_t number);

  // The letters of usual words of a line, in their order.
  struct LineShape {
    std::array<char, 12> letter{};
    std::size_t size = 0;
  };
  // Reads one more line that begins here, and returns its end; nullptr if it is not usual, or has not this shape. The
  // first one makes the shape.
  const char* read_line(const char* at, LineColumns& to, LineShape& shape) const;
  // Its words, up to the end of the line.
  const char* read_line_words(const char* at, LineColumns& to, LineShape& shape) const;
  // Reads words with at most a blank between them, as long as their numbers are of the usual form. False if the first
  // one is not.
  bool read_usual_words(Block& block);
  // Reads a number of the usual form, [+-]digits[.digits] with at most seven digits each, and returns its end; nullptr
  // if it is or may be any other number.
  [[nodiscard]] const char* read_usual(const char* at, const Address& admitted, Decimal& value) const;
  bool read_slash(Block& block);
  bool read_name(Block& block);
  bool raise(Block& block, std::uint32_t column, AlarmCause cause, const char* message);
  void skip_comment();
  void skip_block();
  void end_line();
  void end_percent();
  void end_file();
  [[noreturn]] void refuse(int byte);

  static constexpr int kEnd = -1;

  std::unique_ptr<ByteSource> source_;
  ReaderOptions options_;
  MacroVariables& variables_;
  std::array<Address, 256> address_;
  std::uint32_t line_letters_ = 0;                            // of usual lines: axes, I J K; A is bit 0
  std::array<char, kBufferSize + 2 * kDigitsRead> buffer_{};  // the byte at `end_` is 0
  const char* position_ = buffer_.data();
  const char* end_ = buffer_.data();
  std::uint64_t consumed_ = 0;    // bytes before the buffer
  std::uint64_t line_ = 1;        // being read
  std::uint64_t line_start_ = 0;  // offset of its first byte
  bool at_start_ = true;          // no byte has come
  bool started_ = false;          // something other than blanks, comments, line ends and % was read
  bool begun_ = false;            // the % that begins the program was read
  bool exhausted_ = false;        // the source has no more bytes
  bool done_ = false;             // no more blocks
  char letter_ = 0;               // of the word read last
  Jump jump_ = Jump::none;
  std::array<char, kLongestName> name_{};
  std::size_t name_size_ = 0;
  std::string_view text_;                                               // kept; data() is nothing: it is not
  Place text_begin_;                                                    // where it begins
  std::optional<std::uint64_t> text_n_;                                 // the number of the block there, read before
  std::optional<std::map<std::uint64_t, std::vector<Place>>> numbers_;  // where blocks of a number are, in its order
  std::array<std::optional<Place>, 3> loops_;                           // by number: the statement that began it
  bool moved_ = false;            // the next block does not stand after the one at hand
  std::uint64_t passed_end_ = 0;  // END of this number was passed over
  bool scanning_ = false;
  bool has_variables_ = false;
  MacroCall macro_call_;
  std::array<const char*, LineColumns::kMost> line_end_{};  // of the lines given last
  std::array<char, 8> passed_{};                            // what was not read as words, from its first character
  std::size_t passed_size_ = 0;
};

}  // namespace toolcomp::spec

// SPDX-License-Identifier: Apache-2.0
// The blocks of a piece of FANUC program text, one after the other as they stand there. ProgramReader puts them in the
// order in which they run.
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
#include "spec/language/reader_options.h"

namespace toolcomp::spec {

// What an address admits.
struct Address {
  bool known = false;
  bool sign = false;
  bool point = false;
};

// In constant memory, whatever the length of a line.
class BlockReader {
 public:
  // Where the program goes on after a block: M98, M99, G65. `keep`: the text from here on has to be kept, since it may
  // be read again; no block has come.
  enum class Jump : std::uint8_t { none, call, back, macro, keep };
  // Of G65.
  struct MacroCall {
    std::uint32_t column = 1;
    std::uint64_t program = 0;
    MacroVariables::Values arguments;
  };

  // `variables` are set and read by the text.
  BlockReader(std::unique_ptr<ByteSource> bytes, const Axes& axes, ReaderOptions options, MacroVariables& variables,
              std::uint64_t first_line = 1);

  // The same of a text in memory, in which macro statements jump.
  BlockReader(std::string_view text, const Axes& axes, ReaderOptions options, MacroVariables& variables,
              std::uint64_t first_line = 1);

  // Begins anew, with another text, which must outlive its blocks.
  void begin(std::string_view text, std::uint64_t first_line);
  // From here on macro statements are passed over: nothing is set, and nothing jumps.
  void scan() { scanning_ = true; }
  // The next block with at least one word (or an alarm); false at the end of the text or at the `%` that ends it.
  // Throws InputError for bytes that are no text. Does not allocate.
  bool next(Block& block);
  // To the next block with this sequence number, of a text in memory; false where there is none.
  bool find(std::uint64_t sequence_number);
  // Of the block read last, where it has no alarm.
  [[nodiscard]] Jump jump() const { return jump_; }
  [[nodiscard]] bool calls() const { return jump_ == Jump::call || jump_ == Jump::macro; }
  // The name in angle brackets behind its M98, or empty.
  [[nodiscard]] std::string_view called_name() const { return {name_.data(), name_size_}; }

  // No further blocks.
  void end() { done_ = true; }
  // G65 of the block read last.
  [[nodiscard]] const MacroCall& macro_call() const { return macro_call_; }
  // A word of the block read last has its number from a variable.
  [[nodiscard]] bool has_variables() const { return has_variables_; }
  // The text behind the block read last, which is read no more from here; go_on() reads on in it, or in less of it, and
  // jumps go no further back.
  std::string take_rest();
  void go_on(std::string_view text);
  // Of what comes next.
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
  // The bytes from the one on that peek() shows, six at most.
  std::string_view ahead();
  bool refill();
  void start(std::unique_ptr<ByteSource> bytes, std::uint64_t first_line);
  void skip_byte_order_mark();

  // Bytes taken up to one in the buffer, and so far.
  [[nodiscard]] std::uint64_t offset_of(const char* at) const {
    return consumed_ + static_cast<std::uint64_t>(at - buffer_.data());
  }
  [[nodiscard]] std::uint64_t offset() const { return offset_of(position_); }
  // Of a byte in the buffer, and of the one that peek() shows.
  [[nodiscard]] std::uint32_t column_of(const char* at) const;
  [[nodiscard]] std::uint32_t column() const { return column_of(position_); }

  // A place in the text.
  struct Place {
    std::uint64_t offset = 0;
    std::uint64_t line = 1;
    std::uint64_t line_start = 0;
  };

  // One block, up to and with what ends it; false if it has no word but N and no alarm.
  bool read_block(Block& block);
  // These return whether all is well; after a fault the rest of the block is behind.
  bool read_word(Block& block, char letter);
  bool read_number(Block& block, const Address& admitted, std::uint32_t start, Decimal& value);
  // Of macros (macro_reader.cpp): #100, [#100+2.] after an address and its sign. What is not followed is not supported.
  bool read_macro(Block& block, const Address& admitted, std::uint32_t start, Decimal& value);
  [[nodiscard]] std::optional<Decimal> macro_word(const MacroValue& value, const Address& admitted) const;
  // Statements: #100=5. IF WHILE DO END GOTO G65. Each is a block of its own, and none for those who take blocks.
  bool read_assignment(Block& block);
  bool at_statement();  // but for #100=5.
  bool read_statement(Block& block);
  bool read_if(Block& block, std::uint32_t start);
  bool read_loop(Block& block, std::uint32_t start, bool condition, const Place& at);
  bool read_end(Block& block, std::uint32_t start);
  bool read_goto(Block& block, std::uint32_t start);
  bool read_macro_call(Block& block, std::uint32_t start);
  bool read_argument(Block& block);
  // What stands before a statement, or the text from here on is to be kept first: no statement is read.
  bool begins_statement(Block& block, std::uint32_t start);
  bool ends_statement();
  // Letters from here on, five at most.
  std::string_view read_letters();
  bool not_followed(Block& block, std::uint32_t start, const char* message);
  // [a EQ b]; nothing where it is not followed.
  std::optional<bool> macro_condition();
  // A sum of products up to `depth` brackets deep; nothing where it is anything else, or not known.
  std::optional<MacroValue> macro_sum(int depth);
  std::optional<MacroValue> macro_product(int depth);
  std::optional<MacroValue> macro_operand(int depth);
  std::optional<MacroValue> macro_number();
  std::optional<std::uint64_t> variable_number();  // after #
  std::optional<std::uint64_t> macro_integer(std::uint64_t most);
  int next_of_macro();                  // peek() behind blanks
  void note_code(const Decimal& code);  // G20, G21, G94, G95

  [[nodiscard]] Place here() const { return {offset(), line_, line_start_}; }
  void seek(const Place& place);
  // False: more jumps than are followed.
  bool jump(const Place& place);
  // The block of this number that comes next, or else the first one.
  std::optional<Place> place_of(std::uint64_t sequence_number);
  void find_numbers();
  // Past END of this number; false where there is none.
  bool pass_loop(std::uint64_t number);

  // The words from here on, a blank apart at most, as long as they have usual numbers. False: not even the first one.
  bool read_usual_words(Block& block);
  // The usual number without a detour, [-]digits[.digits] of at most seven each: where it ends; nullptr where it is or
  // may be any other.
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
  std::array<char, 8> passed_{};  // what was not read as words, from its first character
  std::size_t passed_size_ = 0;
};

}  // namespace toolcomp::spec

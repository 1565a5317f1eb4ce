// SPDX-License-Identifier: Apache-2.0
// The grammar: turns one logical block of a Klartext program, all of it in memory, into a Block. Internal to the
// reader.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "spec/language/heidenhain/klartext_formula.h"
#include "spec/language/heidenhain/klartext_words.h"
#include "spec/language/setup.h"

namespace toolcomp::spec::klartext {

// The place of a block in memory. A line feed at `stop` ends it, and kDigitsRead bytes after that can be read.
struct BlockText {
  const char* begin = nullptr;
  const char* stop = nullptr;
  std::uint64_t line = 1;  // first line of the block in the text
  std::size_t mark = 0;    // number of bytes of a byte order mark before `begin`
};

// Functions that take a place return the place after what they have read, or nullptr after they have attached an alarm
// to the block.
class BlockParser {
 public:
  // Both must outlive the parser; `file` is for messages.
  BlockParser(const Setup& setup, const std::string& file);

  // What comes before the statement.
  struct Head {
    const char* statement = nullptr;  // nullptr: the head has a fault, and the block has an alarm
    bool slash = false;
  };
  // Writes line, column, n and alarm of the block.
  Head parse_head(Block& block, const BlockText& text);
  // False if there is nothing but comments or a structure block: then there is no block to return.
  bool parse_statement(Block& block, const char* at);
  // Refuses a block that is too long to be read.
  void refuse_long(Block& block, const char* statement);

  // Whether bytes were skipped: comments, strings, and the rest of a block with a fault.
  [[nodiscard]] bool passed_over() const { return passed_over_; }
  // Whether the statement is a structure block or has a program name.
  [[nodiscard]] bool admits_any_byte(const char* statement) const;
  // Whether END PGM was read.
  [[nodiscard]] bool ended() const { return ended_; }
  // The name in BEGIN PGM, if it was read.
  [[nodiscard]] const Name& program_name() const { return program_name_; }
  [[nodiscard]] Units units() const { return units_; }
  // Permits BEGIN PGM in the next block.
  void begin() { first_ = true; }

 private:
  static constexpr std::uint8_t kNoSlot = 255;

  // The next word or the end of the block, after blanks, comments, and line ends at which the block continues.
  const char* gap(const char* at) {
    if (*at == ' ') ++at;
    return at_word_end(at) ? wide_gap(at) : at;
  }
  const char* wide_gap(const char* at);
  // The place after one word, or after two words with a gap between them; nullptr, without an alarm, if there are other
  // words.
  const char* words(const char* at, std::string_view first, std::string_view second = {});

  struct Place {
    std::uint64_t line;
    std::uint32_t column;
  };
  [[nodiscard]] Place place(const char* at) const;
  const char* raise(Block& block, const char* at, AlarmCause cause, const char* message);
  // Attaches an alarm: not supported.
  const char* refuse(Block& block, const char* at, const char* message);
  // The same if the statement has a name in the list of what is not supported, otherwise E_SYNTAX.
  const char* refuse_by_name(Block& block, const char* at);
  const char* bad_word(Block& block, const char* at);
  // Checks that the block ends here, and that no fault was kept for its end.
  const char* finish(Block& block, const char* at);

  const char* line(Block& block, const char* at);
  const char* line_with_vectors(Block& block, const char* at);
  const char* vector_word(Block& block, const char* at, unsigned rank);
  const char* check_vectors(Block& block, unsigned keys, const char* initiator);
  const char* tail(Block& block, const char* at);
  const char* radius(Block& block, const char* at);
  const char* feed(Block& block, const char* at);
  const char* functions(Block& block, const char* at);
  const char* words_of_function(Block& block, const char* at, std::uint64_t number, const char* function);
  const char* retraction(Block& block, const char* at, const char* function);
  [[nodiscard]] const char* not_judged(std::uint64_t function) const;
  const char* words_without_effect(Block& block, const char* at);

  const char* rare_statement(Block& block, const char* at);
  const char* program(Block& block, const char* at);
  const char* block_form(Block& block, const char* at);
  const char* tool(Block& block, const char* at);
  const char* tool_name(Block& block, const char* at);
  const char* tool_call(Block& block, const char* at);
  const char* tool_definition(Block& block, const char* at);
  const char* function(Block& block, const char* at);
  const char* tcpm(Block& block, const char* at);
  const char* reference(Block& block, const char* at);
  const char* correction_data(Block& block, const char* at);
  const char* correction_row(Block& block, const char* at);
  const char* table_word(Block& block, const char* at);
  const char* select_corrections(Block& block, const char* at);
  const char* cycle(Block& block, const char* at);
  const char* path_cycle(Block& block, const char* at);
  const char* drilling_cycle(Block& block, const char* at);
  const char* cycle_call(Block& block, const char* at);
  // Why the call of a cycle in this block is not followed: a static text, or nullptr if it is.
  [[nodiscard]] const char* call_beyond(const Block& block) const;
  const char* datum_shift(Block& block, const char* at);
  const char* transformation(Block& block, const char* at);
  const char* preset(Block& block, const char* at);
  bool is_first_preset(const Value& number);
  const char* without_effect(Block& block);
  const char* contour_words(Block& block, const char* at);
  const char* contour(Block& block, const char* at, const char* behind, const char* message);
  const char* plane(Block& block, const char* at);
  const char* numbered_function(Block& block, const char* at);
  const char* system_data(Block& block, const char* at);
  const char* assignment(Block& block, const char* at, char operation);
  [[nodiscard]] bool takes_unknown(const Block& block) const;
  const char* label(Block& block, const char* at);
  const char* label_word(Block& block, const char* at);
  const char* call(Block& block, const char* at);
  const char* called_label(Block& block, const char* at);
  const char* called_program(Block& block, const char* at);
  // Reads a value after a key of this length, and the gap after the value.
  const char* keyed_value(Block& block, const char* at, std::size_t key, Value& value);
  const char* quoted(Block& block, const char* at, std::string_view& text);
  const char* free_text();

  const Setup& setup_;
  const std::string& file_;
  std::array<std::uint8_t, 256> slot_{};  // of an axis letter of the setup
  BlockText text_;
  bool first_ = true;  // no block was returned yet
  bool passed_over_ = false;
  bool ended_ = false;
  Name program_name_;
  Units units_;
  bool turned_ = false;          // a rotary axis was sent to a position other than 0
  unsigned renamed_ = 0;         // by slot: M94 may have removed whole turns from the position of this axis
  bool tcpm_ = false;            // TCPM is on
  bool begins_in_tcpm_ = false;  // TCPM was on before this block
  bool beside_ = false;          // RL or RR
  bool lateral_ = false;         // RL or RR, and TCPM has been on since then
  ParameterValues parameters_;
  bool unknown_ = false;         // a value is not known here
  std::uint32_t to_call_ = 0;    // the machining cycle defined last
  std::optional<Value> preset_;  // the number that was selected first
  // Words of this block that are at fault if no other word is.
  const char* call_at_ = nullptr;  // M99, CYCL CALL
  const char* fifth_function_ = nullptr;
  const char* out_of_order_ = nullptr;
  const char* out_of_range_ = nullptr;
  const char* normal_ = nullptr;       // NX
  const char* tool_vector_ = nullptr;  // TX
};

}  // namespace toolcomp::spec::klartext

// SPDX-License-Identifier: Apache-2.0
// One block of a FANUC program: its words, with exact decimals, without their meaning.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "spec/language/decimal.h"
#include "spec/parameters/alarm_causes.h"

namespace toolcomp::spec {

struct Word {
  char address = 0;  // upper case
  Decimal value;
  std::uint32_t column = 0;  // of the address, from 1
  friend bool operator==(const Word& a, const Word& b) { return a.address == b.address && a.value == b.value; }
};

// The alarm that the control raises when it reaches a block it cannot read (docs/events.md, rule 5).
struct ReadAlarm {
  AlarmCause cause = AlarmCause::none;
  std::uint32_t column = 0;
  const char* message = "";  // static text
};

// The words in the order in which they are written. A block with a read alarm has the words before the fault, and is
// not executed.
struct Block {
  static constexpr std::size_t kMaxWords = 64;  // one more raises TOO_MANY_WORDS

  std::uint64_t line = 0;          // of the text, from 1
  std::optional<std::uint64_t> n;  // sequence number; an N word is not among the words
  std::array<Word, kMaxWords> word;
  std::size_t size = 0;
  std::optional<ReadAlarm> alarm;

  [[nodiscard]] std::span<const Word> words() const { return {word.data(), size}; }
};

// Whether usual lines (line_columns.h) are worth a look after this block: it has the word of an axis, or I, J, K.
inline bool lines_may_follow(const Block& block) {
  constexpr std::string_view kOthers = "DFGHLMNOPQRST";
  return std::ranges::any_of(block.words(),
                             [&](const Word& word) { return kOthers.find(word.address) == std::string_view::npos; });
}

// The block as text that the reader reads back: "N30 G01 X10. Y-0". Without the words after a read alarm.
std::string to_string(const Block& block);

}  // namespace toolcomp::spec

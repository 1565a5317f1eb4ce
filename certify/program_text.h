// SPDX-License-Identifier: Apache-2.0
// A program text as lines of words, for taking it apart. Words are found only by their form, so that a faulty word
// stays a word.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace toolcomp::certify {

// One line without its line end, as the pieces that shrinking may remove one by one.
struct TextLine {
  std::vector<std::string> words;
  friend bool operator==(const TextLine&, const TextLine&) = default;
};
using TextProgram = std::vector<TextLine>;

// FANUC: a word is a letter with everything up to the next letter, and a comment is one word. Klartext: words are
// separated by blanks. Only blanks and carriage returns are lost.
TextProgram split_program(std::string_view text, std::string_view dialect);
// Words joined by one blank, every line ended by a line feed; lines without words are left out.
std::string join_program(const TextProgram& program);

// The lines with at least one word.
std::size_t count_blocks(std::string_view text);

// A number inside a word: `prefix` + number + `suffix`, with an empty number if the word has none. It is the last
// number of a word, and only if its digits mean a quantity: FANUC G, M, N and O words count as names, and so do
// Klartext M words.
struct NumberInWord {
  std::string prefix;
  std::string number;
  std::string suffix;
};
NumberInWord number_in(std::string_view word, std::string_view dialect = "fanuc");

// Numbers that are simpler than `number`, the simplest first: 0, only the first digit, fewer decimals, fewer digits,
// without its sign. Each is shorter than `number`, or has the same length and smaller digits, so that repeating this
// ends.
std::vector<std::string> simpler_numbers(std::string_view number);

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
// A program text as lines of words, for taking it apart: by shape only, so that a faulty word stays a word.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace toolcomp::certify {

// One line without its line end, as the pieces that shrinking may leave out one by one.
struct TextLine {
  std::vector<std::string> words;
  friend bool operator==(const TextLine&, const TextLine&) = default;
};
using TextProgram = std::vector<TextLine>;

// FANUC: a word is a letter with everything up to the next letter, a comment is one word. Klartext: words stand between
// blanks. Nothing but blanks and carriage returns is lost.
TextProgram split_program(std::string_view text, std::string_view dialect);
// Words joined by one blank, every line ended by a line feed; lines without words are left out.
std::string join_program(const TextProgram& program);

// The lines with at least one word.
std::size_t count_blocks(std::string_view text);

// A number inside a word: `prefix` + number + `suffix`, or nothing (an empty number) where the word has none. Only the
// last number of a word, and only where the digits mean a quantity: FANUC G, M, N and O words count as names, and so do
// Klartext M words.
struct NumberInWord {
  std::string prefix;
  std::string number;
  std::string suffix;
};
NumberInWord number_in(std::string_view word, std::string_view dialect = "fanuc");

// Simpler numbers than `number`, simplest first: 0, the first digit alone, fewer decimals, fewer digits, without its
// sign. Each is shorter than `number`, or as long and smaller in its digits: taking them again and again ends.
std::vector<std::string> simpler_numbers(std::string_view number);

}  // namespace toolcomp::certify

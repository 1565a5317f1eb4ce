// SPDX-License-Identifier: Apache-2.0
#include "certify/fuzzing/shape.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "certify/program_text.h"

namespace toolcomp::certify::fuzzing {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

char kind_of(char letter) {
  constexpr std::string_view kLinear = "XYZUVW";
  constexpr std::string_view kRotary = "ABC";
  constexpr std::string_view kVector = "IJK";
  if (kLinear.find(letter) != std::string_view::npos) return 'X';
  if (kRotary.find(letter) != std::string_view::npos) return 'A';
  if (kVector.find(letter) != std::string_view::npos) return 'I';
  return letter;
}

// G and M with their number, G43.4 and not G04.0; of every other word its letter.
std::string iso_word(std::string_view word) {
  const char letter = upper(word.front());
  if (letter == 'N' || letter == '(') return {};
  if (letter != 'G' && letter != 'M') return {kind_of(letter)};
  std::string code;
  for (const char c : word.substr(1))
    if (is_digit(c) ? !code.empty() || c != '0'
                    : c == '.' && word.find_first_of("123456789", 1) != std::string_view::npos)
      code += c;
  while (code.find('.') != std::string::npos && (code.back() == '0' || code.back() == '.')) code.pop_back();
  return std::string(1, letter) + (code.empty() ? "0" : code);
}

// Keywords as they are, F AUTO and M128 too; of a coordinate its letters, of vectors NX TX the first, of a number alone
// nothing.
std::string klartext_word(std::string_view word) {
  if (word == "~") return {};
  if (upper(word.front()) == 'M' && word.size() > 1 && is_digit(word[1])) return std::string(word);
  std::string letters;
  for (const char c : word.substr(0, word.find_first_of("+-.0123456789"))) letters += upper(c);
  if (letters.size() == 1) return {kind_of(letters[0])};
  if (letters.size() == 2 && (letters[0] == 'N' || letters[0] == 'T' || letters[0] == 'I') &&
      kind_of(letters[1]) == 'X')
    return {letters[0], 'X'};
  return letters;
}

}  // namespace

std::string shape_of(const spec::Case& c) {
  std::string shape;
  std::string before;
  for (const TextLine& line : split_program(c.program, c.dialect)) {
    std::set<std::string> words;
    for (const std::string& word : line.words) {
      if (word.front() == ';') break;  // a comment, to the end
      if (std::string text = c.dialect == "klartext" ? klartext_word(word) : iso_word(word); !text.empty())
        words.insert(std::move(text));
    }
    std::string block;
    for (const std::string& word : words) block += (block.empty() ? "" : " ") + word;
    if (block.empty() || block == before) continue;
    shape += (shape.empty() ? "" : "|") + block;
    before = block;
  }
  return shape;
}

}  // namespace toolcomp::certify::fuzzing

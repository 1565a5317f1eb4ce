// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/program_text.h"

namespace toolcomp::fuzz {
namespace {

std::string trimmed(std::string_view text) {
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return std::string(text);
}

}  // namespace

std::vector<std::string> lines(std::string_view program) {
  std::vector<std::string> result;
  while (!program.empty()) {
    const std::size_t end = program.find('\n');
    result.emplace_back(program.substr(0, end));
    program = end == std::string_view::npos ? std::string_view() : program.substr(end + 1);
  }
  return result;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

WordTexts words(std::string_view line) {
  WordTexts result;
  std::size_t start = 0;
  for (std::size_t i = 1; i <= line.size(); ++i)
    if (i == line.size() || is_letter(line[i])) {
      std::string word = trimmed(line.substr(start, i - start));
      if (!word.empty()) result.push_back(std::move(word));
      start = i;
    }
  return result;
}

WordTexts words_between_blanks(std::string_view line) {
  WordTexts result;
  while (!line.empty()) {
    const std::size_t end = line.find(' ');
    if (end != 0) result.emplace_back(line.substr(0, end));
    line = end == std::string_view::npos ? std::string_view() : line.substr(end + 1);
  }
  return result;
}

std::string joined_words(const WordTexts& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

}  // namespace toolcomp::fuzz

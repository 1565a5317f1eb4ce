// SPDX-License-Identifier: Apache-2.0
#include "certify/program_text.h"

#include <algorithm>
#include <cctype>

namespace toolcomp::certify {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

void add_word(TextLine& line, std::string_view word) {
  while (!word.empty() && is_blank(word.back())) word.remove_suffix(1);
  while (!word.empty() && is_blank(word.front())) word.remove_prefix(1);
  if (!word.empty()) line.words.emplace_back(word);
}

TextLine split_iso(std::string_view text) {
  TextLine line;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') {
      add_word(line, text.substr(begin, i - begin));
      const std::size_t close = text.find(')', i);
      const std::size_t end = close == std::string_view::npos ? text.size() : close + 1;
      add_word(line, text.substr(i, end - i));
      begin = end;
      i = end - 1;
    } else if (is_letter(text[i]) || text[i] == ';') {
      add_word(line, text.substr(begin, i - begin));
      begin = i;
    }
  }
  if (begin < text.size()) add_word(line, text.substr(begin));
  return line;
}

TextLine split_blanks(std::string_view text) {
  TextLine line;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    if (i == text.size() || is_blank(text[i])) {
      add_word(line, text.substr(begin, i - begin));
      begin = i;
    }
  }
  return line;
}

// Puts `candidate` behind the others if it is new and simpler than `number`.
void propose(std::vector<std::string>& candidates, std::string_view number, std::string candidate) {
  const bool simpler = candidate.size() < number.size() || (candidate.size() == number.size() && candidate < number);
  if (simpler && std::ranges::find(candidates, candidate) == candidates.end())
    candidates.push_back(std::move(candidate));
}

}  // namespace

TextProgram split_program(std::string_view text, std::string_view dialect) {
  TextProgram program;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    program.push_back(dialect == "klartext" ? split_blanks(line) : split_iso(line));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return program;
}

std::string join_program(const TextProgram& program) {
  std::string text;
  for (const TextLine& line : program) {
    for (std::size_t i = 0; i < line.words.size(); ++i) {
      if (i > 0) text += ' ';
      text += line.words[i];
    }
    if (!line.words.empty()) text += '\n';
  }
  return text;
}

std::size_t count_blocks(std::string_view text) {
  std::size_t blocks = 0;
  bool words = false;
  for (const char c : text) {
    if (c == '\n') {
      blocks += words ? 1 : 0;
      words = false;
    } else if (!is_blank(c)) {
      words = true;
    }
  }
  return blocks + (words ? 1 : 0);
}

NumberInWord number_in(std::string_view word, std::string_view dialect) {
  NumberInWord parts;
  if (word.empty() || word.front() == '(' || word.front() == ';') return parts;
  const char address = static_cast<char>(std::toupper(static_cast<unsigned char>(word.front())));
  if (std::string_view(dialect == "klartext" ? "M" : "GMNO").find(address) != std::string_view::npos) return parts;
  std::size_t end = word.size();
  while (end > 0 && !is_digit(word[end - 1]) && word[end - 1] != '.') --end;
  std::size_t begin = end;
  while (begin > 0 && (is_digit(word[begin - 1]) || word[begin - 1] == '.')) --begin;
  if (begin == end) return parts;
  if (begin > 0 && (word[begin - 1] == '-' || word[begin - 1] == '+')) --begin;
  parts.prefix = word.substr(0, begin);
  parts.number = word.substr(begin, end - begin);
  parts.suffix = word.substr(end);
  return parts;
}

std::vector<std::string> simpler_numbers(std::string_view number) {
  std::vector<std::string> candidates;
  const bool sign = number.front() == '-' || number.front() == '+';
  const std::string minus = number.front() == '-' ? "-" : "";
  const std::string_view digits = number.substr(sign ? 1 : 0);
  const std::size_t point = digits.find('.');
  const std::string whole(digits.substr(0, std::min(point, digits.size())));
  const std::string decimals(point == std::string_view::npos ? std::string_view() : digits.substr(point + 1));
  const std::size_t first = whole.find_first_not_of('0');
  const std::string significant = first == std::string::npos ? std::string() : whole.substr(first);

  propose(candidates, number, "0");
  propose(candidates, number, minus + "1");
  if (!significant.empty()) {
    propose(candidates, number, minus + "1" + std::string(significant.size() - 1, '0'));
    propose(candidates, number, minus + significant.substr(0, 1));
    propose(candidates, number, minus + significant.substr(0, 1) + std::string(significant.size() - 1, '0'));
    propose(candidates, number, minus + significant);
  } else if (!decimals.empty()) {
    propose(candidates, number, minus + "0");
  }
  // Without trailing zeros, then one decimal fewer, keeping as many as are needed.
  for (std::size_t keep = 1; keep < decimals.size(); ++keep)
    propose(candidates, number, minus + significant + "." + decimals.substr(0, keep));
  if (!decimals.empty()) propose(candidates, number, minus + significant + "." + decimals);
  if (sign) propose(candidates, number, std::string(digits));
  // The same number of digits with the last non-zero digit but the first cleared.
  std::string cleared(number);
  for (std::size_t i = cleared.size(); i-- > 0;) {
    if (cleared[i] >= '1' && cleared[i] <= '9') {
      cleared[i] = '0';
      propose(candidates, number, cleared);
      break;
    }
  }
  return candidates;
}

}  // namespace toolcomp::certify

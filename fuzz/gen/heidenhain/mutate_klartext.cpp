// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/heidenhain/mutate_klartext.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "fuzz/gen/change_text.h"
#include "fuzz/gen/heidenhain/klartext_vocabulary.h"
#include "fuzz/gen/program_text.h"

namespace toolcomp::fuzz {
namespace {

// Behind the parameter of Q200=+2; else the word.
std::size_t value_begin(const std::string& word) {
  const std::size_t sign = word.find('=');
  return sign == std::string::npos ? 0 : sign + 1;
}

void negate(std::string& word) {
  const std::size_t sign = word.find_first_of("+-");
  if (sign != std::string::npos) {
    word[sign] = word[sign] == '+' ? '-' : '+';
    return;
  }
  const std::size_t digit = word.find_first_of("0123456789.", value_begin(word));
  if (digit != std::string::npos && digit > 0) word.insert(digit, "-");
}

// L and LN, behind a number or not.
bool moves(const std::string& line) {
  const WordTexts words = words_between_blanks(line);
  const auto first = std::ranges::find_if(words, [](const std::string& word) { return !is_digit(word[0]); });
  return first != words.end() && (*first == "L" || *first == "LN");
}

void change_word(Choices& choose, Mode mode, WordTexts& line) {
  const bool free = mode == Mode::unrestricted || choose.chance(10);
  const std::size_t at = line.empty() ? 0 : choose.below(line.size());
  if (line.empty() || (free && choose.chance(20))) {
    line.insert(line.begin() + static_cast<std::ptrdiff_t>(at), any_klartext_word(choose));
    return;
  }
  std::string& word = line[at];
  if (mode == Mode::unrestricted && choose.chance(20)) {
    word = odd_klartext(choose);
    return;
  }
  switch (choose.weighted({50, 20, 12, 8, 10})) {
    case 0:
      return change_digit(choose, word, value_begin(word));
    case 1:
      return negate(word);
    case 2:
      if (!free) return change_digit(choose, word, value_begin(word));
      word = any_klartext_word(choose);
      return;
    case 3:
      // R0, RL, RR and M functions as another of their kind.
      if (word.size() == 2 && word[0] == 'R') word = choose.one_of({"R0", "RL", "RR"});
      if (word[0] == 'M' && free) word = choose.one_of({"M107", "M108", "M128", "M129"});
      return;
    default:
      // A word too few makes most blocks unreadable.
      if (!free) return change_digit(choose, word, value_begin(word));
      line.erase(line.begin() + static_cast<std::ptrdiff_t>(at));
      return;
  }
}

// `gently`: the sign and the size stay.
void change_decimal(Choices& choose, spec::Decimal& value, bool gently) {
  switch (gently ? 1 + 2 * choose.below(2) : choose.below(4)) {
    case 0:
      value.negative = !value.negative && value.digits != 0;
      return;
    case 1:
      value = spec::decimal(0);
      return;
    case 2:
      value = spec::decimal(choose.between(0, 12));
      return;
    default:
      if (value.digits < 999'999'999) value.digits += 1;
      return;
  }
}

}  // namespace

void change_klartext(Choices& choose, spec::Case& c, Mode mode) {
  std::vector<std::string> text = lines(c.program);
  if (text.empty()) text.emplace_back("L X+10");
  const std::size_t at = choose.below(text.size());
  const auto place = text.begin() + static_cast<std::ptrdiff_t>(at);
  // Without the blocks that set it up a program ends early.
  constexpr int motion[] = {68, 8, 10, 8, 6};
  constexpr int other[] = {90, 2, 6, 2, 0};
  constexpr int unrestricted[] = {60, 8, 8, 8, 16};
  const std::span<const int> directed = moves(text[at]) ? std::span(motion) : std::span(other);
  switch (choose.weighted(mode == Mode::directed ? directed : std::span(unrestricted))) {
    case 0: {
      WordTexts line = words_between_blanks(text[at]);
      change_word(choose, mode, line);
      text[at] = joined_words(line);
      break;
    }
    case 1:
      change_line(choose, text, at, LineChange::erase);
      break;
    case 2:
      change_line(choose, text, at, LineChange::repeat);
      break;
    case 3:
      change_line(choose, text, at, LineChange::exchange);
      break;
    default:
      text.insert(place, any_klartext_statement(choose, c.setup));
      break;
  }
  if (text.size() > kMostLines) text.resize(kMostLines);
  c.program = joined(text);
}

// Names and support points stay. Directed: the shape of a tool stays, too.
void change_tool_tables(Choices& choose, spec::Setup& setup, Mode mode) {
  const bool gently = mode == Mode::directed;
  if (!setup.tcs.empty() && choose.chance(20)) {
    spec::CorrectionRow& row = setup.tcs.begin()->second;
    return change_decimal(choose, *choose.one_of({&row.dl, &row.dr, &row.dr2}), gently);
  }
  if (!setup.dr2_tables.empty() && choose.chance(25)) {
    spec::DeviationTable& table = setup.dr2_tables.begin()->second;
    return change_decimal(choose, table[choose.below(table.size())].second, gently);
  }
  if (setup.tools.empty()) return;
  spec::ToolRow& tool = setup.tools[choose.below(setup.tools.size())];
  if (choose.chance(10)) {
    if (tool.l)
      tool.l.reset();
    else
      tool.l = spec::decimal(choose.between(0, 100));
    return;
  }
  spec::Decimal* const delta = choose.one_of({&tool.dl, &tool.dr, &tool.dr2});
  spec::Decimal* const radius = choose.one_of({&tool.r, &tool.r2});
  change_decimal(choose, gently || choose.chance(60) ? *delta : *radius, gently);
}

}  // namespace toolcomp::fuzz

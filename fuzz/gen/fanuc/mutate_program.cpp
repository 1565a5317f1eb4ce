// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/fanuc/mutate_program.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "fuzz/gen/change_text.h"
#include "fuzz/gen/fanuc/setups.h"
#include "fuzz/gen/fanuc/vocabulary.h"
#include "fuzz/gen/program_text.h"
#include "spec/language/parameter.h"

namespace toolcomp::fuzz {
namespace {

void negate(std::string& word) {
  if (word.size() < 2) return;
  if (word[1] == '-')
    word.erase(1, 1);
  else
    word.insert(1, "-");
}

void change_word(Choices& choose, const spec::Case& c, Mode mode, WordTexts& line) {
  const std::size_t at = line.empty() ? 0 : choose.below(line.size());
  // Words of any group end a valid program early more often than not: few of them in directed changes.
  const bool free = mode == Mode::unrestricted || choose.chance(10);
  if (line.empty() || (free && choose.chance(20))) {
    line.insert(line.begin() + static_cast<std::ptrdiff_t>(at), any_word(choose, c.setup, c.section));
    return;
  }
  std::string& word = line[at];
  if (mode == Mode::unrestricted && choose.chance(25)) {
    word = odd_word(choose);
    return;
  }
  switch (choose.weighted({45, 15, 15, 10, 15})) {
    case 0:
      change_digit(choose, word, 1);
      break;
    case 1:
      negate(word);
      break;
    case 2:
      if (free)
        word = any_word(choose, c.setup, c.section);
      else
        change_digit(choose, word, 1);
      break;
    case 3:
      word = word.substr(0, 1) + boundary_number(choose);
      break;
    default:
      line.erase(line.begin() + static_cast<std::ptrdiff_t>(at));
      break;
  }
}

}  // namespace

void change_program(Choices& choose, spec::Case& c, Mode mode) {
  std::vector<std::string> text = lines(c.program);
  if (text.empty()) text.emplace_back("G01 X10.");
  const std::size_t at = choose.below(text.size());
  const auto place = text.begin() + static_cast<std::ptrdiff_t>(at);
  constexpr int directed[] = {70, 8, 8, 8, 2, 4};
  constexpr int unrestricted[] = {60, 8, 8, 8, 12, 4};
  switch (choose.weighted(mode == Mode::directed ? std::span(directed) : std::span(unrestricted))) {
    case 0: {
      WordTexts line = words(text[at]);
      change_word(choose, c, mode, line);
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
    case 4: {
      WordTexts line;
      for (std::size_t n = choose.below(3) + 1; n > 0; --n) line.push_back(any_word(choose, c.setup, c.section));
      text.insert(place, joined_words(line));
      break;
    }
    default: {  // a word moves to another block
      WordTexts line = words(text[at]);
      if (line.empty()) break;
      const std::size_t from = choose.below(line.size());
      text[choose.below(text.size())] += " " + line[from];
      break;
    }
  }
  if (text.size() > kMostLines) text.resize(kMostLines);
  c.program = joined(text);
}

namespace {

void change_decimal(Choices& choose, spec::Decimal& value, int decimals) {
  switch (choose.below(5)) {
    case 0:
      value.negative = !value.negative && value.digits != 0;
      break;
    case 1:
      value = decimal(0, 0);
      break;
    case 2:
      value = decimal(choose.between(-99, 99), 0);
      break;
    case 3:
      if (value.digits < 999'999'999) value.digits += 1;
      break;
    default:
      value = decimal(choose.between(-99'999, 99'999), decimals);
      break;
  }
}

// An entry of a map, by chance; the end of an empty one.
template <class Map>
auto any_of(Choices& choose, Map& map) {
  auto it = map.begin();
  if (!map.empty()) std::advance(it, static_cast<std::ptrdiff_t>(choose.below(map.size())));
  return it;
}

// Any angle, length or bit is a control that could exist; numbers of axes and types are not.
bool is(const spec::ParameterId& id, spec::ParameterType type) {
  const spec::ParameterInfo* const p = spec::find_parameter(id);
  return p != nullptr && p->type == type;
}

// Bits but those that give every number another meaning or take an axis away.
bool is_choice(const spec::ParameterId& id) {
  constexpr spec::ParameterId no_choice[] = {{3401, 0}, {19696, 0}, {19696, 1}};
  return is(id, spec::ParameterType::bit) && std::ranges::find(no_choice, id) == std::end(no_choice);
}

void change_parameter(Choices& choose, Mode mode, spec::Setup& setup) {
  switch (choose.below(5)) {
    case 0: {
      const int bit = choose.one_of({0, 1, 2, 3, 4, 5, 6});
      setup.parameters[{5001, bit}] = spec::decimal(choose.between(0, 1));
      return;
    }
    case 1:
      setup.parameters[{19631, -1}] = decimal(choose.between(-1'000, 90'000), 3);
      return;
    case 2: {
      constexpr spec::ParameterId bits[] = {{5003, 0}, {5003, 1}, {5003, 2}, {5008, 0}, {5008, 1}, {5008, 3}};
      const spec::ParameterId bit = choose.one_of(bits);
      setup.parameters[bit] = spec::decimal(choose.between(0, 1));
      return;
    }
    default: {
      const auto parameter = any_of(choose, setup.parameters);
      if (parameter == setup.parameters.end()) return;
      const bool angle = is(parameter->first, spec::ParameterType::angle);
      if (mode == Mode::directed && is(parameter->first, spec::ParameterType::length)) {
        if (!parameter->second.negative && parameter->second.digits < 99'999'999)
          parameter->second.digits += choose.below(3);
        return;
      }
      if (mode == Mode::directed && !angle && !is_choice(parameter->first)) return;
      if (parameter->first.bit >= 0)
        parameter->second = spec::decimal(choose.between(0, 1));
      else if (angle && mode == Mode::directed)
        parameter->second = decimal(choose.between(-90'000, 90'000), 3);
      else if (choose.chance(50))
        change_decimal(choose, parameter->second, 3);
      else
        setup.parameters.erase(parameter);
      return;
    }
  }
}

}  // namespace

void change_setup(Choices& choose, spec::Setup& setup, Mode mode) {
  const int decimals = increment_decimals(setup);
  switch (choose.weighted({40, 25, 25, 10})) {
    case 0:
      return change_parameter(choose, mode, setup);
    case 1: {
      const auto entry = any_of(choose, setup.h);
      if (entry != setup.h.end()) change_decimal(choose, entry->second.geometry, decimals);
      return;
    }
    case 2: {
      const auto entry = any_of(choose, setup.d);
      if (entry != setup.d.end()) change_decimal(choose, entry->second.geometry, decimals);
      return;
    }
    default: {
      auto& table = *choose.one_of({&setup.workpiece.front(), &setup.position, &setup.measurement});
      const auto entry = any_of(choose, table);
      if (entry != table.end()) change_decimal(choose, entry->second, decimals);
      return;
    }
  }
}

}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/change_text.h"

#include <utility>
#include <vector>

namespace toolcomp::fuzz {
namespace {

// Digits a word may grow to. A control's lengths have nine; far beyond, doubles are so far apart (0.016 at 1e14) that
// the head of a vector cannot be told from the centre of its arc, and which of them it is would be judged, not the
// rule.
constexpr std::size_t kMostDigits = 10;

}  // namespace

void change_digit(Choices& choose, std::string& word, std::size_t from) {
  std::vector<std::size_t> places;
  for (std::size_t i = from; i < word.size(); ++i)
    if (is_digit(word[i])) places.push_back(i);
  if (places.empty()) return;
  const std::size_t at = places[choose.below(places.size())];
  const char digit = static_cast<char>('0' + choose.below(10));
  switch (choose.weighted({60, 20, 20})) {
    case 0:
      word[at] = digit;
      break;
    case 1:
      if (places.size() < kMostDigits) word.insert(at, 1, digit);
      break;
    default:
      if (places.size() > 1) word.erase(at, 1);
      break;
  }
}

void change_line(Choices& choose, std::vector<std::string>& text, std::size_t at, LineChange change) {
  const auto place = text.begin() + static_cast<std::ptrdiff_t>(at);
  switch (change) {
    case LineChange::erase:
      text.erase(place);
      break;
    case LineChange::repeat:
      text.insert(place, std::string(text[at]));
      break;
    case LineChange::exchange:
      std::swap(text[at], text[choose.below(text.size())]);
      break;
  }
}

}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
// Programs with the slip of a pen: what a control meets when a program was typed or edited by hand.
#include <string>
#include <utility>

#include "fuzz/gen/change_text.h"
#include "fuzz/gen/fanuc/vocabulary.h"
#include "fuzz/gen/heidenhain/klartext_vocabulary.h"
#include "fuzz/gen/program_text.h"
#include "fuzz/gen/sections.h"

namespace toolcomp::fuzz {
namespace {

// To the other sign; a number without one gets a minus.
void change_sign(std::string& word) {
  const std::size_t sign = word.find_first_of("+-");
  if (sign != std::string::npos) {
    word[sign] = word[sign] == '+' ? '-' : '+';
    if (word[sign] == '+') word.erase(sign, 1);
    return;
  }
  const std::size_t number = word.find_first_of("0123456789.");
  if (number != std::string::npos && number > 0) word.insert(number, 1, '-');
}

}  // namespace

void slip(Choices& choose, spec::Case& c) {
  const bool klartext = c.setup.control == spec::Control::heidenhain;
  const auto split = klartext ? words_between_blanks : words;
  std::vector<std::string> text = lines(c.program);
  if (text.empty()) return;
  std::string& line = text[choose.below(text.size())];
  WordTexts block = split(line);
  if (block.empty()) return;
  const auto place = block.begin() + static_cast<std::ptrdiff_t>(choose.below(block.size()));
  constexpr std::size_t kMoved = 4;
  const std::size_t kind = choose.weighted({32, 10, 12, 16, 15, 15});
  switch (kind) {
    case 0:
      change_digit(choose, *place, 0);
      break;
    case 1:
      change_sign(*place);
      break;
    case 2:
      *place = klartext ? any_klartext_word(choose) : any_word(choose, c.setup, c.section);
      break;
    case 3:
      block.erase(place);
      break;
    default: {  // into another block, at any place there; sometimes it stays as well
      std::string word = *place;
      if (kind == kMoved) block.erase(place);
      std::string& other = text[choose.below(text.size())];
      if (&other == &line) {
        block.insert(block.begin() + static_cast<std::ptrdiff_t>(choose.below(block.size() + 1)), std::move(word));
        break;
      }
      WordTexts there = split(other);
      there.insert(there.begin() + static_cast<std::ptrdiff_t>(choose.below(there.size() + 1)), std::move(word));
      other = joined_words(there);
      break;
    }
  }
  line = joined_words(block);
  c.program = joined(text);
}

}  // namespace toolcomp::fuzz

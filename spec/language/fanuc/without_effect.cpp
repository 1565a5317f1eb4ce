// SPDX-License-Identifier: Apache-2.0
#include "spec/language/fanuc/without_effect.h"

#include <algorithm>
#include <array>

namespace toolcomp::spec {
namespace {

// Ascending, in tenths.
constexpr std::array<std::uint64_t, 26> kCodes{50,  51,  80,  90,  110, 131, 150, 220, 230, 250, 401,  500,  501,
                                               502, 610, 611, 620, 630, 640, 670, 690, 960, 970, 1130, 1500, 1600};
static_assert(std::ranges::is_sorted(kCodes));

// M00 M01 M02 M30 end or stop the reading ahead, M98 and M99 call and return.
constexpr std::array<std::uint64_t, 6> kMeant{0, 1, 2, 30, 98, 99};

std::string two_digits(std::uint64_t number) { return (number < 10 ? "0" : "") + std::to_string(number); }

}  // namespace

bool code_without_effect(std::uint64_t tenths) { return std::ranges::binary_search(kCodes, tenths); }

void add_words_without_effect(const Block& block, std::set<std::string>& words) {
  for (const Word& word : block.words()) {
    const Decimal& value = word.value;
    if (word.address == 'S' || word.address == 'T') {
      words.insert(std::string(1, word.address));
    } else if (word.address == 'M' && std::ranges::find(kMeant, value.digits) == kMeant.end()) {
      words.insert('M' + two_digits(value.digits));
    } else if (word.address == 'G' && value.decimals <= 1) {
      const std::uint64_t tenths = value.decimals == 1 ? value.digits : value.digits * 10;
      if (!code_without_effect(tenths)) continue;
      const std::string fraction = tenths % 10 == 0 ? std::string() : '.' + std::to_string(tenths % 10);
      words.insert('G' + two_digits(tenths / 10) + fraction);
    }
  }
}

}  // namespace toolcomp::spec

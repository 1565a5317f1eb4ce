// SPDX-License-Identifier: Apache-2.0
#include "spec/language/fanuc/without_effect.h"

#include <algorithm>
#include <array>

#include "spec/language/fanuc/g_codes.h"

namespace toolcomp::spec {
namespace {

// Ascending, in tenths.
constexpr std::array<std::uint64_t, 26> kCodes{kG05, kG05_1, kG08, kG09,   kG11,   kG13_1, kG15,   kG22, kG23,
                                               kG25, kG40_1, kG50, kG50_1, kG50_2, kG61,   kG61_1, kG62, kG63,
                                               kG64, kG67,   kG69, kG96,   kG97,   kG113,  kG150,  kG160};
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

// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/fanuc/tool_turns.h"

#include <algorithm>
#include <cstdlib>

namespace toolcomp::fuzz {

SpaceCounts of_any_sense(Choices& choose, SpaceCounts direction) {
  for (std::int64_t& x : direction)
    if (choose.chance(30)) x = -x;
  if (direction[2] < 0 && choose.chance(70)) direction[2] = -direction[2];
  return direction;
}

void direction_words(Choices& choose, ProgramWriter& write, const SpaceCounts& whole, std::uint64_t zeros) {
  const std::int64_t most = std::max({std::abs(whole[0]), std::abs(whole[1]), std::abs(whole[2])});
  constexpr std::int64_t digits = 99'999;
  const std::int64_t factor = most > digits       ? 1
                              : choose.chance(70) ? write.one()
                              : choose.chance(50) ? 1
                                                  : choose.between(2, 9);
  for (std::size_t i = 0; i < 3; ++i)
    if (whole.at(i) != 0 || choose.chance(zeros)) write.number("IJK"[i], whole.at(i) * factor);
}

std::int64_t rotary_target(Choices& choose, const ProgramWriter& write, char letter,
                           const std::array<int, 6>& weights) {
  const std::int64_t one = write.one();
  switch (choose.weighted(weights)) {
    case 0:
      return choose.between(-12, 12) * 15 * one;
    case 1:
      return choose.between(-4, 4) * 90 * one;
    case 2:
      return choose.between(-8, 8) * 45 * one;
    case 3:
      return choose.between(-60 * one, 60 * one);
    case 4:
      return write.at(letter) + choose.between(-3 * one, 3 * one);
    default:
      return write.at(letter) + choose.between(-180, 180) * one;
  }
}

}  // namespace toolcomp::fuzz

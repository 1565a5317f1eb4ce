// SPDX-License-Identifier: Apache-2.0
#include "corpus/counts.h"

#include <fmt/format.h>

namespace toolcomp::corpus {

std::int64_t nearest(Wide n, Wide d) {
  const Wide twice = 2 * n + d;
  const Wide down = twice / (2 * d) - (twice % (2 * d) < 0 ? 1 : 0);
  return static_cast<std::int64_t>(down);
}

std::string decimal(std::int64_t count, int places) {
  std::uint64_t one = 1;
  for (int i = 0; i < places; ++i) one *= 10;
  const std::uint64_t magnitude = count < 0 ? 0 - static_cast<std::uint64_t>(count) : static_cast<std::uint64_t>(count);
  std::string text = fmt::format("{}{}.{:0{}}", count < 0 ? "-" : "", magnitude / one, magnitude % one, places);
  while (text.ends_with('0')) text.pop_back();
  return text;
}

}  // namespace toolcomp::corpus

// SPDX-License-Identifier: Apache-2.0
#include "certify/causes/follow.h"

#include <algorithm>
#include <utility>

#include "certify/trace/free_space.h"
#include "certify/trace/matcher.h"
#include "certify/trace/path_window.h"

namespace toolcomp::certify {
std::optional<double> followed(PathSource& path, const Metric& metric, std::size_t count, bool to_end,
                               const Recorded& recorded) {
  PathWindow window(path, metric);
  FreeSpace space(window, metric);
  const auto sample = [&](std::size_t i) {
    const AxisPoint at = recorded(i);
    return Sample{at, metric.magnitude(at), i, i};
  };
  if (count == 0 || !window.has(0)) return std::nullopt;
  Sample last = sample(0);
  Reach reach = space.begin(last, Matcher::kWindow);
  Reach ahead;
  double largest = 0;
  for (std::size_t i = 0; !reach.empty();) {
    if (const auto nearest = nearest_of(reach, window, metric, last.at))
      largest = std::max(largest, nearest->in_tolerances);
    window.drop_before(reach.front().piece);
    if (++i == count) break;
    const Sample next = sample(i);
    space.advance(reach, last, next, ahead);
    std::swap(reach, ahead);
    last = next;
  }
  if (reach.empty() || (to_end && !space.at_end(reach))) return std::nullopt;
  return largest;
}

}  // namespace toolcomp::certify

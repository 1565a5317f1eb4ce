#include "certify/trace/causes/follow.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "certify/trace/free_space.h"
#include "certify/trace/matcher.h"
#include "certify/trace/path_window.h"

namespace toolcomp::certify {
namespace {

// Of the nearest of the places that are reached.
double distance(const PathWindow& path, const Metric& metric, const Reach& reach, const AxisPoint& at) {
  double least = std::numeric_limits<double>::infinity();
  for (const Reached& reached : reach) {
    const PathPiece& piece = path[reached.piece].piece;
    if (piece.free) return 0;
    const double t = metric.closest(piece.begin, piece.end, at, {reached.low, reached.high});
    least = std::min(least, metric.in_tolerances(metric.at(piece.begin, piece.end, t, at)));
  }
  return least;
}

}  // namespace

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
    largest = std::max(largest, distance(window, metric, reach, last.at));
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

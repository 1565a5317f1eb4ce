// SPDX-License-Identifier: Apache-2.0
// Which places of the path a recording may have reached: the free-space diagram of Alt and Godau, column by column.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "certify/trace/path_window.h"

namespace toolcomp::certify {

// A recorded position as it is matched.
struct Sample {
  AxisPoint at{};
  double magnitude = 0;
  std::uint64_t number = 0;  // from 0
  std::uint64_t line = 0;    // of the CSV
};

// The places of one piece that are reached, by parameter. Of a move whose inside is not judged: 0 is anywhere inside, 1
// its end.
struct Reached {
  std::size_t piece = 0;
  double low = 0;
  double high = 0;
};
// In the order of the path; those of one piece are one interval.
using Reach = std::vector<Reached>;
inline PathPlace first_of(const Reach& reach) { return {reach.front().piece, reach.front().low}; }
inline PathPlace last_of(const Reach& reach) { return {reach.back().piece, reach.back().high}; }

struct NearestReached {
  PathPlace place;
  Distance distance;
  double in_tolerances = 0;
};
// Where a reach is nearest to a position, in tolerances; nothing inside moves that are not judged.
std::optional<NearestReached> nearest_of(const Reach& reach, const PathWindow& path, const Metric& metric,
                                         const AxisPoint& p);

// A recording and a path are within the tolerance of each other (Fréchet) exactly if both can be run through, never
// backwards, so that what is left behind side by side stays within it. The pairs (place of the recording, place of the
// path) within the tolerance are the free space; between two samples and on one piece it is convex, so that only what
// is reached on the borders of such a cell has to be known: behind each sample one interval of every piece nearby.
//
// The cells of a piece are free within the tolerance and the error of the piece; a place between two pieces within the
// smaller of both, which holds for every recording within the tolerance of the exact path. So such a recording is never
// lost, and one that is followed is within the tolerance and twice the error.
class FreeSpace {
 public:
  FreeSpace(PathWindow& path, const Metric& metric) : path_(path), metric_(metric) {}

  // What a recording that begins at `sample` may have reached: it may begin anywhere on the first move (on the first
  // `most` pieces of it).
  Reach begin(const Sample& sample, std::size_t most);
  // What is reached behind the straight line from `a` to `b`, by what was reached at `a`.
  void advance(const Reach& behind, const Sample& a, const Sample& b, Reach& ahead);
  // Whether the end of the path is among it.
  bool at_end(const Reach& reach) {
    return !reach.empty() && reach.back().high >= 1 && !path_.has(reach.back().piece + 1);
  }

 private:
  [[nodiscard]] std::optional<Part> free_part(std::size_t piece, const Sample& sample) const;
  std::optional<double> beyond(std::size_t piece, const Sample& a, const Sample& b, double least);

  PathWindow& path_;
  const Metric& metric_;
};

}  // namespace toolcomp::certify

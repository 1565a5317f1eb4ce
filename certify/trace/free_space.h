// SPDX-License-Identifier: Apache-2.0
// Finds the places of the path that a recording may have reached, by the free-space diagram of Alt and Godau, column by
// column.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "certify/trace/path_window.h"

namespace toolcomp::certify {

// A recorded position for matching.
struct Sample {
  AxisPoint at{};
  double magnitude = 0;
  std::uint64_t number = 0;  // from 0
  std::uint64_t line = 0;    // of the CSV
};

// The reached places of one piece, by parameter. In a move whose inside is not judged, 0 is anywhere inside, and 1 is
// its end.
struct Reached {
  std::size_t piece = 0;
  double low = 0;
  double high = 0;
};
// In the order of the path. The places of one piece are one interval.
using Reach = std::vector<Reached>;
inline PathPlace first_of(const Reach& reach) { return {reach.front().piece, reach.front().low}; }
inline PathPlace last_of(const Reach& reach) { return {reach.back().piece, reach.back().high}; }

struct NearestReached {
  PathPlace place;
  Distance distance;
  double in_tolerances = 0;
};
// The place of a reach that is nearest to a position, in tolerances; std::nullopt inside moves that are not judged.
std::optional<NearestReached> nearest_of(const Reach& reach, const PathWindow& path, const Metric& metric,
                                         const AxisPoint& p);

// A recording and a path are within the tolerance of each other (Fréchet distance) exactly if both can be run through
// side by side, never backwards, so that their distance always stays within the tolerance. The pairs (place of the
// recording, place of the path) within the tolerance are the free space; between two samples and on one piece it is
// convex, so that only the reached places on the borders of such a cell must be known: after each sample, one interval
// of every piece nearby.
//
// The cells of a piece are free within the tolerance plus the error of the piece; a place between two pieces is free
// within the smaller of both, which is true for every recording within the tolerance of the exact path. So such a
// recording is never lost, and a matched recording is within the tolerance plus twice the error.
class FreeSpace {
 public:
  FreeSpace(PathWindow& path, const Metric& metric) : path_(path), metric_(metric) {}

  // The places that a recording that begins at `sample` may have reached. It may begin anywhere on the first move (on
  // its first `most` pieces).
  Reach begin(const Sample& sample, std::size_t most);
  // The places reached after the straight line from `a` to `b`, from the places reached at `a`.
  void advance(const Reach& behind, const Sample& a, const Sample& b, Reach& ahead);
  // Whether the end of the path is among them.
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

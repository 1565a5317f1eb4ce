// SPDX-License-Identifier: Apache-2.0
#include "certify/trace/free_space.h"

#include <algorithm>

namespace toolcomp::certify {

std::optional<NearestReached> nearest_of(const Reach& reach, const PathWindow& path, const Metric& metric,
                                         const AxisPoint& p) {
  std::optional<NearestReached> best;
  for (const Reached& reached : reach) {
    const PathPiece& piece = path[reached.piece].piece;
    if (piece.free) continue;
    const Part part{reached.low, reached.high};
    if (best && metric.mixed() && metric.at_least(piece.begin, piece.end, p, part) >= best->in_tolerances) continue;
    const double t = metric.closest(piece.begin, piece.end, p, part);
    const Distance distance = metric.at(piece.begin, piece.end, t, p);
    const double in_tolerances = metric.in_tolerances(distance);
    if (!best || in_tolerances < best->in_tolerances) best = {{reached.piece, t}, distance, in_tolerances};
  }
  return best;
}

std::optional<Part> FreeSpace::free_part(std::size_t piece, const Sample& sample) const {
  const PathPiece& p = path_[piece].piece;
  const Limit limit = path_.limit(piece, sample.magnitude);
  if (!p.free) return metric_.part_near(p.begin, p.end, sample.at, limit);
  // Each axis goes from one end to the other in its own time, and never back.
  AxisBox box;
  box.add(p.begin);
  box.add(p.end);
  if (metric_.exceeds(metric_.outside(box, sample.at), limit)) return std::nullopt;
  return Part{0, metric_.exceeds(metric_.between(p.end, sample.at), limit) ? 0.0 : 1.0};
}

// Where on the line from `a` to `b`, not before `least`, the end of the piece can be passed first.
std::optional<double> FreeSpace::beyond(std::size_t piece, const Sample& a, const Sample& b, double least) {
  const AxisPoint corner = path_[piece].piece.end;
  const double magnitude = std::max(a.magnitude, b.magnitude);
  auto part = metric_.part_near(a.at, b.at, corner, path_.limit(piece, magnitude));
  if (!part || part->high < least || !path_.has(piece + 1)) return std::nullopt;
  const Distance& error = path_[piece].piece.error;
  const Distance& next = path_[piece + 1].piece.error;
  if (next.linear < error.linear || next.rotary < error.rotary) {
    const Distance smaller{std::min(error.linear, next.linear), std::min(error.rotary, next.rotary)};
    part = metric_.part_near(a.at, b.at, corner, metric_.limit(smaller, std::max(path_[piece].magnitude, magnitude)));
    if (!part || part->high < least) return std::nullopt;
  }
  return std::max(part->low, least);
}

Reach FreeSpace::begin(const Sample& sample, std::size_t most) {
  Reach reach;
  bool first_move = true;
  for (std::size_t piece = 0; path_.has(piece); ++piece) {
    const auto part = free_part(piece, sample);
    // Behind the first move only what hangs together with it.
    const bool joined = !reach.empty() && reach.back().piece + 1 == piece && reach.back().high >= 1;
    if (part && (first_move || (joined && part->low <= 0))) reach.push_back({piece, part->low, part->high});
    const PathPiece& p = path_[piece].piece;
    if ((p.corner && !p.jump) || piece + 1 == most) first_move = false;
    if (!first_move && (reach.empty() || reach.back().piece != piece || reach.back().high < 1)) break;
  }
  return reach;
}

void FreeSpace::advance(const Reach& behind, const Sample& a, const Sample& b, Reach& ahead) {
  ahead.clear();
  auto left = behind.begin();
  // Where on the line from a to b the begin of the piece is reached first.
  std::optional<double> bottom;
  for (std::size_t piece = 0;; ++piece) {
    if (!bottom) {
      if (left == behind.end()) return;
      piece = left->piece;
    }
    const bool from_left = left != behind.end() && left->piece == piece;
    if (const auto part = free_part(piece, b)) {
      const double low = bottom || path_[piece].piece.free ? part->low : std::max(part->low, left->low);
      if (low <= part->high) ahead.push_back({piece, low, part->high});
    }
    bottom = beyond(piece, a, b, from_left ? 0 : *bottom);
    if (from_left) ++left;
  }
}

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
#include "certify/trace/deviations.h"

#include <algorithm>
#include <cmath>

namespace toolcomp::certify {
namespace {

void widen(Distance& largest, const Distance& d) {
  largest.linear = std::max(largest.linear, d.linear);
  largest.rotary = std::max(largest.rotary, d.rotary);
}

}  // namespace

void Deviations::take(const AxisPoint& recorded, const PlaceOnPath& place) {
  const bool kept = keeps_next();
  ++taken_;
  if (kept) {
    points_.push_back({recorded, place.exact, place.kind});
    if (points_.size() == kMostPoints) {
      for (std::size_t i = 0; i < kMostPoints / 2; ++i) points_[i] = points_[2 * i];
      points_.resize(kMostPoints / 2);
      stride_ *= 2;
    }
  }
  if (place.kind == SampleKind::not_judged) {
    ++not_judged_;
    return;
  }
  if (place.kind == SampleKind::off) {
    ++off_;
    if (!moves_.empty()) moves_.back().off = true;
    return;
  }
  const double bin = in_tolerances(place.distance, tolerance_) * kBins;
  ++histogram_.at(static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(kBins - 1))));
  take_move(place);
}

void Deviations::take_move(const PlaceOnPath& place) {
  if (moves_.empty() || place.line != last_line_) {
    last_line_ = place.line;
    if (moves_.empty() || in_last_ == moves_of_one_) {
      moves_.push_back({place.line, place.n, {}, false});
      in_last_ = 0;
    }
    ++in_last_;
  }
  widen(moves_.back().largest, place.distance);
  if (moves_.size() < kMostMoves) return;
  for (std::size_t i = 0; i < kMostMoves / 2; ++i) {
    Move both = moves_[2 * i];
    widen(both.largest, moves_[2 * i + 1].largest);
    both.off = both.off || moves_[2 * i + 1].off;
    moves_[i] = both;
  }
  moves_.resize(kMostMoves / 2);
  in_last_ += moves_of_one_;
  moves_of_one_ *= 2;
}

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
#include "certify/trace/chords.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toolcomp::certify {
namespace {

using exact::Rational;

// A part is taken at once into as many chords of one bound, or it is halved.
constexpr double kMostChords = 16;
// By then a part is about as long as the ulp of its place: doubles bound it no better. What leaves the edge of reach is
// then somewhat wider than asked for.
constexpr int kMostHalvings = 50;
constexpr double kWider = 16;

// How many equal chords of a part are near enough by one kind of axes. Their sagitta goes with the square of their
// length.
double chords_for(double sagitta, double extent, double most) {
  return extent <= most ? 1 : std::max(1.0, std::ceil(std::sqrt(sagitta / most)));
}

// And how near they are.
double error_of(double sagitta, double extent, double chords) {
  if (sagitta == 0) return 0;
  return std::min(std::nextafter(sagitta / (chords * chords), std::numeric_limits<double>::infinity()), extent);
}

}  // namespace

std::optional<Chords::Chord> Chords::next() {
  if (left_ == 0 && !divide()) return std::nullopt;
  at_ += length_;
  --left_;
  return Chord{at_, error_, left_ == 0 && parts_.empty()};
}

bool Chords::divide() {
  for (;;) {
    const Part part = std::move(parts_.back());
    parts_.pop_back();
    const auto [sagitta, extent] = bound_.part(part.from, part.to);
    const double chords = std::max(chords_for(sagitta.linear, extent.linear, most_.linear),
                                   chords_for(sagitta.rotary, extent.rotary, most_.rotary));
    if (chords <= kMostChords) {
      at_ = part.from;
      left_ = static_cast<std::uint64_t>(chords);
      length_ = (part.to - part.from) / left_;
      error_ = {error_of(sagitta.linear, extent.linear, chords), error_of(sagitta.rotary, extent.rotary, chords)};
      return true;
    }
    if (part.halvings == kMostHalvings) {
      if (extent.linear > kWider * most_.linear || extent.rotary > kWider * most_.rotary) return false;
      at_ = part.from;
      left_ = 1;
      length_ = part.to - part.from;
      error_ = extent;
      return true;
    }
    const Rational middle = (part.from + part.to) / 2;
    parts_.push_back({middle, part.to, part.halvings + 1});
    parts_.push_back({part.from, middle, part.halvings + 1});
  }
}

}  // namespace toolcomp::certify

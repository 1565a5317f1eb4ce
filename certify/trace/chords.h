// SPDX-License-Identifier: Apache-2.0
// Divides a curve into chords, one after the other.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "certify/trace/curve_bound.h"

namespace toolcomp::certify {

// From t = 0 to 1. Where the curve bends strongly the chords are short. Of the rest of the curve only the parts still
// to be divided are kept.
class Chords {
 public:
  // `most`: the largest error of a chord. At the limit of double precision, at the edge of reach, an error may be a few
  // times larger.
  Chords(CurveBound bound, Distance most) : bound_(std::move(bound)), most_(most), parts_{{0, 1, 0}} {}

  struct Chord {
    exact::Rational end;  // t
    Distance error;
    bool last = false;
  };
  // The next chord. Call it until the last one. std::nullopt if no bound is found, however short the chords are.
  std::optional<Chord> next();

  [[nodiscard]] const CurveBound& bound() const { return bound_; }

 private:
  bool divide();

  struct Part {
    exact::Rational from;
    exact::Rational to;
    int halvings = 0;
  };
  CurveBound bound_;
  Distance most_;
  std::vector<Part> parts_;  // the next one last
  // The part in use.
  exact::Rational at_;
  exact::Rational length_;  // of a chord
  std::uint64_t left_ = 0;  // chords
  Distance error_;
};

}  // namespace toolcomp::certify

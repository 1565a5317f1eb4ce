// SPDX-License-Identifier: Apache-2.0
// A place at which a recording and the path differ, and the findings about it.
#pragma once

#include <cstdint>

#include "certify/trace/findings.h"
#include "certify/trace/path_window.h"
#include "certify/trace/run.h"

namespace toolcomp::certify {

// A match that was lost after one sample and found again at another, or at the same sample further along the path.
struct LostMatch {
  bool begin = false;  // nothing was matched before: `from` is the first sample
  bool end = false;    // nothing is matched afterwards: `to` is the last sample, and the rest of the path is left out
  bool cut = false;    // it goes on; reported as far as it is known
  bool continued = false;  // it went on after a cut
  std::uint64_t from = 0;  // number of the last sample matched
  std::uint64_t to = 0;    // number of the first sample matched again
  std::uint64_t line = 0;  // line of the CSV at which it was noticed
  // The recording left the path between the first two places, and came back between the other two. All places between
  // them are equally good.
  PathPlace left_low, left_high;
  PathPlace back_low, back_high;
  double cost = 0;  // in tolerances
};

// The data for judging a fault. The path and the run contain everything in between.
struct FaultScene {
  PathWindow& path;
  const Run& run;
  const Metric& metric;
  const spec::Axes& axes;
};

// The largest distance of one side from the other. The nearest place is the one nearest in tolerances over all axes.
// Linear axes alone, or rotary axes alone, may be nearer at another place.
struct Farthest {
  double lower = 0;                   // in tolerances, from the straight lines that approximate both sides
  double upper = 0;                   // the same, as far as the search went
  AxisPoint at{};                     // where
  AxisPoint other{};                  // the nearest place of the other side
  Distance alone;                     // the largest distance of each kind of axes, each with its own nearest places
  Distance most;                      // the largest distance of each kind of axes at the common nearest places
  Distance error;                     // largest error of the straight lines
  std::uint64_t csv_line = 0;         // if `at` is a sample
  std::optional<std::size_t> turned;  // the rotary axis of `most.rotary`

  // Takes a place `p` and the nearest place of the other side; `line` is the line of the CSV if `p` is a sample.
  void take(const AxisPoint& p, const AxisPoint& nearest, const Distance& lines_off, const Metric& metric,
            std::uint64_t line = 0);
  // Takes the result for another part of the same side.
  void take(const Farthest& part);
};

// A move of the program.
struct MoveName {
  std::uint64_t line = 0;
  std::optional<std::uint64_t> n;
};

// The samples in between, and their distance from the part of the path at which the recording left and came back.
struct SamplesOff {
  bool any = false;            // whether there are samples in between
  std::uint64_t count = 0;     // beyond the tolerance
  std::uint64_t csv_line = 0;  // of the first of them
  MoveName move;               // nearest to it
  bool on_other_path = true;   // each of them is near another part of the path
  Farthest farthest;
};
SamplesOff samples_off(const LostMatch& fault, const FaultScene& scene);

// The path in between, and its distance from the recording.
struct PathLeftOut {
  const char* kind = nullptr;  // nullptr: everything is within the tolerance
  bool is_gap = false;         // all corners were reached, and the recording left a move and came back to it
  std::uint64_t corners = 0;   // not reached
  double length = 0;           // linear axes, setup units
  MoveName first, last;        // moves concerned
  Farthest farthest;
};
PathLeftOut path_left_out(const LostMatch& fault, const FaultScene& scene);

// Adds one finding for the samples that are off the path, and one for the part of the path that was left out, if that
// part is farther from the recording than the recording is from the path.
void report(const LostMatch& fault, const FaultScene& scene, TraceResult& result, Findings& findings);

}  // namespace toolcomp::certify

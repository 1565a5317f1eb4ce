// SPDX-License-Identifier: Apache-2.0
// Where a recording and the path part, and what is said of it.
#pragma once

#include <cstdint>

#include "certify/trace/findings.h"
#include "certify/trace/path_window.h"
#include "certify/trace/run.h"

namespace toolcomp::certify {

// A match was lost behind one sample and found again at another, or at the same one further on.
struct LostMatch {
  bool begin = false;      // nothing was matched before: `from` is the first sample
  bool end = false;        // nothing is matched behind: `to` is the last sample, and the rest of the path is left
  bool cut = false;        // it goes on: told as far as it is known
  bool continued = false;  // it went on after a cut
  std::uint64_t from = 0;  // number of the last sample matched
  std::uint64_t to = 0;    // number of the first one matched again
  std::uint64_t line = 0;  // of the CSV: where it was noticed
  // The recording left the path between these places, for nearer ones are just as good, and came back between those.
  PathPlace left_low, left_high;
  PathPlace back_low, back_high;
  double cost = 0;  // in tolerances
};

// What a fault is judged by: the path and the run hold all that lies between.
struct FaultScene {
  PathWindow& path;
  const Run& run;
  const Metric& metric;
  const spec::Axes& axes;
};

// The farthest that one side is from the other. The nearest place is the one nearest in tolerances, all axes together;
// the linear axes by themselves, and the rotary ones, may be nearer elsewhere.
struct Farthest {
  double lower = 0;                   // in tolerances; by the straight lines that stand for both sides
  double upper = 0;                   // the same, as far as it was searched
  AxisPoint at{};                     // where
  AxisPoint other{};                  // the nearest place of the other side
  Distance alone;                     // the farthest that each kind of axes is, wherever the other one is nearest
  Distance most;                      // the farthest that each is at the nearest places
  Distance error;                     // how far the straight lines may be off
  std::uint64_t csv_line = 0;         // where `at` is a sample
  std::optional<std::size_t> turned;  // the rotary axis of `most.rotary`

  // A place `p` and the nearest one of the other side; `line` of the CSV if `p` is a sample.
  void take(const AxisPoint& p, const AxisPoint& nearest, const Distance& lines_off, const Metric& metric,
            std::uint64_t line = 0);
  // The same as found for another part of the same side.
  void take(const Farthest& part);
};

// A move of the program.
struct MoveName {
  std::uint64_t line = 0;
  std::optional<std::uint64_t> n;
};

// The samples between, and how far they are from the path that was left and come back to.
struct SamplesOff {
  bool any = false;            // samples lie between at all
  std::uint64_t count = 0;     // beyond the tolerance
  std::uint64_t csv_line = 0;  // of the first of them
  MoveName move;               // nearest to it
  bool on_other_path = true;   // each of them is near another part of the path
  Farthest farthest;
};
SamplesOff samples_off(const LostMatch& fault, const FaultScene& scene);

// The path between, and how far it is from the recording there.
struct PathLeftOut {
  const char* kind = nullptr;  // nullptr: nothing is beyond the tolerance
  bool is_gap = false;         // all corners were reached, and a move was left and come back to
  std::uint64_t corners = 0;   // not reached
  double length = 0;           // linear axes, setup units
  MoveName first, last;        // moves concerned
  Farthest farthest;
};
PathLeftOut path_left_out(const LostMatch& fault, const FaultScene& scene);

// Adds one finding of the samples that lie off the path, and one of the path left out if that is farther from the
// recording than the recording is from the path.
void report(const LostMatch& fault, const FaultScene& scene, TraceResult& result, Findings& findings);

}  // namespace toolcomp::certify

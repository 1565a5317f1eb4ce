// SPDX-License-Identifier: Apache-2.0
// What the state machine makes of a block that moves.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>

#include "fast/geometry/displacement.h"
#include "fast/heidenhain/program/alarm.h"
#include "fast/heidenhain/program/effective_tool.h"
#include "fast/heidenhain/program/tool_vector.h"
#include "spec/language/axes.h"

namespace toolcomp::fast::klartext {

// What every event tells of its block.
struct BlockHead {
  std::uint64_t line = 0;
  std::optional<std::uint64_t> n;
};

// The programmed end point and what else the event of a move repeats.
struct MoveHead : BlockHead {
  bool rapid = false;
  bool cancels = false;                           // the first moving block behind RL or RR
  Warnings warnings = 0;                          // found in the block
  std::uint16_t rotary = 0;                       // bit by axis: a rotary axis with a word in this block
  std::optional<double> feed;                     // in force
  Vector xyz{0, 0, 0};                            // programmed
  std::uint16_t more_axes = 0;                    // bit by axis: with a value, but for X, Y, Z
  std::uint16_t unknown = 0;                      // bit by axis: nobody knows where it stands; of no block that is held
  std::array<double, spec::kMaxAxes> position{};  // programmed, by axis, but for X, Y, Z

  // Only what counts, part by part.
  void copy(const MoveHead& other) {
    line = other.line;
    n = other.n;
    rapid = other.rapid;
    cancels = other.cancels;
    warnings = other.warnings;
    rotary = other.rotary;
    feed = other.feed;
    xyz = other.xyz;
    more_axes = other.more_axes;
    for (unsigned rest = more_axes; rest != 0; rest &= rest - 1) {
      const auto axis = static_cast<std::size_t>(std::countr_zero(rest));
      position[axis] = other.position[axis];
    }
  }
};

// A block under RL or RR, held until the next motion is known.
struct PeripheralMotion {
  MoveHead head;
  ToolVector tool;
  Displacement travel;
  int side = 1;          // RL 1, RR −1
  double tip_below = 0;  // programmed_contour.h
  double lateral = 0;    // the distance of the tip from the programmed point: delta
  double radius_delta = 0;
  double effective_corner = 0;
  ToolLength length;
};

}  // namespace toolcomp::fast::klartext

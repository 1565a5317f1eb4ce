// SPDX-License-Identifier: Apache-2.0
// The paths of a run in X, Y and Z as chords, for pictures.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "spec/language/event.h"
#include "spec/language/setup.h"

namespace toolcomp::certify {

using Point3 = std::array<double, 3>;

// One move: its points after the end of the move before (several for an arc, and if samples show the way of the axes).
struct PathMove {
  std::vector<Point3> points;
  bool rapid = false;
  std::size_t event = 0;  // index of its event
};

// From `start` through the moves, in order.
struct Path {
  Point3 start{};
  std::vector<PathMove> moves;
};
// Whether both go through the same points.
bool same_course(const Path& a, const Path& b);

// The position of the events that the path follows.
enum class PathOf : std::uint8_t { programmed, point, axes };

// The path of the moves that have such a position. A move with a coordinate that is not finite is left out.
Path follow(const spec::Axes& axes, const Point3& start, std::span<const spec::Event<double>> events, PathOf what);

// The tool at one place of its path: at a sample, or at the end of a move.
struct ToolStroke {
  Point3 tip{};   // `point` of the event
  Point3 axis{};  // unit, from the tip to the holder
  std::size_t event = 0;
  bool rapid = false;   // of the move; not known for a sample
  bool sample = false;  // inside a move
};
// The strokes of all events with a tool axis, in order.
std::vector<ToolStroke> tool_strokes(const spec::Axes& axes, const Point3& start,
                                     std::span<const spec::Event<double>> events);

// The start position of a setup in X, Y and Z.
Point3 start_of(const spec::Setup& setup);

}  // namespace toolcomp::certify

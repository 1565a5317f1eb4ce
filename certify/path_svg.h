// SPDX-License-Identifier: Apache-2.0
// A picture of a run: the programmed and the compensated path, seen from above, from the side, from a corner and along
// the tool.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "certify/contact_svg.h"
#include "certify/path.h"
#include "spec/language/axes.h"
#include "spec/language/case.h"
#include "spec/language/event.h"
#include "spec/language/setup.h"

namespace toolcomp::certify {

// What is drawn in addition to the programmed path, the tool point and the axes of the events.
struct PathOptions {
  Point3 start{};  // where the path begins
  std::string unit = "mm";
  std::span<const spec::Event<double>> other;  // the events of a controller for the same program, drawn on top
  std::string other_name = "controller";
  std::optional<std::size_t> marked;  // index in `events` of the move at which they first differ
  std::optional<CutterShape> tool;    // the first of a tool table, mm
};

// One self-contained SVG with a panel for XY and a panel for XZ. If the path leaves a plane or the tool leans, there is
// an axonometric panel too, with tool axes and compensation vectors at intervals, inside moves at their samples. If a
// leaning tool runs next to its programmed line, one more panel shows a place seen along the tool (path_detail.h).
// Paths that coincide are drawn once. Lengths in setup units; arcs are drawn as chords of at most five degrees. Axes
// that the setup does not have count as 0.
std::string path_svg(std::span<const spec::Event<double>> events, const spec::Axes& axes,
                     const PathOptions& options = {});

// The options that follow from a setup or a case: the start, the first tool of the table, and the unit.
PathOptions path_options(const spec::Setup& setup);
PathOptions path_options(const spec::Case& c);

}  // namespace toolcomp::certify

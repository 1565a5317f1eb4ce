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

// What is drawn besides the programmed path, the tool point and the axes of the events.
struct PathOptions {
  Point3 start{};  // where the path begins
  std::string unit = "mm";
  std::span<const spec::Event<double>> other;  // what a controller made of the same program, drawn on top
  std::string other_name = "controller";
  std::optional<std::size_t> marked;  // index in `events` of the move where they part
  std::optional<CutterShape> tool;    // the first of a tool table, mm
};

// One self-contained SVG: a panel each for XY and XZ, and an axonometric one where the path leaves a plane or the tool
// leans; there with tool axes and compensation vectors at intervals, inside moves at their samples. Where a leaning
// tool runs beside its programmed line one more panel shows a place seen along it (path_detail.h). Paths that coincide
// are drawn once. Lengths in setup units; arcs are drawn as chords of at most five degrees. Axes that the setup does
// not have count as 0.
std::string path_svg(std::span<const spec::Event<double>> events, const spec::Axes& axes,
                     const PathOptions& options = {});

// The start of a setup, the first tool of its table, and the unit: that of the setup, or what a program says.
PathOptions path_options(const spec::Setup& setup);
PathOptions path_options(const spec::Case& c);

}  // namespace toolcomp::certify

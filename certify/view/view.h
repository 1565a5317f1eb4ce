// SPDX-License-Identifier: Apache-2.0
// A run for the interactive view in space, block by block: its picture, and the data of the view (README.md).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "certify/path.h"
#include "certify/path_svg.h"
#include "certify/view/program_data.h"
#include "model/basis/event.h"
#include "spec/language/case.h"
#include "spec/language/event.h"

namespace toolcomp::certify {

// An exact run: its events in double precision, and the clauses that each of them rests on.
struct ViewRun {
  std::vector<spec::Event<double>> events;
  std::vector<spec::ClauseList> clauses;
};
ViewRun view_run(const std::vector<model::Event>& events);
// The events of a run of `c`, with the clauses that the model marks, as far as the model gives the same events again.
ViewRun view_run(const spec::Case& c, std::vector<spec::Event<double>> events);

// A recorded position, and its place on the exact path, if that is known.
struct ViewSample {
  Point3 at{};
  Point3 exact{};
  bool off = false;  // not followed there
};

// What is shown in addition to the run.
struct ViewOptions {
  PathOptions path;                      // start, unit, the controller's events, the marked event
  std::vector<ViewSample> recorded;      // of a recording
  const ProgramView* program = nullptr;  // for a program's page, with its blocks next to the drawing
};

// HTML: the picture, and over it the interactive view, if the browser can show it. `title` is text, `picture` is SVG.
std::string view(std::string_view title, const spec::Case& c, const ViewRun& run, const ViewOptions& options,
                 std::string_view picture);

// Whether a body of HTML contains a view. Its page then needs the assets (assets.h).
bool has_view(std::string_view body);

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
// A run as a page shows it in space, block by block: its picture, and beside it the data of the interactive view
// (README.md).
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

// An exact run: its events to double precision, and the clauses behind each of them.
struct ViewRun {
  std::vector<spec::Event<double>> events;
  std::vector<spec::ClauseList> clauses;
};
ViewRun view_run(const std::vector<model::Event>& events);
// Events of a run of `c`, with the clauses that the model marks as far as it gives the same ones again.
ViewRun view_run(const spec::Case& c, std::vector<spec::Event<double>> events);

// A recorded position, and its place on the exact path where that is known.
struct ViewSample {
  Point3 at{};
  Point3 exact{};
  bool off = false;  // not followed there
};

// What is shown besides the run.
struct ViewOptions {
  PathOptions path;                      // start, unit, the controller's events, the marked event
  std::vector<ViewSample> recorded;      // of a recording
  const ProgramView* program = nullptr;  // of a program's page: its blocks stand beside the drawing
};

// HTML: the picture, over it, where a browser can, the view. `title` is text, `picture` SVG.
std::string view(std::string_view title, const spec::Case& c, const ViewRun& run, const ViewOptions& options,
                 std::string_view picture);

// Whether a body of HTML holds a view: its page needs the assets (assets.h).
bool has_view(std::string_view body);

}  // namespace toolcomp::certify

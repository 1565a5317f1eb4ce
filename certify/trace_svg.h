// SPDX-License-Identifier: Apache-2.0
// Pictures of a judged recording.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "certify/trace/trace.h"
#include "certify/view/view.h"
#include "spec/language/axes.h"

namespace toolcomp::certify {

// The exact path and the recording over it, with enlarged deviations and marked findings: SVGs for a page, seen from
// above, from the side and, if the path leaves a plane, from a corner. Empty if no linear axis was recorded.
std::string trace_svg(const TraceResult& result, const spec::Axes& axes, std::string_view unit);

// The recording as a view in space shows it.
std::vector<ViewSample> view_samples(const TraceResult& result, const spec::Axes& axes);

// Two charts: the distance of the recording from the path for each move, and the number of samples by distance.
std::string deviation_svg(const TraceResult& result, const TraceOptions& options, std::string_view unit);

}  // namespace toolcomp::certify

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

// The exact path and the recording over it, its deviations drawn larger than they are, findings marked:
// SVGs to stand in a page, seen from above, from the side and, where the path leaves a plane, from a corner. Empty
// where no linear axis was recorded.
std::string trace_svg(const TraceResult& result, const spec::Axes& axes, std::string_view unit);

// The recording as a view in space shows it.
std::vector<ViewSample> view_samples(const TraceResult& result, const spec::Axes& axes);

// How far the recording is from the path, move by move, and how many samples are how far off: two charts.
std::string deviation_svg(const TraceResult& result, const TraceOptions& options, std::string_view unit);

}  // namespace toolcomp::certify

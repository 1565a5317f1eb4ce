// SPDX-License-Identifier: Apache-2.0
// Only decides whether a recording is within the tolerance of a path.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "certify/trace/metric.h"
#include "certify/trace/path.h"

namespace toolcomp::certify {

// The position of a sample, by its number.
using Recorded = std::function<AxisPoint(std::size_t)>;

// The largest distance, in tolerances, of the samples [0, count) from the places of the path at which they may be;
// std::nullopt if the recording is not within the tolerance (free_space.h). `to_end`: the samples must lead to the end
// of the path.
std::optional<double> followed(PathSource& path, const Metric& metric, std::size_t count, bool to_end,
                               const Recorded& recorded);

}  // namespace toolcomp::certify

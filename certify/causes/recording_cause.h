// SPDX-License-Identifier: Apache-2.0
// Looks for one mistake that explains everything found in a recording, if it was made throughout.
#pragma once

#include <optional>
#include <string>

#include "certify/trace/metric.h"
#include "certify/trace/program_path.h"
#include "certify/trace/samples.h"
#include "certify/trace/trace.h"
#include "spec/language/case.h"

namespace toolcomp::certify {

// The mistake with which the recording follows the program within the tolerance: "axes X and Y are exchanged". It
// tries, in this order, the mistakes of mistakes.h, tool center point control that is not in force, axes that are
// exchanged, reversed, shifted, scaled or late, and single numbers that are off. `run` is the whole recording, `found`
// has the findings. std::nullopt if none of them explains everything. The result is a hint: another mistake may look
// the same.
std::optional<std::string> common_cause(const spec::Case& c, const RecordedRun& run, const Metric& metric,
                                        const ProgramPathOptions& options, const TraceResult& found);

}  // namespace toolcomp::certify

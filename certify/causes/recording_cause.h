// SPDX-License-Identifier: Apache-2.0
// What one mistake, if it was made all along, explains everything that was found in a recording.
#pragma once

#include <optional>
#include <string>

#include "certify/trace/metric.h"
#include "certify/trace/program_path.h"
#include "certify/trace/samples.h"
#include "certify/trace/trace.h"
#include "spec/language/case.h"

namespace toolcomp::certify {

// The mistake with which the recording is what the program asks for, within the tolerance: "axes X and Y are
// exchanged". Tried are, in this order, the mistakes of mistakes.h, tool center point control that is not in force,
// axes exchanged, reversed, shifted, scaled, late, and single numbers that are off. `run`: the whole recording;
// `found`: the findings. Nothing where none of them explains all. What is named is a hint: another mistake may look the
// same.
std::optional<std::string> common_cause(const spec::Case& c, const RecordedRun& run, const Metric& metric,
                                        const ProgramPathOptions& options, const TraceResult& found);

}  // namespace toolcomp::certify

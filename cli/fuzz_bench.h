// SPDX-License-Identifier: Apache-2.0
// Where the workers of `toolcomp fuzz` find what they need.
#pragma once

#include "certify/fuzzing/worker.h"
#include "cli/verbs.h"

namespace toolcomp::cli {

// This program, the targets beside it (of build/release they lie in build/fuzz) unless the options say otherwise, and
// the seeds of the source tree.
certify::fuzzing::Bench fuzz_bench(const FuzzOptions& options);

}  // namespace toolcomp::cli

// SPDX-License-Identifier: Apache-2.0
// Examines what a worker saw: turns "something differed" into a finding that can be repeated.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>

#include "certify/fuzzing/dossier.h"

namespace toolcomp::certify::fuzzing {

struct SettleOptions {
  std::chrono::milliseconds timeout{10'000};  // for one answer of a controller
  std::size_t shrink_runs = 2000;
  std::function<bool()> stop;
};

// Judges the sighting again with the subject that it names, and shrinks it. The same input gives the same dossier. A
// sighting that is not reproduced, or cannot be judged, stays as it was seen, and the dossier says so. Crashes and
// hangs are reproduced in a separate process.
Dossier settle(const Finding& seen, const SettleOptions& options);

// Whether even the simplest move fails. Then every program fails.
bool fails_everywhere(const Dossier& dossier);

// The file of one sighting in `file`: a finding (.json), or an input of a target as libFuzzer names it: crash-…,
// timeout-…, oom-…; of a reader any name. `target` is a fuzz target by name. Throws spec::InputError.
Finding read_sighting(const std::filesystem::path& file, const std::string& target);

}  // namespace toolcomp::certify::fuzzing

// SPDX-License-Identifier: Apache-2.0
// What a worker saw, looked at again: from "something differed" to a finding that anybody can repeat.
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

// Judged again with the subject it names and shrunk; the same input gives the same dossier. What does not come again,
// or cannot be judged, stays as it was seen, and the dossier says so. A crash and a hang are looked for in a process of
// their own.
Dossier settle(const Finding& seen, const SettleOptions& options);

// Whether already the plainest move fails: then every program does.
bool fails_everywhere(const Dossier& dossier);

// The file of one sighting in `file`: a finding (.json), or an input of a target as libFuzzer names it: crash-…,
// timeout-…, oom-…; of a reader anything. `target` is a fuzz target by name. Throws spec::InputError.
Finding read_sighting(const std::filesystem::path& file, const std::string& target);

}  // namespace toolcomp::certify::fuzzing

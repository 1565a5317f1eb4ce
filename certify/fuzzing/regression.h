// SPDX-License-Identifier: Apache-2.0
// Findings that were fixed: corpus/regression.
#pragma once

#include <filesystem>
#include <vector>

#include "spec/language/case.h"

namespace toolcomp::certify::fuzzing {

// The cases of a folder of findings and cases (*.json), by file name. Throws spec::InputError for a file that is
// neither.
std::vector<spec::Case> regression_cases(const std::filesystem::path& folder);

// Writes these cases as first inputs of both targets of their sections, below `inputs` in the folders of Target::seeds.
void write_regression_inputs(const std::filesystem::path& folder, const std::filesystem::path& inputs);

}  // namespace toolcomp::certify::fuzzing

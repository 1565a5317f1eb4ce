// SPDX-License-Identifier: Apache-2.0
// Several campaigns as one.
#pragma once

#include <filesystem>
#include <vector>

namespace toolcomp::certify::fuzzing {

// Corpora, findings, sightings and counters of the folders in a new one; of a finding that several have, the smallest.
// The same bytes in whatever order they are named. Throws spec::InputError for a folder that holds no campaign, one at
// work, or a new one that is not empty.
void merge_campaigns(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& merged);

}  // namespace toolcomp::certify::fuzzing

// SPDX-License-Identifier: Apache-2.0
// Merges several campaigns into one.
#pragma once

#include <filesystem>
#include <vector>

namespace toolcomp::certify::fuzzing {

// Puts corpora, findings, sightings and counters of the folders into a new folder. If several have the same finding,
// the smallest is kept. The order of the folders does not matter. Throws spec::InputError for a folder without a
// campaign, for a running campaign, and for a new folder that is not empty.
void merge_campaigns(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& merged);

}  // namespace toolcomp::certify::fuzzing

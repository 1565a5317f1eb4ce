// SPDX-License-Identifier: Apache-2.0
// What a campaign has found, as its folder holds it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "certify/fuzzing/families.h"

namespace toolcomp::certify::fuzzing {

// A finding is a family of ways in which it shows, each with a dossier.
struct Found {
  std::vector<std::filesystem::path> dossiers;  // by name
  std::vector<std::string> what;                // each says
  std::vector<std::string> voices;              // and who stands alone there; empty: not asked
  std::vector<Family> findings;
};
// Of the folder of findings.
Found found_in(const std::filesystem::path& folder);

// "3 findings", and in how many ways where these are more.
std::string findings_text(std::size_t findings, std::size_t ways);

}  // namespace toolcomp::certify::fuzzing

// SPDX-License-Identifier: Apache-2.0
// The findings of a campaign, as they are in its folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "certify/fuzzing/dossier.h"
#include "certify/fuzzing/families.h"
#include "certify/fuzzing/folder.h"

namespace toolcomp::certify::fuzzing {

// A dossier.
struct Shown {
  std::string name;              // name under which state.json counts its cases
  std::filesystem::path folder;  // where it is; empty if it is not kept
  Story story;
};

// A finding is a family of ways in which it shows, each with a dossier.
struct Found {
  std::vector<Shown> ways;
  std::vector<Family> findings;  // of ways
  std::vector<Shown> open;       // cases that could not be decided
};
Found found_in(const Folder& folder);

// Copies the first way of each finding, and the open cases, to a folder. They keep their names; if another case has the
// name, they get the next free one, so that nothing there is overwritten. If a way of a finding is already there, this
// way becomes the first one. Returns the findings with their new places; the other ways have no place.
Found copy_out(Found found, const std::filesystem::path& to);

// "3 findings", with the number of ways if there are more ways than findings.
std::string findings_text(std::size_t findings, std::size_t ways);

}  // namespace toolcomp::certify::fuzzing

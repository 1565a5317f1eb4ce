// SPDX-License-Identifier: Apache-2.0
// What a campaign has found, as its folder holds it.
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
  std::string name;              // by which state.json counts its cases
  std::filesystem::path folder;  // where it is; empty: nowhere that stays
  Story story;
};

// A finding is a family of ways in which it shows, each with a dossier.
struct Found {
  std::vector<Shown> ways;
  std::vector<Family> findings;  // of ways
  std::vector<Shown> open;       // cases that could not be decided
};
Found found_in(const Folder& folder);

// Copies the first way of each finding, and what is open, to a folder, under their names or, where another case has
// one, the next that is free: nothing there is written over. Of a finding of which a way is there already that one
// becomes the first. What is found, as it is there: the other ways are nowhere.
Found copy_out(Found found, const std::filesystem::path& to);

// "3 findings", and in how many ways where these are more.
std::string findings_text(std::size_t findings, std::size_t ways);

}  // namespace toolcomp::certify::fuzzing

// SPDX-License-Identifier: Apache-2.0
// Reads a bundle, and checks its structure and checksums.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "certify/bundle/manifest.h"
#include "certify/bundle/spool.h"

namespace toolcomp::certify::bundle {

struct Bundle {
  explicit Bundle(const std::filesystem::path& folder) : cases(folder), answers(folder), results(folder) {}

  Manifest manifest;
  std::map<std::string, std::string> files;  // by name: all except the three below, index.html and the inputs
  Spool cases, answers, results;             // to be read
};

// Reads a bundle: the seal, the members that the manifest names and no others, each once, with size and digest. Memory
// and disk are bounded: 512 MiB for what is kept in memory, 16 GiB in total. Throws Refused for a bundle that was
// changed, spec::InputError for a file that is not a bundle or cannot be read.
Bundle read_bundle(const std::filesystem::path& file);

}  // namespace toolcomp::certify::bundle

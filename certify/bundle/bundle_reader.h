// SPDX-License-Identifier: Apache-2.0
// A bundle whose structure and checksums are right.
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
  std::map<std::string, std::string> files;  // by name: all but the three below, index.html and the inputs
  Spool cases, answers, results;             // to be read
};

// Reads a bundle: the seal, the members that the manifest names and no others, each once, with size and digest. Memory
// and disk are bounded: 512 MiB for what is kept in memory, 16 GiB for all. Throws Refused for a bundle that is
// not as it was made, spec::InputError for what is no bundle or cannot be read.
Bundle read_bundle(const std::filesystem::path& file);

}  // namespace toolcomp::certify::bundle

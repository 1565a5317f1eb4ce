// SPDX-License-Identifier: Apache-2.0
// Whether a certificate is what its evidence says.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "certify/bundle/manifest.h"

namespace toolcomp::certify::bundle {

struct VerifyOptions {
  std::filesystem::path file;
  std::filesystem::path corpus;  // folder of the golden corpus
  std::size_t sample = 100;      // so many of the cases that were asked are judged again
  std::uint64_t seed = 1;        // of their choice
  bool all = false;              // all of them; generated cases are made again, too
  // Called with the cases judged again and their number.
  std::function<void(std::uint64_t, std::uint64_t)> progress;
};

struct Verification {
  std::vector<std::string> refused;  // why, the first twenty; none: accepted
  Manifest manifest;
  std::string controller;  // name and version, as it said; empty: it could not be asked
  std::string verdict;     // of the certificate
  std::string corpus;      // its version; "none"
  std::uint64_t asked = 0;
  std::uint64_t judged_again = 0;
  std::string signature;  // who signed it; empty: nobody
};

// Checks in this order: seal, members and digests; the signature beside it, if there is one; clauses and corpus, which
// have to be those of this program; that the cases are those that were asked for, each with an answer; that the
// certificate is the sum of what is recorded; then judges recorded answers again, by the code that judged them first,
// and each must come out as recorded. Throws spec::InputError for what is no bundle, or cannot be read, and for a
// folder that is no corpus.
Verification verify(const VerifyOptions& options);

}  // namespace toolcomp::certify::bundle

// SPDX-License-Identifier: Apache-2.0
// Checks whether a certificate agrees with its evidence.
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
  std::size_t sample = 100;      // number of asked cases that are judged again
  std::uint64_t seed = 1;        // of the choice of these cases
  bool all = false;              // judge all cases again, and generate generated cases again
  // Called with the number of cases judged again so far, and in total.
  std::function<void(std::uint64_t, std::uint64_t)> progress;
};

struct Verification {
  std::vector<std::string> refused;  // the first twenty reasons; empty: accepted
  Manifest manifest;
  std::string controller;  // announced name and version; empty if it could not be asked
  std::string verdict;     // of the certificate
  std::string corpus;      // its version; "none"
  std::uint64_t asked = 0;
  std::uint64_t judged_again = 0;
  std::string signature;  // who signed it; empty if it is not signed
};

// Checks in this order: seal, members and digests; the signature next to the bundle, if there is one; clauses and
// corpus, which must be those of this program; that the cases are those that were asked for, each with an answer; that
// the certificate is the sum of the recorded results. Then it judges recorded answers again, by the same code as
// before, and each result must be as recorded. Throws spec::InputError for a file that is not a bundle or cannot be
// read, and for a folder that is not a corpus.
Verification verify(const VerifyOptions& options);

}  // namespace toolcomp::certify::bundle

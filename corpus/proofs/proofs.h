// SPDX-License-Identifier: Apache-2.0
// Golden vectors as lemmas of Coq: the formal specification, run over the real numbers, says what is recorded, every
// number of it (corpus/proofs/Runs.v). Nothing is taken from the engines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "spec/coverage/report.h"
#include "spec/language/case.h"

namespace toolcomp::corpus {

// What a file of such lemmas begins with.
std::string proofs_head();
// The lemma about one vector, and its proof.
std::string proof_of(const spec::Case& c);

struct ProofOptions {
  std::vector<std::string> sections;  // empty: all
  std::size_t a_section = 0;          // so many vectors of each section, chosen by the seed; 0: all
  std::uint64_t seed = 1;
  bool only_tell = false;  // instead of lemmas, which vectors Coq can compute
};

struct ProofFiles {
  std::size_t files = 0;
  std::map<std::string, std::size_t> vectors;  // of each section
};

// Writes Coq files into `output` for proofs/check to prove: of the vectors of a corpus but those of `unproven`.
ProofFiles write_proofs(const std::filesystem::path& corpus, const std::filesystem::path& output,
                        const ProofOptions& options = {});

// The vectors without a proof, by their ids, each with the reason: proofs/unproven.json.
std::map<std::string, std::string> unproven();

// Of each section; those that are not listed as unproven count as proven.
std::vector<spec::ProofCount> count_proofs(const std::filesystem::path& corpus);

}  // namespace toolcomp::corpus

// SPDX-License-Identifier: Apache-2.0
// The golden corpus: vectors in files of one case a line, in a folder a section, pinned by a manifest.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "corpus/manifest.h"
#include "corpus/share.h"
#include "spec/language/case.h"

namespace toolcomp::corpus {

// corpus/golden of the source tree the tool was built from.
std::filesystem::path default_folder();

// A vector and where it stands.
struct Vector {
  std::string file;      // relative to the corpus, with '/'
  std::size_t line = 0;  // from 1
  std::string text;      // as it stands
  spec::Case c;
};

// Which vectors: of these sections (all if empty), and of those every N-th, from the I-th, as a share I of N.
struct Selection {
  std::vector<std::string> sections;
  Share share;

  [[nodiscard]] bool wants(const std::string& section) const;
};

// The selected vectors, by file and line. Throws spec::InputError (naming file and line) for what is no case, for a
// folder without manifest, and for a section that the corpus does not have.
std::vector<Vector> read_vectors(const std::filesystem::path& folder, const Selection& selection = {});

// The cases of one file (one JSON object a line; empty lines are skipped).
std::vector<spec::Case> read_cases(const std::filesystem::path& file);
// The cases of the whole corpus, or of the sections named; one that the corpus does not have gives none.
std::vector<spec::Case> read_golden(const std::filesystem::path& folder, const std::vector<std::string>& sections = {});

}  // namespace toolcomp::corpus

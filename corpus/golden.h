// SPDX-License-Identifier: Apache-2.0
// The golden corpus: vectors in files with one case in each line, in one folder for each section, pinned by a manifest.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "corpus/manifest.h"
#include "corpus/share.h"
#include "spec/language/case.h"

namespace toolcomp::corpus {

// corpus/golden of the source tree from which toolcomp was built.
std::filesystem::path default_folder();

// A vector and its place.
struct Vector {
  std::string file;      // relative to the corpus, with '/'
  std::size_t line = 0;  // from 1
  std::string text;      // as it is in the file
  spec::Case c;
};

// A selection of vectors: those of these sections (of all, if empty), and of them every N-th from the I-th on, as a
// share I of N.
struct Selection {
  std::vector<std::string> sections;
  Share share;

  [[nodiscard]] bool wants(const std::string& section) const;
};

// The selected vectors, by file and line. Throws spec::InputError (with file and line) for a line that is not a case,
// for a folder without manifest, and for a section that the corpus does not have.
std::vector<Vector> read_vectors(const std::filesystem::path& folder, const Selection& selection = {});

// The cases of one file (one JSON object in each line; empty lines are skipped).
std::vector<spec::Case> read_cases(const std::filesystem::path& file);
// The cases of the whole corpus, or of the named sections. A section that the corpus does not have gives no cases.
std::vector<spec::Case> read_golden(const std::filesystem::path& folder, const std::vector<std::string>& sections = {});

}  // namespace toolcomp::corpus

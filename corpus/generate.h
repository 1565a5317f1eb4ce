// SPDX-License-Identifier: Apache-2.0
// Makes golden vectors: first the examples written by hand, then generated vectors that are chosen for what they reach.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/golden.h"

namespace toolcomp::corpus {

// Name and version of the generator; another version may give other vectors for the same seed.
inline constexpr std::string_view kGenerator = "toolcomp corpus 1";

struct GenerateOptions {
  std::filesystem::path folder = default_folder();
  std::vector<std::string> sections;  // empty: all; the files of other sections stay as they are
  std::uint64_t seed = 1;
  std::size_t vectors = 200;      // generated vectors in each section, at least
  std::size_t candidates = 6000;  // generated cases in each section to choose from
  // The version of the corpus. Empty: the version that is there, raised according to the changes; if there is none, the
  // version of the source tree.
  std::string version;
  std::function<void(const std::string& file, std::size_t vectors)> progress;
};

struct Rejection {
  std::string file;  // the vectors are kept next to it as FILE.rej, and the file itself is unchanged
  std::size_t line = 0;
  std::string why;
};

struct GenerateResult {
  std::string version;
  std::size_t vectors = 0;
  std::vector<Rejection> rejected;  // if there are any, no manifest is written
};

// Writes the files of vectors and the manifest. The same options and the same engines give the same bytes, on every
// compiler. Every file is read again and run again, model and fast, before it takes its place. Throws spec::InputError
// for an unknown section, std::runtime_error if a file cannot be written.
GenerateResult generate(const GenerateOptions& options);
// The same with generated vectors that were chosen elsewhere: `chosen` gives the vectors of a section.
GenerateResult generate(const GenerateOptions& options,
                        const std::function<std::vector<spec::Case>(std::string_view section)>& chosen);

// Throws spec::InputError for a section that does not exist.
void expect_sections(const std::vector<std::string>& sections);
// Whether the options ask for vectors of a section.
bool wants(const GenerateOptions& options, std::string_view section);

}  // namespace toolcomp::corpus

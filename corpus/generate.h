// SPDX-License-Identifier: Apache-2.0
// Makes golden vectors: the examples written by hand, then generated ones chosen for what they reach.
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
  std::vector<std::string> sections;  // empty: all; the files of others stay as they are
  std::uint64_t seed = 1;
  std::size_t vectors = 200;      // generated ones a section, at least
  std::size_t candidates = 6000;  // generated cases a section to choose from
  // Of the corpus. Empty: the one there, raised by what has changed; where none is there that of the tree.
  std::string version;
  std::function<void(const std::string& file, std::size_t vectors)> progress;
};

struct Rejection {
  std::string file;  // left beside it as FILE.rej, the file itself untouched
  std::size_t line = 0;
  std::string why;
};

struct GenerateResult {
  std::string version;
  std::size_t vectors = 0;
  std::vector<Rejection> rejected;  // then no manifest is written
};

// Writes the files of vectors and the manifest. The same options and the same engines give the same bytes, on every
// compiler. Every file is read again and run again, model and fast, before it takes its place. Throws spec::InputError
// for an unknown section, std::runtime_error for what cannot be written.
GenerateResult generate(const GenerateOptions& options);
// The same with generated vectors that are chosen elsewhere: `chosen` gives those of a section.
GenerateResult generate(const GenerateOptions& options,
                        const std::function<std::vector<spec::Case>(std::string_view section)>& chosen);

// Throws spec::InputError for a section that there is not.
void expect_sections(const std::vector<std::string>& sections);
// Whether vectors of a section are asked for.
bool wants(const GenerateOptions& options, std::string_view section);

}  // namespace toolcomp::corpus

// SPDX-License-Identifier: Apache-2.0
// The search for hard cases (hard.h).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "corpus/hard.h"

namespace toolcomp::corpus {

struct MineOptions {
  std::vector<std::string> sections;  // empty: all
  std::uint64_t runs = 0;             // of the model, a section; 0: by time
  double seconds = 0;                 // of all sections together
  unsigned jobs = 1;                  // sections side by side
  std::uint64_t seed = 1;
  // Called now and then, never at the same time from two threads.
  std::function<void(const std::string& section, std::uint64_t runs)> progress;
  std::function<bool()> stop;  // whether to come to an end; what was found stays
};

// A case on which the engines differ, or that could not be decided.
struct Met {
  spec::Case c;
  std::string what;
};

struct MineResult {
  HardCases hard;
  std::uint64_t runs = 0;
  std::uint64_t not_searched = 0;  // generated or golden cases that are larger than what is searched
  std::vector<Met> differ;         // by section, kind and clause of the difference
  std::vector<Met> undecided;      // by section and clause
};

// Searches, beginning with the golden corpus, generated cases and the hard cases that are there already; of these the
// sections that are not searched stay as they are. With `runs` the same seed and the same start give the same result.
// Throws spec::InputError for an unknown section.
MineResult mine(const HardCases& before, const MineOptions& options);

}  // namespace toolcomp::corpus

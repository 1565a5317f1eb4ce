// SPDX-License-Identifier: Apache-2.0
// Hard cases: for every decision by sign, the programs nearest to its boundary; for every section, the programs with
// the largest deviations of the fast engine. A search found them (corpus/hard/README.md); they are kept in corpus/hard,
// and run again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "model/exact/real.h"
#include "spec/clauses/clauses.h"
#include "spec/language/case.h"

namespace toolcomp::corpus {

// corpus/hard of the source tree.
std::filesystem::path hard_folder();

// A program in which a decision is very near to its boundary.
struct Nearest {
  spec::Clause clause{};
  exact::Sign outcome{};   // zero: a tie
  int decimals = 0;        // of the finest number in program and setup
  std::string margin;      // |quantity| / scale of the model, rounded up to three digits; "0" for a tie
  std::uint64_t line = 0;  // of the program
  spec::Case c;
};

enum class Deviation : std::uint8_t { ulp, um };

// A program on which the fast engine is farthest from the exact values, in the units that the policy multiplies by k,
// or in micrometres. It is still within the policy.
struct Worst {
  std::string section;
  Deviation of{};
  std::string value;  // rounded up to four digits
  spec::Case c;
};

struct HardCases {
  std::set<std::string> sections;
  std::vector<Nearest> nearest;  // by clause, outcome and decimals
  std::vector<Worst> worst;      // by section
};

// A value that is not negative, rounded up to this number of digits: "1.24e-13", "0".
std::string rounded_up(const exact::Rational& value, int digits);

// Reads FOLDER/manifest.json and the cases it names. Throws spec::InputError, also for a case whose id does not belong
// to its content.
HardCases read_hard(const std::filesystem::path& folder);

struct HardCheck {
  std::uint64_t cases = 0;
  std::uint64_t statements = 0;       // number of statements about margins and deviations
  std::uint64_t lower = 0;            // deviations smaller than stated, as with another compiler or library
  std::vector<std::string> failures;  // "FILE: what is wrong"
};

// Runs all hard cases, or those of some sections, and checks that both engines agree within the policy, that the clause
// has this outcome with exactly this margin, and that no deviation is larger than stated. Throws spec::InputError for a
// section without hard cases.
HardCheck check_hard(const HardCases& hard, const std::vector<std::string>& sections = {},
                     const std::function<void(std::uint64_t done)>& progress = {});

}  // namespace toolcomp::corpus

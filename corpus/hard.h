// SPDX-License-Identifier: Apache-2.0
// Hard cases: for every decision by sign the programs nearest to its boundary, for every section the largest deviations
// of the fast engine; searched for (mine/mine.h), kept in corpus/hard, and run again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "corpus/check.h"
#include "corpus/golden.h"
#include "fuzz/oracle/trial.h"
#include "spec/language/case.h"

namespace toolcomp::corpus {

// corpus/hard of the source tree.
std::filesystem::path hard_folder();

// A program in which a decision comes that near to its boundary.
struct Nearest {
  spec::Clause clause{};
  exact::Sign outcome{};   // zero: a tie
  int decimals = 0;        // of the finest number in program and setup
  std::string margin;      // |quantity| / scale of the model, rounded up to three digits; "0" for a tie
  std::uint64_t line = 0;  // of the program
  std::string found;       // for people: where the search began, and which numbers it changed
  spec::Case c;
};

enum class Deviation : std::uint8_t { ulp, um };

// A program on which the fast engine lies farthest off the exact values, in the units that the policy multiplies by k,
// or in micrometres; within the policy. Its case is a vector: it holds what is expected (vector.h).
struct Worst {
  std::string section;
  Deviation of{};
  std::string value;  // rounded up to four digits
  std::string found;
  spec::Case c;
};

// How much was searched.
struct Searched {
  std::uint64_t runs = 0;      // of the model
  std::uint64_t searches = 0;  // from one program each toward zero, or toward larger deviations
};

struct HardCases {
  std::set<std::uint64_t> seeds;
  std::map<std::string, Searched> sections;     // runs of all, searches for deviations
  std::map<spec::Clause, Searched> predicates;  // runs in which it was decided, searches for its zero
  std::vector<Nearest> nearest;                 // by clause, outcome and decimals
  std::vector<Worst> worst;                     // by section
};

// Whether its numbers are no finer than programs and setups of this control usually have.
bool is_usual(const Nearest& nearest);

// The smallest margin with that outcome that a run has for a clause, exactly, and where; nothing where it has none.
struct MarginFound {
  std::string margin;
  std::uint64_t line = 0;
};
std::optional<MarginFound> least_margin(const fuzz::ModelRun& run, spec::Clause clause, exact::Sign outcome);

// A value, not negative, rounded up to so many digits: "1.24e-13", "0".
std::string rounded_up(const exact::Rational& value, int digits);
std::string deviation_text(double value);
double deviation(const fuzz::Verdict& verdict, Deviation of);

// Reads FOLDER/manifest.json and the cases it names. Throws spec::InputError.
HardCases read_hard(const std::filesystem::path& folder);
// Writes SECTION.jsonl, manifest.json and README.md; only cases that something rests on. Ids are made from the cases.
void write_hard(const std::filesystem::path& folder, HardCases hard);

struct HardCheck {
  std::uint64_t cases = 0;
  std::uint64_t statements = 0;       // about margins and deviations
  std::uint64_t lower = 0;            // deviations smaller than stated: another compiler, another library
  std::vector<std::string> failures;  // "FILE: what is wrong"
};

// Runs all of them: both engines agree within the policy, the clause has that outcome with exactly that margin, no
// deviation is larger than stated, vectors are given again to the letter, and the files stand as the writer writes
// them.
HardCheck check_hard(const std::filesystem::path& folder, const std::vector<std::string>& sections = {},
                     const std::function<void(std::uint64_t done)>& progress = {});

}  // namespace toolcomp::corpus

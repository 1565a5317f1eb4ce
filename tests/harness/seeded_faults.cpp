// SPDX-License-Identifier: Apache-2.0
// program: faults
// link: toolcomp_fast_faulty
// The harness measured: every seeded fault of the fast engine must be found by its section's directed generator, within
// its budget, with a first divergence that rests on the clause the fault breaks. `./dev mutants` prints the table;
// TOOLCOMP_FAULT=NAME asks one alone, TOOLCOMP_FAULT_SEED=N takes other cases than those of N = 1.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "fuzz/faults/fault.h"
#include "fuzz/faults/faults.h"
#include "fuzz/gen/generator.h"
#include "judge/oracle/trial.h"
#include "tests/effort.h"

namespace toolcomp::fuzz {
namespace {

constexpr std::string_view kNames[] = {
    "none",
#define TOOLCOMP_FAULT(name, mistake, section, budget, clauses) #name,
#include "fuzz/faults/faults.inc"
#undef TOOLCOMP_FAULT
};

// A fault in force while this lives.
class Active {
 public:
  explicit Active(std::string_view name) {
    for (std::size_t i = 0; i < std::size(kNames); ++i)
      if (kNames[i] == name) fast::active_fault = static_cast<fast::Fault>(i);
  }
  ~Active() { fast::active_fault = fast::Fault::none; }
  Active(const Active&) = delete;
  Active& operator=(const Active&) = delete;
};

// The i-th case of the sequence that TOOLCOMP_FAULT_SEED names.
spec::Case fresh(std::string_view section, std::uint64_t i) {
  constexpr std::uint64_t apart = 1'000'000;
  static const std::uint64_t sequence = [] {
    const char* const text = std::getenv("TOOLCOMP_FAULT_SEED");
    return text == nullptr ? 1 : std::strtoull(text, nullptr, 10);
  }();
  SeededSource source((sequence - 1) * apart + i);
  return generate(section, Mode::directed, source);
}

bool rests_on(const judge::Difference& difference, std::string_view ids) {
  if (ids.empty()) return true;
  for (const spec::Clause clause : difference.clauses) {
    const std::string_view id = spec::info(clause).id;
    for (std::size_t at = ids.find(id); at != std::string_view::npos; at = ids.find(id, at + 1))
      if (at + id.size() == ids.size() || ids[at + id.size()] == ' ') return true;
  }
  return false;
}

TEST(SeededFaults, NameClausesAndSections) {
  ASSERT_EQ(seeded_faults().size() + 1, std::size(kNames));
  EXPECT_GE(seeded_faults().size(), 12U);
  for (std::size_t i = 0; i < seeded_faults().size(); ++i) {
    const SeededFault& fault = seeded_faults()[i];
    EXPECT_EQ(fault.name, kNames[i + 1]);
    EXPECT_NE(std::ranges::find(sections(), fault.section), sections().end()) << fault.section;
    EXPECT_GT(fault.budget, 0U) << fault.name;
    std::string ids(fault.clauses);
    for (std::size_t at = 0; at < ids.size();) {
      const std::size_t end = std::min(ids.find(' ', at), ids.size());
      EXPECT_TRUE(spec::find_clause(ids.substr(at, end - at))) << ids.substr(at, end - at);
      at = end + 1;
    }
  }
}

// No fault, no finding: what the faults are measured against.
TEST(SeededFaults, TheSoundEngineAgrees) {
  const std::uint64_t cases = test::random_cases(2000);
  for (const std::string_view section : sections())
    for (std::uint64_t seed = 1; seed <= cases; ++seed) {
      const judge::Trial t = judge::try_case(fresh(section, seed));
      ASSERT_FALSE(t.found()) << section << " seed " << seed << ": " << explain(*t.verdict.difference);
    }
}

TEST(SeededFaults, EachIsFoundWithinItsBudgetUnderItsClause) {
  const char* const only = std::getenv("TOOLCOMP_FAULT");
  bool asked = false;
  fmt::print("{:34}{:28}{:>8}{:>8}  {}\n", "fault", "section", "found", "budget", "first divergence");
  std::size_t place = 0;
  for (const SeededFault& fault : seeded_faults()) {
    const bool wanted = test::whole() || place++ % 3 == 0;
    if (only != nullptr ? fault.name != only : !wanted) continue;
    asked = true;
    std::uint64_t found = 0;
    std::string what;
    for (std::uint64_t seed = 1; seed <= fault.budget && found == 0; ++seed) {
      const spec::Case c = fresh(fault.section, seed);
      const judge::Trial t = [&] {
        const Active active(fault.name);
        return judge::try_case(c);
      }();
      // A broken law is no word of the comparison.
      if (!t.found() || t.verdict.difference->kind == "law" || !rests_on(*t.verdict.difference, fault.clauses))
        continue;
      found = seed;
      what = explain(*t.verdict.difference);
    }
    fmt::print("{:34}{:28}{:>8}{:>8}  {}\n", fault.name, fault.section, found == 0 ? "never" : fmt::format("{}", found),
               fault.budget, what);
    EXPECT_NE(found, 0U) << fault.name << " is not found in " << fault.budget << " executions";
  }
  EXPECT_TRUE(asked) << "no seeded fault is called " << only;
}

}  // namespace
}  // namespace toolcomp::fuzz

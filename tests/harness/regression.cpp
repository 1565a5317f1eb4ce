// SPDX-License-Identifier: Apache-2.0
// What was found once and fixed stays fixed: corpus/regression. And programs written by hand, to meet each rule: where
// their values stand by hand too, it is in tests/unit and corpus/examples.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "certify/fuzzing/regression.h"
#include "fuzz/gen/encode.h"
#include "fuzz/gen/generator.h"
#include "judge/oracle/trial.h"
#include "spec/language/case_format.h"

namespace toolcomp {
namespace {

const std::filesystem::path kFolder = TOOLCOMP_SOURCE_DIR "/corpus/regression";

TEST(Regression, EveryFindingThatWasFixedIsJudgedAndAgrees) {
  const auto cases = certify::fuzzing::regression_cases(kFolder);
  EXPECT_FALSE(cases.empty());
  for (const spec::Case& c : cases) {
    const judge::Trial trial = judge::try_case(c);
    EXPECT_FALSE(trial.found()) << c.id << ": " << judge::explain(*trial.verdict.difference);
    EXPECT_EQ(trial.verdict.outcome, judge::Outcome::agrees) << c.id;
    EXPECT_GT(trial.verdict.values, 0U) << c.id;
    EXPECT_NE(std::ranges::find(fuzz::sections(), c.section), fuzz::sections().end()) << c.id;
  }
}

TEST(Regression, ProgramsByHandAgree) {
  std::ifstream file(TOOLCOMP_SOURCE_DIR "/tests/harness/programs.jsonl");
  std::size_t cases = 0;
  for (std::string line; std::getline(file, line); ++cases) {
    const judge::Trial trial = judge::try_case(spec::read_case(line, "programs.jsonl"));
    EXPECT_FALSE(trial.found()) << line << '\n' << judge::explain(*trial.verdict.difference);
    EXPECT_NE(trial.verdict.outcome, judge::Outcome::undecided) << line;
  }
  EXPECT_GT(cases, 500U);
}

// As a first input of a campaign it is the same case.
TEST(Regression, EveryCaseSurvivesTheWayOfAnInput) {
  for (const spec::Case& c : certify::fuzzing::regression_cases(kFolder)) {
    const spec::Case again = fuzz::decode(c.section, fuzz::encode(c));
    EXPECT_EQ(again.program, c.program);
    EXPECT_TRUE(again.setup == c.setup) << c.id;
  }
}

}  // namespace
}  // namespace toolcomp

// SPDX-License-Identifier: Apache-2.0
// The hard cases: all of them again through both engines, and spoilt statements.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>

#include "corpus/check.h"
#include "corpus/hard.h"
#include "fuzz/gen/generator.h"
#include "host/file_writer.h"
#include "spec/language/input_error.h"

namespace toolcomp::corpus {
namespace {

namespace fs = std::filesystem;

TEST(HardCases, AllHold) {
  const HardCheck result = check_hard(read_hard(hard_folder()));
  for (const std::string& failure : result.failures) ADD_FAILURE() << failure;
  EXPECT_GT(result.cases, 100U);
  if (result.lower != 0) std::cout << result.lower << " deviations are smaller here than stated\n";
}

// Every decision by sign that the golden corpus reaches on a side has a hard case, and every section both deviations.
TEST(HardCases, AreComplete) {
  const HardCases hard = read_hard(hard_folder());
  const Coverage golden = coverage();
  for (std::size_t i = 0; i < spec::kClauseCount; ++i) {
    if (spec::clauses()[i].outcomes != spec::ClauseOutcomes::sign) continue;
    const auto has = [&](exact::Sign outcome) {
      return std::ranges::any_of(hard.nearest, [&](const Nearest& n) {
        return n.clause == static_cast<spec::Clause>(i) && n.outcome == outcome;
      });
    };
    EXPECT_TRUE(has(exact::Sign::positive) || golden.counts[i].positive == 0) << spec::clauses()[i].id;
    EXPECT_TRUE(has(exact::Sign::negative) || golden.counts[i].negative == 0) << spec::clauses()[i].id;
    EXPECT_TRUE(has(exact::Sign::zero) || golden.counts[i].tie == 0) << spec::clauses()[i].id;
  }
  // Canned cycles add decimals: nothing in them is hard.
  const std::size_t sections = fuzz::sections().size() - 1;
  EXPECT_EQ(hard.sections.size(), sections);
  EXPECT_EQ(hard.worst.size(), 2 * sections);
}

TEST(HardCases, StaySmall) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(hard_folder()))
    if (entry.is_regular_file()) bytes += entry.file_size();
  EXPECT_LT(bytes, 2'000'000U);
}

// The cases of one section with one statement spoilt.
class SpoiltHardCases : public testing::Test {
 protected:
  void SetUp() override {
    const auto other = [](const auto& statement) { return statement.c.section != kSection; };
    std::erase_if(hard_.nearest, other);
    std::erase_if(hard_.worst, other);
    ASSERT_FALSE(hard_.nearest.empty());
    ASSERT_FALSE(hard_.worst.empty());
  }

  // The one failure there is.
  std::string failure() {
    const HardCheck result = check_hard(hard_);
    if (result.failures.size() != 1) return std::to_string(result.failures.size()) + " failures";
    return result.failures.front();
  }
  Nearest& not_a_tie() {
    return *std::ranges::find_if(hard_.nearest, [](const Nearest& n) { return n.outcome != exact::Sign::zero; });
  }

  static constexpr const char* kSection = "fanuc/cutter-compensation-b";
  HardCases hard_ = read_hard(hard_folder());
};

TEST_F(SpoiltHardCases, HoldAsTheyAre) { EXPECT_EQ(failure(), "0 failures"); }

TEST_F(SpoiltHardCases, AMarginThatIsNotTheOne) {
  for (const char* wrong : {"1e-40", "2", "0"}) {
    const std::string right = std::exchange(not_a_tie().margin, wrong);
    EXPECT_NE(failure().find("the margin is " + right + ", the manifest states " + wrong), std::string::npos)
        << failure();
    not_a_tie().margin = right;
  }
}

TEST_F(SpoiltHardCases, AnotherOutcome) {
  Nearest& n = not_a_tie();
  n.outcome = -n.outcome;
  EXPECT_NE(failure(), "0 failures");
}

TEST_F(SpoiltHardCases, AClauseThatIsNotReached) {
  not_a_tie().clause = *spec::find_clause("heidenhain.face.along-the-tool");
  EXPECT_NE(failure().find("is not reached"), std::string::npos) << failure();
}

TEST_F(SpoiltHardCases, AnotherLine) {
  ++not_a_tie().line;
  EXPECT_NE(failure().find("decided in line"), std::string::npos) << failure();
}

TEST_F(SpoiltHardCases, ADeviationThatIsLarger) {
  hard_.worst.front().value = "1e-9";
  EXPECT_NE(failure().find(", the manifest states 1e-9"), std::string::npos) << failure();
}

// Not a fault: another library may round better. But it is counted.
TEST_F(SpoiltHardCases, ADeviationThatIsSmallerIsCounted) {
  hard_.worst.front().value = "1e9";
  const HardCheck result = check_hard(hard_);
  EXPECT_TRUE(result.failures.empty());
  EXPECT_EQ(result.lower, 1U);
}

TEST(HardCases, WhatCannotBeReadIsNamed) {
  EXPECT_THROW(check_hard(read_hard(hard_folder()), {"fanuc/no-such-section"}), spec::InputError);
  const fs::path folder = fs::path(testing::TempDir()) / ("hard_" + std::to_string(::getpid()));
  EXPECT_THROW(read_hard(folder), spec::InputError) << "no such folder";
  const auto refused = [&](const std::string& manifest) {
    host::write_file(folder / "manifest.json", manifest);
    EXPECT_THROW(read_hard(folder), spec::InputError) << manifest;
  };
  refused("{");
  refused(R"({"hard":2})");
  const std::string sections = R"({"hard":1,"sections":[{"section":"s"}],"nearest":[],"worst":[)";
  const std::string end = "]}";
  host::write_file(folder / "s.jsonl", "");
  EXPECT_NO_THROW((host::write_file(folder / "manifest.json", sections + end), read_hard(folder)));
  refused(sections + R"({"section":"s","of":"ulp","value":"1","case":"none"})" + end);
  host::write_file(folder / "s.jsonl", R"({"case":1,"id":"another","setup":{"control":"fanuc"},"program":"X1.\n"})");
  refused(sections + end);
  fs::remove_all(folder);
}

TEST(RoundedUp, NeverBelow) {
  using exact::Rational;
  EXPECT_EQ(rounded_up(0, 3), "0");
  EXPECT_EQ(rounded_up(1, 3), "1");
  EXPECT_EQ(rounded_up(Rational(1, 3), 3), "3.34e-1");
  EXPECT_EQ(rounded_up(Rational(12301, 10), 3), "1.24e3");
  EXPECT_EQ(rounded_up(Rational(1230), 3), "1.23e3");
  EXPECT_EQ(rounded_up(Rational(9999, 10'000), 3), "1");
  EXPECT_EQ(rounded_up(Rational(1, 1'000'000), 3), "1e-6");
}

}  // namespace
}  // namespace toolcomp::corpus

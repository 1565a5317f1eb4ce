// SPDX-License-Identifier: Apache-2.0
// The hard cases: all of them again through both engines, spoilt statements, and the search itself, briefly.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "corpus/hard.h"
#include "corpus/mine/mine.h"
#include "corpus/vector.h"
#include "fuzz/gen/generator.h"
#include "spec/language/byte_source.h"
#include "spec/language/file_writer.h"
#include "spec/language/input_error.h"

namespace toolcomp::corpus {
namespace {

namespace fs = std::filesystem;

TEST(HardCases, AllHold) {
  const HardCheck result = check_hard(hard_folder());
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
  EXPECT_EQ(hard.sections.size(), fuzz::sections().size());
  EXPECT_EQ(hard.worst.size(), 2 * fuzz::sections().size());
  for (const Worst& w : hard.worst) EXPECT_TRUE(w.c.has_expect) << w.section << ": no vector";
}

TEST(HardCases, StaySmall) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(hard_folder()))
    if (entry.is_regular_file()) bytes += entry.file_size();
  EXPECT_LT(bytes, 2'000'000U);
}

// The cases of one section in a folder of their own, with one statement spoilt.
class SpoiltHardCases : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              (std::string("hard_") + testing::UnitTest::GetInstance()->current_test_info()->name() + "_" +
               std::to_string(::getpid()));
    fs::remove_all(folder_);
    hard_ = read_hard(hard_folder());
    const auto other = [](const auto& statement) { return statement.c.section != kSection; };
    std::erase_if(hard_.nearest, other);
    std::erase_if(hard_.worst, other);
    ASSERT_FALSE(hard_.nearest.empty());
    ASSERT_FALSE(hard_.worst.empty());
  }
  void TearDown() override { fs::remove_all(folder_); }

  // The one failure there is.
  std::string failure() {
    write_hard(folder_, hard_);
    const HardCheck result = check_hard(folder_, {kSection});
    if (result.failures.size() != 1) return std::to_string(result.failures.size()) + " failures";
    return result.failures.front();
  }
  Nearest& not_a_tie() {
    return *std::ranges::find_if(hard_.nearest, [](const Nearest& n) { return n.outcome != exact::Sign::zero; });
  }

  static constexpr const char* kSection = "fanuc/cutter-compensation-b";
  fs::path folder_;
  HardCases hard_;
};

TEST_F(SpoiltHardCases, HoldAsTheyAre) { EXPECT_EQ(failure(), "0 failures"); }

TEST_F(SpoiltHardCases, AMarginThatIsNotTheOne) {
  for (const char* wrong : {"1e-40", "2", "0"}) {
    const std::string right = std::exchange(not_a_tie().margin, wrong);
    EXPECT_NE(failure().find("the margin is " + right + ", " + wrong + " is stated"), std::string::npos) << failure();
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
  EXPECT_NE(failure().find(", 1e-9 is stated"), std::string::npos) << failure();
}

// Not a fault: another library may round better. But it is counted.
TEST_F(SpoiltHardCases, ADeviationThatIsSmallerIsCounted) {
  hard_.worst.front().value = "1e9";
  write_hard(folder_, hard_);
  const HardCheck result = check_hard(folder_, {kSection});
  EXPECT_TRUE(result.failures.empty());
  EXPECT_EQ(result.lower, 1U);
}

TEST_F(SpoiltHardCases, AVectorThatExpectsSomethingElse) {
  const std::string id = vector_id(hard_.worst.front().c);
  for (Worst& w : hard_.worst)
    if (vector_id(w.c) == id) w.c.expect.pop_back();
  EXPECT_NE(failure().find("nothing expected, the model gives"), std::string::npos) << failure();
}

TEST_F(SpoiltHardCases, AChangedFile) {
  write_hard(folder_, hard_);
  const fs::path page = folder_ / "README.md";
  spec::write_file(page, spec::read_file(page) + "\n");
  EXPECT_EQ(check_hard(folder_, {kSection}).failures,
            std::vector<std::string>{"README.md: not as the writer writes it"});
}

TEST_F(SpoiltHardCases, WhatCannotBeReadIsNamed) {
  EXPECT_THROW(check_hard(folder_), spec::InputError) << "no such folder";
  write_hard(folder_, hard_);
  EXPECT_THROW(check_hard(folder_, {"fanuc/no-such-section"}), spec::InputError);
  spec::write_file(folder_ / "manifest.json", "{\"hard\": 2}");
  EXPECT_THROW(read_hard(folder_), spec::InputError);
  spec::write_file(folder_ / "manifest.json", "{");
  EXPECT_THROW(read_hard(folder_), spec::InputError);
}

// The same seed gives the same cases; and a search comes nearer than chance does in as many runs.
TEST(Mining, IsTheSameForASeed) {
  MineOptions options;
  options.sections = {"fanuc/cutter-compensation-b"};
  options.runs = 1500;
  const MineResult first = mine({}, options);
  const MineResult second = mine({}, options);
  ASSERT_FALSE(first.hard.nearest.empty());
  EXPECT_TRUE(first.differ.empty());
  ASSERT_EQ(first.hard.nearest.size(), second.hard.nearest.size());
  for (std::size_t i = 0; i < first.hard.nearest.size(); ++i) {
    EXPECT_EQ(first.hard.nearest[i].margin, second.hard.nearest[i].margin);
    EXPECT_EQ(vector_id(first.hard.nearest[i].c), vector_id(second.hard.nearest[i].c));
  }
  const auto searched = std::ranges::find_if(first.hard.nearest, [](const Nearest& n) {
    return n.found.find("; then ") != std::string::npos && n.outcome != exact::Sign::zero && std::stod(n.margin) < 1e-9;
  });
  EXPECT_NE(searched, first.hard.nearest.end()) << "nothing nearer than 1e-9 was searched for";
}

// Sections that are not searched stay as they are; what is there is where a search begins, and never lost.
TEST(Mining, BeginsWithWhatIsThere) {
  const HardCases before = read_hard(hard_folder());
  MineOptions options;
  options.sections = {"fanuc/tool-offset"};
  options.runs = 20;
  const HardCases after = mine(before, options).hard;
  for (const Nearest& b : before.nearest)
    EXPECT_TRUE(std::ranges::any_of(after.nearest, [&](const Nearest& a) {
      return a.clause == b.clause && a.outcome == b.outcome && std::stod(a.margin) <= std::stod(b.margin);
    })) << spec::info(b.clause).id;
  EXPECT_EQ(after.worst.size(), before.worst.size());
}

TEST(Mining, ASectionNamedTwiceIsSearchedOnce) {
  MineOptions options;
  options.sections = {"fanuc/tool-offset", "fanuc/tool-offset"};
  options.runs = 20;
  const HardCases hard = mine({}, options).hard;
  EXPECT_EQ(hard.sections.size(), 1U);
  EXPECT_LE(hard.worst.size(), 2U);
}

TEST(Mining, AnUnknownSectionIsNamed) {
  MineOptions options;
  options.sections = {"fanuc/no-such-section"};
  EXPECT_THROW(mine({}, options), spec::InputError);
}

}  // namespace
}  // namespace toolcomp::corpus

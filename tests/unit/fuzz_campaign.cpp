// SPDX-License-Identifier: Apache-2.0
// The pure parts of a fuzz campaign: shapes, turns, seeds, sums, floors, what outlives a process.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "certify/fuzzing/board.h"
#include "certify/fuzzing/schedule.h"
#include "certify/fuzzing/settler.h"
#include "certify/fuzzing/shape.h"
#include "certify/fuzzing/state.h"
#include "fuzz/campaign/black_box.h"
#include "fuzz/campaign/counters.h"
#include "fuzz/campaign/diary.h"
#include "fuzz/campaign/floors.h"
#include "host/file_writer.h"
#include "host/temporary_folder.h"

namespace toolcomp::certify::fuzzing {
namespace {

std::string shape(const std::string& program, const std::string& dialect = "fanuc") {
  spec::Case c;
  c.program = program;
  c.dialect = dialect;
  return shape_of(c);
}

TEST(Shape, NumbersAndOrderOfWordsDoNotCount) {
  EXPECT_EQ(shape("N1 G90 G00 X1. H1 G43\nX2.\n"), "G0 G43 G90 H X|X");
  EXPECT_EQ(shape("G43 G90 G0 Y-7 H2 (why)\nZ2.5\n"), "G0 G43 G90 H X|X");
  EXPECT_EQ(shape("G44 H1 Z1\n"), "G44 H X");
}

TEST(Shape, CodesAndKindsOfAxesCount) {
  EXPECT_NE(shape("G43 H1\n"), shape("G44 H1\n"));
  EXPECT_EQ(shape("G43.4 B1 I1 J2\n"), "A G43.4 I");
  EXPECT_EQ(shape("G43.0 H1\n"), shape("G043 H1\n"));
  EXPECT_EQ(shape("M02\n"), "M2");
}

TEST(Shape, BlocksThatRepeatTheOneBeforeCountOnce) { EXPECT_EQ(shape("G41 D1\nX1\nY2\nX3 Y4\nG40\n"), "D G41|X|G40"); }

TEST(Shape, OfKlartext) {
  EXPECT_EQ(shape("1 LN X+1 Y-2 NX+0.6 NZ+0.8 TX+0 TY+1 F AUTO M128 ; c\n", "klartext"), "AUTO F LN M128 NX TX X");
  EXPECT_EQ(shape("TOOL CALL 1 Z\n", "klartext"), "CALL TOOL X");
}

TEST(Schedule, TheTargetThatHadTheLeastTimeIsNext) {
  EXPECT_EQ(next_target(std::vector<std::uint64_t>{5, 3, 9}, 0), 1U);
  EXPECT_EQ(next_target(std::vector<std::uint64_t>{0, 0, 0}, 2), 2U);
  EXPECT_EQ(next_target(std::vector<std::uint64_t>{0, 0, 7}, 2), 0U);
}

TEST(Schedule, ATargetGetsItsShareInSlicesOfTwoMinutesAtMost) {
  EXPECT_EQ(slice_seconds({}, 2, 28), 120U);
  EXPECT_EQ(slice_seconds(3600, 2, 28), 85U);  // 257 s in three
  EXPECT_EQ(slice_seconds(60, 2, 28), 4U);
  EXPECT_EQ(slice_seconds(10, 1, 28), 1U);
}

TEST(Schedule, NoTwoSlicesOfAnyShardHaveOneSeed) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t shard = 1; shard <= 3; ++shard)
    for (std::uint64_t slice = 1; slice <= 500; ++slice) {
      const std::uint64_t seed = slice_seed(7, {shard, 3}, slice);
      EXPECT_GT(seed, 0U);
      EXPECT_LT(seed, std::uint64_t{1} << 32U);
      seeds.insert(seed);
    }
  EXPECT_EQ(seeds.size(), 1500U);
}

State state_with(std::uint64_t executions, double worst, const std::string& begun) {
  State state;
  state.begun = begun;
  state.starts = 1;
  state.seed = executions;
  state.next_slice = 4;
  state.groups["a"] = executions;
  TargetState& target = state.targets["tool_offset_directed"];
  target.sum.milliseconds = 10 * executions;
  target.slices = 3;
  target.sum.executions = executions;
  target.sum.worst_ulp = worst;
  target.sum.clauses.resize(spec::kClauseCount);
  target.sum.clauses[5].reached = executions;
  target.sum.hits["x|missing event|y"] = 2;
  return state;
}

TEST(CampaignState, IsReadBackAsItWasWritten) {
  State state = state_with(100, 0.1, "2026-01-01T00:00:00Z");
  state.open = {2, 3};
  state.ends["crash"] = 1;
  const std::string text = write_state(state, {});
  EXPECT_EQ(write_state(read_state(text, "state.json"), {}), text);
  EXPECT_THROW(read_state("{}", "state.json"), std::exception);
  EXPECT_THROW(read_state("rubbish", "state.json"), std::exception);
}

TEST(CampaignState, MergesTheSameInAnyOrder) {
  std::vector<State> parts{state_with(1, 0.3, "c"), state_with(20, 0.1, "a"), state_with(300, 0.2, "b")};
  std::set<std::string> results;
  std::vector<std::size_t> order{0, 1, 2};
  do {
    State total;
    for (const std::size_t i : order) merge(total, parts[i]);
    results.insert(write_state(total, {}));
    EXPECT_EQ(total.executions(), 321U);
    EXPECT_EQ(total.targets.begin()->second.sum.worst_ulp, 0.3);
  } while (std::ranges::next_permutation(order).found);
  EXPECT_EQ(results.size(), 1U);
}

TEST(Floors, WhatIsJudgedTooSeldomSaysSo) {
  const fuzz::Target& directed = *fuzz::find_target("tool_offset_directed");
  fuzz::Counters result;
  EXPECT_EQ(fuzz::shortfalls(directed, result), std::vector<std::string>{"not run"});
  result.executions = 10'000;
  result.acceptance[0] = 9'000;
  result.values = 50'000;
  result.law_checks = 90'000;
  EXPECT_TRUE(fuzz::shortfalls(directed, result).empty());
  fuzz::Counters few = result;
  few.acceptance[0] = 8'000;
  EXPECT_EQ(fuzz::shortfalls(directed, few), std::vector<std::string>{"acceptance 80.0 %, at least 85 % required"});
  fuzz::Counters wide = result;
  wide.wide = 10'000;
  EXPECT_EQ(fuzz::shortfalls(directed, wide), std::vector<std::string>{"judged share 83.3 %, at least 99 % required"});
  fuzz::Counters lawless = result;
  lawless.law_checks = 10;
  EXPECT_EQ(fuzz::shortfalls(directed, lawless).size(), 1U);
  fuzz::Counters open = result;
  open.acceptance[static_cast<std::size_t>(judge::Acceptance::not_decided)] = 1;
  EXPECT_EQ(fuzz::shortfalls(directed, open).size(), 1U);
  fuzz::Counters none = result;
  none.values = 0;
  EXPECT_FALSE(fuzz::shortfalls(directed, none).empty());
}

TEST(Floors, SeededFaultsAreFoundWithinTheirBudgets) {
  const auto none = fuzz::faults_within("fanuc/tool-length-offset", 0);
  const auto all = fuzz::faults_within("fanuc/tool-length-offset", none.largest);
  EXPECT_EQ(none.within, 0U);
  EXPECT_GT(all.all, 10U);
  EXPECT_EQ(all.within, all.all);
}

TEST(BlackBox, OutlivesItsProcess) {
  const host::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "box";
  {
    fuzz::BlackBox box(file);
    box.begin("first input, which is long");
    box.begin("second");
    EXPECT_TRUE(box.keep("kept"));
    EXPECT_TRUE(box.keep(""));
    EXPECT_FALSE(box.keep(std::string(1 << 20, 'x')));
  }
  const auto contents = fuzz::BlackBox::read(file);
  ASSERT_TRUE(contents);
  EXPECT_EQ(contents->executions, 2U);
  EXPECT_EQ(contents->input, "second");
  EXPECT_EQ(contents->kept, (std::vector<std::string>{"kept", ""}));
  EXPECT_EQ(contents->process, ::getpid());
  EXPECT_FALSE(fuzz::BlackBox::read(folder.path() / "none"));
}

TEST(Diary, KeepsTheFirstHitsOfAGroupThenEverFewer) {
  const host::TemporaryFolder folder;
  fuzz::Diary diary(folder.path(), "tool_offset_directed", 5);
  for (int i = 0; i < 500; ++i)
    diary.hit("group", 1, [i](const fuzz::HowFound&) { return std::to_string(i); }, ".json");
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / fuzz::Diary::kFindings))
    files += entry.is_regular_file() ? 1 : 0;
  EXPECT_EQ(files, 8U + 5U);  // the 16th, 32nd, … 256th
  diary.write({});
  const auto read = fuzz::read_counters("hits 500 a group | with blanks\n");
  EXPECT_EQ(read.hits.at("a group | with blanks"), 500U);
  EXPECT_FALSE(diary.failed());
}

// Where no file can be made what was found is in the black box.
TEST(Diary, WhatCannotBeWrittenIsKept) {
  const host::TemporaryFolder folder;
  fuzz::Diary diary(folder.path(), "tool_offset_directed", 5);
  std::filesystem::remove_all(folder.path() / fuzz::Diary::kFindings);
  host::write_file(folder.path() / fuzz::Diary::kFindings, "no folder");
  diary.hit("group", 7, [](const fuzz::HowFound& how) { return how.target; }, ".json");
  EXPECT_TRUE(diary.failed());
  EXPECT_EQ(
      fuzz::BlackBox::read(folder.path() / fuzz::Diary::kBlackBox)->kept,
      std::vector<std::string>{"0000000007-" + fuzz::digest("tool_offset_directed") + ".json\ntool_offset_directed"});
}

TEST(Settled, IsReadBack) {
  const Settled settled{"coordinate--a.b--12", true, false, true, "some words"};
  const auto again = read_settled(write_settled(settled));
  ASSERT_TRUE(again);
  EXPECT_EQ(again->name, settled.name);
  EXPECT_TRUE(again->fresh);
  EXPECT_FALSE(again->open);
  EXPECT_TRUE(again->everywhere);
  EXPECT_EQ(again->words, settled.words);
  EXPECT_FALSE(read_settled("rubbish"));
}

TEST(OutcomeWindow, CountsWhatCameInTheLastMinute) {
  OutcomeWindow window;
  const host::Clock::time_point start = host::Clock::now();
  const auto at = [start](int seconds) { return start + std::chrono::seconds(seconds); };
  EXPECT_EQ(window.fresh("t", 10, at(0)), 0U);
  EXPECT_EQ(window.fresh("t", 13, at(20)), 3U);
  EXPECT_EQ(window.fresh("t", 14, at(50)), 4U);
  EXPECT_EQ(window.fresh("t", 14, at(81)), 1U);
  EXPECT_EQ(window.fresh("t", 14, at(200)), 0U);
}

}  // namespace
}  // namespace toolcomp::certify::fuzzing

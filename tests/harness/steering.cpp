// SPDX-License-Identifier: Apache-2.0
// Steering: what a search looks for, counted by kind; and the mutation that asks the model.
#include "fuzz/campaign/steering.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/gen/choices.h"
#include "fuzz/gen/numbers.h"
#include "fuzz/gen/push.h"

namespace toolcomp::fuzz {
namespace {

spec::Case steered_case(const std::string& program) {
  spec::Case c;
  c.section = "fanuc/cutter-compensation-c";
  c.setup.axes = spec::Axes("XYZ");
  c.setup.d[1] = {*spec::parse_decimal("5."), {}};
  c.program = program;
  return c;
}

// The least margin of a clause's decisions by sign.
std::optional<double> least_margin(const spec::Case& c, spec::Clause clause) {
  std::optional<double> least;
  const judge::ModelRun run = judge::run_model(c);
  for (const model::Decision& d : run.recorder.decisions())
    if (d.clause == clause && (!least || judge::margin(d) < *least)) least = judge::margin(d);
  return least;
}

// Which kinds of slots a run has: outcomes and margins by clause, pairs, shapes.
TEST(Steering, CountsWhatARunReachesByKind) {
  const judge::ModelRun run =
      judge::run_model(steered_case("G90 G17 G01 F100 X0. Y0.\nG41 D1 X10. Y0.\nX20. Y10.\nX30. Y0.\nG40 X40.\n"));
  std::vector<std::uint8_t> counters(kSteeringSlots);
  count_reached(run, counters);
  std::array<std::size_t, 4> kinds{};
  for (std::size_t slot = 0; slot < counters.size(); ++slot)
    if (counters[slot] > 0)
      ++kinds.at(slot >= kFeatures + kPairSlots         ? 3
                 : slot >= kFeatures                    ? 2
                 : slot % kClauseSlots >= kOutcomeSlots ? 1
                                                        : 0);
  for (const std::size_t count : kinds) EXPECT_GT(count, 0U);
  // Saturating, however often it is added.
  for (int i = 0; i < 300; ++i) count_reached(run, counters);
  EXPECT_EQ(std::ranges::max(counters), 255);
}

// What a run reached before is not new; another row of moves is.
TEST(Steering, WhatIsNewIsNewOnce) {
  const judge::ModelRun turned = judge::run_model(steered_case("G90 G17 G01 F100 X10.\nY10.\nX0.\n"));
  const judge::ModelRun rapid = judge::run_model(steered_case("G90 G17 G01 F100 X10.\nG00 Y10.\nG01 X0.\n"));
  Coverage coverage;
  EXPECT_TRUE(coverage.add(turned));
  EXPECT_FALSE(coverage.add(turned));
  EXPECT_TRUE(coverage.add(rapid));
  EXPECT_FALSE(coverage.add(rapid));
  EXPECT_FALSE(coverage.add(turned));
}

// The same events in another row are new by their shapes alone.
TEST(Steering, ARowOfEventsIsNewByItsShape) {
  const judge::ModelRun once = judge::run_model(steered_case("G90 G17 G01 F100 X10.\nG00 Y10.\nG01 X0.\n"));
  const judge::ModelRun other =
      judge::run_model(steered_case("G90 G17 G01 F100 X10.\nX0.\nG00 Y10.\nG00 X5.\nG01 Y0.\n"));
  std::vector<std::uint8_t> first(kSteeringSlots);
  std::vector<std::uint8_t> second(kSteeringSlots);
  count_reached(once, first);
  count_reached(other, second);
  bool shape = false;
  for (std::size_t slot = kFeatures + kPairSlots; slot < kSteeringSlots; ++slot)
    shape = shape || (second[slot] > 0 && first[slot] == 0);
  EXPECT_TRUE(shape);
}

// Nine in ten pushes that succeed must bring some decision's margin down, and they must succeed often enough to be
// worth their runs.
TEST(Push, BringsADecisionNearerToItsBoundary) {
  std::size_t could = 0;
  std::size_t pushed = 0;
  std::size_t nearer = 0;
  constexpr std::size_t tries = 60;
  for (std::uint64_t seed = 1; seed <= tries; ++seed) {
    SeededSource source(seed);
    const spec::Case before = generate("fanuc/cutter-compensation-c", Mode::directed, source);
    spec::Case after = before;
    Choices choose(source);
    const judge::ModelRun first = judge::run_model(before);
    // Where no decision has a margin there is nothing to push; large cases are left alone.
    if (!is_searched(before) || std::ranges::none_of(first.recorder.decisions(),
                                                     [](const model::Decision& d) { return judge::margin(d) > 0; })) {
      EXPECT_FALSE(push_toward_boundary(after, choose));
      continue;
    }
    ++could;
    if (!push_toward_boundary(after, choose)) {
      EXPECT_EQ(after.program, before.program);
      continue;
    }
    ++pushed;
    EXPECT_TRUE(after.program != before.program || after.setup != before.setup);
    bool one = false;
    for (const model::Decision& d : first.recorder.decisions()) {
      const auto was = least_margin(before, d.clause);
      const auto is = least_margin(after, d.clause);
      one = one || (was && is && *is < *was);
    }
    nearer += one ? 1 : 0;
  }
  EXPECT_GE(could, tries / 2);
  EXPECT_GE(pushed, could / 3) << could;
  EXPECT_GE(nearer * 10, pushed * 9);
}

// No choice is made elsewhere.
TEST(Push, IsTheSameForTheSameChoices) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SeededSource one(seed);
    SeededSource other(seed);
    spec::Case a = generate("heidenhain/face-milling", Mode::directed, one);
    spec::Case b = generate("heidenhain/face-milling", Mode::directed, other);
    Choices choose_a(one);
    Choices choose_b(other);
    EXPECT_EQ(push_toward_boundary(a, choose_a), push_toward_boundary(b, choose_b));
    EXPECT_EQ(a.program, b.program);
    EXPECT_EQ(a.setup, b.setup);
  }
}

}  // namespace
}  // namespace toolcomp::fuzz

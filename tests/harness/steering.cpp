// SPDX-License-Identifier: Apache-2.0
// Steering: what a search looks for, counted by kind; and the mutation that asks the model.
#include "fuzz/campaign/steering.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/gen/choices.h"
#include "fuzz/gen/numbers.h"
#include "fuzz/gen/push.h"
#include "spec/language/input_error.h"

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
  const ModelRun run = run_model(c);
  for (const model::Decision& d : run.recorder.decisions())
    if (d.clause == clause && (!least || margin(d) < *least)) least = margin(d);
  return least;
}

TEST(Steering, IsReadAsItIsWritten) {
  for (const char* const text : {"all", "none", "outcomes", "margins,pairs", "outcomes,margins,pairs,shapes"})
    EXPECT_EQ(to_string(parse_steering(text, "here")), text);
  EXPECT_EQ(parse_steering("outcomes,margins,pairs,shapes,push", "here"), Steering{});
  for (const char* const text : {"", "outcome", "outcomes,", "outcomes margins", ",pairs"})
    EXPECT_THROW(parse_steering(text, "here"), spec::InputError) << text;
}

// Each part is looked for by itself: a run that has all four kinds is new once for each part alone.
TEST(Steering, EachPartIsLookedForByItself) {
  const ModelRun run =
      run_model(steered_case("G90 G17 G01 F100 X0. Y0.\nG41 D1 X10. Y0.\nX20. Y10.\nX30. Y0.\nG40 X40.\n"));
  for (const char* const part : {"outcomes", "margins", "pairs", "shapes"}) {
    Coverage coverage;
    std::vector<std::uint8_t> counters(kSteeringSlots);
    EXPECT_TRUE(coverage.add(run, parse_steering(part, "here"), counters)) << part;
    EXPECT_FALSE(coverage.add(run, parse_steering(part, "here"))) << part;
    EXPECT_GT(coverage.reach().outcomes, 0U);
    EXPECT_GT(coverage.reach().margins, 0U);
    EXPECT_GT(coverage.reach().pairs, 0U);
    EXPECT_GT(coverage.reach().shapes, 0U);
    const auto counted =
        static_cast<std::uint64_t>(std::ranges::count_if(counters, [](std::uint8_t count) { return count != 0; }));
    const Reach& reach = coverage.reach();
    const std::string name = part;
    EXPECT_EQ(counted, name == "outcomes"  ? reach.outcomes
                       : name == "margins" ? reach.margins
                       : name == "pairs"   ? reach.pairs
                                           : reach.shapes)
        << part;
  }
  Coverage coverage;
  EXPECT_FALSE(coverage.add(run, parse_steering("push", "here")));
}

// Two programs with the same clauses in other blocks differ by their pairs; with other rows of the same events, by
// their shapes.
TEST(Steering, PairsAreOfOneBlockAndShapesOfRows) {
  const ModelRun turned = run_model(steered_case("G90 G17 G01 F100 X10.\nY10.\nX0.\n"));
  const ModelRun rapid = run_model(steered_case("G90 G17 G01 F100 X10.\nG00 Y10.\nG01 X0.\n"));
  Coverage coverage;
  coverage.add(turned, {});
  EXPECT_TRUE(coverage.add(rapid, parse_steering("shapes", "here")));
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
    const ModelRun first = run_model(before);
    // Where no decision has a margin there is nothing to push; large cases are left alone.
    if (!is_searched(before) ||
        std::ranges::none_of(first.recorder.decisions(), [](const model::Decision& d) { return margin(d) > 0; })) {
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

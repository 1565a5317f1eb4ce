// SPDX-License-Identifier: Apache-2.0
// program: allocations
// What waits behind a vector of the leading edge offset is bounded, however many blocks come that are none.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/unit/count_allocations.h"
#include "tests/unit/model_run.h"

namespace {

using namespace toolcomp;

constexpr const char* kSetup =
    "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[parameters]\n19631 = 1\n[offsets.D]\n1 = 10\n";
// The vector at the end of X100 waits for Y50: the tool in X-Z, VM = +Y, side backward: (0, -10, 0).
constexpr const char* kBefore = "G43.5 I3 J0 K4\nG41.3 D1\nG01 X100 F100\n";
constexpr const char* kBehind = "Y50\nG40\n";

std::string repeated(const std::string& block, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += block;
  return text;
}

// The allocations that live while the program number has come so often, and the points in the end.
struct Waiting {
  std::size_t allocations = 0;
  test::Lines points;
};
Waiting waiting(int times) {
  const spec::Setup setup = spec::read_setup_toml(kSetup, "setup.toml");
  model::Recorder recorder;
  test::Collector sink;
  model::Engine engine(setup, recorder, sink, 0);
  const auto feed = [&](const std::string& program) {
    spec::ProgramReader reader(spec::text_source(program), setup.axes);
    spec::Block block;
    while (reader.next(block)) engine.block(block);
  };
  feed(kBefore);
  const std::size_t before = live_allocations;
  feed(repeated("O1234\n", times));
  Waiting result{live_allocations - before, {}};
  feed(kBehind);
  engine.end();
  test::Run run{setup, model::Recorder(), {}};
  run.sink.events = sink.events;
  result.points = test::lines(run, test::Show::point);
  return result;
}

TEST(LeadingEdgeWaiting, ProgramNumbersAreNotKept) {
  const Waiting few = waiting(2);
  const Waiting many = waiting(100'000);
  EXPECT_EQ(many.allocations, few.allocations);
  EXPECT_EQ(many.points, few.points);
  ASSERT_EQ(many.points.size(), 5U);
  EXPECT_EQ(many.points[2], "3 linear X100 Y-10 Z0");
}

// Blocks that are some end the waiting: two of them, as ever.
TEST(LeadingEdgeWaiting, BlocksBetweenThemCount) {
  const auto points = [](const std::string& between) {
    return test::lines(test::run(kSetup, kBefore + between + kBehind), test::Show::point)[2];
  };
  EXPECT_EQ(points(repeated("O7\n", 5) + "M08\n" + repeated("N5\n", 5)), "3 linear X100 Y-10 Z0");
  EXPECT_EQ(points(repeated("O7\n", 5) + "M08\n" + repeated("N5\n", 5) + "M09\n"), "3 linear X92 Y0 Z6");
}

// fanuc.leading-edge.no-movement: A block with O alone is no block, so no block comes between.
TEST(LeadingEdgeWaiting, AProgramNumberComesNotBetween) {
  const auto clauses = [](const std::string& between) {
    std::vector<std::vector<spec::Clause>> lists;
    for (const auto& event : test::run(kSetup, kBefore + between + kBehind).sink.events)
      lists.emplace_back(event.clauses.begin(), event.clauses.end());
    return lists;
  };
  EXPECT_EQ(clauses("O7\n"), clauses(""));
  EXPECT_NE(clauses("M08\n"), clauses(""));
}

}  // namespace

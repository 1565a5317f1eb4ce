// SPDX-License-Identifier: Apache-2.0
// The programs for machines that really move: they run to their end, stay moderate, and leave nothing on.
#include "certify/adapter_programs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "certify/adapter_contour.h"
#include "fuzz/gen/choices.h"
#include "judge/oracle/verdict.h"
#include "spec/language/byte_source.h"
#include "spec/language/setup_format.h"

namespace toolcomp::certify {
namespace {

spec::Setup setup(const std::string& name) {
  const std::string file = TOOLCOMP_SOURCE_DIR "/adapters/linuxcnc/setups/" + name + ".toml";
  return spec::read_setup_toml(spec::read_file(file), file);
}

class Machines : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(LinuxCnc, Machines,
                         testing::Values("three-axes", "xyzac-trt", "xyzbc-trt", "xyzab-tdr", "5axis", "max"),
                         [](const auto& machine) {
                           std::string name = machine.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST_P(Machines, RunToTheirEnd) {
  const spec::Setup machine = setup(GetParam());
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const spec::Case c = machine_program(machine, seed);
    const auto events = judge::run_model(c).events;
    ASSERT_GT(events.size(), 4U) << c.program;
    for (const auto& event : events) ASSERT_EQ(event.kind, spec::EventKind::move) << c.program << event.number.view();
  }
}

TEST_P(Machines, AreTheSameForTheSameSeed) {
  const spec::Setup machine = setup(GetParam());
  EXPECT_EQ(machine_program(machine, 7).program, machine_program(machine, 7).program);
  EXPECT_NE(machine_program(machine, 7).program, machine_program(machine, 8).program);
}

TEST(MachinePrograms, TakeUpWhatTheMachineHas) {
  const auto some = [](const char* machine, const char* word) {
    for (std::uint64_t seed = 0; seed < 20; ++seed)
      if (machine_program(setup(machine), seed).program.find(word) != std::string::npos) return true;
    return false;
  };
  for (const char* word : {"G43 H", "G41 D", "G42 D", "G18 G40", "G02", "G03", "G19 ", "G91"})
    EXPECT_TRUE(some("three-axes", word)) << word;
  EXPECT_FALSE(some("three-axes", "G43.4"));
  for (const char* word : {"G43.4 H", " A", " C", "G02"}) EXPECT_TRUE(some("xyzac-trt", word)) << word;
  EXPECT_FALSE(some("xyzac-trt", "G41"));
}

// Approach and retract are straight on exactly; every corner turns left, and none is nearly straight.
TEST(InsideContour, TurnsLeft) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    fuzz::SeededSource source(seed);
    fuzz::Choices choose(source);
    const Contour contour = inside_contour(choose, 5000);
    const auto minus = [](const Point& a, const Point& b) { return Point{a.u - b.u, a.v - b.v}; };
    const auto same = [](const Point& a, const Point& b) { return a.u == b.u && a.v == b.v; };
    ASSERT_GE(contour.legs.size(), 3U);
    EXPECT_EQ(contour.legs.front().radius, 0);
    EXPECT_EQ(contour.legs.back().radius, 0);
    EXPECT_TRUE(same(minus(contour.start, contour.approach), minus(contour.legs.front().end, contour.start)));
    const Point last = minus(contour.legs.back().end, contour.legs[contour.legs.size() - 2].end);
    EXPECT_TRUE(same(minus(contour.retract, contour.legs.back().end), last));
    Point at = contour.start;
    double heading = 0;
    for (std::size_t i = 0; i < contour.legs.size(); ++i) {
      const Leg& leg = contour.legs[i];
      const Point chord = minus(leg.end, at);
      const double length = std::hypot(static_cast<double>(chord.u), static_cast<double>(chord.v));
      const double half =
          leg.radius == 0 ? 0 : std::asin(length / 2 / static_cast<double>(leg.radius)) * (leg.ccw ? 1 : -1);
      const double along = std::atan2(static_cast<double>(chord.v), static_cast<double>(chord.u));
      const double turn = std::remainder(along - half - heading, 2 * std::acos(-1.0));
      if (i > 0) {
        EXPECT_GT(turn, 0.2) << seed;
        EXPECT_LT(turn, 1.6) << seed;
      }
      heading = along + half;
      at = leg.end;
    }
  }
}

}  // namespace
}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
// Cutter compensation B of the fast engine, by hand. The worked examples of 14.4 stand in
// corpus/examples/fanuc/cutter_compensation_b.cpp.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/fanuc/fast_run.h"

namespace toolcomp::fast {
namespace {

std::string setup(const std::string& parameters, const std::string& rest) {
  return "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\"]\ncutter_compensation=\"B\"\n[parameters]\n" +
         parameters + "\n" + rest;
}

const std::string kSetup = setup("", "[offsets.D]\n1=10\n2=\"-10\"\n3=5\n4=20\n[offsets.H]\n1=7\n2=7\n3=7\n");

// The moves as "(x,y)" to 12 places behind the point.
struct Head {
  double x, y;
};
void expect_heads(const ProgramRun& run, const std::vector<Head>& heads) {
  ASSERT_EQ(run.moves(), heads.size()) << run.alarm();
  std::size_t i = 0;
  for (std::size_t e = 0; e < run.events.size(); ++e) {
    if (run.events[e].kind != spec::EventKind::move) continue;
    EXPECT_NEAR(run.point(e, 'X'), heads[i].x, 3e-14) << i;
    EXPECT_NEAR(run.point(e, 'Y'), heads[i].y, 3e-14) << i;
    ++i;
  }
}

TEST(CutterCompensationB, Vectors) {
  // A negative value exchanges the sides, by hand.
  expect_heads(ProgramRun(kSetup, "G00 G41 X30 Y40 D2\n"), {{38, 34}});
  const ProgramRun run(kSetup, "G00 G41 X30 Y40 Z5 D1\n");
  EXPECT_EQ(run.events[0].cause, spec::Cause::start_up);
  EXPECT_EQ(run.events[0].type, spec::MoveType::rapid);
  EXPECT_EQ(run.programmed(0, 'X'), 30);
  EXPECT_EQ(run.axis(0, 'X'), 22);
  EXPECT_EQ(run.axis(0, 'Z'), 5);
}

TEST(CutterCompensationB, CornerArcs) {
  // Example 7: coming up at (0, 60) with G42 and 5.
  const ProgramRun run(kSetup, "G42 Y60 D3\nG39 I-40\n");
  expect_heads(run, {{5, 60}, {0, 65}});
  EXPECT_EQ(run.events[1].arc->direction, spec::ArcDirection::ccw);
  EXPECT_EQ(run.events[1].arc->sweep, 90);
  EXPECT_EQ(run.programmed(1, 'Y'), 60);
  // By hand: a negative value turns the sense round; axis words name a point (G90) or a way (G91), also under G00;
  // the same vector makes no move.
  const ProgramRun negative(kSetup, "G41 Y60 D2\nG39 I-40\n");
  expect_heads(negative, {{10, 60}, {0, 70}});
  EXPECT_EQ(negative.events[1].arc->direction, spec::ArcDirection::ccw);
  expect_heads(ProgramRun(kSetup, "G41 Y60 D1\nG39 X30 Y100\n"), {{-10, 60}, {-8, 66}});
  expect_heads(ProgramRun(kSetup, "G41 Y60 D1\nG91 G39 X30 Y40\nY1\n"), {{-10, 60}, {-8, 66}, {-10, 61}});
  expect_heads(ProgramRun(kSetup, "G41 Y60 D1\nG39 J3\nX1\n"), {{-10, 60}, {1, 70}});
  expect_heads(ProgramRun(kSetup, "G41 X3 Y4 D1\nG39 I0.6 J0.8\n"), {{-5, 10}});
  for (const char* program : {"G39 I1\n", "G41 D1\nG39 I1\n"})
    EXPECT_EQ(ProgramRun(kSetup, program).alarm().substr(0, 6), "PS0035") << program;
  for (const char* words : {"G39", "G39 I0", "G39 I1 Z5", "G39 I1 G41", "G39 I1 G40", "G39 I1 D3", "G39 Y60"})
    EXPECT_EQ(ProgramRun(kSetup, std::string("G41 Y60 D1\n") + words + "\n").alarm(), "PS0035@2") << words;
}

TEST(CutterCompensationB, KeptVectors) {
  // By hand: other axes, no travel, a direction of zero, a lone switch, a new number.
  expect_heads(ProgramRun(kSetup, "G41 X40 D1\nZ5\nX40\nX50 I0\nG42\nM05\nD3\nX60\n"),
               {{40, 10}, {40, 10}, {40, 10}, {50, 10}, {60, -5}});
  // A start-up waits for the first vector; D0 is a number.
  const ProgramRun late(kSetup, "G41 D1\nZ1\nX0\nX40\nD0\nX50\n");
  expect_heads(late, {{0, 0}, {0, 0}, {40, 10}, {50, 0}});
  EXPECT_EQ(late.events[1].cause, spec::Cause::programmed);
  EXPECT_EQ(late.events[2].cause, spec::Cause::start_up);
  EXPECT_EQ(late.events[3].cause, spec::Cause::programmed);
  // EVR: an edited value waits for its number, or counts from the next block on.
  const char* edit = "G41 X40 D1\nG10 L11 P1 R3\nX50\nD1 X60\n";
  const ProgramRun waits(kSetup, edit);
  EXPECT_EQ(waits.point(2, 'Y'), 10);
  EXPECT_EQ(waits.point(3, 'Y'), 3);
  const ProgramRun counts(setup("\"5001#4\"=1", "[offsets.D]\n1=10\n"), edit);
  EXPECT_EQ(counts.point(2, 'Y'), 3);
}

TEST(CutterCompensationB, Arcs) {
  // By hand: the old vector is not radial, so the tool runs a spiral from |(40,10) - (40,40)| = 30 to 40 - 10.
  const ProgramRun tangent(kSetup, "G41 X40 D1\nG03 X80 Y40 J40\n");
  expect_heads(tangent, {{40, 10}, {70, 40}});
  EXPECT_FALSE(tangent.events[1].arc->radius);
  EXPECT_EQ(tangent.events[1].arc->sweep, 90);
  const ProgramRun spiral(kSetup, "G41 X40 D1\nG03 X80 Y40 J40 F1\nG02 X80 Y-40 I0 J-40\n");
  expect_heads(spiral, {{40, 10}, {70, 40}, {80, -50}});
  ASSERT_TRUE(spiral.events[2].arc->radius);
  EXPECT_DOUBLE_EQ(spiral.events[2].arc->radius->first, std::sqrt(1700.0));
  EXPECT_EQ(spiral.events[2].arc->radius->second, 50);
  // The value is the radius: the head lies in the centre.
  const ProgramRun centre(kSetup, "G41 X40 D1\nG03 X50 Y10 J10\n");
  expect_heads(centre, {{40, 10}, {40, 10}});
  EXPECT_FALSE(centre.events[1].arc->sweep);
  EXPECT_FALSE(centre.events[1].arc->radius);
  // A full circle inside with a value beyond the radius: heads beyond the centre, one whole turn.
  const ProgramRun beyond(kSetup, "G41 X40 D4\nG03 J10\n");
  expect_heads(beyond, {{40, 20}, {40, 20}});
  EXPECT_EQ(beyond.events[1].arc->sweep, 360);
}

TEST(CutterCompensationB, Cancel) {
  const ProgramRun alone(kSetup, "G41 X40 D1\nG40\nG40\nX50\n");
  expect_heads(alone, {{40, 10}, {40, 0}, {50, 0}});
  EXPECT_EQ(alone.events[1].cause, spec::Cause::cancel);
  EXPECT_EQ(alone.events[2].cause, spec::Cause::programmed);
  const ProgramRun outside(kSetup, "G41 X40 D1\nG40 Z3\n");
  expect_heads(outside, {{40, 10}, {40, 0}});
  EXPECT_EQ(outside.events[1].cause, spec::Cause::cancel);
  EXPECT_EQ(ProgramRun(kSetup, "G41 D1\nG40 X5\n").events[0].cause, spec::Cause::programmed);
  // A way back that takes a new length along is one move (H1 = 7).
  const ProgramRun length(kSetup, "G43 Z0 H1\nG41 X40 D1\nG40 G49\n");
  expect_heads(length, {{0, 0}, {40, 10}, {40, 0}});
  EXPECT_EQ(length.axis(2, 'Z'), 0);
}

TEST(CutterCompensationB, MachinePositions) {
  // By hand: the first move takes the vector away, the next vector is a start-up; other axes keep it.
  const ProgramRun run(kSetup, "G41 X40 D1\nG28 Z0\nX50\nG28 X45\nY9\nG53 Y0\nX3\n");
  expect_heads(run, {{40, 10}, {40, 10}, {40, 10}, {50, 10}, {45, 0}, {0, 0}, {-10, 9}, {0, 0}, {3, 10}});
  EXPECT_EQ(run.events[4].cause, spec::Cause::reference);
  EXPECT_EQ(run.events[6].cause, spec::Cause::start_up);
  EXPECT_EQ(run.events[8].cause, spec::Cause::start_up);
  EXPECT_EQ(run.machine(4, 'X'), 45);
  const ProgramRun off(kSetup, "G41 X40 D1\nG40 G28 Z0\nX50\n");
  expect_heads(off, {{40, 10}, {40, 0}, {40, 0}, {50, 0}});
  const ProgramRun named(kSetup, "G41 X40 D1\nG92 X0\nX10\nG54\n");
  expect_heads(named, {{40, 10}, {10, 10}});
}

// By hand: Z 0 is called 7 in a block that drops the length of 7. The move that removes a vector has Z 7, one of the
// length alone Z 0.
TEST(CutterCompensationB, LengthMoveInTheBlockOfACoordinateShift) {
  const auto z = [](const std::string& blocks, std::size_t i) {
    const ProgramRun run(kSetup, "G43 H1\n" + blocks);
    EXPECT_EQ(run.alarm(), "");
    EXPECT_EQ(run.axis(i, 'Z'), run.point(i, 'Z'));
    return run.point(i, 'Z');
  };
  EXPECT_EQ(z("G41 D1 G92 H0 Z7\n", 1), 0);
  EXPECT_EQ(z("G41 D1 X40\nG92 H0 Z7\n", 2), 0);
  EXPECT_EQ(z("G41 D1 X40\nG40 G92 H0 Z7\n", 2), 7);
  EXPECT_EQ(z("G41 D1\nG40 G92 H0 Z7\n", 1), 0);
}

TEST(CutterCompensationB, Planes) {
  // By hand: ZX has Z first; left of +Z is +X.
  const ProgramRun zx(kSetup, "G18 G41 Z40 D1\n");
  EXPECT_EQ(zx.point(0, 'X'), 10);
  EXPECT_EQ(zx.point(0, 'Z'), 40);
  const ProgramRun yz(kSetup, "G19 G41 Y40 K1 D1\n");
  EXPECT_EQ(yz.point(0, 'Y'), 30);
  EXPECT_EQ(ProgramRun(kSetup, "G41 X40 D1\nG18\n").alarm(), "PS0037@2");
  EXPECT_EQ(ProgramRun(kSetup, "G41 X40 D1\nG18 G40\n").alarm(), "PS0037@2");
  EXPECT_EQ(ProgramRun("control=\"fanuc\"\naxes=[\"X\",\"Z\"]\ncutter_compensation=\"B\"\n", "G41 X1\n").alarm(),
            "PS0028@1");
}

TEST(CutterCompensationB, Alarms) {
  const auto second = [](const char* block) {
    return ProgramRun(kSetup, std::string("G41 X40 D1\n") + block + "\n").alarm();
  };
  EXPECT_EQ(ProgramRun(kSetup, "G41 D1\nG02 X1 I5\n").alarm(), "PS0034@2");
  EXPECT_EQ(second("G41 G02 X50 R40"), "PS0034@2");
  EXPECT_EQ(second("G42 G02 X50 R40"), "PS0034@2");
  EXPECT_EQ(second("G40 G02 X50 R40"), "PS0034@2");
  EXPECT_EQ(second("G02 X50 R40 D3"), "PS0034@2");
  EXPECT_EQ(second("G02 X50 R40 D1"), "");
  EXPECT_EQ(second("G02 X50 I10"), "PS0038@2");
  EXPECT_EQ(second("G41.3"), "FORBIDDEN_IN_CUTTER_COMPENSATION@2");
  EXPECT_EQ(second("G45 X1"), "PS0042@2");
  EXPECT_EQ(ProgramRun(setup("", "[offsets.D]\n1=1000\n"), "G41 X1 D1\n").alarm(), "PS0029@1");
  // A zero vector: the arc of the G40 block runs as programmed.
  EXPECT_EQ(ProgramRun(kSetup, "G41 X40 D0\nG40 G02 X50 R40\n").alarm(), "");
}

}  // namespace
}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
// Tool length offset in the fast engine: machine coordinates of 14.1.2, and derivations by hand. The worked examples
// stand in corpus/examples/fanuc/tool_length_offset.cpp.
#include <gtest/gtest.h>

#include "spec/language/input_error.h"
#include "tests/unit/fanuc/fast_run.h"

namespace toolcomp::fast {
namespace {

using Path = std::vector<double>;

std::string setup(const std::string& parameters, const std::string& rest, const std::string& axes = R"("X","Y","Z")") {
  return "control=\"fanuc\"\nunits=\"mm\"\naxes=[" + axes + "]\n[parameters]\n" + parameters + "\n" + rest;
}

TEST(ToolLengthOffset, TypeCNeedsOneAxis) {
  const std::string offsets = "[offsets.H]\n1=4\n2=6\n3=2\n";
  EXPECT_EQ(ProgramRun(setup("\"5001#0\"=1", offsets), "G43 H1\n").alarm(), "PS0027@1");
  EXPECT_EQ(ProgramRun(setup("\"5001#0\"=1", offsets), "G43 X1 Y1 H1\n").alarm(), "PS0027@1");
}

TEST(ToolLengthOffset, TypeBTwoAxesAndPlanes) {
  const std::string s = setup("\"5001#1\"=1", "[offsets.H]\n1=4\n2=20\n");
  // By hand: G19 offsets X, G17 offsets Z; H0 in G17 cancels Z alone, G49 both.
  const ProgramRun run(s, "G90 G19 G43 X0 H1\nG17 G43 Z0 H2\nH0\nG49\n");
  EXPECT_EQ(run.axis_path('X'), (Path{4, 4, 4, 0}));
  EXPECT_EQ(run.axis_path('Z'), (Path{0, 20, 0, 0}));
  EXPECT_EQ(ProgramRun(s, "G18 G43 Y0 H1\nG19 G43 X0 H1\nG17 G43 Z0 H1\nG49\n").alarm(), "PS0015@4");
}

TEST(ToolLengthOffset, CancelAloneMoves) {
  const ProgramRun run(setup("", "[offsets.H]\n1=20\n"), "G90 G43 Z100 H1\nG49\nG49\nG43\nG49\n");
  EXPECT_EQ(run.axis_path('Z'), (Path{120, 100, 120, 100}));
}

constexpr const char* kWorkZero = "[offsets.H]\n1=20\n2=4\n[workpiece.G54]\nZ=-300\n";

TEST(MachineMoves, ExamplesOfTypeA) {
  for (const char* evo : {"0", "1"}) {
    const std::string s = setup(std::string("\"5001#6\"=") + evo, kWorkZero);
    const bool restores = *evo == '1';
    const ProgramRun run(s, "G90 G00 G43 Z0 H1\nZ50\nG53 Z-10\nZ50\nH1\n");
    // Machine Z is the workpiece Z less 300.
    EXPECT_EQ(run.axis(1, 'Z') - 300, -230);
    EXPECT_EQ(run.machine(2, 'Z'), -10);
    EXPECT_EQ(run.axis(3, 'Z') - 300, restores ? -230 : -250);
    if (restores)
      EXPECT_EQ(run.moves(), 4U);
    else
      EXPECT_EQ(run.axis(4, 'Z') - 300, -230);
    EXPECT_EQ(ProgramRun(s, "G90 G43 Z0 H1\nG53 X0\nZ50\n").axis(2, 'Z') - 300, -230);
    const ProgramRun home(s, "G90 G43 Z0 H1\nG28 Z80\n");
    EXPECT_EQ(home.machine(1, 'Z'), -200);
    EXPECT_EQ(home.machine(2, 'Z'), 0);
    EXPECT_EQ(home.events[1].cause, spec::Cause::reference);
    const ProgramRun cancelled(s, "G90 G43 Z0 H1\nG49 G28 Z80\nZ50\n");
    EXPECT_EQ(cancelled.machine(1, 'Z'), -220);
    EXPECT_EQ(cancelled.machine(2, 'Z'), 0);
    EXPECT_EQ(cancelled.axis(3, 'Z'), 50);
  }
}

// By hand: Y has lost its vector and X was offset last, so the number stored for Y, 3 for 2, acts on X in the next
// block.
TEST(MachineMoves, WhatIsStoredActsOnTheAxesOffsetLast) {
  const auto last = [](const char* evo, const std::string& rest) {
    const ProgramRun run(setup(std::string("\"5001#1\"=1\n\"5001#6\"=") + evo, "[offsets.H]\n1=10\n2=20\n3=30\n"),
                         "G18 G43 Y0 H1\nG19 H2\nG53 Y0\nG18\n" + rest);
    EXPECT_EQ(run.alarm(), "");
    return std::pair(run.events.back().axes.value[0], run.events.back().axes.value[1]);
  };
  EXPECT_EQ(last("1", "G40 H3\n"), std::pair(20.0, 0.0));
  EXPECT_EQ(last("1", "G40 H3\nG91\n"), std::pair(30.0, 0.0));
  EXPECT_EQ(last("1", "G40 H3\nG91\nG43\n"), std::pair(30.0, 30.0));
  EXPECT_EQ(last("1", "G40 G44\nG91\n"), std::pair(-20.0, 0.0));
  EXPECT_EQ(last("0", "G40 H3\nG91\n"), std::pair(20.0, 0.0));
  EXPECT_EQ(last("0", "G40 H3\nG91\nG43\n"), std::pair(20.0, 30.0));
}

TEST(OffsetMemory, RangesAndNumbers) {
  const std::string b = "[offsets]\nmemory=\"B\"\ncount=32\n[offsets.H]\n1={geometry=\"999.999\",wear=\"0.001\"}\n";
  EXPECT_EQ(ProgramRun(setup("", b), "G43 Z0 H1\n").alarm(), "PS0029@1");
  EXPECT_EQ(ProgramRun(setup("", b), "H33\n").alarm(), "PS0030@1");
  EXPECT_EQ(ProgramRun(setup("", b), "D33\n").alarm(), "PS0030@1");
  EXPECT_EQ(ProgramRun(setup("", b), "G10 L12 P1 R1\n").alarm(), "PS0010@1");
  EXPECT_EQ(ProgramRun(setup("", "[offsets.H]\n1=1\n"), "G10 L10 P1 R1\n").alarm(), "PS0010@1");
}

TEST(OffsetMemory, EditedValueByEvo) {
  // By hand: H1 = 20 active, edited to 25; EVO = 1 brings it in the next block, EVO = 0 in the next one with H.
  const std::string program = "G90 G43 Z0 H1\nG10 L11 P1 R25\nX1\nH1\n";
  const ProgramRun now(setup("\"5001#6\"=1", kWorkZero), program);
  EXPECT_EQ(now.axis_path('Z'), (Path{20, 25}));
  const ProgramRun later(setup("\"5001#6\"=0", kWorkZero), program);
  EXPECT_EQ(later.axis_path('Z'), (Path{20, 20, 25}));
}

TEST(OffsetMemory, EditedValueLeavesBlocksWithNumbersAlone) {
  // By hand: the edited H1 is not brought in by a block that has an H of its own.
  const ProgramRun run(setup("\"5001#1\"=1\n\"5001#6\"=1", kWorkZero),
                       "G90 G43 Z0 H1\nG10 L11 P1 R25\nG18 G43 Y0 H2\n");
  EXPECT_EQ(run.axis_path('Z'), (Path{20, 20}));
  EXPECT_EQ(run.axis_path('Y'), (Path{0, 4}));
}

TEST(OffsetMemory, AddsToBothTablesOfASharedMemory) {
  // By hand: H4 = 17, D4 = -948.251; -72.377 leaves H4 in range and D4 beyond -999.999.
  const std::string s = setup("", "[offsets.H]\n4=17\n5=17\n[offsets.D]\n4=\"-948.251\"\n");
  EXPECT_EQ(ProgramRun(s, "G91 G10 L11 P4 R-72.377\n").alarm(), "PS0032@1");
  // Found by fuzzing: without R nothing is stored, so a value that stood there out of range before is no fault of it.
  const std::string odd = setup("", "[offsets.H]\n2={ geometry = 0, wear = 1000 }\n");
  EXPECT_EQ(ProgramRun(odd, "G91 G10 L11 P2\n").alarm(), "");
  EXPECT_EQ(ProgramRun(odd, "G91 G10 L11 P2 R1\n").alarm(), "PS0032@1");
  EXPECT_EQ(ProgramRun(s, "G91 G10 L11 P5 R-72.377\n").events[0].value, -55.377);
}

TEST(Program, UnitsAndIncrements) {
  // By hand: 1 inch = 25.4 mm; IS-B counts 0.001 mm, in inch programs 0.0001 inch.
  const ProgramRun inch(setup("", ""), "G20 G01 X1 F10\nG21 X1\n");
  EXPECT_EQ(inch.axis_path('X'), (Path{25.4, 1}));
  EXPECT_EQ(inch.events[0].feed, 254);
  const ProgramRun counts(setup("\"3401#0\"=0", ""), "X1234\nX1234.\nG20 X10000\n");
  EXPECT_EQ(counts.axis_path('X'), (Path{1.234, 1234, 25.4}));
  const std::string s = "control=\"fanuc\"\nunits=\"inch\"\naxes=[\"X\",\"Y\",\"Z\"]\n";
  // 0.1 mm = 5/1270 inch: ten of them and back are exactly 0.
  const ProgramRun metric(s, "G21 G91 X0.1\nX0.1\nX0.1\nX-0.3\nX25.4\n");
  EXPECT_EQ(metric.axis(3, 'X'), 0);
  EXPECT_EQ(metric.axis(4, 'X'), 1);
  EXPECT_EQ(metric.axis(0, 'X'), 1.0 / 254.0);
}

TEST(Program, Coordinates) {
  const std::string s = setup("", "[workpiece.G54]\nX=100\n[workpiece.G55]\nX=250\n[position]\nX=5\n");
  // By hand: the machine stays at 105, which is -145 in G55.
  const ProgramRun run(s, "G55\nG91 X1\nG92 X0\nX2\nG90 G53 X0\n");
  EXPECT_EQ(run.axis_path('X'), (Path{-144, 2, -106}));
  EXPECT_EQ(run.machine(2, 'X'), 0);
  const ProgramRun back(s, "G28 X50\nG29 X7\n");
  EXPECT_EQ(back.axis_path('X'), (Path{50, -100, 50, 7}));
}

TEST(Program, Alarms) {
  const std::string s = setup("", "");
  EXPECT_EQ(ProgramRun(s, "X1\nG07\n").alarm(), "PS0010@2");
  EXPECT_EQ(ProgramRun(s, "X1\nX1.2.3\n").alarm(), "PS0007@2");
  EXPECT_EQ(ProgramRun(s, "G30 P5 X0\n").alarm(), "PS0046@1");
  EXPECT_EQ(ProgramRun(s, "X1\nM30\nX2\n").moves(), 1U);
}

TEST(Arcs, CentreSweepAndRadius) {
  const std::string s = setup("", "");
  const ProgramRun quarter(s, "G03 X10 Y10 I0 J10\n");
  const auto& arc = *quarter.events[0].arc;
  EXPECT_EQ(arc.center[0], 0);
  EXPECT_EQ(arc.center[1], 10);
  EXPECT_EQ(arc.sweep, 90);
  EXPECT_FALSE(arc.radius);
  EXPECT_EQ(ProgramRun(s, "G02 X10 Y10 I0 J10\n").events[0].arc->sweep, 270);
  EXPECT_EQ(ProgramRun(s, "G02 I5\n").events[0].arc->sweep, 360);
  // 3-4-5 triangles: chord 6, radius 5, the centre 4 off the chord.
  const auto minor = *ProgramRun(s, "G02 X6 R5\n").events[0].arc;
  EXPECT_EQ(minor.center[0], 3);
  EXPECT_EQ(minor.center[1], -4);
  const auto major = *ProgramRun(s, "G02 X6 R-5\n").events[0].arc;
  EXPECT_EQ(major.center[1], 4);
  // 2 asin(3/5) in degrees, 25 digits by hand calculator: 73.73979529168804
  EXPECT_DOUBLE_EQ(*minor.sweep, 73.73979529168804);
  EXPECT_DOUBLE_EQ(*major.sweep, 286.26020470831196);
  EXPECT_EQ(ProgramRun(s, "G02 X10 R5\n").events[0].arc->sweep, 180);
  const auto spiral = *ProgramRun(s, "G03 X-20 Y10 J10\n").events[0].arc;
  EXPECT_EQ(spiral.sweep, 270);
  EXPECT_EQ(spiral.radius->first, 10);
  EXPECT_EQ(spiral.radius->second, 20);
  EXPECT_FALSE(ProgramRun(s, "G03 Y10 J10\n").events[0].arc->sweep);
  for (const char* program : {"G02 X10 R4.999\n", "G02 X0 R5\n", "G02 X10\n", "G02 X10 I0 J0\n", "G02 X10 R0\n"})
    EXPECT_EQ(ProgramRun(s, program).alarm(), "PS0023@1") << program;
  EXPECT_EQ(ProgramRun(s, "G02 Z5\n").events[0].type, spec::MoveType::linear);
}

TEST(SetupErrors, NameTheKey) {
  const auto message = [](const std::string& text) -> std::string {
    try {
      ProgramRun(text, "");
    } catch (const spec::InputError& error) {
      return error.message();
    }
    return "";
  };
  const std::string axes = R"("X","Y","Z","B","C")";
  EXPECT_NE(message(setup("\"19680\"=3", "", axes)).find("19680"), std::string::npos);
  EXPECT_NE(message(setup("\"19680\"=2\n\"19681\"=1\n\"19682\"=3\n\"19686\"=4\n\"19687\"=2", "", axes)).find("19681"),
            std::string::npos);
  EXPECT_NE(message(setup("\"19680\"=2\n\"19681\"=5\n\"19682\"=7\n\"19686\"=4\n\"19687\"=2", "", axes)).find("19682"),
            std::string::npos);
  EXPECT_NE(message(setup("\"19631\"=\"90.001\"", "", axes)).find("19631"), std::string::npos);
  EXPECT_EQ(message(setup("\"19631\"=90", "", axes)), "");
}

}  // namespace
}  // namespace toolcomp::fast

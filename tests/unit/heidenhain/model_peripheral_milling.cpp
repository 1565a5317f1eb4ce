// SPDX-License-Identifier: Apache-2.0
// Peripheral milling in the exact engine: its rules on paths whose answers are seen by eye: the tool
// along Z, so RL is to the left in the plane. The worked examples stand in
// golden/heidenhain/corpus_examples_peripheral_milling.cpp.
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/heidenhain/klartext_run.h"

namespace {

using namespace toolcomp;
using test::last_move;
using test::Lines;
using test::moves;
using test::run_klartext;
using test::shown;
using test::story;
using test::tool;

const std::string kMill = tool("R = 6\nR2 = 0\nDR = \"-0.1\"\n");
const std::string kCall = "TOOL CALL 1 Z\n";
const std::string kContour = "FUNCTION PROG PATH IS CONTOUR\n";

// R = 1, DR = 0 under IS CONTOUR: the tip runs 1 beside the path. Deltas alone: DR = 1 under M107.
const std::string kOne = tool("R = 1\n");
const std::string kStart = kCall + kContour + "M128\n";

TEST(ModelPeripheralMilling, StartMitreAndEnd) {
  const std::string path = "L X0 Y0 RL\nL X10\nL Y10\nL X0 R0\n";
  const Lines expected{"4 0 1 0 (start-up)", "5 9 1 0", "6 9 10 0", "7 0 10 0 (cancel)"};
  EXPECT_EQ(story(kOne, kStart + path), expected);
  EXPECT_EQ(story(kOne, "TOOL CALL 1 Z DR+1\nM107\nM128\n" + path), expected);
  EXPECT_EQ(story(kOne, kStart + "L X0 Y0 RR\nL X10\nL Y10\nL X0 R0\n"),
            (Lines{"4 0 -1 0 (start-up)", "5 11 -1 0", "6 11 10 0", "7 0 10 0 (cancel)"}));
  // The end of the text and M129 end it too; a block behind M129 is compensated no more.
  EXPECT_EQ(story(kOne, kStart + "L X0 Y0 RL\nL X10\n").back(), "5 10 1 0");
  EXPECT_EQ(story(kOne, kStart + "L X0 Y0 RL\nL X10 M129\nL X20 R0\n"),
            (Lines{"4 0 1 0 (start-up)", "5 10 1 0", "6 20 0 0 (cancel)"}));
}

TEST(ModelPeripheralMilling, BlocksBetweenDoNotCount) {
  EXPECT_EQ(story(kOne, kStart + "L X0 Y0 RL\nL F100\nM8\nQ1 = 3\nL X10\nSTOP\nL Y10\n"),
            (Lines{"4 0 1 0 (start-up)", "8 9 1 0", "10 9 10 0"}));
}

TEST(ModelPeripheralMilling, FirstBlock) {
  // No next: its own direction. The next one without compensation, or with a normal, is a direction all the same.
  EXPECT_EQ(story(kOne, kStart + "L X10 RL\n"), (Lines{"4 10 1 0 (start-up)"}));
  EXPECT_EQ(story(kOne, kStart + "L X10 RL\nL Y10 R0\n"), (Lines{"4 9 0 0 (start-up)", "5 10 10 0 (cancel)"}));
  EXPECT_EQ(story(kOne, kStart + "L X10 RL\nLN X10 Y10 Z0 NX0 NY0 NZ1 R0\n"),
            (Lines{"4 9 0 0 (start-up)", "5 10 10 0 (cancel)"}));
  // The next block's own side where it has one.
  EXPECT_EQ(story(kOne, kStart + "L X10 RL\nL Y10 RR\n"), (Lines{"4 11 0 0 (start-up)", "5 11 10 0"}));
  EXPECT_EQ(story(kOne, kStart + "L X10 RL\nL X10\n"), (Lines{"4 E_NO_DIRECTION"}));
  EXPECT_EQ(story(kOne, kStart + "L Z10 RL\n"), (Lines{"4 E_NO_DIRECTION"}));
}

TEST(ModelPeripheralMilling, WithoutDirectionOfItsOwn) {
  // A plunge and a block that moves nothing take the direction made last.
  EXPECT_EQ(story(kOne, kStart + "L X0 RL\nL X10\nL Z-5\nL Z-5\nL Y10\n"),
            (Lines{"4 0 1 0 (start-up)", "5 10 1 0", "6 10 1 -5", "7 9 1 -5", "8 9 10 -5"}));
  // It is forgotten at the end of the compensated blocks.
  EXPECT_EQ(story(kOne, kStart + "L X0 RL\nL X10\nL X20 R0\nL X30 RL\nL Z5\n"),
            (Lines{"4 0 1 0 (start-up)", "5 10 1 0", "6 20 0 0 (cancel)", "7 E_NO_DIRECTION"}));
}

TEST(ModelPeripheralMilling, ReversalAndChangeOfSide) {
  EXPECT_EQ(story(kOne, kStart + "L X0 RL\nL X10\nL X0\n"), (Lines{"4 0 1 0 (start-up)", "5 E_REVERSAL"}));
  // Nearly so is far: c = (0,1), c' = (0.0002,-1)/sqrt(1.00000004): the mitre is 10000 long.
  EXPECT_EQ(story(kOne, kStart + "L X0 RL\nL X10\nL X0 Y-0.002\nL Y-10 R0\n", 1)[1].substr(0, 7), "5 10010");
  // Both sides of one line: the directions are opposite. A reversal with a change of side: they are the same.
  EXPECT_EQ(story(kOne, kStart + "L X0 RL\nL X10\nL X20 RR\n").back(), "5 E_REVERSAL");
  EXPECT_EQ(story(kOne, kStart + "L X0 RL\nL X10\nL X0 RR\n"), (Lines{"4 0 1 0 (start-up)", "5 10 1 0", "6 0 1 0"}));
}

// The tool of the junction makes both directions. Turned by B90 it is along X: RL of +Y is t x d = +Z.
TEST(ModelPeripheralMilling, ToolOfTheJunction) {
  EXPECT_EQ(story(kOne, kStart + "L X0 B90 RL\nL Y10\nL Z10 R0\n"),
            (Lines{"4 0 0 1 (start-up)", "5 0 10 1", "6 0 10 10 (cancel)"}));
  // d = +Y then +Y with the tool turned from Z to X in between: at the junction t = +X.
  EXPECT_EQ(story(kOne, kStart + "L Y0 RL\nL Y10 B90\nL Y20\n"),
            (Lines{"4 -1 0 0 (start-up)", "5 0 10 1", "6 0 20 1"}));
  // Exactly along the tool by angles: t of B30 is (1/2, 0, sqrt(3)/2), and no decimal travel is along it; B90 is +X.
  EXPECT_EQ(story(kOne, kStart + "L B90 RL\nL X10\n"), (Lines{"4 E_NO_DIRECTION"}));
  EXPECT_EQ(story(kOne, kStart + "L A45 RL\nL Y-5 Z5\n"), (Lines{"4 E_NO_DIRECTION"}));
}

TEST(ModelPeripheralMilling, ReversalWithTheToolTurned) {
  // t = Rz(30) Ry(40): d and -d give opposite directions whatever t is.
  EXPECT_EQ(story(kOne, kStart + "L B40 C30 RL\nL X10 Y3\nL X0 Y0\n").back(), "5 E_REVERSAL");
  // d, d' and t in one plane, which only the angles tell: t = (0, -sin A, cos A), d' = d + k t is not decimal; with
  // A45 it is: d = (1,0,0), d' = (-1,-2,2).
  EXPECT_EQ(story(kOne, kStart + "L A45 RL\nL X1\nL IX-1 IY-2 IZ2\n").back(), "5 E_REVERSAL");
}

TEST(ModelPeripheralMilling, RadiusAndDeltasAndReference) {
  // dL along the tool, dR2 in tool_center alone; CNT-CNT programs the centre: the tip is R2 = 1 below.
  const std::string toroid = tool("R = 3\nR2 = 1\nDL = \"0.5\"\nDR = \"-0.5\"\nDR2 = \"-0.25\"\nL = 50\n");
  const std::string center = "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT CNT-CNT\n";
  const model::Event event = last_move(toroid, kCall + center + "L X0 RL\nL X10\n");
  EXPECT_EQ(shown(event.point), "10 -0.5 -1");
  EXPECT_EQ(shown(event.axes), "10 -0.5 -0.5");
  EXPECT_EQ(shown(event.space->tool_center), "10 -0.5 -0.25");
  EXPECT_EQ(shown(event.space->shift), "0 -0.5 0");
  EXPECT_EQ(shown(event.space->tool_shift), "0 -0.5 0.5");
  EXPECT_EQ(shown(*event.space->carrier), "10 -0.5 49.5");
  // IS CONTOUR: R' = 2.5, whatever REFPNT says.
  const model::Event contour = last_move(toroid, kCall + center + kContour + "L X0 RL\nL X10\n");
  EXPECT_EQ(shown(contour.point), "10 2.5 0");
  EXPECT_EQ(shown(contour.space->shift), "0 -0.5 0");
}

TEST(ModelPeripheralMilling, OutOfScope) {
  const std::string program = kCall + "L X10 RL\nLN X20 Y0 Z0 TX0 TY0 TZ1\nL X30 R0\nM128\nL X40\n";
  EXPECT_EQ(story(kMill, program), (Lines{"2 heidenhain.peripheral.out-of-scope", "3 W_T_IGNORED",
                                          "3 heidenhain.peripheral.out-of-scope", "4 30 0 0", "6 40 0 0"}));
  const test::Run run = run_klartext(kMill, program);
  EXPECT_EQ(run.events()[0].kind, spec::EventKind::undecided);
  EXPECT_TRUE(run.events()[0].out_of_scope);
  EXPECT_FALSE(run.events()[0].permitted.positive);
  // It uses up the cancel.
  EXPECT_EQ(story(kOne, kStart + "L X0 RL\nL X10 M129\nL X20\nL X30 R0\n"),
            (Lines{"4 0 1 0 (start-up)", "5 10 1 0", "6 heidenhain.peripheral.out-of-scope", "7 30 0 0"}));
}

// An alarm of a later block: what is held is given as if that block and all behind it were absent.
TEST(ModelPeripheralMilling, AlarmBehindTheHeldBlock) {
  EXPECT_EQ(story(kOne, kStart + "L X0 RL\nL X10\nLN X20 Y0 Z0 NX0 NY0 NZ1\n"),
            (Lines{"4 0 1 0 (start-up)", "5 10 1 0", "6 E_RC_WITH_N"}));
  EXPECT_EQ(story(kOne, kStart + "L X10 RL\nL Y10 M91\n"), (Lines{"4 10 1 0 (start-up)", "5 E_TCPM_M91"}));
  EXPECT_EQ(story(kOne, kStart + "L X10 RL\nTOOL CALL 1\n"), (Lines{"4 10 1 0 (start-up)", "5 E_TCPM_TOOLCALL"}));
  EXPECT_EQ(story(kOne, kStart + "L X0 RL\nL X10\nNONSENSE\n"),
            (Lines{"4 0 1 0 (start-up)", "5 10 1 0", "6 E_SYNTAX"}));
  // Where it then has no direction, that is the alarm.
  EXPECT_EQ(story(kOne, kStart + "L Z10 RL\nTOOL CALL 1\n"), (Lines{"4 E_NO_DIRECTION"}));
  EXPECT_EQ(story(tool("R = 1\nDR = 1\n"), kCall + "M128\nL X10 RL\n"), (Lines{"3 E_OVERSIZE_DR"}));
  EXPECT_EQ(story(kOne, "M128\nL X10 RL\n"), (Lines{"2 E_NO_TOOL"}));
}

// The clauses of a held block are those of its own words and of its compensation; those of the block behind, which
// makes it go out, are not among them.
TEST(ModelPeripheralMilling, ClausesOfTheHeldBlock) {
  const auto has = [](const model::Event& event, spec::Clause clause) { return event.clauses.contains(clause); };
  const test::Run run = run_klartext(kOne, kStart + "L X0 RL\nL IX10\nL X20 Y5 M108\nLN X30 Y5 Z0 TX0 TY0 TZ1 R0\n");
  const std::vector<model::Event> all = moves(run);
  ASSERT_EQ(all.size(), 4U);
  for (const model::Event& event : all) {
    EXPECT_EQ(has(event, spec::Clause::heidenhain_program_incremental), event.line == 5) << event.line;
    EXPECT_EQ(has(event, spec::Clause::heidenhain_peripheral_tool_vector), event.line == 7) << event.line;
    EXPECT_EQ(has(event, spec::Clause::heidenhain_tool_table_radius), event.line > 3) << event.line;
    EXPECT_EQ(has(event, spec::Clause::heidenhain_peripheral_applies), event.line > 3 && event.line < 7) << event.line;
    EXPECT_TRUE(has(event, spec::Clause::heidenhain_program_length_along_the_tool)) << event.line;
  }
  // What decided is last.
  EXPECT_EQ(all[1].clauses.back(), spec::Clause::heidenhain_peripheral_mitre);
  EXPECT_EQ(all[2].clauses.back(), spec::Clause::heidenhain_peripheral_last_block);
  EXPECT_EQ(all[3].clauses.back(), spec::Clause::heidenhain_peripheral_cancel);
}

// An alarm rests on its own clause last.
TEST(ModelPeripheralMilling, ClausesOfAlarms) {
  const auto last = [](const std::string& setup, const std::string& program) {
    return test::last_clause(setup, program);
  };
  EXPECT_EQ(last(kOne, kStart + "L X0 RL\nL IX10\nL IX-10\nL IY5\n"), "heidenhain.peripheral.reversal");
  EXPECT_EQ(last(kOne, kStart + "L Z10 RL\nL IZ10\n"), "heidenhain.peripheral.former-direction");
  EXPECT_EQ(last(kOne, kStart + "L Z10 RL\n"), "heidenhain.peripheral.former-direction");
  EXPECT_EQ(last(kOne, kStart + "L X0 RL\nL X10\nLN X20 Y0 Z0 NX0 NY0 NZ1\n"), "heidenhain.face.radius-compensation");
  EXPECT_EQ(last(kOne, kStart + "L X10 RL\nL Y10 M91\n"), "heidenhain.program.machine-coordinates-under-tcpm");
  EXPECT_EQ(last(tool("R = 1\nDR = 1\n"), kCall + "M128\nL X10 RL\n"), "heidenhain.tool.oversize-radius");
  EXPECT_EQ(last(kOne, "M128\nL X10 RL\n"), "heidenhain.tool.none");
  EXPECT_EQ(last(kOne, kCall + "L X10 RL\n"), "heidenhain.peripheral.out-of-scope");
}

TEST(ModelPeripheralMilling, ForcedOutcomes) {
  // Forced to be no reversal: there is no finite point.
  const std::string program = kStart + "L X0 RL\nL X10\nL X0\n";
  const test::Run run = run_klartext(kOne, program);
  std::size_t at = 0;
  while (run.recorder.decisions()[at].clause != spec::Clause::heidenhain_peripheral_reversal) ++at;
  const test::Forced apart{at, exact::Sign::positive};
  EXPECT_THROW(run_klartext(kOne, program, &apart), model::NotFinite);
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// The state of a Klartext program in the exact engine, rule by rule.
#include <gtest/gtest.h>

#include <string>

#include "spec/language/input_error.h"
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

const std::string kTools = tool("name = \"END\"\nR = 3\nL = 100\nDL = \"0.5\"\n") +
                           "[[tool]]\nnumber = \"2.1\"\nR = 5\nR2 = 2\nL = 80\n" +
                           "[[correction.tcs]]\nnumber = 1\nDL = \"0.25\"\n";
const std::string kCall = "TOOL CALL 1 Z\n";

std::string direction(const std::string& program) { return shown(*last_move(kTools, program).tool_axis, 6); }
std::string axes(const std::string& program) { return shown(last_move(kTools, program).axes, 6); }

TEST(ModelKlartextState, ToolCall) {
  EXPECT_EQ(axes("L X1\n"), "1 0 0");
  EXPECT_EQ(axes(kCall + "L X1\n"), "1 0 0.5");
  EXPECT_EQ(axes("TOOL CALL \"END\" Z\nL X1\n"), "1 0 0.5");
  EXPECT_EQ(shown(*last_move(kTools, "TOOL CALL 2.1\nL X1\n").space->carrier), "1 0 80");
  EXPECT_EQ(shown(last_move(kTools, "TOOL CALL 2.1\nL X1\n").space->tool_center), "1 0 2");
  EXPECT_FALSE(last_move(kTools, "TOOL CALL 2.1\nTOOL CALL 0\nL X1\n").space->carrier);
  EXPECT_EQ(story(kTools, "TOOL CALL \"NONE\"\n"), (Lines{"1 E_NO_TOOL"}));
  EXPECT_EQ(story(kTools, "TOOL CALL QS1\n"), (Lines{"1 E_NO_TOOL"}));
  EXPECT_EQ(story(kTools, "TOOL CALL 2\n"), (Lines{"1 E_NO_TOOL"}));
  // R0 with a tool, not without one.
  EXPECT_EQ(story(kTools, kCall + "L RL\nTOOL CALL 1\nL X1\n"), (Lines{"4 1 0 0"}));
  EXPECT_EQ(story(kTools, kCall + "L RL\nTOOL CALL S100\nL X1\n"), (Lines{"4 heidenhain.peripheral.out-of-scope"}));
}

// heidenhain.program.no-compensation: TCP' = TIP' + R2' t without a normal too. Toroid of E11, R2 = 1, dR2 = -0.02, and
// 0.1 more of the TOOL CALL: R2' = 0.98 and 1.08; by hand.
TEST(ModelKlartextState, ToolCenterOfBlocksWithoutNormal) {
  const std::string toroid = tool("R = 6\nR2 = 1\nDL = \"0.05\"\nDR = \"-0.1\"\nDR2 = \"-0.02\"\n");
  const auto center = [&](const std::string& program) { return shown(last_move(toroid, program).space->tool_center); };
  const auto tip = [&](const std::string& program) { return shown(last_move(toroid, program).point); };
  EXPECT_EQ(center(kCall + "L X1 Y2 Z3 R0\n"), "1 2 3.98");
  EXPECT_EQ(center("TOOL CALL 1 Z DR2+0.1\nL X1 Y2 Z3 R0\n"), "1 2 4.08");
  EXPECT_EQ(center(kCall + "M128\nLN X1 Y2 Z3 TX0 TY0.6 TZ0.8 R0\n"), "1 2.588 3.784");
  EXPECT_EQ(center(kCall + "M128\nL X1 B90 R0\n"), "1.98 0 0");
  // CNT-CNT: the tip is R2 of the table below the programmed point, the centre dR2 above it.
  const std::string cnt = kCall + "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT CNT-CNT\n";
  EXPECT_EQ(tip(cnt + "L X1 Y2 Z3 R0\n"), "1 2 2");
  EXPECT_EQ(center(cnt + "L X1 Y2 Z3 R0\n"), "1 2 2.98");
  EXPECT_EQ(tip(cnt + "LN X1 Y2 Z3 TX0 TY0.6 TZ0.8 R0\n"), "1 1.4 2.2");
  EXPECT_EQ(center(cnt + "LN X1 Y2 Z3 TX0 TY0.6 TZ0.8 R0\n"), "1 1.988 2.984");
}

TEST(ModelKlartextState, Deltas) {
  EXPECT_EQ(axes("TOOL CALL 1 DL+1\nFUNCTION CORRDATA TCS #1\nL X1\n"), "1 0 1.75");
  // A call without a tool replaces what it names; a row of the compensation table is dropped with the next tool.
  EXPECT_EQ(axes("TOOL CALL 1 DL+1 DR-1\nTOOL CALL DR-2\nL X1\n"), "1 0 1.5");
  EXPECT_EQ(axes("TOOL CALL 1 DL+1\nTOOL CALL DL+2\nL X1\n"), "1 0 2.5");
  EXPECT_EQ(axes("TOOL CALL 1 DL+1\nTOOL CALL 1\nL X1\n"), "1 0 0.5");
  EXPECT_EQ(axes(kCall + "FUNCTION CORRDATA TCS #1\nTOOL CALL DL+1\nL X1\n"), "1 0 1.75");
  EXPECT_EQ(axes(kCall + "FUNCTION CORRDATA TCS #1\nTOOL CALL 1\nL X1\n"), "1 0 0.5");
  EXPECT_EQ(axes(kCall + "FUNCTION CORRDATA TCS #1\nFUNCTION CORRDATA RESET WPL\nL X1\n"), "1 0 0.75");
  EXPECT_EQ(axes(kCall + "FUNCTION CORRDATA TCS #1\nFUNCTION CORRDATA RESET\nL X1\n"), "1 0 0.5");
  EXPECT_EQ(axes(kCall + "SEL CORR-TABLE TCS \"T.tco\"\nFUNCTION CORRDATA WPL #9\nL X1\n"), "1 0 0.5");
  EXPECT_EQ(axes("TOOL CALL DL+1\nFUNCTION CORRDATA TCS #1\nL X1\n"), "1 0 1.25");
  EXPECT_EQ(axes("TOOL CALL 0 DL+1\nL X1\n"), "1 0 1");
}

TEST(ModelKlartextState, DirectionUnderTcpm) {
  const std::string vector = "LN X0 Y0 Z0 TX0 TY0.6 TZ0.8 ";
  EXPECT_EQ(direction(kCall + "L B90\n"), "0 0 1");
  EXPECT_EQ(direction(kCall + "M128\nL B90\n"), "1 0 0");
  EXPECT_EQ(direction(kCall + "M128\nL B90\nL X1\n"), "1 0 0");
  EXPECT_EQ(direction(kCall + vector + "M128\nL X1\n"), "0 0.6 0.8");
  // The tool stands as the rotary axes stand, also where they were positioned before.
  EXPECT_EQ(direction(kCall + "L B90\nM128\nL X1\n"), "1 0 0");
  EXPECT_EQ(direction(kCall + "L B90\nM128\nL C90\n"), "0 1 0");
  EXPECT_EQ(direction(kCall + "L B90\nM128\nL IB-90\n"), "0 0 1");
  // A vector does not change them.
  EXPECT_EQ(direction(kCall + "M128\nL B90\n" + vector + "\nL C90\n"), "0 1 0");
  // M129 at the end of its block, FUNCTION RESET TCPM at once.
  EXPECT_EQ(direction(kCall + "M128\nL B90 M129\n"), "1 0 0");
  EXPECT_EQ(direction(kCall + "M128\nL B90 M129\nL X1\n"), "0 0 1");
  EXPECT_EQ(direction(kCall + "M128\nL B90\nFUNCTION RESET TCPM\nL X1\n"), "0 0 1");
  EXPECT_EQ(direction(kCall + "M128\nL B90\nFUNCTION TCPM OFF\nM128\nL X1\n"), "1 0 0");
  EXPECT_EQ(direction(kCall + "L B90 M128 M129\nL X1\n"), "0 0 1");
  // Rz(C) Ry(B) Rx(A) e: A90 turns Z to -Y, then B nothing, then C90 to +X.
  EXPECT_EQ(direction(kCall + "M128\nL A90 B45 C90\n"), "1 0 0");
}

TEST(ModelKlartextState, ToolAxis) {
  EXPECT_EQ(direction("TOOL CALL 1 X\nL X1\n"), "1 0 0");
  EXPECT_EQ(direction("TOOL CALL 1 Y\nTOOL CALL 1\nL X1\n"), "0 1 0");
  EXPECT_EQ(direction("TOOL CALL 1 X\nM128\nL C90\n"), "0 1 0");
  // Under TCPM the tool stays where it is; the axis counts with the next rotary word, or when TCPM ends.
  EXPECT_EQ(direction(kCall + "M128\nL B90\nTOOL CALL Y\nL X1\n"), "1 0 0");
  EXPECT_EQ(direction(kCall + "M128\nL B90\nTOOL CALL Y\nL B0\n"), "0 1 0");
  EXPECT_EQ(direction(kCall + "M128\nTOOL CALL Y\nM129\nL X1\n"), "0 1 0");
}

TEST(ModelKlartextState, ReferencePoint) {
  const auto point = [](const std::string& program) { return shown(last_move(kTools, program).point, 6); };
  const std::string tcpm = "TOOL CALL 2.1\nFUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS ";
  EXPECT_EQ(point(tcpm + "REFPNT CNT-CNT\nL X1\n"), "1 0 -2");
  EXPECT_EQ(point(tcpm + "REFPNT CENTER-CENTER\nL X1\n"), "1 0 -2");
  EXPECT_EQ(point(tcpm + "REFPNT TIP-CNT\nL X1\n"), "1 0 0");
  EXPECT_EQ(point(tcpm + "REFPNT CNT-CNT\nFUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\nL X1\n"), "1 0 0");
  EXPECT_EQ(point(tcpm + "REFPNT CNT-CNT\nL X1 M128\n"), "1 0 0");
  EXPECT_EQ(point(tcpm + "REFPNT CNT-CNT\nM129\nL X1\n"), "1 0 0");
}

TEST(ModelKlartextState, AlarmsUnderTcpm) {
  EXPECT_EQ(story(kTools, "M128\nTOOL CALL 9\n"), (Lines{"2 E_TCPM_TOOLCALL"}));
  EXPECT_EQ(story(kTools, "M128\nTOOL CALL S100\nL X1\n"), (Lines{"3 1 0 0"}));
  EXPECT_EQ(story(kTools, "M128\nL X1 M91\n"), (Lines{"2 E_TCPM_M91"}));
  EXPECT_EQ(story(kTools, "M91 M128\n"), (Lines{"1 E_TCPM_M91"}));
  EXPECT_EQ(story(kTools, "M128\nL X1 M129 M92\n"), (Lines{"2 E_TCPM_M91"}));
  EXPECT_EQ(story(kTools, "M128\nM129\nL X1 M91\n"), (Lines{"3 1 0 0"}));
}

TEST(ModelKlartextState, OversizeSwitch) {
  const std::string block = "LN X1 Y0 Z0 NX0 NY0 NZ1 ";
  const std::string call = "TOOL CALL 1 Z DR+1\n";
  EXPECT_EQ(story(kTools, call + block + "M107\n" + block + "M108\n" + block + "\n"),
            (Lines{"2 1 0 0", "3 1 0 0", "4 E_OVERSIZE_DR"}));
  EXPECT_EQ(story(kTools, call + block + "M107 M108\n" + block + "\n"), (Lines{"2 1 0 0", "3 E_OVERSIZE_DR"}));
  // DL > 0 never.
  EXPECT_EQ(story(kTools, "TOOL CALL 1 Z DL+1\n" + block + "\n"), (Lines{"2 1 0 0"}));
}

TEST(ModelKlartextState, PositionsAndDatumShift) {
  const std::string start = "[position]\nX = 7\nB = 30\n";
  EXPECT_EQ(story(kTools + start, "L IX1 Y2\nL IX-0.5 IY+1\n"), (Lines{"1 8 2 0", "2 7.5 3 0"}));
  EXPECT_EQ(story(kTools,
                  "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+10\nCYCL DEF 7.2 IY+5\nL IX1\nL X1 Y1\n"
                  "CYCL DEF 7.1 IX+1\nL X1\nL X1 M91\nL IX1 M91\nL X1\n"),
            (Lines{"4 1 0 0", "5 11 6 0", "7 12 6 0", "8 1 6 0", "9 2 6 0", "10 12 6 0"}));
  // Rotary axes start at 0 whatever the setup says.
  EXPECT_EQ(shown(*last_move(kTools + start, "M128\nL IB90\n").tool_axis), "1 0 0");
}

TEST(ModelKlartextState, Parameters) {
  EXPECT_EQ(story(kTools, "Q1 = +5.5\nFN 0: Q2 = -Q1\nQL1 = 3\nL X+Q1 Y-Q2 Z+QL1\nL X+Q3 Y+QR1\n"),
            (Lines{"4 5.5 5.5 3", "5 0 0 3"}));
  EXPECT_EQ(axes("Q7 = 2\nTOOL CALL 1 DL+Q7\nL X1\n"), "1 0 2.5");
}

TEST(ModelKlartextState, Feed) {
  const auto feeds = [](const std::string& program) {
    std::string list;
    for (const model::Event& event : moves(run_klartext(kTools, program)))
      list += (list.empty() ? "" : " ") + (event.feed ? event.feed->decimal(3) : std::string("-")) +
              (event.type == spec::MoveType::rapid ? "!" : "");
    return list;
  };
  EXPECT_EQ(feeds("L X1\nL X2 F100\nL X3 FMAX\nL X4\n"), "- 100 -! 100");
  EXPECT_EQ(feeds("TOOL CALL 1 Z F500\nL X1\nL X2 F100\nL X3 F AUTO\n"), "500 100 500");
  EXPECT_EQ(feeds("TOOL CALL 1 Z F500\nL X1 FZ0.1\nL X2 FAUTO\nL F7\nL X3 FU1\nL X4\n"), "- 500 - -");
  EXPECT_EQ(feeds("BEGIN PGM A INCH\nTOOL CALL 1 Z F500\nL X1\nL X2 F33\n"), "50 3.3");
}

TEST(ModelKlartextState, Units) {
  const std::string inch = "BEGIN PGM A INCH\nTOOL CALL 1 Z\nL X1\n";
  // 0.5 mm and 100.5 mm in inches, exactly 5/127 each mm.
  EXPECT_EQ(last_move(kTools, inch).axes[2].rational(), exact::Rational(5, 254));
  EXPECT_EQ((*last_move(kTools, inch).space->carrier)[2].rational(), exact::Rational(1005, 254));
  EXPECT_EQ(last_move("units = \"inch\"\n" + kTools, "TOOL CALL 1 Z\nL X1\n").axes[2].rational(),
            exact::Rational(5, 254));
  // The position of the setup is in units of the setup.
  EXPECT_EQ(story(kTools + "[position]\nX = 254\n", "BEGIN PGM A INCH\nL Y1\n"), (Lines{"2 10 1 0"}));
  EXPECT_EQ(story("units = \"inch\"\n" + kTools + "[position]\nX = 10\n", "BEGIN PGM A MM\nL Y1\n"),
            (Lines{"2 254 1 0"}));
}

TEST(ModelKlartextState, EndsOfTheProgram) {
  EXPECT_EQ(story(kTools, "L X1 M30\nL X2\n"), (Lines{"1 1 0 0"}));
  EXPECT_EQ(story(kTools, "L X1\nM2\nL X2\n"), (Lines{"1 1 0 0"}));
  EXPECT_EQ(story(kTools, "BEGIN PGM A MM\nL X1\nEND PGM A MM\nL X2\n"), (Lines{"2 1 0 0"}));
}

TEST(ModelKlartextState, OwnMoves) {
  EXPECT_EQ(story(kTools, "L X0\nL B0\nL F100 M3\nLN X0 Y0 Z0 TX0 TY0 TZ1\n").size(), 3U);  // E_NO_TOOL at last
  EXPECT_EQ(story(kTools, "L U5 X1\n"), (Lines{"1 E_SYNTAX"}));
  const model::Event event = last_move("axes = [\"X\", \"Y\", \"Z\", \"U\", \"B\"]\n" + kTools, kCall + "L U5 X1\n");
  EXPECT_EQ(event.point[3].decimal(3), "5");
  EXPECT_EQ(event.axes[3].decimal(3), "5");
  EXPECT_FALSE(event.axes.has(4));
}

// The manual's blocks in sequence.
TEST(ModelKlartextState, ExampleProgram) {
  const std::string ball = tool("R = 3\nR2 = 3\nDL = 0\nDR = \"-0.1\"\nDR2 = \"-0.1\"\n");
  EXPECT_EQ(story(ball, R"(0 BEGIN PGM HHFACE MM
1 BLK FORM 0.1 Z X-50 Y-50 Z-20
2 BLK FORM 0.2 X+50 Y+50 Z+0
3 TOOL CALL 1 Z S12000 F1000
4 L Z+100 R0 FMAX M3
5 L X+36.0084 Y+6.177 Z-1.9209 R0
6 LN X+36.0084 Y+6.177 Z-1.9209 NX-0.4658107 NY+0 NZ+0.8848844 R0
7 LN X+36.0084 Y+6.177 Z-1.9209 NX-0.4658107 NY+0 NZ+0.8848844 TX+0.0000000 TY+0.6558846 TZ+0.7548612 R0 M128
8 LN X+36.0084 Y+6.177 Z-1.9209 NX-0.4658107 NY+0 NZ+0.8848844 R0
9 L Z+100 R0 FMAX M129
10 M30
11 END PGM HHFACE MM
)",
                  15),
            (Lines{"5 0 0 100", "6 36.0084 6.177 -1.9209", "7 36.054981069776461 6.177 -1.909388439575351",
                   "8 36.054981069776461 6.24258845869536 -1.933902321076868", "9 36.0084 6.177 -1.9209",
                   "10 36.0084 6.177 100"}));
}

TEST(ModelKlartextState, WrongSetup) {
  spec::Setup setup;
  model::Recorder recorder;
  test::Collector sink;
  EXPECT_THROW(model::klartext::Engine(setup, recorder, sink), spec::InputError);
}

}  // namespace

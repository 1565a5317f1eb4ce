// SPDX-License-Identifier: Apache-2.0
// The state of a Klartext program in the fast engine. Expected values by hand from heidenhain.program.*.
#include "tests/unit/heidenhain/fast_klartext_run.h"

namespace toolcomp::fast::klartext {
namespace {

const std::string kTools =
    "[[tool]]\nnumber=1\nR=3\nR2=3\nL=100\nDL=0.5\nDR=\"-0.1\"\nDR2=\"-0.1\"\n"
    "[[tool]]\nnumber=\"5.1\"\nname=\"BALL 2\"\nR=2\nR2=2\n"
    "[[correction.tcs]]\nnumber=4\nDL=0.25\n";
const std::string kCall = "TOOL CALL 1 Z\n";

TEST(Klartext, InitialState) {
  const KlartextRun run(kTools + "[position]\nX=1\nZ=\"2.5\"\nB=30\n", "L Y3\n");
  ASSERT_EQ(run.messages(), "");
  EXPECT_EQ(run.tip(0), (Triple{1, 3, 2.5}));
  EXPECT_EQ(run.tool_axis(0), (Triple{0, 0, 1}));
  EXPECT_EQ(run.center(0), (Triple{1, 3, 2.5}));
  EXPECT_FALSE(run.moves[0].feed.has_value());
  EXPECT_FALSE(run.moves[0].space->carrier.has_value());
  EXPECT_EQ(run.moves[0].type, spec::MoveType::linear);
  // Rotary axes are at 0 at the start.
  EXPECT_EQ(KlartextRun(kTools + "[position]\nB=30\n", "M128\nL C90\n").tool_axis(0), (Triple{0, 0, 1}));
}

TEST(Klartext, WithoutCompensation) {
  const KlartextRun run(kTools, kCall + "L X36.0084 Y6.177 Z-1.9209 R0\n");  // E7
  EXPECT_EQ(run.tip(0), run.programmed(0));
  EXPECT_EQ(run.shift(0), (Triple{0, 0, 0}));
  EXPECT_EQ(run.tool_shift(0), (Triple{0, 0, 0.5}));
  expect_triple(run.axes(0), {36.0084, 6.177, -1.4209});
  expect_triple(run.center(0), {36.0084, 6.177, 0.9791});
  expect_triple(*run.moves[0].space->carrier, {36.0084, 6.177, 98.5791}, 100);
  // Under CNT-CNT the tip lies R2 of the table below.
  const KlartextRun center(kTools, kCall + "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT CNT-CNT\nL X0 A90\n");
  expect_triple(center.tool_axis(0), {0, -1, 0});
  expect_triple(center.tip(0), {0, 3, 0});
  expect_triple(center.center(0), {0, 0.1, 0});
}

// heidenhain.program.no-compensation: TCP' = TIP' + R2' t without a normal too. Toroid of E11, R2 = 1, dR2 = -0.02, and
// 0.1 more of the TOOL CALL: R2' = 0.98 and 1.08; by hand.
TEST(Klartext, ToolCenterOfBlocksWithoutNormal) {
  const std::string toroid = "[[tool]]\nnumber=1\nR=6\nR2=1\nDL=0.05\nDR=\"-0.1\"\nDR2=\"-0.02\"\n";
  const auto expect = [&](const std::string& program, const Triple& tip, const Triple& center) {
    const KlartextRun run(toroid, program);
    ASSERT_FALSE(run.moves.empty()) << program;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(run.tip(run.last())[i], tip[i], 1e-14) << program;
      EXPECT_NEAR(run.center(run.last())[i], center[i], 1e-14) << program;
    }
  };
  expect(kCall + "L X1 Y2 Z3 R0\n", {1, 2, 3}, {1, 2, 3.98});
  expect("TOOL CALL 1 Z DR2+0.1\nL X1 Y2 Z3 R0\n", {1, 2, 3}, {1, 2, 4.08});
  expect(kCall + "M128\nLN X1 Y2 Z3 TX0 TY0.6 TZ0.8 R0\n", {1, 2, 3}, {1, 2.588, 3.784});
  expect(kCall + "M128\nL X1 B90 R0\n", {1, 0, 0}, {1.98, 0, 0});
  // CNT-CNT: the tip is R2 of the table below the programmed point, the centre dR2 above it.
  const std::string cnt = kCall + "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT CNT-CNT\n";
  expect(cnt + "L X1 Y2 Z3 R0\n", {1, 2, 2}, {1, 2, 2.98});
  expect(cnt + "LN X1 Y2 Z3 TX0 TY0.6 TZ0.8 R0\n", {1, 1.4, 2.2}, {1, 1.988, 2.984});
}

TEST(Klartext, Units) {
  // Setup in mm, program in inches: tables and the position of the setup are converted.
  const KlartextRun inch("[[tool]]\nnumber=1\nR=1\nDL=12.7\n[position]\nX=25.4\n",
                         "BEGIN PGM A INCH\nTOOL CALL 1 Z DL0.25 F300\nL Y1 FAUTO\nEND PGM A INCH\n");
  EXPECT_EQ(inch.tip(0), (Triple{1, 1, 0}));
  expect_triple(inch.axes(0), {1, 1, 0.75});
  EXPECT_EQ(inch.moves[0].feed, 30.0);
  // Without BEGIN PGM the units of the setup; the tables are in mm still.
  const KlartextRun setup("units=\"inch\"\n[[tool]]\nnumber=1\nR=1\nDL=12.7\n[position]\nX=2\n", kCall + "L Y1\n");
  expect_triple(setup.axes(0), {2, 1, 0.5});
  const KlartextRun mm("units=\"inch\"\n[position]\nX=2\n", "BEGIN PGM A MM\nL Y1\n");
  expect_triple(mm.tip(0), {50.8, 1, 0});
}

TEST(Klartext, Parameters) {
  const KlartextRun run(kTools, "Q1 = +5.5\nFN 0: Q2 = -Q1\nQL3 = 7\nQR3 = 8\nL X+Q1 Y-Q2 Z-Q9\nL X+QL3 YQR3\n");
  EXPECT_EQ(run.messages(), "");
  EXPECT_EQ(run.tip(0), (Triple{5.5, 5.5, 0}));
  EXPECT_EQ(run.tip(1), (Triple{7, 8, 0}));
}

TEST(Klartext, PositionsAndDatumShift) {
  const KlartextRun run(kTools,
                        "L X10 Y20\nL IX1.5 IY-1\nCYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X100\nCYCL DEF 7.2 IZ5\n"
                        "L IX1 Y2\nL X3\nL X4 Z1 M91\nCYCL DEF 7.0\nCYCL DEF 7.1 IX1\nL X0 Z0\n");
  EXPECT_EQ(run.messages(), "");
  EXPECT_EQ(run.tip(1), (Triple{11.5, 19, 0}));
  EXPECT_EQ(run.tip(2), (Triple{12.5, 2, 0}));
  EXPECT_EQ(run.tip(3), (Triple{103, 2, 0}));
  EXPECT_EQ(run.tip(4), (Triple{4, 2, 1}));
  EXPECT_EQ(run.tip(5), (Triple{101, 2, 5}));
}

TEST(Klartext, ExactSums) {
  std::string program = "L X0\n";
  for (int i = 0; i < 10; ++i) program += "L IX0.1\n";
  const KlartextRun run("", program);
  EXPECT_EQ(run.tip(run.last())[0], 1.0);
}

TEST(Klartext, ToolCall) {
  EXPECT_EQ(KlartextRun(kTools, "TOOL CALL 2 Z\n").messages(), "E_NO_TOOL@1");
  EXPECT_EQ(KlartextRun(kTools, "TOOL CALL QS1 Z\n").messages(), "E_NO_TOOL@1");
  EXPECT_EQ(KlartextRun(kTools, kCall + "M128\nTOOL CALL 2 Z\n").messages(), "E_TCPM_TOOLCALL@3");
  // Without a tool it may stand under TCPM, and replaces what it names.
  const KlartextRun call(kTools,
                         "TOOL CALL 1 Z DL1 DR-0.1\nM128\nTOOL CALL DL2 S100\nL X0\nTOOL CALL F70\nL X1\n"
                         "M129\nTOOL CALL 1 Z\nL X2\n");
  EXPECT_EQ(call.messages(), "");
  EXPECT_EQ(call.tool_shift(0), (Triple{0, 0, 2.5}));
  EXPECT_EQ(call.tool_shift(1), (Triple{0, 0, 2.5}));
  EXPECT_EQ(call.moves[1].feed, 70.0);
  EXPECT_EQ(call.tool_shift(2), (Triple{0, 0, 0.5}));
  const KlartextRun named(kTools,
                          "TOOL CALL \"BALL 2\" Z\nL X0\nTOOL CALL 5.1 Z\nL X0\nTOOL CALL 0 Z\nL X0\n"
                          "LN X0 Y0 Z0 NX0 NY0 NZ1\n");
  EXPECT_EQ(named.messages(), "");
  EXPECT_EQ(named.center(0), (Triple{0, 0, 2}));
  EXPECT_EQ(named.center(1), (Triple{0, 0, 2}));
  EXPECT_EQ(named.center(2), (Triple{0, 0, 0}));
  EXPECT_FALSE(named.moves[2].space->carrier.has_value());
  // A tool call sets R0, one without a tool does not.
  EXPECT_EQ(KlartextRun(kTools, kCall + "L RL\nTOOL CALL S1\nL X1\nTOOL CALL 1\nL X2\n").messages(),
            "heidenhain.peripheral.out-of-scope@4");
}

TEST(Klartext, CorrectionRow) {
  const KlartextRun run(kTools, kCall +
                                    "SEL CORR-TABLE TCS \"a.tco\"\nL X0\nFUNCTION CORRDATA TCS #4\nL X0\n"
                                    "FUNCTION CORRDATA RESET WPL\nTOOL CALL S5\nL X0\nFUNCTION CORRDATA RESET\nL X0\n"
                                    "FUNCTION CORRDATA TCS #4\nTOOL CALL 1 Z\nL X0\n");
  EXPECT_EQ(run.messages(), "");
  const std::array<double, 5> expected{0.5, 0.75, 0.75, 0.5, 0.5};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(run.tool_shift(i)[2], expected[i]) << i;
}

TEST(Klartext, DirectionOfTheTool) {
  // Rz(C) Ry(B) Rx(A) e; words are remembered while TCPM is off.
  const KlartextRun run(kTools, kCall +
                                    "L B90 C90\nM128\nL X1\nL A0\nL IC90\nL X2\nLN X0 Y0 Z0 NX0 NY0 NZ1 TX0 TY1 "
                                    "TZ0\nL X3\nL IA90\nL X4 M129\nL X5\n");
  EXPECT_EQ(run.messages(), "");
  EXPECT_EQ(run.tool_axis(0), (Triple{0, 0, 1}));
  EXPECT_EQ(run.tool_axis(1), (Triple{0, 0, 1}));  // no rotary word since M128
  EXPECT_EQ(run.tool_axis(2), (Triple{0, 1, 0}));
  EXPECT_EQ(run.tool_axis(3), (Triple{-1, 0, 0}));
  EXPECT_EQ(run.tool_axis(4), (Triple{-1, 0, 0}));
  EXPECT_EQ(run.tool_axis(5), (Triple{0, 1, 0}));  // T of LN
  EXPECT_EQ(run.tool_axis(6), (Triple{0, 1, 0}));  // stays
  // A90 turns ez to (0, −1, 0), which B90 leaves alone and C180 takes to (0, 1, 0).
  EXPECT_EQ(run.tool_axis(7), (Triple{0, 1, 0}));
  EXPECT_EQ(run.tool_axis(8), (Triple{0, 1, 0}));
  EXPECT_EQ(run.tool_axis(9), (Triple{0, 0, 1}));  // M129 from the end of its block
  // LN without T puts the tool along the normal.
  const KlartextRun normal(kTools, kCall + "M128\nLN X0 Y0 Z0 NX0.6 NY0 NZ0.8\nL X1\n");
  EXPECT_TRUE(normal.flat(0));
  expect_triple(normal.tool_axis(1), {0.6, 0, 0.8}, 1);
}

TEST(Klartext, ToolAxis) {
  const KlartextRun run(kTools,
                        "TOOL CALL 1 X\nL X0\nLN X0 Y0 Z0 NX0.6 NY0 NZ0.8\nM128\nL B90\nTOOL CALL Y\nL X1\n"
                        "L C90\nM129\nL X2\n");
  EXPECT_EQ(run.messages(), "");
  EXPECT_EQ(run.tool_axis(0), (Triple{1, 0, 0}));
  EXPECT_EQ(run.axes(0), (Triple{0.5, 0, 0}));
  expect_shift(run.shift(1), {0.04, 0, -0.08});     // dR2 (n − t)
  EXPECT_EQ(run.tool_axis(2), (Triple{0, 0, -1}));  // Ry(90) ex
  EXPECT_EQ(run.tool_axis(3), (Triple{0, 0, -1}));  // the letter turns nothing under TCPM
  EXPECT_EQ(run.tool_axis(4), (Triple{-1, 0, 0}));  // Rz(90) Ry(90) ey
  EXPECT_EQ(run.tool_axis(5), (Triple{0, 1, 0}));
}

TEST(Klartext, FunctionsAtStartAndEnd) {
  const std::string block = "LN X0 Y0 Z0 NX0.6 NY0 NZ0.8 TX0 TY0.6 TZ0.8 ";
  // M107 from the start of its block, M108 from its end.
  const std::string call = "TOOL CALL 1 Z DR0.2\n";
  EXPECT_EQ(KlartextRun(kTools, call + block + "M128 M107\n" + block + "M108\n" + block + "\n").messages(),
            "E_OVERSIZE_DR@4");
  EXPECT_EQ(KlartextRun(kTools, kCall + block + "M128\n" + block + "M129\n" + block + "\n").messages(),
            "W_T_IGNORED@4");
  EXPECT_EQ(KlartextRun(kTools, kCall + "L X1 M30\nL X2\n").moves.size(), 1U);
  EXPECT_EQ(KlartextRun(kTools, kCall + "L X1 M91 M128\n").messages(), "E_TCPM_M91@2");
  EXPECT_EQ(KlartextRun(kTools, kCall + "L X1 M91 M129\nM128\nM92\n").messages(), "E_TCPM_M91@4");
  EXPECT_EQ(KlartextRun(kTools, kCall + "M128\nFUNCTION RESET TCPM\nL X1 M92\n").messages(), "");
}

TEST(Klartext, Feed) {
  const KlartextRun run(kTools,
                        "TOOL CALL 1 Z F800\nL X1\nL X2 F500\nL X3 FMAX\nL X4\nL X5 FAUTO\nL X6 FZ0.1\n"
                        "L X7\nL F20\nL X8\n");
  const std::array<double, 8> expected{800, 500, 0, 500, 800, 0, 0, 20};
  ASSERT_EQ(run.moves.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(run.moves[i].feed.value_or(0), expected[i]) << i;
  EXPECT_EQ(run.moves[2].type, spec::MoveType::rapid);
  EXPECT_EQ(run.moves[3].type, spec::MoveType::linear);
}

TEST(Klartext, AxesOfEvents) {
  const KlartextRun run("axes=[\"C\",\"X\",\"Y\",\"Z\",\"W\",\"A\"]\n",
                        "7 L X1 W5 C30\nL Z2\nLN X0 Y0 Z0 NX0 NY0 NZ1\n");
  EXPECT_EQ(run.messages(), "E_NO_TOOL@3");
  ASSERT_EQ(run.moves.size(), 2U);
  EXPECT_EQ(run.moves[0].n, 7U);
  EXPECT_EQ(run.moves[0].programmed.present, 0b011110);
  EXPECT_EQ(run.moves[0].point.present, 0b011110);
  EXPECT_EQ(run.moves[0].axes.present, 0b011111);
  EXPECT_EQ(run.moves[0].axes[0], 30);
  EXPECT_EQ(run.moves[0].axes[4], 5);
  EXPECT_FALSE(run.moves[1].n.has_value());
  EXPECT_EQ(run.moves[1].axes.present, 0b011110);
  EXPECT_EQ(run.moves[1].axes[4], 5);
}

TEST(Klartext, WarningsAndAlarmsOfReading) {
  EXPECT_EQ(KlartextRun(kTools, "L X1.1234567\nL X1 Y\nL X2\n").messages(), "W_DIGITS@1 E_SYNTAX@2");
  EXPECT_EQ(KlartextRun(kTools, "L X100000000000000000\n").messages(), "POSITION_RANGE@1");
  // Up to 17 digits before the point and 18 behind it are exact.
  const KlartextRun run(kTools, "L X99999999999999999\nL IX.000000000000000001\nL IX-99999999999999999\n");
  EXPECT_EQ(run.tip(2)[0], 1e-18);
}

// A counter holds 2^125 / (127 * 10^18) = 3.349e17 to either side: three times the longest word, not four times.
TEST(Klartext, IncrementalWordsOutgrowTheCounter) {
  for (const char* const sign : {"", "-"}) {
    const std::string longest = std::string("L IX") + sign + "99999999999999999\n";
    const std::string three = longest + longest + longest;
    const std::string warnings = "W_DIGITS@1 W_DIGITS@2 W_DIGITS@3";
    EXPECT_EQ(KlartextRun(kTools, three).messages(), warnings) << sign;
    EXPECT_EQ(KlartextRun(kTools, three + longest + "L X0\n").messages(), warnings + " POSITION_RANGE@4") << sign;
  }
}

}  // namespace
}  // namespace toolcomp::fast::klartext

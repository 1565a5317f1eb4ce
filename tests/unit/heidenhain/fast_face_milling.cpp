// Heidenhain face milling in the fast engine. Expected values: the worked examples of part 7 and the table of part 6 of
// the sheet, typed in, and hand derivations where a comment says so.
#include "tests/unit/heidenhain/fast_klartext_run.h"

namespace toolcomp::fast::klartext {
namespace {

const std::string kBall = "[[tool]]\nnumber=1\nR=3\nR2=3\nDR=\"-0.1\"\nDR2=\"-0.1\"\n";
const std::string kNewBall = "[[tool]]\nnumber=1\nR=3\nR2=3\n";
const std::string kToroid = "[[tool]]\nnumber=1\nR=6\nR2=1\nDL=0.05\nDR=\"-0.1\"\nDR2=\"-0.02\"\n";
const std::string kPoint = "LN X+36.0084 Y+6.177 Z-1.9209 ";
const std::string kN = "NX-0.4658107 NY+0 NZ+0.8848844 ";
const std::string kT = "TX+0.0000000 TY+0.6558846 TZ+0.7548612 ";
const std::string kBlock13 = kPoint + kN + kT + "R0 ";
const std::string kCall = "TOOL CALL 1 Z S12000 F1000\n";
const std::string kOversize = "TOOL CALL 1 Z DL+0.2 DR+0.2 DR2+0.2\nM107\n";
const std::string kCenter = "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT CNT-CNT\n";

TEST(FaceMilling, ReworkedBallAtTheTip) {  // E1
  const KlartextRun run(kBall, kCall + kBlock13 + "M128\n");
  ASSERT_EQ(run.messages(), "");
  expect_shift(run.shift(0), {0.046581069776461, 0.065588458695360, -0.013002321076868});
  expect_shift(run.tool_shift(0), {0.046581069776461, 0.065588458695360, -0.013002321076868});
  expect_triple(run.tip(0), {36.054981069776461, 6.242588458695360, -1.933902321076868});
  expect_triple(run.center(0), {36.054981069776461, 8.144653760860809, 0.255195115379139});
  expect_triple(run.contact(0), {37.405832093293828, 8.144653760860809, -2.310969632306029});
  EXPECT_FALSE(run.flat(0));
  EXPECT_FALSE(run.moves[0].space->contact->angle.has_value());
  EXPECT_FALSE(run.moves[0].space->carrier.has_value());
}

TEST(FaceMilling, ReworkedBallAtTheCenter) {  // E2
  const KlartextRun run(kBall, kCall + kCenter + kBlock13);
  expect_triple(run.center(0), {36.054981069776461, 6.177, -2.009388439575351});
  expect_triple(run.tip(0), {36.054981069776461, 4.274934697834551, -4.198485876031357});
  expect_shift(run.shift(0), {0.046581069776461, 0.065588458695360, -0.013002321076868});
  expect_triple(run.contact(0), {37.405832093293828, 6.177, -4.575553187260518});
  // M128 in the block: at the tip again (D-35).
  const KlartextRun tip(kBall, kCall + kCenter + kBlock13 + "M128\n");
  expect_triple(tip.tip(0), {36.054981069776461, 6.242588458695360, -1.933902321076868});
  // TIP-CNT differs in the point of rotation alone.
  const KlartextRun rotation(kBall, kCall + "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT TIP-CNT\n" + kBlock13);
  expect_triple(rotation.tip(0), {36.054981069776461, 6.242588458695360, -1.933902321076868});
}

TEST(FaceMilling, OversizeAtTheTip) {  // E3
  const KlartextRun run(kNewBall, kOversize + kBlock13 + "M128\n");
  expect_shift(run.shift(0), {-0.093162139552922, -0.131176917390721, 0.026004642153735});
  expect_shift(run.tool_shift(0), {-0.093162139552922, 0, 0.176976879150701});
  expect_triple(run.tip(0), {35.915237860447078, 6.045823082609279, -1.894895357846265});
  expect_triple(run.axes(0), {35.915237860447078, 6.177, -1.743923120849299});
  expect_triple(run.center(0), {35.915237860447078, 8.144653760860809, 0.520660434105191});
  expect_triple(run.contact(0), {37.405832093293828, 8.144653760860809, -2.310969632306029});
  const KlartextRun forbidden(kNewBall, "TOOL CALL 1 Z DL+0.2 DR+0.2 DR2+0.2\n" + kBlock13 + "M128\n");
  EXPECT_EQ(forbidden.messages(), "E_OVERSIZE_DR@2");
}

TEST(FaceMilling, OversizeAtTheCenter) {  // E4
  const KlartextRun run(kNewBall, kOversize + kCenter + kBlock13);
  expect_triple(run.center(0), {35.915237860447078, 6.177, -1.743923120849299});
  expect_triple(run.tip(0), {35.915237860447078, 4.078169321748470, -4.159478912800754});
  expect_triple(run.axes(0), {35.915237860447078, 4.209346239139191, -4.008506675803788});
}

TEST(FaceMilling, WithoutTcpm) {  // E5
  const std::string block = kPoint + kN + "R0\n";
  const KlartextRun run(kBall, kCall + block);
  expect_triple(run.tip(0), {36.054981069776461, 6.177, -1.909388439575351});
  expect_shift(run.shift(0), {0.046581069776461, 0, 0.011511560424649});
  expect_triple(run.contact(0), {37.405832093293828, 6.177, -1.575553187260518});
  const KlartextRun oversize(kNewBall, kOversize + block);
  expect_triple(oversize.tip(0), {35.915237860447078, 6.177, -1.943923120849299});
  expect_triple(oversize.axes(0), {35.915237860447078, 6.177, -1.743923120849299});
  // T is ignored, also where it would be warned of.
  const KlartextRun ignored(kBall, kCall + kPoint + kN + "TX0.5 TY0.5 TZ0.5 R0\n");
  EXPECT_EQ(ignored.messages(), "W_T_IGNORED@2");
  EXPECT_EQ(ignored.tip(0), run.tip(0));
}

TEST(FaceMilling, ToolAlongTheNormal) {  // E6
  const std::string block = kPoint + kN + "R0 M128\n";
  const KlartextRun run(kBall, kCall + block);
  expect_shift(run.shift(0), {0, 0, 0});
  EXPECT_EQ(run.tip(0), run.programmed(0));
  EXPECT_TRUE(run.flat(0));
  expect_triple(run.center(0), {34.657548976482633, 6.177, 0.645264747685168});
  const KlartextRun oversize(kNewBall, kOversize + block);
  EXPECT_EQ(oversize.tip(0), oversize.programmed(0));
  expect_shift(oversize.tool_shift(0), {-0.093162139552922, 0, 0.176976879150701});
  expect_triple(oversize.axes(0), {35.915237860447078, 6.177, -1.743923120849299});
}

TEST(FaceMilling, FlankByNormal) {  // E8
  const KlartextRun run(
      "[[tool]]\nnumber=1\nR=6\nDR=\"-0.1\"\n",
      kCall + "LN X60.6593 Y102.4690 Z-7.1012 NX0.0000 NY0.9397 NZ0.3420 TX-0.0807 TY-0.3409 TZ0.9366 R0 M128\n");
  EXPECT_EQ(run.messages(), "");
  expect_shift(run.shift(0), {0.000000214108896, -0.093969091346891, -0.034202483409745});
  expect_triple(run.tip(0), {60.659300214108896, 102.375030908653109, -7.135402483409745});
  // 96.83 and 60.66 are sums with 102.47.
  expect_triple(run.contact(0), {60.659312846533784, 96.830854519186560, -9.153349004584695}, 6);
}

TEST(FaceMilling, Toroid) {  // E11
  const KlartextRun run(kToroid, kCall + kBlock13 + "M128\n");
  expect_shift(run.shift(0), {0.059390409959017, 0.060213860946861, -0.043521433662979});
  expect_shift(run.tool_shift(0), {0.059390409959017, 0.093008090294541, -0.005778374413738});
  expect_triple(run.tip(0), {36.067790409959017, 6.237213860946861, -1.964421433662979});
  expect_triple(run.axes(0), {36.067790409959017, 6.270008090294541, -1.926678374413738});
  expect_triple(run.contact(0), {39.603847947997413, 9.776395162440404, -4.608483801244025});
  expect_triple(run.center(0), {36.067790409959017, 6.879980756161392, -1.224657472377846});
  const KlartextRun center(kToroid, kCall + kCenter + kBlock13);
  expect_triple(center.center(0), {36.067790409959017, 6.224096169207789, -1.979518657362676});
  expect_triple(center.tip(0), {36.067790409959017, 5.581329273993258, -2.719282618647809});
  const KlartextRun off(kToroid, kCall + kPoint + kN + "R0\n");
  expect_triple(off.tip(0), {36.097716213955292, 6.177, -1.918597687915070});
  EXPECT_NEAR(off.axes(0)[2], -1.868597687915070, 1e-15);
  expect_triple(off.contact(0), {41.474210697764609, 6.177, -1.805784395753506});
  const KlartextRun along(kToroid, kCall + kPoint + kN + "R0 M128\n");
  expect_shift(along.shift(0), {0, 0, 0});
  expect_shift(along.tool_shift(0), {-0.023290534888230, 0, 0.044244219787675});
}

TEST(FaceMilling, NormalAlongTheTool) {  // E13
  const std::string point = "LN X10 Y20 Z5 ";
  const KlartextRun run(kToroid, kCall + point + "NX0 NY0 NZ1 TX0 TY0 TZ1 R0 M128\n");
  EXPECT_TRUE(run.flat(0));
  expect_triple(run.tip(0), {10, 20, 5});
  expect_triple(run.axes(0), {10, 20, 5.05});
  const KlartextRun contour(kToroid,
                            kCall + "FUNCTION PROG PATH IS CONTOUR\n" + point + "NX0 NY0 NZ1 TX0 TY0 TZ1 R0 M128\n");
  expect_triple(contour.tip(0), {10, 20, 5});
  const KlartextRun near(kToroid, kCall + point + "NX0.0000001 NY0 NZ1 TX0 TY0 TZ1 R0 M128\n");
  EXPECT_FALSE(near.flat(0));
  expect_shift(near.shift(0), {-0.080000002000000, 0, 0});
  // As near as 17 decimals come: u is whole still.
  const KlartextRun nearest(kToroid, kCall + point + "NX0.00000000000000001 NY0 NZ1 TX0 TY0 TZ1 R0 M128\n");
  EXPECT_EQ(nearest.messages(), "W_DIGITS@2");
  EXPECT_FALSE(nearest.flat(0));
  expect_shift(nearest.shift(0), {-0.08, 0, 0});
  // Opposite: the same formulas, and a warning.
  const KlartextRun opposite(kToroid, kCall + point + "NX0 NY0 NZ-1 TX0 TY0 TZ1 R0 M128\n");
  EXPECT_TRUE(opposite.flat(0));
  EXPECT_EQ(opposite.messages(), "W_N_BELOW@2");
}

TEST(FaceMilling, NearTheToolNothingIsLost) {
  // T = (0.28, 0.48, 0.83138439), N beside it by 1e-8 in X: u is the part of (1, 0, 0) across T, by hand from
  // (1, 0, 0) − t (t.x), with t unit: |T|² = 0.28² + 0.48² + 0.83138439² = 1.000 000 004 ….
  const KlartextRun run(kToroid, kCall +
                                     "LN X0 Y0 Z0 NX0.28000001 NY0.48 NZ0.83138439 TX0.28 TY0.48 TZ0.83138439 R0 "
                                     "M128\n");
  const double x = 0.28;
  const double y = 0.48;
  const double z = 0.83138439;
  const double square = x * x + y * y + z * z;
  const double w = std::sqrt((1 - x * x / square) * (1 - x * x / square) + x * x * (y * y + z * z) / square / square);
  const Triple u{(1 - x * x / square) / w, -x * y / square / w, -x * z / square / w};
  // (rho' − rho) u; dR2 (n − t) is below 2e-10.
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(run.shift(0)[i], -0.08 * u[i], 3e-10);
}

TEST(FaceMilling, RationalExample) {  // E16
  const std::string tool = "[[tool]]\nnumber=1\nR=5\nR2=2\nDL=0.25\nDR=0.3\nDR2=0.1\n";
  const std::string block = "LN X0 Y0 Z0 NX0.6 NY0 NZ0.8 R0 M107\n";
  const KlartextRun run(tool, kCall + block);
  expect_shift(run.shift(0), {13.0 / 50, 0, -1.0 / 50});
  expect_shift(run.tool_shift(0), {13.0 / 50, 0, 23.0 / 100});
  expect_triple(run.contact(0), {-21.0 / 5, 0, 2.0 / 5});
  expect_triple(run.center(0), {13.0 / 50, 0, 52.0 / 25});
  const KlartextRun contour(tool, kCall + "FUNCTION PROG PATH IS CONTOUR\n" + block);
  expect_triple(contour.tip(0), {223.0 / 50, 0, -21.0 / 50});
  expect_triple(contour.axes(0), {223.0 / 50, 0, -17.0 / 100});
  EXPECT_EQ(contour.contact(0), (Triple{0, 0, 0}));
  expect_shift(contour.shift(0), {13.0 / 50, 0, -1.0 / 50});
}

TEST(FaceMilling, CornerDeltaAlone) {  // E21
  const KlartextRun run(kNewBall, "TOOL CALL 1 Z S5000 DR2:+0.3\nM107\n" + kBlock13 + "M128\n");
  expect_shift(run.shift(0), {-0.139743209329383, -0.196765376086081, 0.039006963230603});
  expect_triple(run.center(0), {35.868656790670617, 8.144653760860809, 0.609148873680541});
}

TEST(FaceMilling, SumOfDeltas) {  // E23
  const std::string tool =
      "[[tool]]\nnumber=1\nR=3\nR2=3\nL=100\nDL=\"-0.03\"\nDR=\"-0.1\"\nDR2=\"-0.1\"\n"
      "[[correction.tcs]]\nnumber=7\nDL=\"-0.005\"\nDR=0.01\nDR2=0.01\n";
  const KlartextRun run(tool,
                        "TOOL CALL 1 Z DL+0.2 DR+0.2 DR2+0.2\nFUNCTION CORRDATA TCS #7\nM107\n" + kBlock13 + "M128\n");
  expect_shift(run.tool_shift(0), {-0.051239176754107, 0.036073652282448, 0.138854648707051});
  expect_triple(run.tip(0), {35.957160823245893, 6.104852695435104, -1.906597446815446});
  expect_triple(run.axes(0), {35.957160823245893, 6.213073652282448, -1.782045351292949});
  // The carrier is 100 above the tip of a tool of table length; sums with 100 t.
  const Triple tip = run.axes(0);
  const Triple t = run.tool_axis(0);
  expect_triple(*run.moves[0].space->carrier, {tip[0] + 100 * t[0], tip[1] + 100 * t[1], tip[2] + 100 * t[2]}, 100);
}

TEST(FaceMilling, Undercut) {  // E25
  const KlartextRun run(kBall, kCall + "LN X0 Y0 Z0 NX0.6 NY0 NZ-0.8 R0\n");
  EXPECT_EQ(run.messages(), "W_N_BELOW@2");
  expect_shift(run.shift(0), {-0.06, 0, 0.18});
}

TEST(FaceMilling, InchProgram) {  // E27
  const KlartextRun run(
      kBall, "BEGIN PGM E27 INCH\n" + kCall + "LN X1.4176535 Y0.2431890 Z-0.0756260 " + kN + kT + "R0 F100 M128\n");
  expect_shift(run.shift(0), {0.001833900384900, 0.002582222783282, -0.000511902404601});
  expect_triple(run.tip(0), {1.419487400384900, 0.245771222783282, -0.076137902404601}, 0.25);
  EXPECT_EQ(run.moves[0].feed, 10.0);  // tenths of an inch a minute
}

// The table of part 6: tool R R2, deltas, and the verdicts N with M108, N with M107, T alone with M108.
TEST(FaceMilling, Verdicts) {
  struct Row {
    const char* r;
    const char* r2;
    const char* dr;
    const char* dr2;
    const char* checked;
    const char* permitted;
    const char* without_normal;
  };
  const std::array<Row, 9> rows{{
      {"3", "3", "-0.1", "-0.1", "", "", ""},
      {"3", "3", "0.2", "0.2", "E_OVERSIZE_DR@2", "", "E_OVERSIZE_DR@2"},
      {"3", "3", "0", "0.3", "E_OVERSIZE_DR2@2", "", ""},
      {"3", "3", "-0.1", "0", "E_R2_GT_R@2", "", ""},
      {"3", "3", "0", "-0.1", "", "", ""},
      {"6", "0", "-0.1", "0", "", "", ""},
      {"6", "1", "0", "-1.1", "E_R2_NEG@2", "E_R2_NEG@2", "E_R2_NEG@2"},
      {"6", "1", "-5.5", "0", "E_R2_GT_R@2", "", ""},
      {"6", "0", "0.2", "0.2", "E_OVERSIZE_DR@2", "", "E_OVERSIZE_DR@2"},
  }};
  const auto quoted = [](const char* text) { return "\"" + std::string(text) + "\"\n"; };
  for (const Row& row : rows) {
    const std::string tool = "[[tool]]\nnumber=1\nR=" + quoted(row.r) + "R2=" + quoted(row.r2) +
                             "DR=" + quoted(row.dr) + "DR2=" + quoted(row.dr2);
    SCOPED_TRACE(tool);
    EXPECT_EQ(KlartextRun(tool, kCall + "LN X0 Y0 Z0 NX0.6 NY0 NZ0.8 R0\n").messages(), row.checked);
    EXPECT_EQ(KlartextRun(tool, kCall + "LN X0 Y0 Z0 NX0.6 NY0 NZ0.8 R0 M107\n").messages(), row.permitted);
    const std::string alarm = row.without_normal;
    EXPECT_EQ(KlartextRun(tool, kCall + "LN X0 Y0 Z0 TX0 TY0 TZ1 R0 M128\n").messages(),
              alarm.empty() ? "W_NO_LATERAL@2" : alarm);
  }
}

TEST(FaceMilling, VerdictsInOrder) {
  const auto verdict = [](const std::string& tool, const std::string& words = "NX0.6 NY0 NZ0.8 R0") {
    return KlartextRun("[[tool]]\nnumber=1\n" + tool, kCall + "LN X0 Y0 Z0 " + words + "\n").messages();
  };
  EXPECT_EQ(verdict("R=\"-1\"\nDR=0.2\n"), "E_TOOL@2");
  EXPECT_EQ(verdict("R=1\nR2=2\nDR=\"-3\"\n"), "E_TOOL@2");
  EXPECT_EQ(verdict("R=1\nR2=\"-1\"\n"), "E_TOOL@2");
  EXPECT_EQ(verdict("R=1\nDR=\"-1.1\"\nDR2=\"-1\"\n"), "E_TOOL_EFF@2");
  EXPECT_EQ(verdict("R=1\nDR=\"-1\"\n"), "");
  EXPECT_EQ(verdict("R=\"-1\"\n", "NX0.6 NY0 NZ0.8 RL"), "E_RC_WITH_N@2");
  EXPECT_EQ(KlartextRun("", "LN X0 Y0 Z0 NX0.6 NY0 NZ0.8 RL\n").messages(), "E_NO_TOOL@1");
  // Exact sums: 0.3 - 0.1 - 0.2 is 0, which no sum of doubles is.
  EXPECT_EQ(KlartextRun("[[tool]]\nnumber=1\nR=1\nDR=0.3\n[[correction.tcs]]\nnumber=1\nDR=\"-0.2\"\n",
                        "TOOL CALL 1 Z DR-0.1\nFUNCTION CORRDATA TCS #1\nLN X0 Y0 Z0 NX0.6 NY0 NZ0.8\n")
                .messages(),
            "");
}

// |v.v − 1| against 0.0002: 0.9999² = 0.99980001, and 0.9998² + 0.02² = 1.00000004 − 0.0000…; by hand.
TEST(FaceMilling, Normalization) {
  const auto warnings = [](const std::string& words) {
    return KlartextRun(kBall, kCall + "LN X0 Y0 Z0 " + words + "\n").messages();
  };
  EXPECT_EQ(warnings("NX0 NY0 NZ0.9999 R0"), "");
  EXPECT_EQ(warnings("NX0 NY0 NZ0.9998 R0"), "W_NOT_NORMALIZED@2");
  // 1.0002 = 0.0001² · 2 + 1.0002 − 2e-8: 0.01² + 0.01² + 1² is 1.0002, no more.
  EXPECT_EQ(warnings("NX0.01 NY0.01 NZ1 R0"), "");
  EXPECT_EQ(warnings("NX0.01 NY0.01000001 NZ1 R0"), "W_NOT_NORMALIZED@2");
  EXPECT_EQ(warnings("NX0.0100000000000001 NY0.01 NZ1 R0"), "W_DIGITS@2 W_NOT_NORMALIZED@2");
  EXPECT_EQ(warnings("NX0 NY0 NZ2 TX0 TY1 TZ2 R0 M128"), "W_NOT_NORMALIZED@2 W_NOT_NORMALIZED@2");
}

// n.t against −0.0002 with t = (0, 0, 1): N = (0.99999998, 0, −0.0002) is nearer, (0.99999997, 0, −0.00020000 …)
// beyond.
TEST(FaceMilling, Below) {
  const auto warnings = [](const std::string& words) {
    return KlartextRun(kBall, kCall + "LN X0 Y0 Z0 " + words + " R0\n").messages();
  };
  // (N.T)² = 4e-8, 4e-8 N.N = 4e-8 (x² + 4e-8): beyond where x² < 1 − 4e-8, that is x < 0.99999998 (x² = 0.99999996 +
  // 4e-16 > 0.99999996).
  EXPECT_EQ(warnings("NX0.99999998 NY0 NZ-0.0002"), "");
  EXPECT_EQ(warnings("NX0.99999997 NY0 NZ-0.0002"), "W_N_BELOW@2");
}

TEST(FaceMilling, ContactJump) {
  const std::string head = kCall + "M128\n";
  const auto block = [](const std::string& n) { return "LN X0 Y0 Z0 " + n + " TX0 TY0 TZ1 R0\n"; };
  const std::string right = block("NX0.6 NY0 NZ0.8");
  const std::string left = block("NX-0.6 NY0 NZ0.8");
  const std::string back = block("NX0 NY0.6 NZ0.8");
  const std::string flat = block("NX0 NY0 NZ1");
  EXPECT_EQ(KlartextRun(kToroid, head + right + left).messages(), "W_CONTACT_JUMP@4");
  EXPECT_EQ(KlartextRun(kToroid, head + right + back).messages(), "");  // a quarter exactly
  EXPECT_EQ(KlartextRun(kToroid, head + right + block("NX-0.00000001 NY0.6 NZ0.8")).messages(), "W_CONTACT_JUMP@4");
  EXPECT_EQ(KlartextRun(kToroid, head + right + block("NX0.00000001 NY0.6 NZ0.8")).messages(), "");
  EXPECT_EQ(KlartextRun(kToroid, head + right + flat + left).messages(), "W_CONTACT_JUMP@4 W_CONTACT_JUMP@5");
  EXPECT_EQ(KlartextRun(kBall, head + right + left).messages(), "");  // no flat
  EXPECT_EQ(KlartextRun(kToroid, head + right + "L X1\n" + left).messages(), "");
  // M129 turns the tool of the block before, not its contact: w = (0.6, 0, 0) and (-1e-16, 0.6, 0).
  EXPECT_EQ(KlartextRun(kToroid, head + "LN X0 Y0 Z0 NX0.6 NY0.8 NZ0 TX0 TY1 TZ0 R0 M129\n" +
                                     "LN X0 Y0 Z0 NX-0.0000000000000001 NY0.6 NZ0.8 TX0 TY0 TZ1 M128\n")
                .messages(),
            "W_DIGITS@4 W_CONTACT_JUMP@4");
  EXPECT_EQ(KlartextRun(kToroid, head + right + "M8\n" + left).messages(), "W_CONTACT_JUMP@5");
  EXPECT_EQ(KlartextRun(kToroid, head + right + "TOOL CALL S100\n" + left).messages(), "");
}

std::string ball_with(const std::string& points, const std::string& more = "") {
  return "[[tool]]\nnumber=1\nR=3\nR2=3\nDR2=5\nDR2TABLE=\"B\"\n" + more +
         "[[dr2table]]\nname=\"B\"\npoints=" + points + "\n";
}

// The manual's sample: 40 degrees 0.03, 50 degrees −0.02, at 45 degrees 0.005. DR2 of the tool does not count.
TEST(FaceMilling, DeviationTable) {
  const std::string at_45 = "LN X0 Y0 Z0 NX1 NY0 NZ1 TX0 TY0 TZ1 R0 M128\n";
  const KlartextRun run(ball_with("[[40, 0.03], [50, \"-0.02\"]]"), kCall + at_45);
  EXPECT_EQ(run.messages(), "W_NOT_NORMALIZED@2");
  EXPECT_DOUBLE_EQ(run.angle(0), 45);
  const double r = std::sqrt(0.5);
  expect_shift(run.shift(0), {0.005 * r, 0, 0.005 * (r - 1)});
  // DR2 of TOOL CALL is added; the ends of the table count, exactly.
  const KlartextRun added(ball_with("[[45, 0.03], [50, 0]]"), "TOOL CALL 1 Z DR2-0.01\n" + at_45);
  expect_shift(added.shift(0), {0.02 * r, 0, 0.02 * (r - 1)});
  EXPECT_EQ(KlartextRun(ball_with("[[45, 0]]"), kCall + at_45).moves.size(), 1U);
  EXPECT_EQ(KlartextRun(ball_with("[[0, 0], [45, 0]]"), kCall + at_45).moves.size(), 1U);
  EXPECT_EQ(KlartextRun(ball_with("[[0, 0], [\"44.999999999999999\", 0]]"), kCall + at_45).messages(),
            "E_3DTC_RANGE@2");
  EXPECT_EQ(KlartextRun(ball_with("[[\"45.000000000000001\", 0], [90, 0]]"), kCall + at_45).messages(),
            "E_3DTC_RANGE@2");
  // R2 + tau = 3 − 6 theta/90 is 0 at 45 degrees exactly, below with the least bit more.
  EXPECT_EQ(KlartextRun(ball_with("[[0, 0], [90, \"-6\"]]"), kCall + at_45).moves.size(), 1U);
  EXPECT_EQ(KlartextRun(ball_with("[[0, 0], [90, \"-6.00000000000001\"]]"), kCall + at_45).messages(), "E_R2_NEG@2");
  // Verdicts: no test of tau without M107, but of the deltas.
  EXPECT_EQ(KlartextRun(ball_with("[[0, 0], [90, 1]]"), "TOOL CALL 1 Z DR2+0.01\n" + at_45).messages(),
            "E_OVERSIZE_DR2@2");
  EXPECT_EQ(KlartextRun("[[tool]]\nnumber=1\nR=3\nR2=1\nDR2TABLE=\"B\"\n[[dr2table]]\nname=\"B\"\npoints=[[0,0]]\n",
                        kCall + at_45)
                .messages(),
            "E_3DTC_SHAPE@2");
  // Along the tool the angle is 0, opposite 180, exactly.
  const KlartextRun along(ball_with("[[0, 0.01]]"), kCall + "LN X0 Y0 Z0 NX0.6 NY0 NZ0.8 R0 M128\n");
  EXPECT_EQ(along.angle(0), 0);
  const KlartextRun opposite(ball_with("[[180, 0.01]]"), kCall + "LN X0 Y0 Z0 NX0 NY0 NZ-1 R0\n");
  EXPECT_EQ(opposite.angle(0), 180);
}

}  // namespace
}  // namespace toolcomp::fast::klartext

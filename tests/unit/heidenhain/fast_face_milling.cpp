// SPDX-License-Identifier: Apache-2.0
// Heidenhain face milling in the fast engine. Expected values: a table of verdicts by the order of checks, and hand
// derivations. The worked examples stand in golden/heidenhain/corpus_examples_face_milling.cpp.
#include "tests/unit/heidenhain/fast_klartext_run.h"

namespace toolcomp::fast::klartext {
namespace {

const std::string kBall = "[[tool]]\nnumber=1\nR=3\nR2=3\nDR=\"-0.1\"\nDR2=\"-0.1\"\n";
const std::string kToroid = "[[tool]]\nnumber=1\nR=6\nR2=1\nDL=0.05\nDR=\"-0.1\"\nDR2=\"-0.02\"\n";
const std::string kCall = "TOOL CALL 1 Z S12000 F1000\n";

TEST(FaceMilling, NormalAlongTheTool) {
  const std::string point = "LN X10 Y20 Z5 ";
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

// Tool R R2, deltas, and the verdicts N with M108, N with M107, T alone with M108.
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

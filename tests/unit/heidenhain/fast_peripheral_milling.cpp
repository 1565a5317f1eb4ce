// SPDX-License-Identifier: Apache-2.0
// Heidenhain peripheral milling by RL and RR in the fast engine, by hand. The worked examples stand in
// golden/heidenhain/corpus_examples_peripheral_milling.cpp.
#include "tests/unit/heidenhain/fast_klartext_run.h"

namespace toolcomp::fast::klartext {
namespace {

const std::string kMill = "[[tool]]\nnumber=1\nR=6\nR2=0\nDR=\"-0.1\"\n";
const std::string kHead = "TOOL CALL 1 Z S12000 F1000\n";

// By hand: the tool along Z, RL, delta = dR = −0.1 (OFF): left of +X is (0, 0, 1) x (1, 0, 0) = (0, 1, 0).
TEST(PeripheralMilling, Square) {
  const KlartextRun run(kMill, kHead + "M128\nL X0 Y0 RL F500\nL X10\nL Y10\nL X0 Y20 R0\nL X1\n");
  ASSERT_EQ(run.messages(), "");
  expect_triple(run.tip(0), {0, -0.1, 0});
  expect_triple(run.tip(1), {10.1, -0.1, 0});  // mitre of (0, 1, 0) and (−1, 0, 0), times −0.1
  expect_triple(run.tip(2), {10.1, 10, 0});    // the last one: its own direction
  expect_triple(run.tip(3), {0, 20, 0});
  EXPECT_EQ(run.moves[0].cause, spec::Cause::start_up);
  EXPECT_EQ(run.moves[1].cause, spec::Cause::programmed);
  EXPECT_EQ(run.moves[2].cause, spec::Cause::programmed);
  EXPECT_EQ(run.moves[3].cause, spec::Cause::cancel);
  EXPECT_EQ(run.moves[4].cause, spec::Cause::programmed);
  EXPECT_EQ(run.moves[0].feed, 500.0);
}

TEST(PeripheralMilling, SideAndTool) {
  // RR is the mirror image; the tool along −X (C90 B-90 from Z … by hand Ry(−90) ez = (−1, 0, 0)): t x d for +Y is
  // (−1, 0, 0) x (0, 1, 0) = (0, 0, −1).
  const KlartextRun right(kMill, kHead + "M128\nL X0 RR\nL X10\nL X20 R0\n");
  expect_triple(right.tip(1), {10, 0.1, 0});
  const KlartextRun turned(kMill, kHead + "M128\nL X0 B-90 RL\nL Y10\nL Y20 R0\n");
  expect_triple(turned.tool_axis(0), {-1, 0, 0});
  expect_triple(turned.tip(0), {0, 0, 0.1});
  expect_triple(turned.tip(1), {0, 10, 0.1});
  // RL to RR: the mitre of (0, 1, 0) and (1, 0, 0).
  const KlartextRun change(kMill, kHead + "M128\nL X0 RL\nL X10\nL Y10 RR\nL Y20 R0\n");
  expect_triple(change.tip(1), {9.9, -0.1, 0});
  // dL moves the real tool along t; under CNT-CNT the tip lies below the programmed point by R2 of the table.
  const std::string ball = "[[tool]]\nnumber=1\nR=3\nR2=2\nL=50\nDL=0.5\nDR=\"-0.1\"\nDR2=\"-0.2\"\n";
  const KlartextRun center(
      ball, kHead + "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT CNT-CNT\nL X0 RL\nL X10\nL X20 R0\n");
  expect_triple(center.tip(1), {10, -0.1, -2});
  expect_triple(center.axes(1), {10, -0.1, -1.5});
  expect_triple(center.center(1), {10, -0.1, -0.2});
  expect_triple(*center.moves[1].space->carrier, {10, -0.1, 48.5});
  expect_shift(center.tool_shift(1), {0, -0.1, 0.5});
  expect_triple(center.tip(2), {20, 0, -2});
  // R2' above it: -2 + 2 - 0.2.
  expect_triple(center.center(2), {20, 0, -0.2});
}

TEST(PeripheralMilling, Directions) {
  const auto messages = [](const std::string& body) { return KlartextRun(kMill, kHead + "M128\n" + body).messages(); };
  EXPECT_EQ(messages("L X0 RL\nL X10\nL X0\nL X-10 R0\n"), "E_REVERSAL@4");
  // Straight on with the other side is a reversal too, there and back with it is none.
  EXPECT_EQ(messages("L X0 RL\nL X10\nL X20 RR\nL X30 R0\n"), "E_REVERSAL@4");
  EXPECT_EQ(messages("L X0 RL\nL X10\nL X0 RR\nL X-10 R0\n"), "");
  EXPECT_EQ(messages("L X0 RL\nL Z10\nL X10 R0\n"), "E_NO_DIRECTION@3");
  EXPECT_EQ(messages("L X0 RL\n"), "E_NO_DIRECTION@3");
  EXPECT_EQ(messages("L X5 RL\n"), "");  // nothing follows: its own direction
  EXPECT_EQ(messages("L X5 RL\nM30\nL Z1\n"), "");
  // Alarm of a block behind: what is held ends as if nothing followed.
  const KlartextRun alarm(kMill, kHead + "M128\nL X5 RL\nTOOL CALL 1 Z\n");
  EXPECT_EQ(alarm.messages(), "E_TCPM_TOOLCALL@4");
  ASSERT_EQ(alarm.moves.size(), 1U);
  expect_triple(alarm.tip(0), {5, -0.1, 0});
  // What moves along the tool keeps the direction made last: plunge in the middle.
  const KlartextRun plunge(kMill, kHead + "M128\nL X0 RL\nL X10\nL Z-5\nL Y10\nL Y20 R0\n");
  ASSERT_EQ(plunge.messages(), "");
  expect_triple(plunge.tip(1), {10, -0.1, 0});
  expect_triple(plunge.tip(2), {10.1, -0.1, -5});
  // A stretch does not know the one before.
  EXPECT_EQ(messages("L X0 RL\nL X10\nL X20 R0\nL X30 RL\nL Z5\n"), "E_NO_DIRECTION@6");
}

// Nearly back: c.c' = −1 + 5e-13, by hand with e = 1e-6 · 1: directions (1, 0, 0) and (−1, e, 0)/|…|.
TEST(PeripheralMilling, NearReversal) {
  const KlartextRun run(kMill, kHead + "M128\nL X0 RL\nL X10\nL X0 Y0.00001\nL X-10 R0\n");
  ASSERT_EQ(run.messages(), "");
  // v = −0.1 (c + c')/(1 + c.c') = −0.1 (−1/tan(a/2) …): with the angle a = atan(1e-6) between the lines, the corner
  // lies 0.1/tan(a/2) before the end point, tan(a/2) = (sqrt(1 + e²) − 1)/e.
  const double half = 5e-7 * (1 - 2.5e-13);
  expect_triple(run.tip(1), {10 + 0.1 / half, -0.1, 0}, 2e5);
  // Far nearer than doubles tell, by exact numbers; a hair on the other side of straight back.
  const KlartextRun near(kMill, kHead + "M128\nL X0 RL\nL X90000\nL X0 Y0.000000000001\nL X-10 R0\n");
  EXPECT_EQ(near.messages(), "W_DIGITS@5");
  EXPECT_NEAR(near.tip(1)[0], 90000 + 0.1 * 90000 / 0.5e-12, 4);
  // Turned tools: by double-double.
  EXPECT_EQ(KlartextRun(kMill, kHead + "M128\nL X0 A30 C10 RL\nL X10\nL X0\nL X-10 R0\n").messages(), "E_REVERSAL@4");
}

// The head of so long a mitre is hardly known along the movement, but lies on the offset lines of both. By hand: out by
// d = (1, 0, 0), back by (−1, e, 0)/n, n = sqrt(1 + e²), e = 1e-10/10000 = 1e-14. The tool t = (0, u, w) gives c = t x
// d = (0, w, −u), and of the way back c' = (−w e, −w, u)/m, m = sqrt(1 + w² e²). Their mitre is (c + c')/(1 + c.c') =
// (−w e/(m − 1), w, −u) = (−2/(w e), w, −u), times −0.1.
TEST(PeripheralMilling, AlmostBackStaysOnTheOffsetLines) {
  for (const char* const turn : {"", " A30", " A30 C0 B0"}) {
    const KlartextRun run(kMill, kHead + "M128\nL X0" + turn + " RL\nL X10000\nL X0 Y0.0000000001\nL X-10 R0\n");
    const auto [zero, u, w] = run.tool_axis(1);
    EXPECT_EQ(zero, 0) << turn;
    EXPECT_NEAR(run.tip(1)[0] / (0.1 * 2 / (w * 1e-14)), 1, 1e-9) << turn;
    EXPECT_NEAR(run.tip(1)[1], -0.1 * w, 1e-15) << turn;
    EXPECT_NEAR(run.tip(1)[2], 0.1 * u, 1e-15) << turn;
  }
}

TEST(PeripheralMilling, OutOfScope) {
  const KlartextRun run(kMill, kHead + "L X10 RL\nLN X0 Y0 Z0 TX0 TY0 TZ1\nL X20 R0\n");
  EXPECT_EQ(run.messages(), "heidenhain.peripheral.out-of-scope@2 W_T_IGNORED@3 heidenhain.peripheral.out-of-scope@3");
  EXPECT_TRUE(run.events[0].out_of_scope);
  EXPECT_EQ(run.events[0].permitted, spec::PermittedOutcomes{});
  ASSERT_EQ(run.moves.size(), 1U);
  expect_triple(run.tip(0), {20, 0, 0});
  // M129 acts at the end of its block: the next one is out of scope, and no move is `cancel`.
  const KlartextRun off(kMill, kHead + "M128\nL X0 RL\nL X10 M129\nL X20\nL X30 R0\n");
  EXPECT_EQ(off.messages(), "heidenhain.peripheral.out-of-scope@5");
  ASSERT_EQ(off.moves.size(), 3U);
  EXPECT_EQ(off.moves[2].cause, spec::Cause::programmed);
}

}  // namespace
}  // namespace toolcomp::fast::klartext

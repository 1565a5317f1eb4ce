// SPDX-License-Identifier: Apache-2.0
// FUNCTION PROG PATH in the fast engine. Expected values by hand from the clauses of heidenhain.contour; the worked
// examples stand in golden/heidenhain/corpus_examples_programmed_contour.cpp.
#include "tests/unit/heidenhain/fast_klartext_run.h"

namespace toolcomp::fast::klartext {
namespace {

const std::string kToroid = "[[tool]]\nnumber=1\nR=5\nR2=2\nDL=0.25\nDR=\"-0.3\"\nDR2=\"-0.1\"\n";
const std::string kHead = "TOOL CALL 1 Z\n";
const std::string kContour = "FUNCTION PROG PATH IS CONTOUR\n";
const std::string kCenter = "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT CNT-CNT\n";

// P7: the contour point q is the tip of the nominal tool at q + R2 n + rho u − R2 t, its centre at q + R2 n + rho u.
TEST(ProgrammedContour, SameAsOff) {
  const std::string vectors = "NX0.6 NY0 NZ0.8 TX0 TY0 TZ1 R0\n";
  const KlartextRun contour(kToroid, kHead + kContour + kCenter + "LN X1 Y2 Z3 " + vectors);
  const KlartextRun tip(kToroid, kHead + "M128\nLN X5.2 Y2 Z2.6 " + vectors);
  const KlartextRun center(kToroid, kHead + kCenter + "LN X5.2 Y2 Z4.6 " + vectors);
  expect_triple(contour.tip(0), tip.tip(0));
  expect_triple(contour.tip(0), center.tip(0));
  expect_triple(contour.center(0), tip.center(0));
  expect_triple(contour.axes(0), center.axes(0));
  expect_shift(contour.shift(0), tip.shift(0));
  EXPECT_EQ(contour.contact(0), (Triple{1, 2, 3}));
  expect_triple(tip.contact(0), {1, 2, 3});
  expect_triple(center.contact(0), {1, 2, 3});
}

TEST(ProgrammedContour, Modal) {
  const std::string block = "LN X1 Y2 Z3 NX0.6 NY0 NZ0.8 TX0 TY0 TZ1 R0\n";
  // Also across tool calls.
  const KlartextRun run(kToroid, kHead + kContour + kHead + "M128\n" + block + "FUNCTION PROG PATH OFF\n" + block);
  EXPECT_EQ(run.contact(0), (Triple{1, 2, 3}));
  expect_triple(run.contact(1), {1 - 4.2, 2, 3 + 0.4});  // −2 n + 2 t − 3 u
  // Blocks without compensation keep the programmed point, and REFPNT.
  const KlartextRun plain(kToroid, kHead + kContour + kCenter + "L X1 Y2 Z3\nLN X1 Y2 Z3 TX0 TY0 TZ1\n");
  expect_triple(plain.tip(0), {1, 2, 1});
  expect_triple(plain.tip(1), {1, 2, 1});
}

// RL along X with the tool along Z: the left is +Y, and the tip stands beside the contour by R' = 4.7.
TEST(ProgrammedContour, Flank) {
  const KlartextRun run(kToroid, kHead + kContour + kCenter + "L X0 RL\nL X10\nL X20 R0\n");
  expect_triple(run.tip(0), {0, 4.7, 0});
  expect_triple(run.tip(1), {10, 4.7, 0});
  expect_triple(run.tip(2), {20, 0, -2});
  expect_shift(run.shift(1), {0, -0.3, 0});
  expect_shift(run.tool_shift(1), {0, -0.3, 0.25});
}

}  // namespace
}  // namespace toolcomp::fast::klartext

// SPDX-License-Identifier: Apache-2.0
// FUNCTION PROG PATH in the exact engine: IS CONTOUR agrees with OFF at the nominal tip and centre (P7), and is modal.
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/heidenhain/klartext_run.h"

namespace {

using namespace toolcomp;
using test::last_move;
using test::Lines;
using test::shown;
using test::story;
using test::tool;

const std::string kToroid = tool("R = 5\nR2 = 2\nDR = \"-0.5\"\nDR2 = \"-0.25\"\n");
const std::string kCall = "TOOL CALL 1 Z\n";
const std::string kContour = "FUNCTION PROG PATH IS CONTOUR\n";
const std::string kCenter = "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT CNT-CNT\n";
const std::string kVectors = "NX0.6 NY0 NZ0.8 TX0 TY0.6 TZ0.8\n";

// n = (0.6, 0, 0.8), t = (0, 0.6, 0.8), n.t = 0.64, w = (0.6, -0.384, 0.288), |w|² = 0.5904 = 1 - 0.64².
TEST(ModelProgrammedContour, AgreesWithTheNominalTool) {
  const model::Event tip = last_move(kToroid, kCall + "M128\nLN X0 Y0 Z0 " + kVectors);
  // The contact of the tip at 0, as CONTOUR: its decimals to 15 digits are near enough for 9 digits.
  const auto& q = tip.space->contact->point;
  const std::string at = "LN X" + q[0].decimal(15) + " Y" + q[1].decimal(15) + " Z" + q[2].decimal(15) + " ";
  for (const std::string& tcpm : {std::string("M128\n"), kCenter}) {
    const model::Event contour = last_move(kToroid, kCall + tcpm + kContour + at + kVectors);
    EXPECT_EQ(shown(contour.point, 9), shown(tip.point, 9));
    EXPECT_EQ(shown(contour.space->tool_center, 9), shown(tip.space->tool_center, 9));
    EXPECT_EQ(shown(contour.space->shift, 30), shown(tip.space->shift, 30));
  }
  // TIP at P is CNT at P + R2 t = (0, 1.2, 1.6) (P5).
  const model::Event center = last_move(kToroid, kCall + kCenter + "LN X0 Y1.2 Z1.6 " + kVectors);
  EXPECT_EQ(shown(center.point, 30), shown(tip.point, 30));
  EXPECT_EQ(shown(center.space->contact->point, 30), shown(tip.space->contact->point, 30));
}

TEST(ModelProgrammedContour, IsModal) {
  // n = t: the flat bottom touches, q = P; the tip of the contour is P either way. A wall, n across t: R' beside it.
  const std::string wall = "LN X0 Y0 Z0 NX1 NY0 NZ0\n";
  const std::string mill = tool("R = 5\nDR = \"-0.5\"\n");
  EXPECT_EQ(story(mill, kContour + kCall + wall + kCall + wall + "FUNCTION PROG PATH OFF\n" + wall),
            (Lines{"3 4.5 0 0", "5 4.5 0 0", "7 -0.5 0 0"}));
}

TEST(ModelProgrammedContour, UncompensatedBlocksKeepTheReference) {
  EXPECT_EQ(story(kToroid, kCall + kContour + kCenter + "L X1 Y2 Z3\n"), (Lines{"4 1 2 1"}));
  const model::Event event = last_move(kToroid, kCall + kContour + kCenter + "L X1 Y2 Z3\n");
  // R2' above the tip: 1 + 2 - 0.25.
  EXPECT_EQ(shown(event.space->tool_center), "1 2 2.75");
}

}  // namespace

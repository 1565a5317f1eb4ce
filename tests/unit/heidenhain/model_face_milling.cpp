// SPDX-License-Identifier: Apache-2.0
// Face milling in the exact engine: the table of oversize verdicts, warnings, and 3D-ToolComp. Expected values
// are derived by hand. The worked examples stand in
// golden/heidenhain/corpus_examples_face_milling.cpp.
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

// Block 13 of the manual's example.
const std::string kPoint = "X+36.0084 Y+6.177 Z-1.9209 ";
const std::string kN = "NX-0.4658107 NY+0 NZ+0.8848844 ";
const std::string kT = "TX+0.0000000 TY+0.6558846 TZ+0.7548612 ";
const std::string kBlock = "LN " + kPoint + kN + kT;
const std::string kCall = "TOOL CALL 1 Z S12000 F1000\n";
const std::string kCenter = "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT CNT-CNT\n";

// A ball of 6 mm re-worked to 5.8 mm; the same as it was; a toroid cutter.
const std::string kReworked = tool("R = 3\nR2 = 3\nDL = 0\nDR = \"-0.1\"\nDR2 = \"-0.1\"\nL = 100\n");
const std::string kBall = tool("R = 3\nR2 = 3\n");
const std::string kToroid = tool("R = 6\nR2 = 1\nDL = \"0.05\"\nDR = \"-0.1\"\nDR2 = \"-0.02\"\n");

const spec::SpaceCompensation<exact::Real>& space(const model::Event& event) { return *event.space; }
const spec::Contact<exact::Real>& contact(const model::Event& event) { return *event.space->contact; }

// The centre of a ball by a negative DL is what CNT-CNT gives (P15, E28).
TEST(ModelFaceMilling, NegativeLengthForTheCenter) {
  for (const std::string& block : {kBlock + "\n", std::string("LN X1 Y2 Z3 NX0.6 NY0 NZ0.8 TX0 TY0.8 TZ0.6\n")}) {
    const std::string tip = "TOOL CALL 1 Z DL-3\nM128\n";
    EXPECT_EQ(shown(last_move(kReworked, tip + block).axes), shown(last_move(kReworked, kCall + kCenter + block).axes));
  }
}

// DL = DR = DR2 = a moves every tool by a n (P3).
TEST(ModelFaceMilling, EvenOversize) {
  const std::string call = "TOOL CALL 1 Z DL+0.5 DR+0.5 DR2+0.5\nM107\n";
  for (const char* keys : {"R = 3\nR2 = 3\n", "R = 6\nR2 = 1\n", "R = 6\nR2 = 0\n"}) {
    const model::Event event = last_move(tool(keys), call + "LN X0 Y0 Z0 NX0.6 NY0 NZ0.8 TX0 TY0.28 TZ0.96 M128\n");
    EXPECT_EQ(shown(space(event).tool_shift), "0.3 0 0.4") << keys;
  }
}

// Scaling of N and T changes nothing (P4).
TEST(ModelFaceMilling, LengthsOfVectors) {
  const auto point = [](const std::string& vectors) {
    return shown(last_move(kToroid, kCall + "LN X1 Y2 Z3 " + vectors + "M128\n").point, 30);
  };
  EXPECT_EQ(point("NX0.1 NY0.2 NZ0.3 TX0 TY0.1 TZ1 "), point("NX0.3 NY0.6 NZ0.9 TX0 TY0.3 TZ3 "));
}

TEST(ModelFaceMilling, ToolAxisXAndY) {
  // t = e: u is what is left of n across it. N = (0.8, 0.6, 0): along X the shift of the ball is -0.1 (n - e).
  const std::string block = "LN X0 Y0 Z0 NX0.8 NY0.6 NZ0\n";
  EXPECT_EQ(shown(last_move(kReworked, "TOOL CALL 1 X\n" + block).point), "0.02 -0.06 0");
  EXPECT_EQ(shown(last_move(kReworked, "TOOL CALL 1 Y\n" + block).point), "-0.08 0.04 0");
}

// The clause of an alarm of the checks; several tell E_TOOL.
bool states(const std::string& clause, const std::string& alarm) {
  if (alarm == "E_OVERSIZE_DR") return clause == "heidenhain.tool.oversize-radius";
  if (alarm == "E_OVERSIZE_DR2") return clause == "heidenhain.tool.oversize-corner";
  if (alarm == "E_R2_GT_R") return clause == "heidenhain.tool.corner-beyond-radius";
  if (alarm == "E_R2_NEG") return clause == "heidenhain.tool.effective-corner-radius";
  if (alarm == "E_TOOL_EFF") return clause == "heidenhain.tool.effective-radius";
  if (alarm == "E_TOOL") return clause.starts_with("heidenhain.tool.table-");
  return alarm.empty();
}

struct VerdictRow {
  const char* keys;
  const char* normal;       // N block, M108: the alarm, or ""
  const char* permitted;    // N block, M107
  const char* tool_vector;  // T-only block, M108
};

TEST(ModelFaceMilling, OversizeVerdicts) {
  const VerdictRow rows[] = {
      {"R = 3\nR2 = 3\nDR = \"-0.1\"\nDR2 = \"-0.1\"\n", "", "", ""},
      {"R = 3\nR2 = 3\nDR = \"0.2\"\nDR2 = \"0.2\"\n", "E_OVERSIZE_DR", "", "E_OVERSIZE_DR"},
      {"R = 3\nR2 = 3\nDR2 = \"0.3\"\n", "E_OVERSIZE_DR2", "", ""},
      {"R = 3\nR2 = 3\nDR = \"-0.1\"\n", "E_R2_GT_R", "", ""},
      {"R = 3\nR2 = 3\nDR2 = \"-0.1\"\n", "", "", ""},
      {"R = 6\nR2 = 0\nDR = \"-0.1\"\n", "", "", ""},
      {"R = 6\nR2 = 1\nDR2 = \"-1.1\"\n", "E_R2_NEG", "E_R2_NEG", "E_R2_NEG"},
      {"R = 6\nR2 = 1\nDR = \"-5.5\"\n", "E_R2_GT_R", "", ""},
      {"R = 6\nR2 = 0\nDR = \"0.2\"\nDR2 = \"0.2\"\n", "E_OVERSIZE_DR", "", "E_OVERSIZE_DR"},
      // By heidenhain.tool.order-of-checks.
      {"R = \"-1\"\nR2 = \"-1\"\n", "E_TOOL", "E_TOOL", "E_TOOL"},
      {"R = 1\nR2 = \"-1\"\n", "E_TOOL", "E_TOOL", "E_TOOL"},
      {"R = 1\nR2 = 2\nDR = -3\n", "E_TOOL", "E_TOOL", "E_TOOL"},
      {"R = 1\nR2 = 1\nDR = -2\nDR2 = -2\n", "E_TOOL_EFF", "E_TOOL_EFF", "E_TOOL_EFF"},
  };
  for (const VerdictRow& row : rows) {
    const auto verdict = [&row](const std::string& program) {
      for (const model::Event& event : test::events_of(tool(row.keys), program)) {
        if (event.kind != spec::EventKind::alarm) continue;
        std::string number(event.number.view());
        // It rests on its own clause last.
        EXPECT_TRUE(states(std::string(spec::info(event.clauses.back()).id), number)) << number << ' ' << row.keys;
        return number;
      }
      return std::string();
    };
    const std::string normal = "LN X1 Y1 Z1 NX0.6 NY0 NZ0.8 TX0 TY0 TZ1 M128";
    EXPECT_EQ(verdict(kCall + normal + "\n"), row.normal) << row.keys;
    EXPECT_EQ(verdict(kCall + normal + " M107\n"), row.permitted) << row.keys;
    EXPECT_EQ(verdict(kCall + "LN X1 Y1 Z1 TX0 TY0 TZ1 M128\n"), row.tool_vector) << row.keys;
  }
}

TEST(ModelFaceMilling, WhatTheVerdictsLetThrough) {
  const std::string block = "LN X1 Y1 Z1 NX0.6 NY0 NZ0.8 M107\n";
  // R2 > R': a ball of R2', nothing shifted where dR2 = 0.
  EXPECT_EQ(shown(space(last_move(tool("R = 3\nR2 = 3\nDR = \"-0.1\"\n"), kCall + block)).shift), "0 0 0");
  // 6.2/0.2 of an end mill: 0.2 (n - t) + 0 u.
  EXPECT_EQ(shown(space(last_move(tool("R = 6\nDR = \"0.2\"\nDR2 = \"0.2\"\n"), kCall + block)).shift), "0.12 0 -0.04");
  // R2' = 2.9 < R': the ball becomes a toroid of rho' = 0.1: -0.1 (n - t) + 0.1 u.
  EXPECT_EQ(shown(space(last_move(tool("R = 3\nR2 = 3\nDR2 = \"-0.1\"\n"), kCall + block)).shift), "0.04 0 0.02");
}

TEST(ModelFaceMilling, Alarms) {
  const std::string block = "LN X1 Y1 Z1 NX0 NY0 NZ1";
  EXPECT_EQ(story(kBall, block + "\n"), (Lines{"1 E_NO_TOOL"}));
  EXPECT_EQ(story(kBall, "TOOL CALL 2\n"), (Lines{"1 E_NO_TOOL"}));
  EXPECT_EQ(story(kBall, kCall + block + " RL\n"), (Lines{"2 E_RC_WITH_N"}));
  EXPECT_EQ(story(kBall, kCall + "L RR\n" + block + " M128\n"), (Lines{"3 E_RC_WITH_N"}));
  EXPECT_EQ(story(kBall, kCall + "L RR\n" + block + " R0\n"), (Lines{"3 1 1 1"}));
  EXPECT_EQ(story(kBall, kCall + "LN X+1 Y+2 NX0 NY0 NZ1\n"), (Lines{"2 E_LN_COORD"}));
  EXPECT_EQ(story(kBall, kCall + "LN Y+1 X+2 Z+3 NX0 NY0 NZ1\n"), (Lines{"2 E_LN_ORDER"}));
  EXPECT_EQ(story(kBall, kCall + "LN X+1 Y+2 Z+3 NX0 NZ1\n"), (Lines{"2 E_VEC_INCOMPLETE"}));
  EXPECT_EQ(story(kBall, kCall + "LN X+1 Y+2 Z+3 NX0 NY0 NZ0\n"), (Lines{"2 E_VEC_ZERO"}));
  EXPECT_EQ(story(kBall, kCall + "LN X+1 Y+2 Z+3 NX+10 NY0 NZ0\n"), (Lines{"2 E_VEC_RANGE"}));
  EXPECT_EQ(story(kBall, kCall + block + " M1 M3 M8 M9 M10\n"), (Lines{"2 E_TOO_MANY_M"}));
}

TEST(ModelFaceMilling, WarningsInTheirOrder) {
  const std::string at = "LN X1 Y1 Z1.000001 ";
  EXPECT_EQ(story(kBall, kCall + at + "NX0 NY0 NZ-1.1 TX0 TY0 TZ2\n", 0),
            (Lines{"2 W_DIGITS", "2 W_T_IGNORED", "2 W_NOT_NORMALIZED", "2 W_N_BELOW", "2 1 1 1"}));
  EXPECT_EQ(story(kBall, kCall + at + "NX0 NY0 NZ-1.1 TX0 TY0 TZ2 M128\n", 0),
            (Lines{"2 W_DIGITS", "2 W_NOT_NORMALIZED", "2 W_NOT_NORMALIZED", "2 W_N_BELOW", "2 1 1 1"}));
  // v.v off by 0.0002 exactly: (1.0001)² = 1.00020001 is beyond, 0.9999² = 0.99980001 is not.
  EXPECT_EQ(story(kBall, kCall + "LN X1 Y1 Z1 NX0 NY0 NZ1.0001\n").size(), 2U);
  EXPECT_EQ(story(kBall, kCall + "LN X1 Y1 Z1 NX0 NY0 NZ0.9999\n").size(), 1U);
}

TEST(ModelFaceMilling, JumpOfTheContact) {
  const auto block = [](const std::string& normal) { return "LN X0 Y0 Z0 " + normal + "\n"; };
  const std::string right = block("NX0.6 NY0 NZ0.8");
  const std::string left = block("NX-0.6 NY0 NZ0.8");
  const std::string aside = block("NX0 NY0.6 NZ0.8");
  const std::string top = block("NX0 NY0 NZ1");
  const auto jumps = [](const std::string& setup, const std::string& program) {
    std::string lines;
    for (const model::Event& event : test::events_of(setup, program))
      if (event.number.view() == "W_CONTACT_JUMP") lines += std::to_string(event.line);
    return lines;
  };
  const std::string mill = tool("R = 5\n");
  EXPECT_EQ(jumps(mill, kCall + right + left + aside + right), "3");
  EXPECT_EQ(jumps(mill, kCall + right + top + top + left), "35");
  EXPECT_EQ(jumps(tool("R = 5\nR2 = 5\n"), kCall + right + left + top), "");
  EXPECT_EQ(jumps(mill, kCall + right + "L X1\n" + left), "");
  EXPECT_EQ(jumps(mill, kCall + right + "L F100\n" + left), "4");
  EXPECT_EQ(jumps(mill, kCall + right + "TOOL CALL DL-0.1\n" + left), "");
}

// 3D-ToolComp
const std::string kTable = "[[dr2table]]\nname = \"W\"\npoints = [[40, \"0.03\"], [50, \"-0.02\"]]\n";
const std::string kMeasured = tool("R = 3\nR2 = 3\nDR2 = \"-0.5\"\nDR2TABLE = \"W\"\n");

TEST(ModelToolComp, ManualExample) {
  // 45 degrees: 0.005; DR2 of the tool table does not count. D_tip = 0.005 (n - t) with n = (1, 0, 1)/sqrt 2.
  const model::Event event = last_move(kMeasured + kTable, kCall + "LN X0 Y0 Z0 NX1 NY0 NZ1\n");
  EXPECT_EQ(contact(event).angle->decimal(15), "45");
  EXPECT_EQ(space(event).shift[0].decimal(12), "0.003535533906");
  EXPECT_EQ(space(event).shift[2].decimal(12), "-0.001464466094");
}

TEST(ModelToolComp, AngleInsideASegment) {
  // 48.089812806873 degrees (E1): tau = 0.03 - 0.005 (theta - 40) = -0.010449064034365.
  const model::Event event = last_move(kMeasured + kTable, kCall + kBlock + "M128\n");
  EXPECT_EQ(contact(event).angle->decimal(12), "48.089812806873");
  // n.x of E1 is -0.465810699...: the shift along X is tau n.x, t.x being 0.
  EXPECT_EQ((space(event).shift[0] / contact(event).normal[0]).decimal(12), "-0.010449064034");
  EXPECT_EQ(shown(space(event).tool_shift), shown(space(event).shift));
}

TEST(ModelToolComp, RangeAndSigns) {
  const auto verdict = [](const std::string& setup, const std::string& normal, const std::string& call = kCall) {
    return story(setup, call + "LN X0 Y0 Z0 " + normal + "\n", 3).back();
  };
  const std::string table = "[[dr2table]]\nname = \"W\"\npoints = [[30, 0], [45, -3], [60, -3], [90, \"-3.5\"]]\n";
  const std::string ball = tool("R = 3\nR2 = 3\nDR2TABLE = \"W\"\n");
  EXPECT_EQ(verdict(ball + table, "NX0 NY0 NZ1"), "2 E_3DTC_RANGE");
  EXPECT_EQ(verdict(ball + table, "NX1 NY0 NZ-0.0000001"), "2 E_3DTC_RANGE");
  // At 45 degrees and on to 60 R2' = 0, not below it.
  EXPECT_EQ(verdict(ball + table, "NX1 NY0 NZ1").substr(0, 3), "2 -");
  EXPECT_EQ(verdict(ball + table, "NX1.1 NY0 NZ1").substr(0, 3), "2 -");
  EXPECT_EQ(verdict(ball + table, "NX1 NY0 NZ0"), "2 E_R2_NEG");
  EXPECT_EQ(verdict(ball + table, "NX2 NY0 NZ1"), "2 E_R2_NEG");
  // 0.1 more: 0 where the table has -3.1, at 60 + 6 degrees. tan 66 = 2.24603677.
  const std::string more = "TOOL CALL 1 Z DR2+0.1\nM107\n";
  const auto with = [&](const std::string& normal) {
    return story(ball + table, more + "LN X0 Y0 Z0 " + normal + "\n", 3).back();
  };
  EXPECT_EQ(with("NX2.2460367 NY0 NZ1").substr(0, 3), "3 -");
  EXPECT_EQ(with("NX2.2460368 NY0 NZ1"), "3 E_R2_NEG");
  // A toroid cutter has no such table.
  EXPECT_EQ(verdict(tool("R = 3\nR2 = 2\nDR2TABLE = \"W\"\n") + table, "NX1 NY0 NZ1"), "2 E_3DTC_SHAPE");
  EXPECT_EQ(test::last_clause(tool("R = 3\nR2 = 2\nDR2TABLE = \"W\"\n") + table, kCall + "LN X0 Y0 Z0 NX1 NY0 NZ1\n"),
            "heidenhain.tool.deviation-shape");
  // Its values need no M107, those of TOOL CALL do.
  const std::string positive = "[[dr2table]]\nname = \"W\"\npoints = [[0, 1], [180, 1]]\n";
  EXPECT_EQ(verdict(ball + positive, "NX0 NY0 NZ1"), "2 0 0 0");
  EXPECT_EQ(verdict(ball + positive, "NX0 NY0 NZ1", "TOOL CALL 1 Z DR2+0.1\n"), "2 E_OVERSIZE_DR2");
  EXPECT_EQ(verdict(ball + positive, "NX0 NY0 NZ1", "TOOL CALL 1 Z DR+0.1\n"), "2 E_OVERSIZE_DR");
}

}  // namespace

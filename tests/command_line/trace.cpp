// SPDX-License-Identifier: Apache-2.0
// `toolcomp certify --trace` as a user runs it, on both controls: positions by hand.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/command_line/command.h"

namespace {

using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::toolcomp;

// A ball of 3 mm re-worked to 2.9 mm, N = (0.6, 0, 0.8), the tool along Z. The contact stays where the ball of the
// table has it: nominal centre P + (0, 0, 3), contact 3·N below, the centre of the real ball 2.9·N above that, its tip
// 2.9 below. So the tip goes to P + (-0.06, 0, 0.02).
const std::string kBall =
    "control = \"heidenhain\"\naxes = [\"X\", \"Y\", \"Z\"]\n[[tool]]\nnumber = 1\nR = 3\nR2 = 3\n"
    "DR = \"-0.1\"\nDR2 = \"-0.1\"\n";
const std::string kFace =
    "TOOL CALL 1 Z\nL X+0 Y+0 Z+0 R0 FMAX\nLN X+10 Y+0 Z+0 NX+0.6 NY+0 NZ+0.8 F500\n"
    "LN X+20 Y+0 Z+0 NX+0.6 NY+0 NZ+0.8\n";

class Trace : public testing::Test {
 protected:
  Folder folder;

  [[nodiscard]] Outcome judged(const std::string& csv, const std::string& program, const std::string& setup,
                               const std::string& tolerance = "0.001") const {
    return toolcomp("certify --trace " + folder.write("trace.csv", csv) + " --tolerance " + tolerance + " " + program +
                    (setup.empty() ? "" : " --setup " + folder.write("setup.toml", setup)) + " --report " +
                    folder.path("report"));
  }
  [[nodiscard]] Outcome face(const std::string& csv) const { return judged(csv, folder.write("p.h", kFace), kBall); }
};

TEST_F(Trace, AKlartextProgramConforms) {
  const Outcome outcome = face("time,X,Y,Z\n0,0,0,0\n1,4.97,0,0.01\n2,9.94,0,0.02\n3,14.94,0,0.02\n4,19.94,0,0.02\n");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("5 samples, 0 off the path, 0 of 2 corners missed"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(std::filesystem::exists(folder.path("report/index.html")));
}

// The path of a ball as in the table: 0.06 and 0.02 off, the root of 0.004 at the end. One finding for the run.
TEST_F(Trace, APathWithoutTheCompensationDoesNot) {
  const Outcome outcome = face("X,Y,Z\n0,0,0\n10,0,0\n15,0,0\n20,0,0\n");
  EXPECT_EQ(outcome.status, 1) << outcome.out;
  EXPECT_NE(outcome.out.find("4 samples, 3 off the path"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("trace.csv:3: off the path of line 4 by 0.0632456\n"), std::string::npos) << outcome.out;
}

TEST_F(Trace, AnEndThatWasNotReached) {
  const Outcome outcome = face("X,Y,Z\n0,0,0\n9.94,0,0.02\n15,0,0.02\n");
  EXPECT_EQ(outcome.status, 1) << outcome.out;
  EXPECT_NE(outcome.out.find("trace.csv:4: end not reached of line 4 by 4.94"), std::string::npos) << outcome.out;
}

// There and back: the last sample stands at the end, the far corner was cut off.
TEST_F(Trace, ACornerOnTheWayBackToTheEnd) {
  const Outcome outcome = judged("X,Y\n0,0\n1,0\n0,0\n", folder.write("p.nc", "G01 X9. F100\nX0\n"),
                                 "control = \"fanuc\"\naxes = [\"X\", \"Y\"]\n");
  EXPECT_EQ(outcome.status, 1) << outcome.out;
  EXPECT_NE(outcome.out.find("1 of 2 corners missed"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("corner not reached of line 1 by 8\n"), std::string::npos) << outcome.out;
}

// A case of a Heidenhain control brings its own setup; the axes of the trace are those of that setup.
TEST_F(Trace, ACase) {
  const std::string c = folder.write(
      "case.json",
      "{\"case\": 1, \"dialect\": \"klartext\", \"setup\": {\"control\": \"heidenhain\", \"axes\": [\"X\", \"Y\", "
      "\"Z\"],"
      " \"tool\": [{\"number\": 1, \"R\": 3, \"R2\": 3, \"DR\": \"-0.1\", \"DR2\": \"-0.1\"}]},\n \"program\": \"" +
          [] {
            std::string text;
            for (const char letter : kFace) text += letter == '\n' ? std::string("\\n") : std::string(1, letter);
            return text;
          }() +
          "\"}\n");
  EXPECT_EQ(judged("X,Y,Z\n0,0,0\n9.94,0,0.02\n19.94,0,0.02\n", c, "").status, 0);
  EXPECT_EQ(judged("X,Y,Z\n0,0,0\n9.94,0,0.02\n19.94,0,0.022\n", c, "").status, 1);
  const Outcome other = judged("X,Y,C\n", c, "");
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.err.find("trace.csv:1:5:"), std::string::npos) << other.err;
}

// The rotary axis has a tolerance of its own, and a finding its name.
TEST_F(Trace, RotaryAxes) {
  const std::string program = folder.write("p.nc", "G90 G01 X10. C90. F100\n");
  const std::string csv = folder.write("trace.csv", "X [mm];C (deg)\n0;0\n5;45.5\n10;90\n");
  const std::string arguments = "certify --trace " + csv + " --tolerance 0.01 " + program + " --setup " +
                                folder.write("setup.toml", "control = \"fanuc\"\naxes = [\"X\", \"C\"]\n") +
                                " --report " + folder.path("report");
  EXPECT_EQ(toolcomp(arguments + " --rotary-tolerance 0.5").status, 0);
  const Outcome outcome = toolcomp(arguments);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.out.find("trace.csv:3: off the path of line 1 by"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find(", C "), std::string::npos) << outcome.out;
  for (const std::string tolerance : {"0", "-1", "nan", "x"}) {
    const Outcome refused = toolcomp(arguments + " --rotary-tolerance " + tolerance);
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("--rotary-tolerance"), std::string::npos) << refused.err;
  }
}

// Positions of a Klartext program in inches are inches, whatever the setup.
TEST_F(Trace, AProgramInInches) {
  const std::string program = folder.write("p.h", "BEGIN PGM A INCH\nL X+1 R0 FMAX\nL Y+1\nEND PGM A INCH\n");
  const std::string setup = "control = \"heidenhain\"\naxes = [\"X\", \"Y\", \"Z\"]\n";
  EXPECT_EQ(judged("X,Y,Z\n0,0,0\n1,0,0\n1,1,0\n", program, setup).status, 0);
  EXPECT_EQ(judged("X,Y,Z\n0,0,0\n25.4,0,0\n25.4,25.4,0\n", program, setup).status, 1);
}

TEST_F(Trace, FromStandardInputWithCarriageReturns) {
  const Outcome outcome = toolcomp(
      "certify --trace " + folder.write("trace.csv", "X,Y,Z\r\n0,0,0\r\n9.94,0,0.02\r\n19.94,0,0.02\r\n") +
          " --tolerance 0.001 - --setup " + folder.write("setup.toml", kBall) + " --report " + folder.path("report"),
      "sed 's/$/\\r/' " + folder.write("p.h", kFace) + " | ");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

// Nothing judged, or less than the whole program, is said.
TEST_F(Trace, WhatCannotBeDecidedIsSaid) {
  const std::string csv = "X,Y,Z\n1,0,0\n3,0,0\n";
  const Outcome scope = judged(csv, folder.write("p.h", "TOOL CALL 1 Z\nL X+1 R0\nL X+2 RL\nL X+3 R0\n"), kBall);
  EXPECT_EQ(scope.status, 3) << scope.out;
  EXPECT_NE(scope.err.find("line 3 (heidenhain.peripheral.out-of-scope)"), std::string::npos) << scope.err;
  const Outcome empty = judged(csv, folder.write("p.h", ""), kBall);
  EXPECT_EQ(empty.status, 3);
  EXPECT_NE(empty.err.find("no move to judge"), std::string::npos) << empty.err;
  const Outcome dialect = judged(csv, folder.write("p.h", "N10 G01 X1. F100\n"), kBall);
  EXPECT_EQ(dialect.status, 3);
  EXPECT_NE(dialect.err.find("p.h:1: the path ends in E_SYNTAX"), std::string::npos) << dialect.err;
  const Outcome sample = face("X,Y,Z\n");
  EXPECT_EQ(sample.status, 3);
  EXPECT_NE(sample.err.find("no sample"), std::string::npos) << sample.err;
  // Up to an alarm the path is judged.
  const Outcome alarm = judged("X,Y,Z\n0,0,0\n1,0,0\n", folder.write("p.h", "L X+1 R0\nL X+2 Q+3\n"), kBall);
  EXPECT_EQ(alarm.status, 0) << alarm.out;
  EXPECT_NE(alarm.err.find("p.h:2: the path ends in E_SYNTAX"), std::string::npos) << alarm.err;
}

TEST_F(Trace, BadInput) {
  const std::string program = folder.write("p.h", kFace);
  const std::string csv = folder.write("good.csv", "X,Y,Z\n0,0,0\n9.94,0,0.02\n19.94,0,0.02\n");
  const std::string setup = " --setup " + folder.write("setup.toml", kBall);
  const auto refused = [&](const std::string& arguments, const std::string& words) {
    const Outcome outcome = toolcomp("certify " + arguments + " --report " + folder.path("report"));
    EXPECT_EQ(outcome.status, 2) << arguments << '\n' << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << "one line: " << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder.path("report"))) << arguments;
  };
  const auto trace = [](const std::string& file) { return "--trace " + file + " --tolerance 0.001 "; };
  refused(trace(folder.path("none.csv")) + program + setup, "none.csv: cannot be read");
  refused(trace(folder.path("")) + program + setup, "Is a directory");
  refused(trace(folder.write("empty.csv", "")) + program + setup, "empty.csv:1:1: no header");
  refused(trace(folder.write("few.csv", "X,Y,Z\n0,0,0\n9.94,0\n")) + program + setup, "few.csv:3:7: fewer values");
  refused(trace(folder.write("word.csv", "X,Y,Z\n0,0,0\n9.94,0,up\n")) + program + setup, "word.csv:3:8: \"up\"");
  refused(trace(program) + program + setup, "p.h:1:1: expected time or an axis");
  refused(trace(csv) + folder.path("none.h") + setup, "none.h: cannot be read");
  refused(trace(csv) + folder.path("") + setup, "Is a directory");
  refused(trace(csv) + folder.write("nul.h", std::string("L X+1\n;\0\n", 9)) + setup, "nul.h:2:2:");
  refused(trace(csv) + folder.write("empty.json", ""), "empty.json:1:1:");
  refused(trace(csv) + program + " " + program + setup, "one program");
  refused(trace(csv) + "--controller cat " + program + setup, "a --controller or a --trace");
  refused("--trace " + csv + " " + program + setup, "--tolerance");
  for (const std::string tolerance : {"0", "-1", "nan", "inf", "0.001x", "''", "mm"})
    refused(fmt::format("--trace {} --tolerance {} {}{}", csv, tolerance, program, setup), "--tolerance");
}

// The page cannot be written where a file stands: said before anything is judged.
TEST_F(Trace, AReportNeedsAFolder) {
  const std::string csv = folder.write("good.csv", "X,Y,Z\n0,0,0\n9.94,0,0.02\n19.94,0,0.02\n");
  const Outcome outcome = toolcomp("certify --trace " + csv + " --tolerance 0.001 " + folder.write("p.h", kFace) +
                                   " --setup " + folder.write("setup.toml", kBall) + " --report " + csv + "/here");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("good.csv is not a folder"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

}  // namespace

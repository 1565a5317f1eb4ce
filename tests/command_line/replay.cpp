// SPDX-License-Identifier: Apache-2.0
// `toolcomp replay` as a user runs it, on cases of both controls and on what is no finding.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/command_line/command.h"

namespace {

using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::toolcomp;

const std::string kServe = TOOLCOMP_BINARY_DIR "/toolcomp serve --engine fast";

// A ball of 3 mm re-worked to 2.9 mm: its centre goes to P + (0, 0, 3) - 0.1·N, so X -0.06 for N = (0.6, 0, 0.8).
const std::string kCase =
    R"({"case": 1, "id": "ball", "section": "heidenhain/face-milling", "dialect": "klartext",
  "setup": {"control": "heidenhain", "axes": ["X", "Y", "Z"],
            "tool": [{"number": 1, "R": 3, "R2": 3, "DR": "-0.1", "DR2": "-0.1"}]},
  "program": "TOOL CALL 1 Z\nLN X+0 Y+0 Z+0 NX+0.6 NY+0 NZ+0.8\n"})";

std::string finding(const std::string& c, const std::string& controller = "") {
  return "{\"finding\": 1,\n \"kind\": \"coordinate\",\n \"clause\": \"heidenhain.face.effective-tip\",\n \"line\": "
         "2,\n"
         " \"field\": \"tool_center.X\",\n \"controller\": \"" +
         controller + "\",\n \"case\": " + c + "}\n";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

class Replay : public testing::Test {
 protected:
  Folder folder;

  void refused(const std::string& name, const std::string& text, const std::string& words) const {
    const Outcome outcome = toolcomp("replay " + folder.write(name, text));
    EXPECT_EQ(outcome.status, 2) << outcome.out << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << "one line: " << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
};

TEST_F(Replay, AKlartextCaseAgrees) {
  const Outcome outcome = toolcomp("replay " + folder.write("case.json", kCase));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("LN X+0 Y+0 Z+0"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("agrees"), std::string::npos);
  EXPECT_EQ(toolcomp("replay -", "cat " + folder.write("case.json", kCase) + " | ").status, 0);
}

// The controller of the finding is asked again, unless another is named.
TEST_F(Replay, AKlartextFindingComesBack) {
  const std::string wrong =
      "sh " + folder.write("wrong.sh", kServe + R"( | sed -u 's/"tool_center":{"X":-0.06/"tool_center":{"X":0.06/')");
  const std::string file = folder.write("finding.json", finding(kCase, wrong));
  const Outcome outcome = toolcomp("replay --yes " + file);
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  for (const char* words : {"finding.json:2: coordinate tool_center.X", "expected  -0.06\n", "actual    0.06\n",
                            "deviation 120 µm", "heidenhain."})
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words << '\n' << outcome.out;
  EXPECT_NE(outcome.err.find("differs, as in the finding"), std::string::npos) << outcome.err;
  EXPECT_EQ(toolcomp("replay " + file + " --controller '" + kServe + "'").status, 0);
  // Carriage returns between the members change nothing.
  std::string returns;
  for (const char c : finding(kCase, wrong)) returns += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(toolcomp("replay --yes " + folder.write("returns.json", returns)).status, 1);
}

TEST_F(Replay, ControllersThatFail) {
  const std::string file = folder.write("finding.json", finding(kCase));
  const Outcome crash = toolcomp("replay " + file + " --controller false");
  EXPECT_EQ(crash.status, 1);
  EXPECT_NE(crash.out.find("crash reply"), std::string::npos) << crash.out;
  const Outcome hang = toolcomp("replay " + file + " --controller 'sleep 60' --timeout 0.3");
  EXPECT_EQ(hang.status, 1);
  EXPECT_NE(hang.out.find("hang reply"), std::string::npos) << hang.out;
  EXPECT_EQ(toolcomp("replay " + file + " --controller no-such-controller").status, 2);
}

// Every fault with its line and column in the file, the case within a finding too.
TEST_F(Replay, WhatIsNoFinding) {
  const std::string good = finding(kCase);
  refused("empty.json", "", "empty.json:1:1:");
  refused("program.h", "0 BEGIN PGM A MM\nL X+1\n", "program.h:1:3:");
  refused("program.nc", "G90 G00 X1.\n", "program.nc:1:1:");
  refused("cut.json", good.substr(0, good.find("DR2")), "cut.json:9:");
  refused("two.json", replaced(good, "\"finding\": 1", "\"finding\": 2"),
          "two.json:1:13: finding: expected an integer from 1 to 1");
  refused("line.json", replaced(good, "\"line\": 2", "\"line\": \"2\""), "line.json:4:10: line: expected a number");
  refused("kind.json", replaced(good, "\"coordinate\"", "[]"), "kind.json:2:10: kind: expected a string");
  refused("key.json", replaced(good, "\"field\"", "\"fields\""), "key.json:5:2: finding: unknown key \"fields\"");
  refused("none.json", "\n{\"finding\": 1}", "none.json:2:1: \"case\" is missing");
  refused("table.json", "{\"finding\": 1,\n \"case\": 3}", "table.json:2:10: case: expected a table");
  refused("setup.json", replaced(good, "\"R2\"", "\"R3\""), "setup.json:9:");
  // The program of the case: a row of a table that the setup does not have, a NUL.
  refused("row.json", replaced(good, "TOOL CALL 1 Z", "FUNCTION CORRDATA TCS #5"), "row.json: program:1:23:");
  refused("nul.json", replaced(good, "TOOL CALL 1 Z", "L X+1 \\u0000"), "nul.json: program:1:7:");
  const Outcome missing = toolcomp("replay " + folder.path("absent.json"));
  EXPECT_EQ(missing.status, 2);
  EXPECT_NE(missing.err.find("absent.json: cannot be read"), std::string::npos);
  const Outcome directory = toolcomp("replay " + folder.path(""));
  EXPECT_EQ(directory.status, 2);
  EXPECT_NE(directory.err.find("Is a directory"), std::string::npos);
}

}  // namespace

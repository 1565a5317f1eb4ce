// SPDX-License-Identifier: Apache-2.0
// Programs spoiled by one slip each: the message names line, column and word, and where one fits what may be meant.
// What is expected was written by hand, from the slip.
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "tests/command_line/command.h"

namespace {

using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::toolcomp;

struct Spoiled {
  const char* block;  // the second line of the program
  const char* place;  // "2:5"
  std::vector<const char*> says;
};

void expect_told(const Folder& folder, const std::string& name, const std::string& before, const Spoiled& spoiled) {
  const std::string program = folder.write(name, before + '\n' + spoiled.block + "\nM30\n");
  for (const char* engine : {"model", "fast"}) {
    const Outcome outcome = toolcomp("run " + program + " --engine " + engine);
    EXPECT_NE(outcome.err.find(name + ':' + spoiled.place + ": "), std::string::npos) << spoiled.block << '\n'
                                                                                      << outcome.err;
    for (const char* word : spoiled.says)
      EXPECT_NE(outcome.err.find(word), std::string::npos) << spoiled.block << '\n' << outcome.err;
  }
}

TEST(SpoiledPrograms, Fanuc) {
  const Folder folder;
  std::ignore = folder.write("setup.toml", "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n");
  const Spoiled rows[] = {
      {"G01 XO Y5.", "2:5", {"PS0005", "\"XO\"", "the letter O; the digit 0 may be meant"}},
      {"G01 X1O. Y5.", "2:8", {"PS0007", "\"X1O.\"", "the letter O; the digit 0 may be meant"}},
      {"GO1 X5.", "2:1", {"PS0005", "\"GO1\"", "the letter O; the digit 0 may be meant"}},
      {"G01 X10,5", "2:8", {"PS0004", "\"X10,5\"", "a comma; a number has a decimal point"}},
      {"G01 X Y5.", "2:5", {"PS0005", "\"X\""}},
      {"G01 X5. ; contour begins", "2:11", {"PS0009", "\"contour\"", "; ends a block; a comment is written in ( )"}},
      {"G01 X5. ; set up", "2:11", {"PS0005", "; ends a block"}},
      {"G01 X5.)", "2:8", {"PS0004", "a ) without a ("}},
      {"G01 X1.5.", "2:9", {"PS0007", "\"X1.5.\""}},
      {"G01 X--5.", "2:7", {"PS0006", "\"X--5.\""}},
      {"G01 E5.", "2:5", {"PS0009", "\"E5.\""}},
      {"G01 5.", "2:5", {"PS0004", "\"5.\"", "a number without its letter"}},
      {"G01 X12345678.12345678", "2:22", {"PS0003", "\"X12345678.12345678\""}},
      {"G01 X5. F", "2:9", {"PS0005", "\"F\""}},
      {"G01 X5. T-1", "2:10", {"PS0006", "\"T-1\""}},
      {"G01 X5. H1.5", "2:11", {"PS0007", "\"H1.5\""}},
      {"G01 X5]", "2:7", {"PS0004", "\"X5]\""}},
      {"G01 X=5.", "2:5", {"PS0005", "\"X=5.\""}},
      {"G01 X5. Z", "2:9", {"PS0005", "\"Z\""}},
      {"M6 (A (NESTED) COMMENT)", "2:16", {"PS0009", "\"COMMENT)\"", "comments cannot be nested"}},
      {"G77.7 X5.", "2:1", {"PS0010 there is no such G code"}},
  };
  for (const Spoiled& row : rows) expect_told(folder, "p.nc", "G90 G17 G40 F100", row);
}

// The code that G43.4 does not allow is named, with its place.
TEST(SpoiledPrograms, CodesUnderToolCenterPointControl) {
  const Folder folder;
  std::ignore =
      folder.write("setup.toml",
                   "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n[parameters]\n"
                   "\"19680\" = 2\n\"19681\" = 5\n\"19682\" = 3\n\"19686\" = 4\n\"19687\" = 2\n[offsets.H]\n1 = 100\n");
  expect_told(folder, "p.nc", "G90 G17 (G53)",
              {"G43.4 H1 X0 G54 F100", "2:13", {"FORBIDDEN_UNDER_TOOL_DIRECTION", "do not allow: G54"}});
  expect_told(folder, "p.nc", "G43.4 H1 X0", {"G053", "2:1", {"FORBIDDEN_UNDER_TOOL_DIRECTION", "do not allow: G53"}});
}

TEST(SpoiledPrograms, Klartext) {
  const Folder folder;
  std::ignore = folder.write(
      "setup.toml",
      "control = \"heidenhain\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n[[tool]]\nnumber = 1\nR = 3\n");
  const Spoiled rows[] = {
      {"L X+1O Y+5", "2:3", {"E_SYNTAX", "\"X+1O\"", "the letter O; the digit 0 may be meant"}},
      {"L X+O Y+5", "2:3", {"E_SYNTAX", "\"X+O\"", "the letter O; the digit 0 may be meant"}},
      {"L X+5Y+6 R0", "2:3", {"E_SYNTAX", "\"X+5Y+6\"", "words must be separated by blanks"}},
      {"G01 X+5", "2:1", {"E_SYNTAX", "\"G01\"", "a G code in a Klartext program"}},
      {"L X+1.2.3", "2:3", {"E_SYNTAX", "\"X+1.2.3\"", "a second decimal point"}},
      {"L X Y+5", "2:3", {"E_SYNTAX", "\"X\""}},
      {"L X+5 (contour)", "2:7", {"E_SYNTAX", "\"(contour)\"", "a comment begins with ;"}},
      {"L X+5 RK F100", "2:7", {"E_SYNTAX", "\"RK\""}},
      {"L X+5 +6", "2:7", {"E_SYNTAX", "\"+6\"", "a number without its letter"}},
      {"L X+5 W+6", "2:7", {"E_SYNTAX", "\"W+6\""}},
      {"L X+5 X+6", "2:7", {"E_SYNTAX", "\"X+6\""}},
      {"LL X+5", "2:1", {"E_SYNTAX", "\"LL\""}},
      {"L X++5", "2:3", {"E_SYNTAX", "\"X++5\""}},
      {"L X+5 R0 F100 M3 Z+5", "2:18", {"E_SYNTAX", "\"Z+5\""}},
      {"TOOL CAL 1 Z", "2:1", {"E_SYNTAX", "\"TOOL\""}},
      {"LN X+1 Y+2 Z+3 NX+0 NY+0 NZ+", "2:26", {"E_SYNTAX", "\"NZ+\""}},
      {"L X+5 )", "2:7", {"E_SYNTAX", "a stray bracket"}},
      {"PLANE SPATIAL SPA+0 SPB+0", "2:26", {"E_SYNTAX", "the block ends too early"}},
      {"FUNCTION TCPM F TPC AXIS POS PATHCTRL AXIS", "2:15", {"E_SYNTAX", "\"F\""}},
      {"L X+5 M3O", "2:7", {"E_SYNTAX", "\"M3O\"", "the letter O; the digit 0 may be meant"}},
  };
  for (const Spoiled& row : rows) expect_told(folder, "p.h", "TOOL CALL 1 Z S1000 F500", row);
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// What nobody could read ends with exit status 2 and one clear line; what a control would read ends in its alarm.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/command_line/command.h"
#include "tests/effort.h"

namespace {

using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::toolcomp;

// A sanitizer reserves address space of its own.
const std::string kMemoryLimit = toolcomp::test::kSanitized ? "" : "ulimit -v 400000; ";

class BadInput : public testing::Test {
 protected:
  Folder folder;
  std::string setup = folder.write("setup.toml", "control = \"fanuc\"\n");

  void refused(const std::string& arguments, const std::string& words) const {
    const Outcome outcome = toolcomp(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments << '\n' << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << "one line: " << outcome.err;
  }
};

TEST_F(BadInput, ProgramsThatAreNoText) {
  std::string noise;
  unsigned state = 1;
  for (int i = 0; i < 5000; ++i) noise += static_cast<char>((state = state * 1664525U + 1013904223U) >> 24U);
  refused("run " + folder.write("noise.nc", noise), "noise.nc:");
  refused("run " + folder.write("nul.nc", std::string("G00 X1.\nX2.\0Y3.\n", 16)), "nul.nc:2:4:");
  refused("run " + folder.path("missing.nc"), "missing.nc");
  refused("run " + folder.write("latin.nc", "G01 X1. \xE4\n"), "latin.nc:1:9:");
}

TEST_F(BadInput, EventsBeforeTheBytesStand) {
  const Outcome outcome = toolcomp("run " + folder.write("nul.nc", std::string("G00 X1.\nX2.\nX3.\0\n", 17)));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.events().size(), 2U);
}

TEST_F(BadInput, Setups) {
  const std::string program = folder.write("p.nc", "G00 X1.\n");
  refused("run " + program + " --setup " + folder.write("key.toml", "control = \"fanuc\"\nunitz = \"mm\"\n"),
          "key.toml:2:1:");
  refused("run " + program + " --setup " + folder.write("toml.toml", "control = \n"), "toml.toml:1:");
  refused("run " + program + " --setup " + folder.path("none.toml"), "none.toml");
  refused("config check " + folder.write("case.json", "{\"case\": 1, \"program\": 3}"), "case.json:1:");
  const Folder empty;
  refused("run " + empty.write("p.nc", "G00 X1.\n"), "--setup");
}

// The two that were taken for nothing: 19680 mistyped, a bit of a parameter that has none.
TEST_F(BadInput, UnknownParameters) {
  const std::string program = folder.write("p.nc", "G00 X1.\n");
  const auto with = [&](const std::string& line) {
    return folder.write("p.toml", "control = \"fanuc\"\n[parameters]\n" + line + "\n");
  };
  refused(
      "run " + program + " --setup " + with("19860 = 2"),
      R"(p.toml:3:1: parameters: "19860" is not known (`toolcomp spec parameters` lists them); did you mean 19680?)");
  refused("config check " + with("\"19631#3\" = 1"), R"(p.toml:3:1: parameters: "19631#3" is not known)");
  refused("config check " + with("19680 = 3"), "p.toml:3:9: parameters.19680: expected 0, 2, 12 or 21");
  refused("config check " +
              folder.write("case.json", "{\"case\":1,\"program\":\"\",\"setup\":{\"parameters\":\n{\"19860\":2}}}"),
          "case.json:2:2: parameters:");
}

TEST_F(BadInput, Usage) {
  EXPECT_EQ(toolcomp("").status, 2);
  EXPECT_EQ(toolcomp("frobnicate").status, 2);
  EXPECT_EQ(toolcomp("run").status, 2);
  EXPECT_EQ(toolcomp("--help").status, 0);
}

TEST_F(BadInput, AlarmsOfReadingAreResults) {
  const Outcome outcome = toolcomp("run " + folder.write("p.nc", "G00 X1.\nN20 Y2. X1.2.3\nX9.\n"));
  EXPECT_EQ(outcome.status, 0);
  ASSERT_EQ(outcome.events().size(), 2U);
  EXPECT_EQ(outcome.events()[1].at("kind"), "alarm");
  EXPECT_EQ(outcome.events()[1].at("number"), "PS0007");
  EXPECT_EQ(outcome.events()[1].at("line"), 2);
  EXPECT_NE(outcome.err.find("p.nc:2:13: PS0007"), std::string::npos) << outcome.err;
}

TEST_F(BadInput, KlartextProgramsThatAreNoText) {
  const std::string klartext = " --setup " + folder.write("heidenhain.toml", "control = \"heidenhain\"\n");
  refused("run " + folder.write("latin.h", "L X+1 ;\xE4\nL X\xE4\n") + klartext, "latin.h:2:4:");
  refused("run " + folder.write("nul.h", std::string("L X+1\n;\0\n", 9)) + klartext, "nul.h:2:2:");
  refused("run " + folder.write("row.h", "M3\nFUNCTION CORRDATA TCS #5\n") + klartext, "row.h:2:23:");
}

TEST_F(BadInput, HeidenhainSetupsAndCases) {
  const std::string program = folder.write("p.h", "L X+1\n");
  const auto setup_refused = [&](const std::string& keys, const std::string& words) {
    refused("run " + program + " --setup " + folder.write("s.toml", "control = \"heidenhain\"\n" + keys), words);
  };
  setup_refused("[parameters]\n", "s.toml:2:2: setup: \"parameters\" belongs to control \"fanuc\"");
  setup_refused("[[tool]]\nnumber = 1\nDR2TABLE = \"T\"\n", "s.toml:4:12:");
  setup_refused("[[tool]]\nnumber = 1\n[[tool]]\nnumber = 1\n", "s.toml:5:10:");
  refused("config check " +
              folder.write("case.json", R"({"case":1,"dialect":"klartext","setup":{"control":"fanuc"},"program":""})"),
          "case.json:1:21: dialect:");
}

TEST_F(BadInput, AlarmsOfReadingKlartextAreResults) {
  const std::string klartext = " --setup " + folder.write("heidenhain.toml", "control = \"heidenhain\"\n");
  const Outcome outcome =
      toolcomp("run " + folder.write("p.h", "L X+1 R0 FMAX\n20 LN X+1 Y+2 ~\n  NX0 NY0 NZ1 TX+Q1\nL X+9\n") + klartext);
  EXPECT_EQ(outcome.status, 0);
  ASSERT_EQ(outcome.events().size(), 2U);
  EXPECT_EQ(outcome.events()[1].at("kind"), "alarm");
  EXPECT_EQ(outcome.events()[1].at("number"), "E_SYNTAX");
  EXPECT_EQ(outcome.events()[1].at("line"), 2);
  EXPECT_EQ(outcome.events()[1].at("n"), 20);
  EXPECT_NE(outcome.err.find("p.h:3:15: E_SYNTAX"), std::string::npos) << outcome.err;
}

TEST_F(BadInput, OneKlartextLineOfAHundredMegabytes) {
  const std::string klartext = folder.write("heidenhain.toml", "control = \"heidenhain\"\n");
  const Outcome outcome =
      toolcomp("run - --setup " + klartext, kMemoryLimit + "yes 'L X+1 ' | tr -d '\\n' | head -c 100000000 | ");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  ASSERT_EQ(outcome.events().size(), 1U) << outcome.out.substr(0, 500);
  EXPECT_EQ(outcome.events()[0].at("number"), "E_SYNTAX");
}

// A line of 100 MB under a memory limit of 400 MB for the whole process.
TEST_F(BadInput, OneLineOfAHundredMegabytes) {
  for (const auto& [words, alarm] :
       {std::pair<std::string, std::string>{"7", "PS0004"}, {"X1.", "TOO_MANY_WORDS"}, {"G01", "TOO_MANY_WORDS"}}) {
    const Outcome outcome =
        toolcomp("run - --setup " + setup, kMemoryLimit + "yes '" + words + "' | tr -d '\\n' | head -c 100000000 | ");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    ASSERT_EQ(outcome.events().size(), 1U) << outcome.out.substr(0, 500);
    EXPECT_EQ(outcome.events()[0].at("number"), alarm);
  }
}

}  // namespace

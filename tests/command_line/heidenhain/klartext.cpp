// SPDX-License-Identifier: Apache-2.0
// Klartext programs through every command, as a user runs them: the manual's situations of examples/heidenhain.
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "tests/command_line/command.h"

namespace {

using nlohmann::json;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::toolcomp;

const std::string kExamples = TOOLCOMP_SOURCE_DIR "/examples/heidenhain/";
const std::string kReworked = kExamples + "reworked-ball-at-tip/reworked.h";
const std::string kOversize = kExamples + "oversize-at-tip/oversize.h";

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

class Heidenhain : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(BothEngines, Heidenhain, testing::Values("model", "fast"),
                         [](const auto& engine) { return engine.param; });

// E1 (corpus/examples/heidenhain/face_milling.cpp): block 13 of the manual with the re-worked ball.
TEST_P(Heidenhain, BlockThirteenOfTheManual) {
  const Outcome outcome = toolcomp("run " + kReworked + " --engine " + GetParam());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto events = outcome.events();
  json block;
  for (const json& event : events)
    if (event.value("n", 0) == 16) block = event;
  EXPECT_NEAR(block.at("point").at("X"), 36.054981069776461, 1e-13);
  EXPECT_NEAR(block.at("tool_center").at("Y"), 8.144653760860809, 1e-13);
  EXPECT_NEAR(block.at("contact").at("Z"), -2.310969632306029, 1e-13);
  EXPECT_NEAR(block.at("shift").at("X"), 0.046581069776461, 1e-13);
  EXPECT_NEAR(block.at("normal").at(2), 0.884884395753506, 1e-13);
}

// E16 with an alarm behind it: M107 is missing.
TEST_P(Heidenhain, AnAlarmIsTheResult) {
  const Folder folder;
  const std::string setup =
      folder.write("setup.toml", "control = \"heidenhain\"\n[[tool]]\nnumber = 1\nR = 5\nR2 = 2\n");
  const std::string program =
      folder.write("p.h", "TOOL CALL 1 Z DR+0.3\nL X+1 R0 FMAX\nLN X+0 Y+0 Z+0 NX+0.6 NY+0 NZ+0.8\n");
  const Outcome outcome = toolcomp("run " + program + " --setup " + setup + " --engine " + GetParam());
  EXPECT_EQ(outcome.status, 0);
  ASSERT_EQ(outcome.events().size(), 2U);
  EXPECT_EQ(outcome.events()[1].at("number"), "E_OVERSIZE_DR");
  EXPECT_NE(outcome.err.find("p.h:3:"), std::string::npos) << outcome.err;
}

// The fault stands in the second line of the block.
TEST_P(Heidenhain, AFaultIsShownWhereItStands) {
  const Folder folder;
  const std::string setup = folder.write("setup.toml", "control = \"heidenhain\"\n");
  const std::string program = folder.write("p.h", "0 BEGIN PGM A MM\n1 L X+1 ~\n  Y+2 Q+3\n");
  const Outcome outcome = toolcomp("run " + program + " --setup " + setup + " --engine " + GetParam());
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.events().at(0).at("number"), "E_SYNTAX");
  EXPECT_EQ(outcome.events().at(0).at("line"), 2);
  EXPECT_NE(outcome.err.find("p.h:3:7:"), std::string::npos) << outcome.err;
}

// RL without TCPM is not modelled: the run goes on and says so at its end.
TEST_P(Heidenhain, WhatIsOutOfScopeIsNoSilentPass) {
  const Folder folder;
  const std::string setup = folder.write("setup.toml", "control = \"heidenhain\"\n[[tool]]\nnumber = 1\nR = 5\n");
  const std::string program = folder.write("p.h", "TOOL CALL 1 Z\nL X+1 R0\nL X+2 RL\nL X+3 R0\n");
  const Outcome outcome = toolcomp("run " + program + " --setup " + setup + " --engine " + GetParam());
  EXPECT_EQ(outcome.status, 3);
  ASSERT_EQ(outcome.events().size(), 3U);
  EXPECT_EQ(outcome.events()[1].at("kind"), "undecided");
  EXPECT_EQ(outcome.events()[1].at("reason"), "OUT_OF_SCOPE");
  EXPECT_EQ(outcome.events()[2].at("point").at("X"), 3);
}

// The units of a plain program are those of BEGIN PGM.
TEST_P(Heidenhain, PlainProgramsSayTheUnitsOfTheProgram) {
  const Folder folder;
  const std::string setup = folder.write("setup.toml", "control = \"heidenhain\"\n");
  const std::string program = folder.write("p.h", "BEGIN PGM A INCH\nL X+1 R0 FMAX\nEND PGM A INCH\n");
  const Outcome outcome = toolcomp("run " + program + " --setup " + setup + " --format gcode --engine " + GetParam());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("%\nG90 G94 G20\n")) << outcome.out;
  EXPECT_NE(outcome.out.find("G00 X1"), std::string::npos) << outcome.out;
}

// A panel for every contact that differs, each with nominal and effective tool; the oversize shows the real one too.
TEST_P(Heidenhain, PicturesShowBothToolsAtTheContact) {
  const Outcome reworked = toolcomp("run " + kReworked + " --format svg --engine " + GetParam());
  ASSERT_EQ(reworked.status, 0) << reworked.err;
  EXPECT_GE(count(reworked.out, "cut by the plane of N and T"), 4U);
  EXPECT_NE(reworked.out.find("nominal (grey) R 3 R2 3, effective (blue) R 2.9 R2 2.9 mm"), std::string::npos);
  EXPECT_EQ(reworked.out.find("a tool as in the table"), std::string::npos);
  const Outcome oversize = toolcomp("run " + kOversize + " --format svg --engine " + GetParam());
  ASSERT_EQ(oversize.status, 0) << oversize.err;
  EXPECT_NE(oversize.out.find("effective (blue) R 3.2 R2 3.2 mm"), std::string::npos);
  EXPECT_NE(oversize.out.find("a tool as in the table (green) stays 0.2 away from the wall"), std::string::npos);
}

TEST(HeidenhainCommands, EveryExampleAgrees) {
  for (const char* name :
       {"reworked-ball-at-tip/reworked.h", "reworked-ball-at-center/reworked.h", "oversize-at-tip/oversize.h",
        "oversize-at-center/oversize.h", "reworked-end-mill-flank/flank.h", "ball-on-contour/contour.h"})
    EXPECT_EQ(toolcomp("diff " + kExamples + name).status, 0) << name;
}

TEST(HeidenhainCommands, ExplainShowsTheBlockAsWritten) {
  const Outcome outcome = toolcomp("explain " + kReworked + " --block 16");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("16 LN X+36.0084 Y+6.177 Z-1.9209"), std::string::npos);
  EXPECT_NE(outcome.out.find("heidenhain.face.along-the-tool"), std::string::npos);
  EXPECT_NE(outcome.out.find("heidenhain.face.effective-tip"), std::string::npos);
  EXPECT_NE(outcome.out.find("  double  {"), std::string::npos);
}

TEST(HeidenhainCommands, FuzzAndCertifyKnowTheSections) {
  const Outcome fuzz = toolcomp("fuzz --section heidenhain/face-milling --runs 60 --seed 3");
  EXPECT_EQ(fuzz.status, 0) << fuzz.out << fuzz.err;
  const Folder folder;
  const std::string served = std::string(TOOLCOMP_BINARY_DIR) + "/toolcomp serve --engine fast";
  const Outcome certified =
      toolcomp("certify --controller '" + served + "' --setup " + kExamples + "reworked-ball-at-tip/setup.toml " +
               kReworked + " --report " + folder.path("report"));
  EXPECT_EQ(certified.status, 0) << certified.out << certified.err;
}

// A program in two files: lines count on in the second, for every command.
TEST(HeidenhainCalls, FilesBesideTheProgram) {
  const Folder folder;
  std::ignore = folder.write("setup.toml", "control = \"heidenhain\"\n");
  const std::string main =
      folder.write("main.h", "BEGIN PGM MAIN MM\nL X1\nCALL PGM PASS.H\nCALL PGM \"pass\"\nL X0\nEND PGM MAIN MM\n");
  std::ignore = folder.write("Pass.H", "BEGIN PGM PASS MM\nLBL 1\nL IY1\nCALL LBL 1 REP 1\nEND PGM PASS MM\n");
  std::vector<std::string> ran;
  for (const json& event : toolcomp("run " + main).events())
    ran.push_back(std::to_string(event.at("line").get<int>()) + ' ' + event.at("point").at("Y").dump());
  EXPECT_EQ(ran, (std::vector<std::string>{"2 0", "9 1", "9 2", "9 3", "9 4", "5 4"}));
  EXPECT_EQ(toolcomp("diff " + main).status, 0);
  const Outcome explained = toolcomp("explain " + main + " --block 9");
  EXPECT_EQ(explained.status, 0) << explained.err;
  EXPECT_EQ(count(explained.out, "line 9: L IY1"), 1U);
  EXPECT_EQ(count(explained.out, "  exact "), 4U);

  // From standard input nothing stands beside it.
  const Outcome alone = toolcomp("run - --setup " + folder.path("setup.toml") + " < " + main);
  EXPECT_NE(alone.err.find(":3:1: E_NO_PROGRAM "), std::string::npos) << alone.err;
}

TEST(HeidenhainCalls, WhatIsNotSupportedSaysItsNameAndPlace) {
  const Folder folder;
  std::ignore = folder.write("setup.toml", "control = \"heidenhain\"\n");
  const std::string program = folder.write("p.h", "L X1\n7 RND R2\n");
  const Outcome outcome = toolcomp("run " + program);
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("p.h:2:3: RND (rounding) is not supported"), std::string::npos) << outcome.err;
}

// Each verb says where it stops to judge, and how much it did not look at; none of them ends with 0.
TEST(HeidenhainPrograms, WhatIsNotJudgedIsSaidByEveryVerb) {
  const Folder folder;
  std::ignore = folder.write("setup.toml",
                             "control = \"heidenhain\"\naxes = [\"X\", \"Y\", \"Z\", \"A\", \"B\", \"C\"]\n"
                             "[[tool]]\nnumber = 1\nR = 3\n");
  const std::string tilted = folder.write(
      "tilted.h", "TOOL CALL 1 Z\nL X+5 R0 F100\nPLANE SPATIAL SPA+0 SPB+45 SPC+0 TURN FMAX\nL X+6\nL X+7\n");
  const std::string beside = folder.write("beside.h", "TOOL CALL 1 Z\nL X+5 RL F100\nL X+6\nL X+7 R0\n");
  for (const char* verb : {"run --engine model ", "run --engine fast ", "run --format svg ", "diff ", "explain "}) {
    const Outcome plane = toolcomp(verb + tilted);
    EXPECT_EQ(plane.status, 3) << verb;
    EXPECT_NE(plane.err.find("tilted.h:3:1: PLANE SPATIAL (tilted working plane) is not judged\n"
                             "not run: 2 blocks after it\n"),
              std::string::npos)
        << verb << plane.err;
    const Outcome open = toolcomp(verb + beside);
    EXPECT_EQ(open.status, 3) << verb;
    EXPECT_NE(open.err.find("beside.h:2:1: OUT_OF_SCOPE "), std::string::npos) << verb << open.err;
    EXPECT_NE(open.err.find("not judged: 2 moves of this kind\n"), std::string::npos) << verb << open.err;
  }
  const Outcome certified = toolcomp("certify --controller '" TOOLCOMP_BINARY_DIR "/toolcomp serve --engine fast' " +
                                     tilted + " --report " + folder.path("report"));
  EXPECT_EQ(certified.status, 3) << certified.err;
  EXPECT_NE((certified.out + certified.err).find("2 of 5 blocks were judged (40 %)"), std::string::npos)
      << certified.out << certified.err;
  const Outcome run = toolcomp("run " + tilted);
  EXPECT_EQ(run.events().size(), 2U);
  EXPECT_EQ(run.events().back().at("kind"), "not_judged");
  EXPECT_EQ(run.events().back().at("code"), "PLANE SPATIAL");
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// Programs as they come, as a user runs them: what is not supported says its name with its place, and programs are
// called from files beside.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "tests/command_line/command.h"

namespace {

using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::toolcomp;

class FanucPrograms : public testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] Outcome run(const std::string& program) const {
    return toolcomp("run " + folder.write("p.nc", program) + " --setup " + setup + " --engine " + GetParam());
  }
  Folder folder;
  std::string setup = folder.write("setup.toml", "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n");
};
INSTANTIATE_TEST_SUITE_P(BothEngines, FanucPrograms, testing::Values("model", "fast"),
                         [](const auto& engine) { return engine.param; });

TEST_P(FanucPrograms, WhatIsNotSupportedSaysItsNameAndPlace) {
  struct Row {
    const char* block;
    const char* said;
    const char* code;  // of what is not supported; empty: an alarm of the control
  };
  const Row rows[] = {
      {"N10 G98 G68 X1 R2", "p.nc:2:9: G68 (coordinate system rotation) is not supported", "G68"},
      {"G68 X0 Y0 R45.", "p.nc:2:1: G68 (coordinate system rotation) is not supported", "G68"},
      {"  X#1", "p.nc:2:3: # (a macro variable without a known value) is not supported", "#"},
      {"G01 X1 ,R5", "p.nc:2:8: ,R (corner rounding) is not supported", ",R"},
      {"X1 G77.7", "PS0010 there is no such G code", ""},
      {"N5 M98 P7", "p.nc:2:4: PS0076 M98: there is no program with this number", ""},
  };
  for (const auto& [block, said, code] : rows) {
    const Outcome outcome = run(std::string("G80 G69 X1\n") + block + "\nX9\n");
    const bool beyond = *code != 0;
    EXPECT_EQ(outcome.status, beyond ? 3 : 0) << block;
    ASSERT_EQ(outcome.events().size(), 2U) << block;
    EXPECT_EQ(outcome.events().back().at("kind"), beyond ? "not_supported" : "alarm") << block;
    EXPECT_EQ(outcome.events().back().value("code", ""), code);
    EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("not run: 1 block after it") != std::string::npos, beyond) << outcome.err;
  }
}

TEST_P(FanucPrograms, FilesBesideAreCalled) {
  const std::string sub = folder.write("o0007.NC", "O7\nG91 X1\nM99 P30\n");
  const Outcome outcome = run("O1\nM98 P20007\nX50\nN30 Y2\nM30\n");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  ASSERT_EQ(outcome.events().size(), 2U);
  EXPECT_EQ(outcome.events()[0].at("line"), 7) << "behind the five of the main program";
  EXPECT_EQ(outcome.events()[1].at("axes").at("X"), 1);
  EXPECT_EQ(outcome.events()[1].at("axes").at("Y"), 2);
  // What is wrong in a file is told where it stands in it, whatever was joined before.
  const std::string second = folder.write("8.nc", "O8\nX1\n  G68 X1\n");
  const Outcome alarm = run("O1\nM98 P7\nN30 M98 P8\nM30\n");
  EXPECT_EQ(alarm.status, 3) << alarm.err;
  EXPECT_NE(alarm.err.find("8.nc:3:3: G68 "), std::string::npos) << alarm.err;
  EXPECT_EQ(alarm.events().back().at("line"), 10) << "of the joined text";
  EXPECT_EQ(folder.write("8.nc", "O8\nX1 \xFF\n"), second);
  const Outcome bytes = run("O1\nM98 P8\nM30\n");
  EXPECT_EQ(bytes.status, 2);
  EXPECT_NE(bytes.err.find("8.nc:2:4: "), std::string::npos) << bytes.err;
  // Two files of one program are an error of the input.
  const std::string other = folder.write("7.txt", "X1\n");
  const Outcome both = run("M98 P7\n");
  EXPECT_EQ(both.status, 2);
  EXPECT_NE(both.err.find("o0007.NC"), std::string::npos) << both.err;
  EXPECT_NE(both.err.find("7.txt"), std::string::npos) << both.err;
}

}  // namespace

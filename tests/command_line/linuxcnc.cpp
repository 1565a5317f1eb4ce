// SPDX-License-Identifier: Apache-2.0
// program: linuxcnc
// alone with: linuxcnc
// The adapters of LinuxCNC with LinuxCNC itself, where its package is installed: a handful of programs.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>

#include "tests/command_line/command.h"

namespace {

using nlohmann::json;
using toolcomp::test::command;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::read;
using toolcomp::test::toolcomp;

const std::string kSetups = TOOLCOMP_SOURCE_DIR "/adapters/linuxcnc/setups/";

class LinuxCnc : public testing::Test {
 protected:
  Folder folder;

  void SetUp() override {
    if (command("command -v linuxcnc halsampler rs274").status != 0) GTEST_SKIP() << "linuxcnc-uspace is not installed";
    if (command("pgrep -x rtapi_app").status == 0) GTEST_SKIP() << "LinuxCNC is running: one instance at a time";
  }
  [[nodiscard]] Outcome motion(const std::string& machine, const std::string& more,
                               const std::string& shell = "") const {
    return toolcomp("certify --controller linuxcnc-motion --setup " + kSetups + machine + ".toml --report " +
                        folder.path("report") + " " + more,
                    shell);
  }
};

TEST_F(LinuxCnc, TheInterpreterAgrees) {
  const Outcome outcome = toolcomp(
      "certify --controller linuxcnc --section fanuc/tool-length-offset "
      "--section fanuc/cutter-compensation-c --cases 200 --report " +
      folder.path("report"));
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const json certificate = json::parse(read(folder.path("report/certificate.json")));
  for (const json& section : certificate.at("sections")) EXPECT_GT(section.at("results").at("agrees"), 5) << section;
  // What it does otherwise is counted by name, and said.
  EXPECT_GT(certificate.at("sections")[1].at("known_differences").at("outer-corner"), 0);
  EXPECT_NE(certificate.at("verdict").get<std::string>().find(" cases differ by design"), std::string::npos);
  EXPECT_NE(
      certificate.at("known_differences").at("outer-corner").get<std::string>().find("fanuc.cutter-c.outer-obtuse"),
      std::string::npos);
}

TEST_F(LinuxCnc, ThreeAxesConform) {
  const Outcome outcome = motion("three-axes", "--cases 6");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("6 programs, conforms 6"), std::string::npos) << outcome.out;
}

TEST_F(LinuxCnc, ATrunnionConforms) {
  const Outcome outcome = motion("xyzac-trt", "--cases 2");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

// The judge alone is told 0.01 mm more between the axes, or the other sense of a rotary axis.
TEST_F(LinuxCnc, AWrongMachineIsFound) {
  EXPECT_EQ(motion("xyzac-trt", "--cases 2 --altered 19704=-20.49").status, 1);
  EXPECT_EQ(motion("5axis", "--cases 2 --altered 19689=0").status, 1);
}

// A kit for what LinuxCNC has, its programs run with offsets typed into LinuxCNC's own table, recorded and judged.
TEST_F(LinuxCnc, AKitConformsAndAWrongOffsetIsNamed) {
  const std::string setup =
      read(kSetups + "xyzac-trt.toml") + "\n[workpiece.G54]\nX = 30\nY = -20\nZ = 10\n[position]\nX = 1\nZ = 2\n";
  const Outcome made = toolcomp("kit make --setup " + folder.write("machine.toml", setup) + " --out " +
                                folder.path("kit") + " --controller linuxcnc-motion --cases 60 --travel X=-500,500 " +
                                "--travel Y=-500,500 --travel Z=-500,500 --travel A=-720,720 --travel C=-720,720 "
                                "--section fanuc/tool-length-offset --section fanuc/cutter-compensation-c "
                                "--section fanuc/tool-center-point-control");
  ASSERT_EQ(made.status, 0) << made.err;
  const json kit = json::parse(read(folder.path("kit/kit.json")));
  ASSERT_EQ(kit.at("programs").size(), 1U);  // a minute each
  std::map<std::string, int> cases;
  for (const json& program : kit.at("programs"))
    for (const json& c : program.at("cases")) ++cases[c.at("section").get<std::string>()];
  EXPECT_EQ(cases.size(), 3U);
  for (const auto& [section, count] : cases) EXPECT_GT(count, 0) << section;

  const auto record = [&](const std::string& folder_name, const std::string& more) {
    const Outcome ran = command("/usr/bin/python3 " TOOLCOMP_SOURCE_DIR "/adapters/linuxcnc/kit.py " +
                                folder.path("kit") + " " + folder.path(folder_name) + more);
    EXPECT_EQ(ran.status, 0) << ran.err;
    return toolcomp("kit judge " + folder.path("kit") + " " + folder.path(folder_name) + " --report " +
                    folder.path("certificate"));
  };
  const Outcome right = record("right", "");
  EXPECT_EQ(right.status, 0) << right.out << right.err;
  // The length under tool center point control is off by 0.1.
  const std::string program = read(folder.path("kit/" + kit.at("programs")[0].at("file").get<std::string>()));
  const std::string number = std::to_string(std::stoi(program.substr(program.find("G43.4 H") + 7)));
  const std::string offsets = read(folder.path("kit/offsets.csv"));
  const std::string row = "H and D," + number + ",";
  const double length = std::stod(offsets.substr(offsets.find(row) + row.size()));
  const Outcome wrong = record("wrong", " --offset H" + number + "=" + std::to_string(length - 0.1));
  EXPECT_EQ(wrong.status, 1) << wrong.out << wrong.err;
  EXPECT_NE(wrong.out.find("one mistake explains everything found: H" + number + " (here "), std::string::npos)
      << wrong.out;
  EXPECT_NE(wrong.out.find(" is off by -0.1"), std::string::npos) << wrong.out;
}

// What needs no LinuxCNC.
TEST(LinuxCncAdapter, TranslatesAndCuts) {
  if (command("test -x /usr/bin/python3").status != 0) GTEST_SKIP() << "python3 is not installed";
  const Outcome outcome = command("/usr/bin/python3 " TOOLCOMP_SOURCE_DIR "/tests/adapters/linuxcnc.py");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

// The command killed, then the adapter: the next start works, and nothing is left.
TEST_F(LinuxCnc, TheNextStartRecovers) {
  EXPECT_NE(motion("three-axes", "--cases 40", "timeout -s KILL 6 ").status, 0);
  const std::string certify = TOOLCOMP_BINARY_DIR "/toolcomp certify --controller linuxcnc-motion --cases 40 --setup " +
                              kSetups + "three-axes.toml --report " + folder.path("report");
  const Outcome killed =
      command("{ " + certify + " & p=$!; sleep 6; kill -KILL $(cat /proc/$p/task/$p/children); wait $p; }");
  EXPECT_EQ(killed.status, 3) << killed.out << killed.err;
  EXPECT_NE(killed.err.find("killed by signal 9"), std::string::npos) << killed.err;
  const Outcome outcome = motion("three-axes", "--cases 1");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_FALSE(std::filesystem::exists("/tmp/linuxcnc.lock"));
  EXPECT_NE(command("pgrep -x rtapi_app").status, 0);
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// The formal specification as a controller: `--controller spec`.
#include <gtest/gtest.h>

#include <string>

#include "spec_engine/engine.h"
#include "tests/command_line/command.h"

namespace {

using toolcomp::test::command;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::read;
using toolcomp::test::toolcomp;
using Json = nlohmann::json;

class CertifySpecification : public testing::Test {
 protected:
  void SetUp() override {
    if (!::toolcomp::spec_engine::available()) GTEST_SKIP() << "built without Coq or OCaml";
  }
  Folder folder_;
};

TEST_F(CertifySpecification, ConformsWhereItSaysAll) {
  const Outcome outcome =
      toolcomp("certify --controller spec --section fanuc/tool-offset --cases 50 --report " + folder_.path("report"));
  EXPECT_TRUE(outcome.status == 0 || outcome.status == 3) << outcome.out << outcome.err;
  const Json certificate = Json::parse(read(folder_.path("report/certificate.json")));
  EXPECT_TRUE(certificate["findings"].empty()) << outcome.out;
  EXPECT_NE(outcome.out.find(" 0 differ"), std::string::npos) << outcome.out;
  EXPECT_EQ(certificate["controller"]["name"], "toolcomp formal specification");
}

TEST_F(CertifySpecification, NamesThePackagesItNeeds) {
  EXPECT_EQ(toolcomp("certify --packages --controller spec").out, "coq\nocaml-nox\nocaml-findlib\n");
}

TEST_F(CertifySpecification, DiffHoldsItAgainstTheModel) {
  const std::string setup = folder_.write("setup.toml", "control = \"fanuc\"\n[offsets.H]\n1 = 4\n");
  const std::string program = folder_.write("a.nc", "G43 Z10. H1\nG02 X10. R-5.5\n");
  const Outcome agrees = toolcomp("diff --engines model,spec " + program + " --setup " + setup);
  EXPECT_EQ(agrees.status, 0) << agrees.out << agrees.err;
  EXPECT_NE(agrees.err.find("agrees"), std::string::npos) << agrees.err;
  const std::string wrong = folder_.write("b.nc", "G41 D1 X10.\n");
  EXPECT_EQ(toolcomp("diff --engines model,spec " + wrong + " --setup " + setup).status, 0);
}

// It goes through the list of blocks as a whole: a program may have 50,000.
TEST_F(CertifySpecification, SaysNothingOfLongerPrograms) {
  constexpr int kBlocks = 50'001;
  std::string text;
  for (int i = 0; i < kBlocks; ++i) text += "X1.\n";
  const std::string setup = folder_.write("setup.toml", "control = \"fanuc\"\n");
  const Outcome silent = toolcomp("diff --engines model,spec " + folder_.write("long.nc", text) + " --setup " + setup);
  EXPECT_EQ(silent.status, 3) << silent.out << silent.err;
  EXPECT_NE(silent.err.find("more than 50,000 blocks"), std::string::npos) << silent.err;
}

// By hand: G43 puts H1 = 5.25 on Z; three quarters of a circle from (5, 0) about (5, 5) clockwise; G49 takes it away.
TEST_F(CertifySpecification, GivesEvents) {
  const std::string request = R"({"case":1,"id":"b","setup":{"control":"fanuc","offsets":{"H":{"1":"5.25"}}},)"
                              R"("program":"G43 Z10 H1\nG01 X5 F100\nG02 X10 Y5 I0 J5\nG49\n"})";
  const Outcome outcome =
      command("printf '%s\\n' '" + request + "' | " TOOLCOMP_BINARY_DIR "/toolcomp serve --engine spec");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const Json events = Json::parse(outcome.out)["events"];
  ASSERT_EQ(events.size(), 4U) << outcome.out;
  EXPECT_EQ(events[0]["axes"]["Z"], 15.25);
  EXPECT_EQ(events[2]["sweep"], 270);
  EXPECT_EQ(events[2]["center"], (Json{{"X", 5}, {"Y", 5}}));
  EXPECT_EQ(events[3]["axes"], (Json{{"X", 10}, {"Y", 5}, {"Z", 10}}));
}

// By hand: under RL along X the tool, 0.5 smaller than the table says, stands 0.5 to the right of the contour, which
// begins at right angles to it; then it leaves it.
TEST_F(CertifySpecification, GivesEventsOfKlartext) {
  const std::string request =
      R"({"case":1,"id":"c","dialect":"klartext","setup":{"control":"heidenhain","tool":[{"number":1,"R":5,"DR":"-0.5"}]},)"
      R"("program":"TOOL CALL 1 Z\nL Y-8 M128\nL Y0 RL\nL X20\nL Y30 R0\n"})";
  const Outcome outcome =
      command("printf '%s\\n' '" + request + "' | " TOOLCOMP_BINARY_DIR "/toolcomp serve --engine spec");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const Json events = Json::parse(outcome.out)["events"];
  ASSERT_EQ(events.size(), 4U) << outcome.out;
  EXPECT_EQ(events[1]["cause"], "start-up");
  EXPECT_EQ(events[1]["point"], (Json{{"X", 0}, {"Y", -0.5}, {"Z", 0}}));
  EXPECT_EQ(events[2]["point"], (Json{{"X", 20}, {"Y", -0.5}, {"Z", 0}}));
  EXPECT_EQ(events[3]["cause"], "cancel");
  EXPECT_EQ(events[3]["point"], (Json{{"X", 20}, {"Y", 30}, {"Z", 0}}));
}

}  // namespace

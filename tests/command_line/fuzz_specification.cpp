// SPDX-License-Identifier: Apache-2.0
// The formal specification as the third voice of a campaign.
#include <gtest/gtest.h>

#include <string>

#include "formal/engine.h"
#include "tests/command_line/command.h"

namespace {

using toolcomp::test::command;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::read;
using toolcomp::test::toolcomp;
using Json = nlohmann::json;

class ThirdVoice : public testing::Test {
 protected:
  void SetUp() override {
    if (!::toolcomp::formal::available()) GTEST_SKIP() << "built without Coq or OCaml";
  }
  Folder folder;
  std::string dir = folder.path("c");
  std::string fuzz = "fuzz --campaign " + dir + " --built-in";
};

TEST_F(ThirdVoice, HasWhatWorkersKeepAndAgrees) {
  const Outcome outcome = toolcomp(fuzz + " --section fanuc/tool-length-offset --runs 200 --json");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const Json summary = Json::parse(outcome.out);
  const Json& voice = summary["specification"];
  EXPECT_EQ(voice["asked"], true);
  EXPECT_GT(voice["cases"], 20);
  EXPECT_EQ(voice["differ"], 0);
  EXPECT_EQ(voice["agreed"].get<int>() + voice["undecided"].get<int>() + voice["refused"].get<int>(), voice["cases"]);
  EXPECT_GT(voice["agreed"], 20);
  EXPECT_NE(outcome.err.find("formal specification: "), std::string::npos) << outcome.err;
  // What it has had it is not asked again.
  const Outcome next = toolcomp(fuzz + " --section fanuc/tool-length-offset --runs 2 --json");
  EXPECT_LT(Json::parse(next.out)["specification"]["cases"].get<int>(), voice["cases"].get<int>() + 10) << next.out;
}

TEST_F(ThirdVoice, MakesCasesWhileNothingWaits) {
  const Outcome outcome = toolcomp(fuzz + " --target tool_offset_directed --for 4s --json");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const Json summary = Json::parse(outcome.out);
  EXPECT_GT(summary["specification"]["cases"], summary["targets"][0]["executions"].get<int>() / 100);
  EXPECT_EQ(summary["specification"]["differ"], 0);
}

TEST_F(ThirdVoice, IsLeftOutWhereItIsNotWanted) {
  const Outcome outcome = toolcomp(fuzz + " --target tool_offset_directed --runs 20 --no-specification --json");
  const Json summary = Json::parse(outcome.out);
  EXPECT_EQ(summary["specification"]["asked"], false);
  EXPECT_EQ(summary["specification"]["cases"], 0);
  EXPECT_EQ(outcome.err.find("formal specification"), std::string::npos) << outcome.err;
}

// The model takes G44 for G43.
TEST_F(ThirdVoice, SaysThatTheModelStandsAlone) {
  const Outcome outcome = command(TOOLCOMP_BINARY_DIR "/toolcomp_with_wrong_model " + fuzz +
                                  " --target tool_length_offset_directed --runs 300 --json");
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  const Json summary = Json::parse(outcome.out);
  ASSERT_FALSE(summary["findings"].empty()) << outcome.out;
  for (const Json& finding : summary["findings"]) {
    const std::string story = read(finding["folder"].get<std::string>() + "/finding.txt");
    EXPECT_EQ(finding["voices"], "the model stands alone: fast engine and formal specification agree") << story;
    EXPECT_NE(story.find("clause    fanuc."), std::string::npos) << story;
    EXPECT_NE(story.find("stage     shrunk"), std::string::npos) << story;
  }
}

TEST_F(ThirdVoice, SaysThatTheFastEngineStandsAlone) {
  const Outcome outcome = command("TOOLCOMP_FAULT=g44_as_g43 " TOOLCOMP_BINARY_DIR "/toolcomp_with_faults " + fuzz +
                                  " --target tool_length_offset_directed --runs 300");
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("  the fast engine stands alone: model and formal specification agree\n"),
            std::string::npos)
      << outcome.out;
  EXPECT_EQ(outcome.out.find("the model stands alone"), std::string::npos) << outcome.out;
}

// What it sees itself, in cases that it makes. Its finding is held exactly again; without the fault it agrees.
TEST_F(ThirdVoice, ItsFindingIsReplayed) {
  const std::string wrong = TOOLCOMP_BINARY_DIR "/toolcomp_with_wrong_model ";
  const Outcome outcome = command(wrong + fuzz + " --target tool_length_offset_directed --for 5s --json");
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  EXPECT_GT(Json::parse(outcome.out)["specification"]["differ"], 0);
  const std::string found = command("ls -d " + dir + "/findings/specification--fanuc.*").out;
  ASSERT_FALSE(found.empty());
  const std::string folder_of_it = found.substr(0, found.find('\n'));
  const std::string story = read(folder_of_it + "/finding.txt");
  EXPECT_NE(story.find("kind      specification\n"), std::string::npos) << story;
  EXPECT_NE(story.find("voices    the model stands alone: fast engine and formal specification agree\n"),
            std::string::npos)
      << story;
  const Outcome again = command(wrong + "replay " + folder_of_it + "/finding.json");
  EXPECT_EQ(again.status, 1) << again.out << again.err;
  EXPECT_NE(again.err.find("asked: spec\ndiffers, as in the finding"), std::string::npos) << again.err;
  EXPECT_EQ(toolcomp("replay " + folder_of_it + "/finding.json").status, 0);
}

}  // namespace

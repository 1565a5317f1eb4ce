// SPDX-License-Identifier: Apache-2.0
// The formal specification as the third voice of a campaign.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "spec_engine/engine.h"
#include "tests/command_line/campaign.h"

namespace {

using toolcomp::test::Background;
using toolcomp::test::comes_true;
using toolcomp::test::command;
using toolcomp::test::dossiers;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::read;
using toolcomp::test::toolcomp;
using Json = nlohmann::json;
namespace fs = std::filesystem;

class ThirdVoice : public testing::Test {
 protected:
  void SetUp() override {
    if (!::toolcomp::spec_engine::available()) GTEST_SKIP() << "built without Coq or OCaml";
  }
  Folder folder;
  std::string dir = folder.path("c");
  std::string fuzz = "fuzz --campaign " + dir + " --built-in";

  // Ends a campaign as soon as something is true of its folder; what it prints.
  template <class Condition>
  Json until(const std::string& command_line, Condition condition) {
    const Background campaign("exec " + command_line + " --for 1h --json");
    EXPECT_TRUE(comes_true([&] { return fs::exists(dir + "/state.json") && condition(); }));
    EXPECT_TRUE(campaign.end(SIGINT));
    return Json::parse(campaign.out());
  }
  std::vector<fs::path> its_findings() const {
    std::vector<fs::path> list = dossiers(dir);
    std::erase_if(list, [](const fs::path& path) { return !path.filename().string().starts_with("specification--"); });
    return list;
  }
};

TEST_F(ThirdVoice, HasWhatWorkersKeepAndAgrees) {
  const Outcome outcome = toolcomp(fuzz + " --section fanuc/tool-length-offset --runs 100 --json");
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

// It has judged more than the inputs that workers kept for it, which `asked` lists.
TEST_F(ThirdVoice, MakesCasesWhileNothingWaits) {
  const auto makes_some = [&] {
    // The first slice is its own.
    std::istringstream statistics(read(fs::path(dir) / "work" / "00000001" / "statistics"));
    std::string name;
    std::int64_t executions = 0;
    statistics >> name >> executions;
    const std::string asked = read(dir + "/asked");
    return executions > std::ranges::count(asked, '\n');
  };
  const Json summary = until(TOOLCOMP_BINARY_DIR "/toolcomp " + fuzz + " --target tool_offset_directed", makes_some);
  EXPECT_GT(summary["specification"]["cases"], 0);
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
                                  " --target tool_length_offset_directed --runs 100 --json");
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
                                  " --target tool_length_offset_directed --runs 100");
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("  the fast engine stands alone: model and formal specification agree\n"),
            std::string::npos)
      << outcome.out;
  EXPECT_EQ(outcome.out.find("the model stands alone"), std::string::npos) << outcome.out;
}

// What it sees itself, in cases that it makes. Its finding is held exactly again; without the fault it agrees.
TEST_F(ThirdVoice, ItsFindingIsReplayed) {
  const std::string wrong = TOOLCOMP_BINARY_DIR "/toolcomp_with_wrong_model ";
  const Json summary =
      until(wrong + fuzz + " --target tool_length_offset_directed", [&] { return !its_findings().empty(); });
  EXPECT_GT(summary["specification"]["differ"], 0);
  ASSERT_FALSE(its_findings().empty());
  const std::string folder_of_it = its_findings()[0].string();
  const std::string story = read(folder_of_it + "/finding.txt");
  EXPECT_NE(story.find("kind      specification\n"), std::string::npos) << story;
  EXPECT_NE(story.find("voices    the model stands alone: fast engine and formal specification agree\n"),
            std::string::npos)
      << story;
  const Outcome again = command(wrong + "replay --yes " + folder_of_it + "/finding.json");
  EXPECT_EQ(again.status, 1) << again.out << again.err;
  EXPECT_NE(again.err.find("asked: spec\ndiffers, as in the finding"), std::string::npos) << again.err;
  EXPECT_EQ(toolcomp("replay --yes " + folder_of_it + "/finding.json").status, 0);
}

}  // namespace

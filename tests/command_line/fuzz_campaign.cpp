// SPDX-License-Identifier: Apache-2.0
// `toolcomp fuzz` with the built-in driver, in a folder that is named or a temporary one: it resumes, survives kills,
// tells bugs apart, merges.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <set>
#include <sstream>
#include <string>

#include "spec_engine/engine.h"
#include "tests/command_line/campaign.h"

namespace {

using toolcomp::test::alive;
using toolcomp::test::Background;
using toolcomp::test::comes_true;
using toolcomp::test::command;
using toolcomp::test::dossiers;
using toolcomp::test::entries;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::read;
using toolcomp::test::state_of;
using toolcomp::test::toolcomp;
using Json = nlohmann::json;
namespace fs = std::filesystem;

const std::string kSection = " --section fanuc/tool-length-offset";
const std::string kBuiltIn = " --built-in --no-specification";
const std::string kWithFaults = TOOLCOMP_BINARY_DIR "/toolcomp_with_faults ";

// The same command with a seeded fault in its fast engine.
Outcome with_fault(const std::string& fault, const std::string& arguments) {
  return command("TOOLCOMP_FAULT=" + fault + " " + kWithFaults + arguments);
}

// What tells findings apart, as their stories say it.
std::string key_of(const fs::path& dossier) {
  std::istringstream story(read((dossier / "finding.txt").string()));
  std::string key;
  for (std::string line; std::getline(story, line);)
    for (const char* name : {"section ", "clause ", "kind ", "shape "})
      if (line.starts_with(name)) key += line + '\n';
  return key;
}

std::size_t sightings(const std::string& campaign) { return entries(fs::path(campaign) / "findings/new").size(); }

// Clauses reached, over all targets.
std::size_t clauses(const Json& state) {
  std::size_t count = 0;
  for (const auto& target : state["targets"]) count += target["clauses"].size();
  return count;
}

// The number of a worker that has begun.
int a_worker(const std::string& campaign) {
  int process = 0;
  EXPECT_TRUE(comes_true([&] {
    if (!fs::exists(campaign + "/state.json")) return false;
    const Json state = state_of(campaign);
    for (const Json& running : state.value("running", Json::array()))
      if (running["executions"] > 20) process = running["process"];
    return process > 0;
  }));
  return process;
}

std::string without_seconds(const std::string& finding) {
  Json json = Json::parse(finding);
  json.erase("seconds");
  return json.dump();
}

class Campaign : public testing::Test {
 protected:
  Folder folder;
  std::string dir = folder.path("c");
  std::string fuzz = "fuzz --campaign " + dir + kBuiltIn;
};

// With a folder that is named, and without.
class Fuzz : public testing::TestWithParam<bool> {
 protected:
  Fuzz() { fs::create_directories(temporary); }

  Folder folder;
  std::string findings = folder.path("found");
  std::string temporary = folder.path("tmp");
  std::string environment = "TMPDIR=" + temporary + " TOOLCOMP_FAULT=g44_as_g43 ";
  std::string fuzz = "fuzz" + kBuiltIn + (GetParam() ? " --campaign " + folder.path("c") : "") + " --findings " +
                     findings + " --target tool_length_offset_directed";

  // The folder of the campaign: of one without a name while it is there.
  std::string dir() const {
    if (GetParam()) return folder.path("c");
    const std::vector<fs::path> list = entries(temporary);
    return list.empty() ? "" : list.front().string();
  }

  // One, which is replayed with the fault and agrees without it.
  void expect_one_finding(const Json& summary) const {
    ASSERT_EQ(summary["findings"].size(), 1U) << summary;
    const std::string file = summary["findings"][0]["folder"].get<std::string>() + "/finding.json";
    const Outcome again = command(environment + kWithFaults + "replay --yes " + file);
    EXPECT_EQ(again.status, 1) << file << again.out << again.err;
    const bool ours = Json::parse(read(file)).value("controller", "").empty();
    EXPECT_EQ(toolcomp("replay --yes " + file).status, ours ? 0 : 1) << file;
    ASSERT_EQ(entries(findings).size(), 1U);
    EXPECT_EQ(read(entries(findings)[0] / "finding.json"), read(file));
  }
};
INSTANTIATE_TEST_SUITE_P(InAFolder, Fuzz, testing::Bool(),
                         [](const auto& p) { return p.param ? "Named" : "Temporary"; });

TEST_P(Fuzz, OneFaultIsOneFinding) {
  const Outcome outcome = command(environment + kWithFaults + fuzz + " --runs 100 --json");
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  expect_one_finding(Json::parse(outcome.out));
  for (const char* words : {"\nFINDING ", "toolcomp replay ", "clause outcomes",
                            ::toolcomp::spec_engine::available() ? "the fast engine" : "not known who stands alone"})
    EXPECT_NE(outcome.err.find(words), std::string::npos) << words << '\n' << outcome.err;
  EXPECT_EQ(entries(temporary).size(), 0U) << "the temporary folder is left";
  // Found again it is the same, and nothing is written over: a campaign goes on, one without a name begins anew, and
  // with as many runs it meets the fault in the same ways.
  const std::string bytes = read(entries(findings)[0] / "finding.json");
  EXPECT_EQ(command(environment + kWithFaults + fuzz + (GetParam() ? " --runs 20" : " --runs 100") + " --json").status,
            1);
  EXPECT_EQ(entries(findings).size(), 1U);
  EXPECT_EQ(read(entries(findings)[0] / "finding.json"), bytes);
}

TEST_P(Fuzz, AWrongControllerIsOneFindingThatAsksItAgain) {
  const std::string wrong = TOOLCOMP_BINARY_DIR "/toolcomp_faulty_controller drop-event";
  const Outcome outcome =
      toolcomp(fuzz + " --runs 40 --json --controller '" + wrong + "'", "TMPDIR=" + temporary + " ");
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  expect_one_finding(Json::parse(outcome.out));
  const Outcome again = toolcomp("replay --yes " + (entries(findings)[0] / "finding.json").string());
  EXPECT_NE(again.err.find("asked: " + wrong), std::string::npos) << again.err;
}

TEST_P(Fuzz, AKillLosesNoFinding) {
  {
    const Background campaign("exec env " + environment + kWithFaults + fuzz + " --for 1h");
    const int worker = comes_true([&] { return !dir().empty(); }) ? a_worker(dir()) : 0;
    EXPECT_TRUE(comes_true([&] { return sightings(dir()) + dossiers(dir()).size() > 0; }));
    EXPECT_TRUE(campaign.end(SIGKILL));
    EXPECT_TRUE(comes_true([&] { return !alive(worker); })) << "the worker lives on";
    EXPECT_EQ(campaign.errors().find("--campaign " + dir() + "`") == std::string::npos, GetParam());
  }
  const std::vector<fs::path> kept = dossiers(dir());
  const std::size_t corpus = entries(dir() + "/corpus/tool_length_offset_directed").size();
  const Json before = state_of(dir());
  const Outcome next = command(environment + kWithFaults + "fuzz" + kBuiltIn + " --campaign " + dir() +
                               " --target tool_length_offset_directed --runs 2 --json --findings " + findings);
  EXPECT_EQ(next.status, 1) << next.out << next.err;
  const Json summary = Json::parse(next.out);
  expect_one_finding(summary);
  EXPECT_TRUE(std::ranges::includes(dossiers(dir()), kept));
  EXPECT_GE(entries(dir() + "/corpus/tool_length_offset_directed").size(), corpus);
  EXPECT_GE(clauses(state_of(dir())), clauses(before));
  EXPECT_GT(summary["executions_in_all"].get<std::uint64_t>(), before["executions"].get<std::uint64_t>());
  EXPECT_TRUE(entries(dir() + "/work").empty());
}

// What was looked at is there; what was not waits in the folder, which stays for it.
TEST_P(Fuzz, AnInterruptLosesNoFinding) {
  const Background campaign("exec env " + environment + kWithFaults + fuzz + " --for 1h --json");
  EXPECT_TRUE(comes_true([&] { return !dir().empty() && !dossiers(dir()).empty(); }));
  EXPECT_TRUE(campaign.end(SIGINT));
  const Json summary = Json::parse(campaign.out());
  expect_one_finding(summary);
  if (GetParam()) return;
  EXPECT_EQ(entries(temporary).empty(), summary["to_look_at"] == 0) << summary;
  const bool told = campaign.errors().find("--campaign " + dir() + "` resumes the campaign, with") != std::string::npos;
  EXPECT_EQ(told, !entries(temporary).empty()) << campaign.errors();
}

TEST_F(Campaign, EndsWithASummaryAndGoesOnWhereItStopped) {
  const Outcome first = toolcomp(fuzz + kSection + " --runs 100 --jobs 2 --seed 3");
  EXPECT_EQ(first.status, 0) << first.out << first.err;
  for (const char* words : {"start 1, seed 3, ", "tool_length_offset_directed", "clause outcomes", "seeded faults of",
                            "mutation score", "\nno finding\n"})
    EXPECT_NE(first.out.find(words), std::string::npos) << words << '\n' << first.out;
  EXPECT_FALSE(entries(dir + "/corpus/tool_length_offset_directed").empty());
  EXPECT_TRUE(entries(dir + "/work").empty());
  const Json before = state_of(dir);
  const Outcome second = toolcomp(fuzz + kSection + " --runs 20 --seed 3 --json");
  EXPECT_EQ(second.status, 0) << second.out << second.err;
  const Json summary = Json::parse(second.out);
  EXPECT_EQ(summary["starts"], 2);
  EXPECT_EQ(summary["verdict"], "no finding");
  EXPECT_GT(summary["executions_in_all"].get<std::uint64_t>(), before["executions"].get<std::uint64_t>());
  EXPECT_EQ(summary["targets"].size(), 2U);
  EXPECT_GE(clauses(state_of(dir)), clauses(before));
  EXPECT_EQ(read(dir + "/log").find("start 1: seed 3"), std::string("2026-01-01T00:00:00Z ").size());
}

// Corpus and findings, but for times.
TEST_F(Campaign, TheSameSeedGivesTheSameBytes) {
  const auto bytes = [&](const std::string& name) {
    const std::string campaign = folder.path(name);
    const Outcome outcome =
        with_fault("g44_as_g43", "fuzz --campaign " + campaign + kBuiltIn + kSection + " --runs 100 --seed 5");
    EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
    std::string all;
    for (const fs::path& file : entries(campaign + "/corpus/tool_length_offset_directed"))
      all += file.filename().string() + read(file);
    for (const fs::path& dossier : dossiers(campaign))
      all += dossier.filename().string() + without_seconds(read(dossier / "finding.json"));
    all += state_of(campaign)["findings"].dump();
    return all;
  };
  const std::string once = bytes("once");
  EXPECT_NE(once.find("G44"), std::string::npos);
  EXPECT_EQ(once, bytes("again"));
}

// A bug that shows at several clauses and in many programs is one finding, and each way it shows has one folder,
// however often it was met.
TEST_F(Campaign, ManyHitsOfOneBugAreOneFinding) {
  const Outcome outcome = with_fault("g44_as_g43", fuzz + " --target tool_length_offset_directed --runs 1000 --json");
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  const Json summary = Json::parse(outcome.out);
  EXPECT_GT(summary["targets"][0]["differ"], 50);
  ASSERT_EQ(summary["findings"].size(), 1U) << outcome.out;
  const Json& finding = summary["findings"][0];
  EXPECT_GT(finding["other_ways"].size(), 2U) << outcome.out;
  std::set<std::string> keys{key_of(finding["folder"].get<std::string>())};
  std::uint64_t cases = finding["cases"].get<std::uint64_t>();
  for (const Json& way : finding["other_ways"]) {
    EXPECT_TRUE(keys.insert(key_of(way["folder"].get<std::string>())).second) << outcome.out;
    cases += way["cases"].get<std::uint64_t>();
  }
  EXPECT_GE(cases, 2 * keys.size()) << outcome.out;
  EXPECT_EQ(dossiers(dir).size(), keys.size());
  const fs::path dossier = summary["findings"][0]["folder"].get<std::string>();
  for (const char* file : {"finding.json", "case.json", "expected.jsonl", "actual.jsonl", "picture.svg", "finding.txt"})
    EXPECT_GT(fs::file_size(dossier / file), 0U) << file;
  for (const char* words : {"found by  tool_length_offset_directed, seed ", "toolcomp replay", "stage     shrunk",
                            "The decision, exactly: "})
    EXPECT_NE(read(dossier / "finding.txt").find(words), std::string::npos) << words << read(dossier / "finding.txt");
  // With the fault it comes again, without it does not.
  EXPECT_EQ(with_fault("g44_as_g43", "replay --yes " + (dossier / "finding.json").string()).status, 1);
  EXPECT_EQ(toolcomp("replay --yes " + (dossier / "finding.json").string()).status, 0);
}

// Both miss a move of fanuc.length-offset.move-without-axis-word: the one of a lone G43, the other of a lone G49.
TEST_F(Campaign, TwoBugsAtOneClauseAreTwoFindings) {
  const auto at_the_clause = [&] {
    std::vector<fs::path> list = dossiers(dir);
    std::erase_if(list, [](const fs::path& path) {
      return !path.filename().string().starts_with("missing-event--fanuc.length-offset.move-without-axis-word--");
    });
    return list;
  };
  const std::string target = " --target tool_length_offset_directed";
  EXPECT_EQ(with_fault("zero_move_missing", fuzz + target + " --runs 400").status, 1);
  const auto first = at_the_clause();
  ASSERT_FALSE(first.empty());
  EXPECT_EQ(with_fault("g49_z_only", fuzz + target + " --runs 2000").status, 1);
  const auto both = at_the_clause();
  EXPECT_TRUE(std::ranges::includes(both, first));
  ASSERT_GT(both.size(), first.size());
  std::set<std::string> keys;
  for (const fs::path& dossier : both) keys.insert(key_of(dossier));
  EXPECT_EQ(keys.size(), both.size());
}

TEST_F(Campaign, AWorkerThatIsKilledOrCrashesIsReplaced) {
  const Background campaign(TOOLCOMP_BINARY_DIR "/toolcomp " + fuzz + kSection);
  const int first = a_worker(dir);
  ::kill(first, SIGKILL);
  EXPECT_TRUE(comes_true([&] { return state_of(dir)["ends"].contains("killed by signal 9"); }));
  int second = 0;
  EXPECT_TRUE(comes_true([&] { return (second = a_worker(dir)) != first; }));
  // Not SIGSEGV, which AddressSanitizer takes.
  ::kill(second, SIGABRT);
  EXPECT_TRUE(comes_true([&] { return state_of(dir)["ends"].contains("killed by signal 6"); }));
  EXPECT_NE(a_worker(dir), second);
  // A crash is a finding, also one that does not come again; its input is there.
  EXPECT_TRUE(comes_true([&] { return dossiers(dir).size() == 1; }));
  EXPECT_TRUE(campaign.end(SIGINT));
  EXPECT_NE(campaign.out().find("workers that ended by killed by signal 6: 1"), std::string::npos) << campaign.out();
  ASSERT_EQ(dossiers(dir).size(), 1U);
  const std::string story = read(dossiers(dir)[0] / "finding.txt");
  EXPECT_NE(story.find("not reproduced"), std::string::npos) << story;
}

class CampaignEndedBy : public Campaign, public testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(Signals, CampaignEndedBy, testing::Values(SIGINT, SIGTERM));

TEST_P(CampaignEndedBy, ASignalSaysWhatItHas) {
  const Background campaign(TOOLCOMP_BINARY_DIR "/toolcomp " + fuzz + kSection);
  const int worker = a_worker(dir);
  EXPECT_TRUE(campaign.end(GetParam()));
  // It is killed with its shell; who collects it then is not the campaign, and may take a moment.
  EXPECT_TRUE(comes_true([&] { return !alive(worker); })) << "the worker lives on";
  EXPECT_NE(campaign.out().find("clause outcomes"), std::string::npos) << campaign.out();
  EXPECT_FALSE(fs::exists(dir + "/running.json"));
}

TEST_F(Campaign, AFolderThatCannotBeWritten) {
  const std::string file = folder.write("file", "");
  EXPECT_EQ(toolcomp("fuzz --campaign " + file + "/c" + kSection + " --runs 2").status, 2);
  // Every write above 0 bytes fails, as on a full disk.
  const Outcome full = command("(trap '' XFSZ; ulimit -f 0; " TOOLCOMP_BINARY_DIR "/toolcomp " + fuzz + kSection +
                               " --runs 2 2>&1; echo status $?) | cat");
  EXPECT_NE(full.out.find("cannot be written"), std::string::npos) << full.out;
  EXPECT_NE(full.out.find("status 2\n"), std::string::npos) << full.out;
}

// In the middle of a run a worker cannot make files any more: what it found is in its black box, and comes to light.
TEST_F(Campaign, AFindingThatCannotBeWrittenIsThereAtTheNextStart) {
  // Without a pause, so that it is there before the first finding, and again, if one came between.
  const std::string findings = (std::filesystem::path(dir) / "work" / "00000001" / "findings").string();
  const std::string made = "until [ -d " + findings + " ]; do :; done; ";
  const std::string broken = "until [ -f " + findings + " ]; do rm -rf " + findings + "; echo >" + findings + "; done";
  const Outcome outcome = command("timeout 600 sh -c '" + made + broken + "' 2>/dev/null & TOOLCOMP_FAULT=g44_as_g43 " +
                                  kWithFaults + fuzz + " --target tool_length_offset_directed --for 10m");
  EXPECT_EQ(outcome.status, 2) << outcome.out << outcome.err;
  EXPECT_NE(outcome.err.find("could no longer write"), std::string::npos) << outcome.err;
  EXPECT_GE(sightings(dir), 1U);
  const Outcome next = with_fault("g44_as_g43", fuzz + " --target tool_length_offset_directed --runs 2");
  EXPECT_EQ(next.status, 1) << next.out << next.err;
  EXPECT_GE(dossiers(dir).size(), 1U) << next.out;
}

TEST_F(Campaign, ShardsMergeInAnyOrderToTheSameBytes) {
  std::string all;
  for (const std::string shard : {"1", "2", "3"}) {
    const std::string part = folder.path("shard" + shard);
    const Outcome outcome = with_fault(
        "g44_as_g43", "fuzz --campaign " + part + kBuiltIn + kSection + " --runs 120 --shard " + shard + "/3");
    EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
    all = part + " " + all;
  }
  const std::string one = folder.path("one");
  const std::string two = folder.path("two");
  EXPECT_EQ(toolcomp("fuzz --campaign " + one + " --merge " + all).status, 0);
  EXPECT_EQ(toolcomp("fuzz --campaign " + two + " --merge " + folder.path("shard2") + " " + folder.path("shard1") +
                     " " + folder.path("shard3"))
                .status,
            0);
  EXPECT_EQ(command("diff -r " + one + " " + two).out, "");
  const Json state = state_of(one);
  EXPECT_EQ(state["starts"], 3);
  EXPECT_GE(state["executions"], 3 * 120);
  EXPECT_FALSE(dossiers(one).empty());
  EXPECT_GE(entries(one + "/corpus/tool_length_offset_directed").size(),
            entries(folder.path("shard1") + "/corpus/tool_length_offset_directed").size());
  // It goes on as any other; into one that is there nothing is merged.
  EXPECT_EQ(toolcomp("fuzz --campaign " + one + kBuiltIn + kSection + " --runs 2").status, 1);
  EXPECT_EQ(toolcomp("fuzz --campaign " + one + " --merge " + two).status, 2);
  EXPECT_EQ(toolcomp("fuzz --campaign " + folder.path("x") + " --merge " + folder.path("none")).status, 2);
}

// A controller that judges nothing finds nothing, which is no verdict.
TEST_F(Campaign, NothingFoundMeansSomethingOnlyWhereSomethingWasJudged) {
  const std::string none = TOOLCOMP_BINARY_DIR "/toolcomp_faulty_controller one-section";
  const Outcome outcome =
      toolcomp("fuzz --campaign " + dir + " --target tool_offset_directed --runs 40 --controller '" + none + "'");
  EXPECT_EQ(outcome.status, 3) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("below its floor: tool_offset_directed: no value judged"), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("too short to count as a pass"), std::string::npos) << outcome.out;
}

TEST_F(Campaign, WhatItIsNotAsked) {
  for (const std::string wrong : {" --target nothing", " --section fanuc/nothing", " --shard 3/2", " --shard 1",
                                  " --runs 2 --for 3s", " --for soon"}) {
    const Outcome outcome = toolcomp(fuzz + wrong);
    EXPECT_EQ(outcome.status, 2) << wrong << outcome.out;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  }
  EXPECT_EQ(toolcomp("fuzz --merge " + dir).status, 2);
}

}  // namespace

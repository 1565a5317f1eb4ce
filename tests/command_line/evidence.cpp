// SPDX-License-Identifier: Apache-2.0
// What was found is there, whatever ended the run: a signal, a kill, a limit.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <string>

#include "tests/command_line/command.h"

namespace {

using toolcomp::test::command;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::read;
using toolcomp::test::toolcomp;
using Json = nlohmann::json;

const std::string kFaulty = TOOLCOMP_BINARY_DIR "/toolcomp_faulty_controller ";
const std::string kSection = " --section fanuc/tool-length-offset ";

// Without what a kill has left half written, under a name of its own.
std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> files;
  if (std::filesystem::is_directory(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() != ".part") files.push_back(entry.path().string());
  std::ranges::sort(files);
  return files;
}

// A controller that drops events and after some answers sends the signal to the command that runs it.
struct Ending {
  const Folder folder;
  const std::string report = folder.path("r");
  std::string controller(int signal) const {
    const std::string script =
        kFaulty + "drop-event | while IFS= read -r line; do n=$((n + 1)); printf '%s\\n' \"$line\"; " +
        "if [ $n = 40 ]; then kill -" + std::to_string(signal) + " $(cat " + folder.path("command") + "); fi; done\n";
    return "sh " + folder.write("controller", script);
  }
  Outcome run(const std::string& verb, int signal) const {
    return toolcomp(verb + " --controller '" + controller(signal) + "'" + kSection,
                    "sh -c 'echo $$ >" + folder.path("command") + "; exec \"$@\"' sh ");
  }
};

class EndedBy : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Signals, EndedBy, testing::Values(SIGINT, SIGTERM));

TEST_P(EndedBy, ASignalCertifyWritesWhatItHas) {
  const Ending ending;
  const Outcome outcome = ending.run("certify --cases 300 --report " + ending.report, GetParam());
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find(" not run: interrupted (SIG"), std::string::npos) << outcome.out;
  const Json certificate = Json::parse(read(ending.report + "/certificate.json"));
  EXPECT_NE(certificate["interrupted"], "");
  EXPECT_GT(certificate["cases_not_run"], 100);
  EXPECT_FALSE(certificate["findings"].empty());
  EXPECT_NE(read(ending.report + "/index.html").find("interrupted (SIG"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(ending.report + "/running.json"));
  for (const std::string& file : files_in(ending.report + "/findings"))
    EXPECT_EQ(toolcomp("replay " + file + " --controller '" + kFaulty + "drop-event'").status, 1) << file;
}

TEST(Kill, CertifyLosesNoFindingAndSaysSo) {
  const Ending ending;
  const Outcome outcome = ending.run("certify --cases 300 --report " + ending.report, SIGKILL);
  EXPECT_EQ(outcome.status, 128 + SIGKILL);
  const std::vector<std::string> findings = files_in(ending.report + "/findings");
  ASSERT_FALSE(findings.empty());
  for (const std::string& file : findings)
    EXPECT_EQ(toolcomp("replay " + file + " --controller '" + kFaulty + "drop-event'").status, 1) << file;
  const std::string kept = read(findings.front());
  // The next run says so, and keeps them.
  const Outcome next =
      toolcomp("certify --cases 5 --controller '" + kFaulty + "none'" + kSection + "--report " + ending.report);
  EXPECT_NE(next.err.find("ended without a report"), std::string::npos) << next.err;
  EXPECT_NE(next.err.find("its findings are in " + ending.report + "/interrupted-1"), std::string::npos) << next.err;
  ASSERT_EQ(files_in(ending.report + "/interrupted-1").size(), findings.size());
  EXPECT_EQ(read(files_in(ending.report + "/interrupted-1").front()), kept);
  // And the one after that has nothing to say.
  const Outcome last =
      toolcomp("certify --cases 5 --controller '" + kFaulty + "none'" + kSection + "--report " + ending.report);
  EXPECT_EQ(last.err.find("ended without a report"), std::string::npos) << last.err;
}

TEST(TimeLimit, WhatIsLeftIsCounted) {
  const Folder folder;
  const Outcome outcome = toolcomp("certify --time-limit 1s --cases 20000 --controller '" + kFaulty + "none'" +
                                   kSection + "--report " + folder.path("r"));
  EXPECT_EQ(outcome.status, 3) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("not decided: time limit of 1 s"), std::string::npos) << outcome.out;
  EXPECT_EQ(toolcomp("certify --time-limit soon --controller x").status, 2);
}

// Two runs do not share a folder.
TEST(Report, IsThatOfOneRunAtATime) {
  const Folder folder;
  const std::string report = folder.path("r");
  const std::string over = folder.path("over");
  const std::string slow =
      "sh " + folder.write("slow", "until [ -e " + over + " ]; do sleep 0.1; done; exec " + kFaulty + "none\n");
  const std::string certify =
      TOOLCOMP_BINARY_DIR "/toolcomp certify --cases 1" + kSection + "--report " + report + " --controller ";
  const Outcome outcome = command("(" + certify + "'" + slow + "' >/dev/null 2>&1 & until [ -e " + report +
                                  "/running.json ]; do sleep 0.1; done; " + certify + "'" + kFaulty +
                                  "none'; status=$?; touch " + over + "; wait; exit $status)");
  EXPECT_EQ(outcome.status, 2) << outcome.out;
  EXPECT_NE(outcome.err.find("is still working in this folder"), std::string::npos) << outcome.err;
}

// A controller is found again from another folder.
TEST(ReplayOfEvidence, RunsTheControllerWhereItWasRun) {
  const Folder folder;
  static_cast<void>(folder.write("controller", "exec " + kFaulty + "drop-event\n"));
  const Outcome outcome =
      command("cd " + folder.path("") +
              " && " TOOLCOMP_BINARY_DIR "/toolcomp certify --cases 10 --controller 'sh ./controller'" + kSection);
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  const std::vector<std::string> findings = files_in(folder.path("report/findings"));
  ASSERT_FALSE(findings.empty());
  EXPECT_EQ(toolcomp("replay --yes " + findings.front()).status, 1);
}

}  // namespace

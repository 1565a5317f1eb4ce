// SPDX-License-Identifier: Apache-2.0
// `toolcomp certify`, `fuzz`, `replay`, `explain`, `spec` and `corpus` as a user runs them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "tests/command_line/command.h"
#include "tests/effort.h"

namespace {

using nlohmann::json;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::toolcomp;

const std::string kTool = TOOLCOMP_BINARY_DIR "/toolcomp";
const std::string kServe = kTool + " serve --engine fast";
const std::string kExamples = TOOLCOMP_SOURCE_DIR "/examples/fanuc/";

// A wrapper around the fast engine; every answer to a case passes through the sed script.
std::string wrapper(const Folder& folder, const std::string& name, const std::string& script) {
  return "sh " + folder.write(name, kServe + " | sed -u '" + script + "'\n");
}

TEST(Certify, TheFastEngineConforms) {
  const Folder folder;
  const std::string cases = toolcomp::test::effort(" --cases 20", " --cases 100");
  const Outcome outcome =
      toolcomp("certify --controller '" + kServe + "'" + cases + " --report " + folder.path("report"));
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(folder.path("report/index.html")));
  EXPECT_TRUE(std::filesystem::exists(folder.path("report/junit.xml")));
  const json certificate = json::parse(toolcomp::test::read(folder.path("report/certificate.json")));
  EXPECT_TRUE(certificate.is_object());
}

// What the user says about a coarse controller: nothing is bad usage, with a line that names the option.
TEST(Certify, ACoarseResolutionMustBeAccepted) {
  const Folder folder;
  const std::string controller = wrapper(folder, "coarse.sh", R"(s/"protocol":1/"protocol":1,"resolution":"0.02"/)");
  const std::string arguments = "certify --controller '" + controller +
                                "' --section fanuc/tool-length-offset --cases 10 --report " + folder.path("report");
  const Outcome refused = toolcomp(arguments);
  EXPECT_EQ(refused.status, 2) << refused.out;
  EXPECT_NE(refused.err.find("--accept-resolution 0.02"), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(folder.path("report")));
  const Outcome accepted = toolcomp(arguments + " --accept-resolution 0.02");
  EXPECT_EQ(accepted.status, 0) << accepted.out << accepted.err;
  EXPECT_NE(accepted.out.find(" s; "), std::string::npos) << "time elapsed";
  EXPECT_NE(accepted.out.find("values not judged"), std::string::npos);
  EXPECT_EQ(toolcomp(arguments + " --accept-resolution 0.01").status, 2);
  EXPECT_EQ(toolcomp(arguments + " --accept-resolution no").status, 2);
}

// Every fault gives exit status 1 and a finding that replays.
class Faults : public testing::TestWithParam<std::pair<const char*, const char*>> {};
INSTANTIATE_TEST_SUITE_P(Wrappers, Faults,
                         testing::Values(std::pair{"flips_a_sign", R"(s/"axes":{"X":-/"axes":{"X":/)"},
                                         std::pair{"drops_an_event",
                                                   R"(s/{"kind":"move","line":3,[^}]*}[^}]*}[^}]*}[^}]*},//)"},
                                         std::pair{"prints_rubbish", R"(s/"events":/"events"=/)"}),
                         [](const auto& fault) { return fault.param.first; });

TEST_P(Faults, AreFound) {
  const Folder folder;
  const std::string controller = wrapper(folder, "controller.sh", GetParam().second);
  // Two sections: all of them take longer, and show no more.
  const Outcome outcome = toolcomp("certify --controller '" + controller +
                                   "' --section fanuc/tool-length-offset --section heidenhain/face-milling --cases 60"
                                   " --corpus " TOOLCOMP_SOURCE_DIR "/corpus/golden --timeout 120 --report " +
                                   folder.path("report"));
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  const std::filesystem::path findings = folder.path("report/findings");
  ASSERT_TRUE(std::filesystem::exists(findings));
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(findings)) {
    const json finding = json::parse(toolcomp::test::read(entry.path()));
    EXPECT_FALSE(finding.at("clause").get<std::string>().empty());
    if (count++ == 0) {
      EXPECT_EQ(toolcomp("replay --yes " + entry.path().string()).status, 1);
      EXPECT_EQ(toolcomp("replay --yes " + entry.path().string() + " --controller '" + kServe + "'").status, 0)
          << "the engine itself is right";
    }
  }
  EXPECT_GT(count, 0U);
}

// What is not settled says so; so does the time that was given.
TEST(Certify, SettlesWithinTheTimeGiven) {
  const Folder folder;
  const std::string command = "certify --controller '" +
                              wrapper(folder, "controller.sh", "s/\"X\":[-0-9.]*/\"X\":77/g") +
                              "' --section fanuc/tool-length-offset --cases 20 --report " + folder.path("report");
  const auto finding = [&folder] {
    return json::parse(toolcomp::test::read(folder.path("report/findings/01-coordinate.json")));
  };
  const Outcome usual = toolcomp(command + " --settle 600s");
  EXPECT_EQ(usual.status, 1) << usual.out << usual.err;
  EXPECT_TRUE(std::regex_search(usual.out, std::regex(R"( (\d+) of \1 groups settled, in 600 s at most \(--settle\))")))
      << usual.out;
  EXPECT_NE(usual.err.find("settling, 600s at most for all: group 1 of "), std::string::npos) << usual.err;
  EXPECT_FALSE(finding().contains("not_settled"));
  const Outcome none = toolcomp(command + " --settle 0");
  EXPECT_EQ(none.status, 1) << none.out << none.err;
  EXPECT_NE(none.out.find(", not settled: not asked for)"), std::string::npos) << none.out;
  EXPECT_TRUE(std::regex_search(none.out, std::regex(R"( 0 of \d+ groups settled, in 0 s at most \(--settle\))")))
      << none.out;
  EXPECT_EQ(finding().at("not_settled"), "not asked for");
  EXPECT_EQ(finding().at("tried"), 0);
  EXPECT_EQ(toolcomp(command + " --settle soon").status, 2);
}

TEST(Certify, AHangIsAFinding) {
  const Folder folder;
  const std::string controller =
      "sh " + folder.write("hang.sh", "read hello\n" + kServe + " <<E\n{\"hello\":1}\nE\nsleep 600\n");
  const Outcome outcome = toolcomp("certify --controller '" + controller +
                                   "' --section fanuc/leading-edge-offset --cases 1 --timeout 5 --report " +
                                   folder.path("report") + " " + kExamples + "three-hole-boring/three-holes.nc");
  EXPECT_EQ(outcome.status, 1) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("hang"), std::string::npos) << outcome.out;
}

// The summary of two runs is the same but for times.
TEST(Fuzz, SameSeedSameBytes) {
  const auto summary = [] {
    const Outcome outcome =
        toolcomp("fuzz --section fanuc/leading-edge-offset --runs 100 --seed 7 --json --controller '" + kServe + "'");
    EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
    return std::regex_replace(outcome.out, std::regex("\"(seconds|seconds_in_all|per_second)\": [^,]*,"), "");
  };
  EXPECT_EQ(summary(), summary());
}

TEST(Explain, ABlockNearNinetyDegrees) {
  const Outcome outcome = toolcomp("explain " + kExamples + "inclined-faces-tool-vector/faces.nc --block 80");
  EXPECT_EQ(outcome.status, 0);
  for (const char* words : {"fanuc.leading-edge.near-90", "counts as 90", "exact ", "double ", "N80 X20.0 I1 J0 K100"})
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words << '\n' << outcome.out;
  EXPECT_EQ(toolcomp("explain " + kExamples + "inclined-faces-tool-vector/faces.nc --block 999").status, 2);
}

TEST(Spec, ListsShowsAndTraces) {
  EXPECT_NE(toolcomp("spec list").out.find("fanuc.leading-edge.near-90"), std::string::npos);
  EXPECT_NE(toolcomp("spec show fanuc.leading-edge.near-90").out.find("19631"), std::string::npos);
  EXPECT_EQ(toolcomp("spec show fanuc.nothing").status, 2);
  EXPECT_NE(toolcomp("spec trace").out.find("model/"), std::string::npos);
}

TEST(Corpus, ChecksAndLints) {
  const Outcome check = toolcomp("corpus check");
  EXPECT_EQ(check.status, 0) << check.out << check.err;
  const Outcome lint = toolcomp("corpus lint");
  EXPECT_EQ(lint.status, 0) << lint.out;
  EXPECT_EQ(toolcomp("corpus diff " TOOLCOMP_SOURCE_DIR "/corpus/golden").status, 0);
}

// Generation is byte-identical for a seed: what is in the tree is what the generator makes.
// Some sections, or the whole tree.
TEST(Corpus, GeneratesWhatIsInTheTree) {
  const Folder folder;
  std::vector<std::string> sections;
  if (!toolcomp::test::whole())
    sections = {"fanuc/tool-offset", "fanuc/cutter-compensation-b", "heidenhain/programmed-contour"};
  std::string command = "corpus generate --seed 1 --dir " + folder.path("golden");
  for (const std::string& section : sections) command += " --section " + section;
  const Outcome outcome = toolcomp(command);
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(TOOLCOMP_SOURCE_DIR "/corpus/golden")) {
    if (!entry.is_regular_file()) continue;
    const auto name = std::filesystem::relative(entry.path(), TOOLCOMP_SOURCE_DIR "/corpus/golden");
    if (!sections.empty() && std::ranges::find(sections, name.parent_path().string()) == sections.end()) continue;
    ++files;
    const std::string expected = toolcomp::test::read(entry.path());
    EXPECT_TRUE(expected == toolcomp::test::read(folder.path("golden") / name)) << name;
  }
  EXPECT_GE(files, 5U);
}

}  // namespace

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

// Only what rests on clauses known so well; the rest is counted, on standard error and in the certificate.
TEST(Certify, KnownLeavesOutAndSaysSo) {
  const Folder folder;
  const std::string common = " --section fanuc/tool-length-offset --section fanuc/cutter-compensation-c --cases 20";
  const std::string report = " --report " + folder.path("report");
  const std::string fast = "certify --controller '" + kServe + "'" + common + report;
  const auto certificate = [&] { return json::parse(toolcomp::test::read(folder.path("report/certificate.json"))); };
  const Outcome whole = toolcomp(fast);
  EXPECT_EQ(whole.status, 0) << whole.out << whole.err;
  EXPECT_EQ(whole.err.find("left out"), std::string::npos) << whole.err;
  EXPECT_NE(whole.out.find(" clauses judged, "), std::string::npos) << whole.out;
  const json all = certificate();
  const Outcome part = toolcomp(fast + " --known manual,sister");
  EXPECT_EQ(part.status, 0) << part.out << part.err;
  EXPECT_NE(part.err.find(" events left out: they do not rest only on clauses known as manual, sister"),
            std::string::npos)
      << part.err;
  EXPECT_NE(part.out.find(", judged only by clauses known as manual, sister"), std::string::npos) << part.out;
  const json some = certificate();
  EXPECT_EQ(some["left_out"]["judged"], json::parse(R"(["manual", "sister"])"));
  EXPECT_FALSE(some["left_out"]["clauses"].empty());
  for (const char* kind : {"manual", "sister"})
    EXPECT_EQ(some["known"]["clauses"][kind], all["known"]["clauses"][kind]) << kind;
  for (const char* kind : {"recollection", "ours"}) {
    EXPECT_EQ(some["known"]["clauses"][kind], 0) << kind;
    EXPECT_GT(all["known"]["clauses"][kind], 0) << kind;
  }
  for (std::size_t i = 0; i < all["sections"].size(); ++i) {
    const json& a = all["sections"][i];
    const json& s = some["sections"][i];
    EXPECT_EQ(a["events_left_out"], 0);
    EXPECT_GT(s["events_left_out"], 0);
    EXPECT_EQ(a["events"].get<int>(), s["events"].get<int>() + s["events_left_out"].get<int>());
    EXPECT_GT(s["values"], 0);
    EXPECT_LT(s["values"], a["values"]);
  }
}

TEST(Certify, KnownTakesFourWords) {
  const Folder folder;
  const std::string arguments =
      "certify --controller fast --section fanuc/tool-offset --cases 1 --report " + folder.path("report");
  for (const std::string kinds : {"rumour", "manual,rumour", "''", ",", "Manual", "manual;sister"}) {
    const Outcome outcome = toolcomp(arguments + " --known " + (kinds.front() == '\'' ? kinds : "'" + kinds + "'"));
    EXPECT_EQ(outcome.status, 2) << kinds;
    EXPECT_NE(outcome.err.find("--known"), std::string::npos) << outcome.err;
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path("report")));
  const Outcome trace =
      toolcomp("certify --trace " + folder.write("t.csv", "X,Y,Z\n0,0,0\n") + " --tolerance 1 --known manual " +
               kExamples + "three-hole-boring/three-holes.nc --report " + folder.path("report"));
  EXPECT_EQ(trace.status, 2) << trace.out << trace.err;
  EXPECT_NE(trace.err.find("--known"), std::string::npos) << trace.err;
}

// A lie in what is judged is found, with how its clause is known before what differs, and replays; a bundle of it is
// verified.
TEST(Certify, AFindingUnderKnownReplays) {
  const Folder folder;
  // Type A offsets Z, says a manual: 100 and 20.
  const std::string program = folder.write("a.nc", "G90 G43 G00 Z100. H1\nM30\n");
  static_cast<void>(
      folder.write("setup.toml", "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[offsets.H]\n1 = 20\n"));
  const std::string liar = wrapper(folder, "liar.sh", R"(s/"Z":120/"Z":121/)");
  const Outcome found = toolcomp("certify --controller '" + liar + "' " + program +
                                 " --known manual,sister,recollection,ours --report " + folder.path("report"));
  EXPECT_EQ(found.status, 1) << found.out << found.err;
  EXPECT_NE(found.out.find("\n  known as "), std::string::npos) << found.out;
  const Outcome known = toolcomp("certify --controller '" + liar + "' " + program + " --known manual --report " +
                                 folder.path("known") + " --evidence " + folder.path("known.tar.zst"));
  EXPECT_EQ(known.status, 1) << known.out << known.err;
  const std::string file = folder.path("known/findings/01-coordinate.json");
  EXPECT_EQ(json::parse(toolcomp::test::read(file))["judged"], json::parse(R"(["manual"])"));
  const Outcome again = toolcomp("replay --yes " + file);
  EXPECT_EQ(again.status, 1) << again.out << again.err;
  EXPECT_NE(again.err.find("clauses known as manual"), std::string::npos) << again.err;
  const Outcome verified = toolcomp("verify --all " + folder.path("known.tar.zst"));
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
  // Nothing of it rests on what is ours alone: the lie is left out, and nothing judged is no pass.
  EXPECT_EQ(toolcomp("certify --controller '" + liar + "' " + program + " --known recollection --report " +
                     folder.path("other"))
                .status,
            3);
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
  EXPECT_TRUE(
      std::regex_search(usual.out, std::regex(R"( (\d+) of \1 groups settled, within 600 s at most \(--settle\))")))
      << usual.out;
  EXPECT_NE(usual.err.find("settling, at most 600s for all groups: group 1 of "), std::string::npos) << usual.err;
  EXPECT_FALSE(finding().contains("not_settled"));
  const Outcome none = toolcomp(command + " --settle 0");
  EXPECT_EQ(none.status, 1) << none.out << none.err;
  EXPECT_NE(none.out.find(", not settled: not asked for)"), std::string::npos) << none.out;
  EXPECT_TRUE(std::regex_search(none.out, std::regex(R"( 0 of \d+ groups settled, within 0 s at most \(--settle\))")))
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

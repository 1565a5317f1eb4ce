// SPDX-License-Identifier: Apache-2.0
// `toolcomp certify --controller NAME` with adapters that are shell scripts: no controller is needed.
#include <gtest/gtest.h>

#include <string>

#include "tests/command_line/command.h"

namespace {

using nlohmann::json;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::read;
using toolcomp::test::toolcomp;

// Two blocks along X, ten millimetres each.
const std::string kProgram = "G01 X10. F100\nX20.\n";
const std::string kGood = "X,Y,Z\n0,0,0\n10,0,0\n20,0,0\n";

class TraceAdapter : public testing::Test {
 protected:
  Folder folder;

  // An adapter that does `script` in the folder of each program.
  void adapter(const std::string& script, const std::string& more = "") const {
    std::filesystem::create_directories(folder.path("adapters/fake"));
    ASSERT_FALSE(folder.write("adapters/fake/machine.toml", "axes = [\"X\", \"Y\", \"Z\"]\n").empty());
    ASSERT_FALSE(folder
                     .write("adapters/fake/manifest.toml",
                            "[[adapter]]\nname = \"fake\"\nkind = \"trace\"\ncommand = \"sh run.sh\"\n"
                            "tolerance = \"0.01\"\nsetups = [\"machine.toml\"]\n" +
                                more)
                     .empty());
    ASSERT_FALSE(folder
                     .write("adapters/fake/run.sh",
                            "for one in \"$1\"/*/; do cd \"$one\"\n" + script + "\ndone\necho the end >&2\n")
                     .empty());
  }
  [[nodiscard]] Outcome certify(const std::string& more = "", const std::string& program = kProgram) const {
    return toolcomp("certify --controller fake --adapters " + folder.path("adapters") + " " +
                    folder.write("p.nc", program) + " --setup " + folder.path("adapters/fake/machine.toml") +
                    " --report " + folder.path("report") + " " + more);
  }
  [[nodiscard]] json run() const { return json::parse(read(folder.path("report/certificate.json"))).at("runs").at(0); }
};

TEST_F(TraceAdapter, ARecordingOnThePathConforms) {
  adapter("test -s program.nc && test -s setup.json && printf '" + kGood + "' >trace.csv");
  const Outcome outcome = certify();
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.err.find("the end\n"), std::string::npos) << "what it says is passed on";
  EXPECT_EQ(run().at("outcome"), "conforms");
  EXPECT_TRUE(std::filesystem::exists(folder.path("report/index.html")));
  EXPECT_FALSE(std::filesystem::exists(folder.path("report/runs/0001"))) << "removed where it conforms";
}

TEST_F(TraceAdapter, ANewDifferenceIsAFinding) {
  adapter("printf 'X,Y,Z\\n0,0,0\\n10,0.02,0\\n20,0,0\\n' >trace.csv");
  const Outcome outcome = certify();
  EXPECT_EQ(outcome.status, 1) << outcome.out;
  EXPECT_EQ(run().at("outcome"), "differs");
  EXPECT_TRUE(std::filesystem::exists(folder.path("report/runs/0001/report/index.html")));
  EXPECT_EQ(certify("--tolerance 0.03").status, 0);
  EXPECT_EQ(certify("--tolerance -1").status, 2);
}

TEST_F(TraceAdapter, TheReportSaysWhatItLooksLike) {
  adapter("printf 'X,Y,Z\\n0,0,0\\n0,10,0\\n0,20,0\\n' >trace.csv");
  const Outcome outcome = certify();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.out.find("likely cause, in 1 of the programs that differ: axes X and Y are exchanged"),
            std::string::npos)
      << outcome.out;
  EXPECT_EQ(run().at("cause"), "axes X and Y are exchanged");
  EXPECT_NE(read(folder.path("report/index.html")).find("axes X and Y are exchanged"), std::string::npos);
  EXPECT_NE(read(folder.path("report/runs/0001/report/index.html")).find("off the path"), std::string::npos) << "drawn";
}

TEST_F(TraceAdapter, RotaryAxesHaveATolerance) {
  adapter("printf 'X,C\\n0,0\\n10,0.02\\n20,0\\n' >trace.csv");
  ASSERT_FALSE(folder.write("adapters/fake/machine.toml", "axes = [\"X\", \"Y\", \"Z\", \"C\"]\n").empty());
  EXPECT_EQ(certify().status, 1);
  EXPECT_EQ(certify("--rotary-tolerance 0.03").status, 0);
}

TEST_F(TraceAdapter, AnAlarmIsOneForBothOrAFinding) {
  adapter("echo 'I will not' >alarm.txt");
  const Outcome outcome = certify();
  EXPECT_EQ(outcome.status, 1) << outcome.out;
  EXPECT_EQ(run().at("why"), "refused: I will not");
  // An arc without its centre: PS0022.
  EXPECT_EQ(certify("", "G02 X10. F100\n").status, 0);
  EXPECT_EQ(run().at("outcome"), "both refuse");
}

TEST_F(TraceAdapter, ToRunOnWhereTheModelRefusesIsAFinding) {
  adapter("printf '" + kGood + "' >trace.csv");
  EXPECT_EQ(certify("", kProgram + "G02 X30.\n").status, 1);
  EXPECT_EQ(run().at("why"), "ran on where the model gives PS0022 in line 3");
}

TEST_F(TraceAdapter, WhatItDoesNotHaveIsNoFailure) {
  adapter("echo 'line 1: G01' >not_applicable.txt");
  const Outcome outcome = certify();
  EXPECT_EQ(outcome.status, 3) << "nothing was judged";
  EXPECT_EQ(run().at("outcome"), "not applicable");
  EXPECT_EQ(run().at("why"), "line 1: G01");
}

TEST_F(TraceAdapter, NoRecordingIsNoPass) {
  adapter(":");
  EXPECT_EQ(certify().status, 3);
  EXPECT_EQ(run().at("outcome"), "failed");
  adapter("echo broken >&2; exit 7");
  const Outcome outcome = certify();
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("fake: exit status 7: broken"), std::string::npos) << outcome.err;
  adapter("sleep 1000");
  EXPECT_EQ(certify("--timeout 0.01").status, 3);
}

// Three programs; in the folder of the third the adapter does `script`. `command` knows the process that runs it.
class Interrupted : public TraceAdapter {
 protected:
  [[nodiscard]] Outcome certify_three(const std::string& script, const std::string& more = "") const {
    adapter("case $one in */0003/) " + script + ";; *) printf '" + kGood + "' >trace.csv; sleep 0.05;; esac");
    return three(more);
  }
  [[nodiscard]] Outcome three(const std::string& more = "") const {
    std::string programs;
    for (const char* name : {"1.nc", "2.nc", "3.nc"}) programs += folder.write(name, kProgram) + " ";
    return toolcomp("certify --controller fake --adapters " + folder.path("adapters") + " " + programs + " --setup " +
                        folder.path("adapters/fake/machine.toml") + " --report " + folder.path("report") + " " + more,
                    "sh -c 'echo $$ >" + folder.path("command") + "; exec \"$@\"' sh ");
  }
  [[nodiscard]] std::string signalled(const std::string& signal) const {
    return "kill -" + signal + " $(cat " + folder.path("command") + ")";
  }
  [[nodiscard]] json certificate() const { return json::parse(read(folder.path("report/certificate.json"))); }
};

TEST_F(Interrupted, WhatWasRecordedIsJudged) {
  for (const std::string signal : {"INT", "TERM"}) {
    const Outcome outcome = certify_three(signalled(signal) + "; sleep 1000");
    EXPECT_EQ(outcome.status, 3) << outcome.err;
    EXPECT_NE(outcome.out.find("2 programs not run: interrupted (SIG" + signal + ")"), std::string::npos)
        << outcome.out;
    const json all = certificate();
    EXPECT_EQ(all.at("verdict"), "not decided: interrupted");
    EXPECT_EQ(all.at("errors"), "") << "it was killed";
    EXPECT_EQ(all.at("runs").at(0).at("outcome"), "conforms");
    EXPECT_EQ(all.at("runs").at(1).at("outcome"), "not run") << "the newest recording may be cut";
    EXPECT_EQ(all.at("runs").at(2).at("outcome"), "not run");
    EXPECT_TRUE(std::filesystem::exists(folder.path("report/runs/0002/trace.csv"))) << "but stays";
  }
}

TEST_F(Interrupted, ByATimeLimit) {
  const Outcome outcome = certify_three("sleep 1000", "--time-limit 1s");
  EXPECT_EQ(outcome.status, 3) << outcome.err;
  EXPECT_EQ(certificate().at("interrupted"), "time limit of 1 s");
  EXPECT_EQ(certificate().at("programs_not_run"), 2);
}

TEST_F(Interrupted, ByAKillNothingIsLost) {
  const Outcome killed = certify_three(signalled("KILL"));
  EXPECT_NE(killed.status, 0);
  EXPECT_FALSE(std::filesystem::exists(folder.path("report/certificate.json")));
  adapter("printf '" + kGood + "' >trace.csv");
  const Outcome next = three();
  EXPECT_EQ(next.status, 0) << next.err;
  EXPECT_NE(next.err.find("ended without a report; its recordings are in " + folder.path("report/interrupted-1")),
            std::string::npos)
      << next.err;
  EXPECT_EQ(read(folder.path("report/interrupted-1/0001/trace.csv")), "X,Y,Z\n0,0,0\n10,0,0\n20,0,0\n");
  EXPECT_EQ(three().err.find("without a report"), std::string::npos);
}

TEST_F(TraceAdapter, TheReportHasItsFormsAndSaysWho) {
  adapter("printf 'X,Y,Z\\n0,0,0\\n10,0.02,0\\n20,0,0\\n' >trace.csv");
  EXPECT_EQ(certify("--operator 'A. Miller' --serial 4711").status, 1);
  const json certificate = json::parse(read(folder.path("report/certificate.json")));
  EXPECT_EQ(certificate.at("occasion").at("operator"), "A. Miller");
  EXPECT_EQ(certificate.at("occasion").at("serial"), "4711");
  for (const char* page : {"report/index.html", "report/runs/0001/report/index.html"})
    EXPECT_NE(read(folder.path(page)).find("A. Miller"), std::string::npos) << page;
  const json result = json::parse(read(folder.path("report/certificate.sarif"))).at("runs").at(0).at("results").at(0);
  EXPECT_EQ(result.at("ruleId"), "trace.off-the-path");
  EXPECT_EQ(result.at("locations").at(0).at("physicalLocation").at("artifactLocation").at("uri"),
            "runs/0001/trace.csv");
  EXPECT_EQ(result.at("locations").at(0).at("physicalLocation").at("region").at("startLine"), 3) << "of the CSV";
  EXPECT_NE(read(folder.path("report/junit.xml")).find(R"(tests="1" failures="1" errors="0" skipped="0")"),
            std::string::npos);
}

class KnownDifferences : public TraceAdapter {
 protected:
  void known(const std::string& more = "") const {
    std::filesystem::create_directories(folder.path("adapters/fake"));
    ASSERT_FALSE(folder
                     .write("adapters/fake/known.toml",
                            "[[difference]]\nid = \"wide\"\nreason = \"r\"\nrecognised = \"r\"\n"
                            "setup = \"machine.toml\"\nprogram = \"G01 X10. F100\\nX20.\"\n" +
                                more)
                     .empty());
  }
};

TEST_F(KnownDifferences, ExplainFindingsInTheirLines) {
  known();
  const std::string wide = "printf 'X,Y,Z\\n0,0,0\\n10,0,0\\n15,0.5,0\\n20,0,0\\n' >trace.csv\n";
  adapter(wide + "echo wide 2 2 >known.txt", "known_differences = \"known.toml\"\n");
  EXPECT_EQ(certify().status, 0);
  EXPECT_EQ(run().at("known"), json({"wide"}));
  adapter(wide + "echo wide 1 1 >known.txt", "known_differences = \"known.toml\"\n");
  EXPECT_EQ(certify().status, 1) << "another line";
  adapter(wide + "echo broad 2 2 >known.txt", "known_differences = \"known.toml\"\n");
  const Outcome outcome = certify();
  EXPECT_EQ(outcome.status, 2) << "no such id";
  EXPECT_NE(outcome.err.find("known.txt:1:1: "), std::string::npos) << outcome.err;
}

// And so does the table of `toolcomp results`, by the adapter's reason.
TEST_F(KnownDifferences, TheBadgeSaysAsMuch) {
  known();
  const auto badge = [&](const std::string& script, int status) {
    adapter(script, "known_differences = \"known.toml\"\n");
    EXPECT_EQ(certify("--badge " + folder.path("badge.json")).status, status) << script;
    const json read = json::parse(toolcomp::test::read(folder.path("badge.json")));
    return read.at("message").get<std::string>() + ": " + read.at("color").get<std::string>();
  };
  const std::string wide = "printf 'X,Y,Z\\n0,0,0\\n10,0,0\\n15,0.5,0\\n20,0,0\\n' >trace.csv\n";
  EXPECT_EQ(badge("printf '" + kGood + "' >trace.csv", 0), "conforms in 1 program: brightgreen");
  EXPECT_EQ(badge(wide, 1), "1 program differs: red");
  EXPECT_EQ(badge("echo 'line 1: G01' >not_applicable.txt", 3), "nothing judged: lightgrey");
  EXPECT_EQ(badge(wide + "echo wide 2 2 >known.txt", 0), "1 program differs by design: yellowgreen");
  const Outcome table = toolcomp("results --json " + folder.path("report"));
  ASSERT_EQ(table.status, 0) << table.err;
  const json controller = json::parse(table.out).at("controllers").at(0);
  EXPECT_EQ(controller.at("name"), "fake");
  EXPECT_EQ(controller.at("cells").at("").at("standing"), "differs by design");
  EXPECT_EQ(controller.at("cells").at("").at("known_differences"), json::parse(R"({"wide": 1})"));
  EXPECT_EQ(controller.at("known_differences"), json::parse(R"({"wide": "r"})"));
}

TEST_F(KnownDifferences, ExplainAlarmsOfTheModel) {
  known("alarms = [\"PS0022\"]\n");
  adapter("printf '" + kGood + "' >trace.csv", "known_differences = \"known.toml\"\n");
  EXPECT_EQ(certify("", kProgram + "G02 X30.\n").status, 0);
  EXPECT_EQ(run().at("outcome"), "known difference");
}

// Without programs named, that of each known difference is run: it must differ.
TEST_F(KnownDifferences, MustShow) {
  known();
  const auto generated = [&] {
    return toolcomp("certify --controller fake --cases 0 --adapters " + folder.path("adapters") + " --report " +
                    folder.path("report"));
  };
  adapter("printf '" + kGood + "' >trace.csv; echo wide 1 2 >known.txt", "known_differences = \"known.toml\"\n");
  const Outcome outcome = generated();
  EXPECT_EQ(outcome.status, 1) << outcome.out;
  EXPECT_NE(outcome.out.find("\"wide\" did not show"), std::string::npos) << outcome.out;
  adapter("printf 'X,Y,Z\\n0,0,0\\n10,1,0\\n20,0,0\\n' >trace.csv; echo wide 1 2 >known.txt",
          "known_differences = \"known.toml\"\n");
  EXPECT_EQ(generated().status, 0);
}

TEST(Adapters, ABadManifestIsBadInput) {
  const Folder folder;
  std::filesystem::create_directories(folder.path("a"));
  const std::string file = folder.write("a/manifest.toml", "[[adapter]]\nname = 7\n");
  const Outcome outcome =
      toolcomp("certify --controller seven --adapters " + folder.path(".") + " --report " + folder.path("r"));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("manifest.toml:2:8: "), std::string::npos) << outcome.err;
}

TEST(Adapters, AControllerBehindAPipe) {
  const Folder folder;
  std::filesystem::create_directories(folder.path("a"));
  ASSERT_FALSE(folder
                   .write("a/manifest.toml",
                          "[[adapter]]\nname = \"served\"\nkind = \"pipe\"\ncommand = \"exec " TOOLCOMP_BINARY_DIR
                          "/toolcomp serve --engine fast\"\n")
                   .empty());
  // The environment names the folder here.
  const Outcome outcome =
      toolcomp("certify --controller served " + folder.write("p.nc", kProgram) + " --setup " +
                   folder.write("setup.toml", "axes = [\"X\", \"Y\", \"Z\"]\n") + " --report " + folder.path("report"),
               "TOOLCOMP_ADAPTERS=" + folder.path(".") + " ");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("1 cases,      1 agree"), std::string::npos) << outcome.out;
}

// A controller may say of a case that it has no such thing: counted, not judged.
TEST(Adapters, ACaseMayNotApply) {
  const Folder folder;
  const std::string hello =
      R"({"name":"n","version":"1","protocol":1,"sections":["fanuc/tool-length-offset"],"fields":["kind","line","axes"]})";
  const std::string answer = R"(s/.*"id":\("[^"]*"\).*/{"id":\1,"not_applicable":"no such thing"}/)";
  const std::string controller =
      "sh " + folder.write("c.sh", "while read -r line; do case $line in *hello*) echo '" + hello +
                                       "';; *) printf '%s\\n' \"$line\" | sed '" + answer + "';; esac; done\n");
  const std::string cases =
      folder.write("c.jsonl", R"({"case":1,"id":"one","dialect":"fanuc","section":"fanuc/tool-length-offset",)"
                              R"("setup":{"control":"fanuc","axes":["X","Y","Z"]},"program":"G01 X10. F100\n"})"
                              "\n");
  const Outcome outcome =
      toolcomp("certify --controller '" + controller + "' " + cases + " --report " + folder.path("report"));
  EXPECT_NE(outcome.out.find("fanuc/tool-length-offset           not applicable"), std::string::npos)
      << outcome.out << outcome.err;
  const json certificate = json::parse(read(folder.path("report/certificate.json")));
  EXPECT_EQ(certificate.at("sections").at(0).at("results").at("not applicable"), 1);
}

}  // namespace

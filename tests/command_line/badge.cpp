// SPDX-License-Identifier: Apache-2.0
// `toolcomp certify --badge`: what the badge says, by hand from the exit status of each run; never more than that.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/command_line/command.h"

namespace {

using nlohmann::json;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::toolcomp;

const std::string kServe = TOOLCOMP_BINARY_DIR "/toolcomp serve --engine fast";

class Badge : public testing::Test {
 protected:
  Folder folder;
  std::string program;

  // Type A offsets Z, says a manual: 100 and 20.
  void SetUp() override {
    std::ignore =
        folder.write("setup.toml", "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[offsets.H]\n1 = 20\n");
    program = folder.write("a.nc", "G90 G43 G00 Z100. H1\nM30\n");
  }

  // Of a run that ends so; what every badge has is expected.
  [[nodiscard]] json badge(const std::string& arguments, int status) const {
    const std::string file = folder.path("badge.json");
    const Outcome outcome =
        toolcomp("certify " + arguments + " --report " + folder.path("report") + " --badge " + file);
    EXPECT_EQ(outcome.status, status) << outcome.out << outcome.err;
    json read = json::parse(toolcomp::test::read(file));
    EXPECT_EQ(read["schemaVersion"], 1);
    EXPECT_EQ(read["label"], "toolcomp");
    for (const auto& [key, value] : read.items())
      EXPECT_TRUE(key == "schemaVersion" || key == "label" || key == "message" || key == "color" || key == "isError")
          << key;
    return read;
  }
  // A controller that runs the fast engine's answers to cases through sed.
  [[nodiscard]] std::string wrapped(const std::string& script) const {
    return "--controller 'sh " + folder.write("wrapped.sh", kServe + " | sed -u '" + script + "'\n") + "' ";
  }
};

TEST_F(Badge, IsGreenWhereAllOfItConforms) {
  json read = badge("--controller fast --section fanuc/tool-offset --section fanuc/tool-length-offset --cases 3", 0);
  EXPECT_EQ(read["message"], "conforms in 2 of 13 sections");
  EXPECT_EQ(read["color"], "brightgreen");
  read = badge("--controller fast " + program, 0);
  EXPECT_EQ(read["message"], "conforms in 1 program");
  EXPECT_EQ(read["color"], "brightgreen");
}

TEST_F(Badge, CountsFindingsInRed) {
  const json read = badge(wrapped(R"(s/"Z":120/"Z":121/)") + program, 1);
  EXPECT_EQ(read["message"], "1 finding");
  EXPECT_EQ(read["color"], "red");
}

// The clauses of this program are of several kinds: by one alone there is nothing to judge.
TEST_F(Badge, IsGreyWhereNothingWasJudged) {
  const json read = badge("--controller fast --known recollection " + program, 3);
  EXPECT_EQ(read["message"], "nothing judged");
  EXPECT_EQ(read["color"], "lightgrey");
}

// G68 is not supported: what follows is not judged.
TEST_F(Badge, IsYellowWhereAPartWasNotJudged) {
  const std::string part = folder.write("part.nc", "G90 G43 G00 Z100. H1\nX5.\nG68 X0 Y0 R30.\nX10.\nM30\n");
  const json read = badge("--controller fast " + part, 3);
  EXPECT_EQ(read["message"], "judged only in part");
  EXPECT_EQ(read["color"], "yellow");
}

// What a controller calls its design is counted: green, but not the brightest.
TEST_F(Badge, SaysWhatDiffersByDesign) {
  const std::string other = folder.write("other.nc", "G90 G00 X1.\nM30\n");
  const std::string script = folder.write("otherwise.py", R"(import json, sys
for request in map(json.loads, sys.stdin):
    if "hello" in request:
        answer = {"name": "no lengths", "protocol": 1, "sections": [], "fields": ["kind", "line", "axes"]}
    elif "G43" in request["program"]:
        answer = {"id": request["id"], "not_applicable": "no length", "known_difference": "no-length"}
    else:
        answer = {"id": request["id"], "events": [{"kind": "move", "line": 1, "axes": {"X": 1, "Y": 0, "Z": 0}}]}
    print(json.dumps(answer), flush=True)
)");
  const std::string bundle = folder.path("otherwise.tar.zst");
  const json read =
      badge("--controller 'python3 " + script + "' " + program + " " + other + " --evidence " + bundle, 0);
  EXPECT_EQ(read["message"], "conforms in 1 program; 1 case differs by design");
  EXPECT_EQ(read["color"], "yellowgreen");
  const json certificate = json::parse(toolcomp::test::read(folder.path("report/certificate.json")));
  EXPECT_EQ(certificate["verdict"], "conforms in 1 program; 1 case differs by design");
  EXPECT_EQ(certificate["sections"][0]["known_differences"], json::parse(R"({"no-length": 1})"));
  EXPECT_NE(toolcomp::test::read(folder.path("report/index.html")).find("<code>no-length</code>"), std::string::npos);
  // The evidence says the same: what was counted is judged again.
  const Outcome verified = toolcomp("verify --all " + bundle);
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
}

TEST_F(Badge, OfARecording) {
  const std::string line = folder.write("line.nc", "N10 G90 G01 X10. F100\nN20 Y10.\n");
  const auto of = [&](const std::string& csv, int status) {
    return badge("--trace " + folder.write("t.csv", csv) + " --tolerance 0.01 " + line, status);
  };
  json read = of("X,Y\n0,0\n10,0\n10,10\n", 0);
  EXPECT_EQ(read["message"], "the recording conforms");
  EXPECT_EQ(read["color"], "brightgreen");
  read = of("X,Y\n0,0\n5,1\n10,0\n10,10\n", 1);
  EXPECT_EQ(read["message"], "1 finding");
  EXPECT_EQ(read["color"], "red");
}

// An earlier badge does not outlive the beginning of a run that is killed; a file that cannot be is bad usage, and
// nothing is asked.
TEST_F(Badge, IsNoneOfAnEarlierRun) {
  const std::string file = folder.write("badge.json", R"({"message":"conforms in 13 sections","color":"brightgreen"})");
  const std::string kill = folder.write("kill.sh", "kill -KILL $PPID\n");
  EXPECT_NE(toolcomp("certify --controller 'exec sh " + kill + "' " + program + " --report " + folder.path("report") +
                     " --badge " + file)
                .status,
            0);
  const json read = json::parse(toolcomp::test::read(file));
  EXPECT_EQ(read["message"], "not finished");
  EXPECT_EQ(read["color"], "lightgrey");
  const Outcome refused = toolcomp("certify --controller fast " + program + " --report " + folder.path("other") +
                                   " --badge " + folder.path(""));
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("--badge"), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(folder.path("other")));
}

}  // namespace

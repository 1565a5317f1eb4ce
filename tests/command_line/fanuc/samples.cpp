// SPDX-License-Identifier: Apache-2.0
// `--samples` as a user gives it: the pyramid of the manual's program O0010 under posture control and without.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "tests/command_line/command.h"

namespace {

using nlohmann::json;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::toolcomp;

constexpr const char* kSetup =
    "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n[parameters]\n19680 = 2\n19681 = 5\n19682 = 3\n"
    "19686 = 4\n19687 = 2\n[offsets.H]\n1 = 100\n[offsets.D]\n2 = 5\n";

// Worked example 8 (corpus/examples/fanuc/tool_posture_control.cpp): a square pyramid, base ±20, apex (0, 0, 40), cut
// with its side.
std::string pyramid(const std::string& p) {
  return "N10 G90 G00 X30.0 Y-30.0 Z0.0\nN20 G43.5 H1 " + p +
         "\nN30 G42.6 D2\nN40 G01 X20.0 Y-20.0 I-1 J1 K2 F1000\nN50 X20. Y20. I-1 J-1 K2\nN60 X-20. Y20. I1 J-1 K2\n"
         "N70 X-20. Y-20. I1 J1 K2\nN80 X20. Y-20. I-1 J1 K2\nN90 G40 X30. Y-30.\nN100 G49\nM30\n";
}

// How far a point lies outside the face of block `n`.
double height(int n, double x, double y, double z) {
  const double out = n == 50 ? x : n == 60 ? y : n == 70 ? -x : -y;
  return (2 * out + z - 40) / std::sqrt(5.0);
}

class Samples : public testing::TestWithParam<std::string> {
 protected:
  Folder folder;
  std::string setup = folder.write("setup.toml", kSetup);
  std::string with_posture = folder.write("p1.nc", pyramid("P1"));
  std::string without = folder.write("p0.nc", pyramid("P0"));

  [[nodiscard]] Outcome run(const std::string& program, const std::string& options) const {
    return toolcomp("run " + program + " --setup " + setup + " --engine " + GetParam() + " " + options);
  }
};
INSTANTIATE_TEST_SUITE_P(BothEngines, Samples, testing::Values("model", "fast"),
                         [](const auto& engine) { return engine.param; });

// The flank stays on the face: tip and control point are 5 off it at every sample of the four sides; without posture
// control the control point is not.
TEST_P(Samples, TheSideOfTheToolStaysOnTheFace) {
  const auto farthest = [&](const std::string& program, const std::string& field) {
    const Outcome outcome = run(program, "--samples 100");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    double worst = 0;
    std::size_t samples = 0;
    for (const json& event : outcome.events()) {
      if (event.at("kind") != "sample" || event.value("n", 0) < 50 || event.value("n", 0) > 80) continue;
      ++samples;
      const json& p = event.at(field);
      worst = std::max(worst, std::fabs(height(event.at("n"), p.at("X"), p.at("Y"), p.at("Z")) - 5));
    }
    EXPECT_EQ(samples, 4U * 99U);
    return worst;
  };
  EXPECT_LT(farthest(with_posture, "point"), 1e-13);
  EXPECT_LT(farthest(with_posture, "axes"), 1e-13);
  EXPECT_LT(farthest(without, "point"), 1e-13);
  EXPECT_GT(farthest(without, "axes"), 10);  // 100 · 0.151 at the middle
}

// Worked example 8, N50 at t = 1/2.
TEST_P(Samples, StandBeforeTheirMoveWithReducedFractions) {
  const auto events = run(with_posture, "--samples 4").events();
  const auto at = std::find_if(events.begin(), events.end(), [](const json& e) { return e.value("n", 0) == 50; });
  ASSERT_GE(events.end() - at, 4);
  std::vector<std::string> kinds;
  for (auto i = at; i < at + 4; ++i) kinds.push_back(i->at("kind") == "sample" ? i->at("t") : i->at("kind"));
  EXPECT_EQ(kinds, (std::vector<std::string>{"1/4", "1/2", "3/4", "move"}));
  const json& middle = *(at + 1);
  EXPECT_NEAR(middle.at("point").at("X"), 24.0994579587496, 1e-12);
  EXPECT_NEAR(middle.at("axes").at("X"), -20.6219015912462, 1e-12);
  EXPECT_NEAR(middle.at("axes").at("Z"), 92.4241430699913, 1e-12);
  EXPECT_NEAR(middle.at("axes").at("B"), -26.565051177078, 1e-12);
  EXPECT_NEAR(middle.at("axes").at("C"), 0, 1e-12);
  EXPECT_NEAR(middle.at("tool_axis").at(0), -1 / std::sqrt(5.0), 1e-14);
  EXPECT_FALSE(middle.contains("machine"));
  for (const json& event : run(with_posture, "").events()) EXPECT_NE(event.at("kind"), "sample");
}

TEST_P(Samples, AreRowsOfTheTable) {
  const Outcome outcome = run(with_posture, "--samples 2 --format csv");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  std::string head;
  std::getline(lines, head);
  EXPECT_NE(head.find(",t,"), std::string::npos);
  const auto columns = std::count(head.begin(), head.end(), ',');
  int samples = 0;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns) << line;
    if (!line.starts_with("sample,")) continue;
    ++samples;
    EXPECT_NE(line.find(",1/2,"), std::string::npos) << line;
  }
  EXPECT_EQ(samples, 6) << "N40 to N90";
}

// A program goes straight from sample to sample; the picture shows the tool between the ends of blocks. Half way along
// N60 the tool leans by arctan 1/2 to -Y.
TEST_P(Samples, InProgramsAndPictures) {
  const std::string gcode = run(with_posture, "--samples 2 --format gcode").out;
  const std::string ends = run(with_posture, "--format gcode").out;
  EXPECT_EQ(std::count(gcode.begin(), gcode.end(), '\n') - std::count(ends.begin(), ends.end(), '\n'), 6);
  const std::string n60 = gcode.substr(gcode.find("N60 G01"));
  EXPECT_NE(n60.substr(0, n60.find('\n')).find(" B-26.56505117707"), std::string::npos) << n60;
  EXPECT_NE(n60.substr(0, n60.find('\n')).find(" C90 F1000"), std::string::npos) << n60;
  const auto picture = [&](const std::string& program, const std::string& options) {
    const Outcome outcome = run(program, "--format svg " + options);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  };
  const std::string thin = "class=\"tp-tool tp-thin\"";
  EXPECT_EQ(picture(with_posture, "").find(thin), std::string::npos);
  EXPECT_NE(picture(with_posture, "--samples 12").find(thin), std::string::npos);
  EXPECT_NE(picture(with_posture, "--samples 12"), picture(without, "--samples 12"));
}

TEST_P(Samples, OfACase) {
  json c = {{"case", 1},
            {"id", "pyramid"},
            {"section", "fanuc/tool-posture-control"},
            {"dialect", "fanuc"},
            {"samples", 3},
            {"setup", {{"control", "fanuc"}, {"axes", {"X", "Y", "Z"}}}},
            {"program", "G90 G01 F1000\nG43.5 H0 P1\nX30. I1 K1\n"}};
  const std::string path = folder.write("case.json", c.dump());
  const auto count = [](const Outcome& outcome) {
    std::size_t samples = 0;
    for (const json& event : outcome.events()) samples += event.at("kind") == "sample" ? 1 : 0;
    return samples;
  };
  EXPECT_EQ(count(toolcomp("run " + path + " --engine " + GetParam())), 2U);
  EXPECT_EQ(count(toolcomp("run " + path + " --samples 5 --engine " + GetParam())), 4U);
  EXPECT_EQ(count(toolcomp("run " + path + " --samples 0 --engine " + GetParam())), 0U);
  const std::string answer = toolcomp("serve --engine " + GetParam(), "printf '%s\\n' '" + c.dump() + "' | ").out;
  EXPECT_NE(answer.find("\"t\":\"2/3\""), std::string::npos) << answer;
}

class SampleOptions : public testing::Test {
 protected:
  Folder folder;
  std::string setup = folder.write("setup.toml", kSetup);
  std::string program = folder.write("p1.nc", pyramid("P1"));
};

TEST_F(SampleOptions, DiffExplainAndCertifyTakeThem) {
  const Outcome diff = toolcomp("diff " + program + " --setup " + setup + " --samples 7");
  EXPECT_EQ(diff.status, 0) << diff.out << diff.err;
  const Outcome fewer = toolcomp("diff " + program + " --setup " + setup);
  EXPECT_NE(diff.err, fewer.err) << "more values";
  const Outcome explain = toolcomp("explain " + program + " --setup " + setup + " --samples 2 --block 50");
  EXPECT_EQ(explain.status, 0) << explain.err;
  EXPECT_NE(explain.out.find("\"t\":\"1/2\""), std::string::npos) << explain.out;
  const Outcome certify =
      toolcomp("certify " + program + " --setup " + setup + " --samples 3 --report " + folder.path("report") +
               " --controller '" TOOLCOMP_BINARY_DIR "/toolcomp serve --engine fast'");
  EXPECT_EQ(certify.status, 0) << certify.out << certify.err;
  const std::string report = toolcomp::test::read(folder.path("report") + "/index.html");
  EXPECT_NE(report.find("tp-tool tp-thin"), std::string::npos) << "tool axes along the path";
}

TEST_F(SampleOptions, NumbersThatCannotBe) {
  for (const char* number : {"-1", "1000001", "99999999999999999999", "x", "1.5", "''"}) {
    const Outcome outcome = toolcomp("run " + program + " --setup " + setup + " --samples " + number);
    EXPECT_EQ(outcome.status, 2) << number;
    EXPECT_EQ(outcome.out, "") << number;
    EXPECT_NE(outcome.err.find("--samples"), std::string::npos) << outcome.err;
  }
}

// A recording of the axes is judged against the curve they run, not against its ends: the samples of a finer run lie
// on it, those of a run without posture control do not.
TEST_F(SampleOptions, RecordingsAreJudgedAgainstTheCurve) {
  const auto recording = [&](const std::string& name, const std::string& p) {
    const std::string path = folder.write(name + ".nc", pyramid(p));
    std::string csv = "X,Y,Z,B,C\n";
    for (const json& event : toolcomp("run " + path + " --setup " + setup + " --engine fast --samples 200").events()) {
      if (!event.contains("axes")) continue;
      const json& a = event.at("axes");
      for (const char* axis : {"X", "Y", "Z", "B", "C"}) {
        csv += a.at(axis).dump();
        csv += *axis == 'C' ? '\n' : ',';
      }
    }
    return folder.write(name + ".csv", csv);
  };
  const auto judge = [&](const std::string& csv) {
    return toolcomp("certify " + program + " --setup " + setup + " --trace " + csv + " --tolerance 0.01 --report " +
                    folder.path("trace"))
        .status;
  };
  EXPECT_EQ(judge(recording("same", "P1")), 0);
  EXPECT_EQ(judge(recording("other", "P0")), 1);
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// Tool side compensation as a user runs it: the examples in the examples folder, the manual's interference figure, long
// flanks, and what explain, the picture and the report show of them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/command_line/command.h"

namespace {

using nlohmann::json;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::toolcomp;

const std::string kExamples = TOOLCOMP_SOURCE_DIR "/examples/fanuc/";
const std::string kBoss = kExamples + "tapered-boss-tool-side/boss.nc";
const std::string kBossVector = kExamples + "tapered-boss-tool-side/boss-vector.nc";
const std::string kFlank = kExamples + "blade-flank-tool-side/flank.nc";
const std::string kServe = TOOLCOMP_BINARY_DIR "/toolcomp serve --engine fast";

using Point = std::vector<double>;

class ToolSide : public testing::TestWithParam<std::string> {
 protected:
  static void expect_points(const std::string& program, const std::vector<Point>& points) {
    const Outcome outcome = toolcomp("run " + program + " --engine " + GetParam());
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const std::vector<json> events = outcome.events();
    ASSERT_EQ(events.size(), points.size()) << outcome.out;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(events[i].at("point").at(std::string(1, "XYZ"[axis])).get<double>(), points[i][axis], 1e-12)
            << "event " << i << ' ' << events[i].dump();
  }
};
INSTANTIATE_TEST_SUITE_P(BothEngines, ToolSide, testing::Values("model", "fast"),
                         [](const auto& engine) { return engine.param; });

// By hand: a groove 4 wide along X, a tool 10 wide that leans by 30 degrees towards X. Square to the tool the bottom is
// 4 cos 30 long, and the tool runs 10 - 4 cos 30 against it.
TEST_P(ToolSide, AGrooveTooNarrowSaysByHowMuch) {
  const Folder folder;
  const std::string setup = folder.write(
      "setup.toml",
      "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n[parameters]\n19680 = 2\n19681 = 5\n"
      "19682 = 3\n19686 = 4\n19687 = 2\n\"19630\" = \"0.001\"\n[offsets.D]\n1 = 5\n");
  const std::string program =
      folder.write("groove.nc", "G90 G00 X-20. B30. C0.\nG01 G41.2 D1 X0. F100\nY-20.\nX4.\nY0.\nX20.\nG40 X40.\n");
  const Outcome run = toolcomp("run " + program + " --setup " + setup + " --engine " + GetParam());
  EXPECT_NE(run.err.find("groove.nc:4: note: the paths cross by 6.5359\n"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("groove.nc:4:1: PS0041 "), std::string::npos) << run.err;
}

// By hand: VT is (0, s, c), (s, 0, c), (0, -s, c), (-s, 0, c) at the walls, s and c of 10 degrees. Each corner is one
// of 90 degrees in the plane of the wall before it, so that V = 6 (n1 + n2) with n1 = VT x travel and n2 the next
// travel turned left, which lies in that plane; the vector is kept while the tool turns.
TEST_P(ToolSide, TheTaperedBoss) {
  const double c = 6 * std::cos(10 * std::numbers::pi / 180);
  const double s = 6 * std::sin(10 * std::numbers::pi / 180);
  expect_points(kBoss, {{70, -40, 30},
                        {70, -40, 0},
                        {40, -40 - c, s},
                        {-46, -40 - c, s},
                        {-46, -40 - c, s},
                        {-40 - c, 46, s},
                        {-40 - c, 46, s},
                        {46, 40 + c, s},
                        {46, 40 + c, s},
                        {40 + c, -40, s},
                        {40, -70, 0},
                        {40, -70, 30}});
}

// The same with c = 12/13 and s = 5/13 up to N70. N80 and N90 enclose an acute corner in the plane of VT (0, -5,
// 12)/13: U2 = (-60, -20, 0) has u2 = U2 + (100/169)(0, -5, 12) there, |u2|^2 = 4000 - (100/13)^2.
TEST_P(ToolSide, TheBossByTheToolVector) {
  const double c = 6 * 12.0 / 13;
  const double s = 6 * 5.0 / 13;
  const double length = std::sqrt(4000 - 10000.0 / 169);
  const Point d2{-60 / length, (-20 + 500.0 / 169) / length, -1200.0 / 169 / length};
  // n2 = VT x d2.
  const Point n2{(-5 * d2[2] - 12 * d2[1]) / 13, 12 * d2[0] / 13, 5 * d2[0] / 13};
  const auto head = [&](double x, double y, double back) {
    return Point{x + 6 * (n2[0] - back * d2[0]), y + 6 * (n2[1] - back * d2[1]), 6 * (n2[2] - back * d2[2])};
  };
  expect_points(kBossVector, {{70, -40, 30},
                              {70, -40, 0},
                              {40, -40 - c, s},
                              {-46, -40 - c, s},
                              {-46, -40 - c, s},
                              {-40 - c, 46, s},
                              {-40 - c, 46, s},
                              {46, 40 + c, s},
                              head(40, 40, 1),
                              head(-20, 20, 0),
                              {-80, 0, 0},
                              {-80, 0, 30}});
}

TEST_P(ToolSide, TheManualsInterferenceFigure) {
  const Folder folder;
  const std::string setup =
      folder.write("setup.toml",
                   "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"A\", \"C\"]\n[parameters]\n19680 = 2\n"
                   "19681 = 5\n19682 = 3\n19686 = 4\n19687 = 1\n[offsets.D]\n1 = 10\n[position]\nY = 40\nZ = 40\n");
  const auto run = [&](const std::string& q) {
    const std::string program = folder.write("p.nc", "G90 G00 A46.\nG01 G41.2 D1 Y0 Z0 F1000\nN4 Y-200. Z-200." + q +
                                                         "\nN5 A-45.\nN6 Y-400. Z0\nG40 Y-440. Z40.\nM30\n");
    return toolcomp("run " + program + " --setup " + setup + " --digits 18 --engine " + GetParam());
  };
  const Outcome outcome = run("");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  ASSERT_EQ(outcome.events().size(), 3U) << outcome.out;
  EXPECT_EQ(outcome.events().back().at("number"), "PS0041");
  EXPECT_EQ(outcome.events().back().at("line"), 3);
  EXPECT_NE(outcome.err.find("p.nc:3:"), std::string::npos) << outcome.err;

  // TS8 (corpus/examples/fanuc/tool_side_compensation.cpp), the vectors at N4, Q1: (10, 0, 0), Q2: V1, Q3: V1 and V2.
  const double y = -206.946583704589972867;
  const double z = -207.193398003386511394;
  const std::vector<std::vector<Point>> heads{{{10, -200, -200}}, {{10, y, z}}, {{10, y, z}, {-10, y, z}}};
  for (std::size_t q = 1; q <= heads.size(); ++q) {
    const Outcome kept = run(" Q" + std::to_string(q));
    const std::vector<json> events = kept.events();
    ASSERT_GT(events.size(), 1 + heads[q - 1].size()) << kept.out;
    for (std::size_t i = 0; i < heads[q - 1].size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(events[2 + i].at("point").at(std::string(1, "XYZ"[axis])).get<double>(), heads[q - 1][i][axis],
                    1e-12)
            << "Q" << q << ' ' << events[2 + i].dump();
    if (GetParam() == "model" && q > 1) {
      EXPECT_NE(kept.out.find("\"Y\":-206.946583704589972867,\"Z\":-207.193398003386511394"), std::string::npos)
          << "every printed digit: " << kept.out;
    }
  }
}

TEST(ToolSideExamples, BothEnginesAgree) {
  for (const std::string& program : {kBoss, kBossVector, kFlank}) {
    const Outcome outcome = toolcomp("diff " + program);
    EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  }
}

TEST(ToolSideExplained, TheHeadsOfACorner) {
  const Outcome outcome = toolcomp("explain " + kBossVector + " --block 80 --digits 6");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* words : {"2 heads", "X46 Y45.538462 Z2.307692", "decision fanuc.tool-side.obtuse-or-acute",
                            "fanuc.tool-side.outer-acute"})
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words << '\n' << outcome.out;
}

// From above, from the side, from a corner, and one place along the tool.
TEST(ToolSidePictures, ShowBothPathsTheToolAndOnePlaceAlongIt) {
  for (const char* engine : {"model", "fast"}) {
    const Outcome outcome = toolcomp("run " + kFlank + " --format svg --engine " + engine);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    for (const char* words : {"tp-path tp-programmed\"", "tp-path tp-point\"", "tp-tool\"", "tp-vector\"",
                              "axonometric", "along the tool at", "distance of the lines 5 mm", "tp-round\""})
      EXPECT_NE(outcome.out.find(words), std::string::npos) << words << '\n' << outcome.out.substr(0, 2000);
    EXPECT_EQ(outcome.out.find("nan"), std::string::npos);
  }
}

TEST(ToolSideReport, ShowsThePathsOfTheProgramsItJudged) {
  const Folder folder;
  const Outcome outcome =
      toolcomp("certify --controller '" + kServe + "' --report " + folder.path("report") + " " + kBoss + " " + kFlank);
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const std::string page = toolcomp::test::read(folder.path("report/index.html"));
  for (const char* words : {"<h2 id=\"programs\">", "boss.nc", "flank.nc", "along the tool at"})
    EXPECT_NE(page.find(words), std::string::npos) << words;
}

TEST(Flanks, AreMadeAndAgree) {
  const Folder folder;
  for (const char* tool : {"rotary", "vector"}) {
    const std::string program = folder.path(std::string(tool) + ".nc");
    const Outcome made = toolcomp(std::string("corpus flank --blocks 600 --tool ") + tool + " --out " + program);
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_NE(made.out.find("600 blocks in 2 passes"), std::string::npos) << made.out;
    const Outcome diff = toolcomp("diff " + program + " --setup " + folder.path(std::string(tool) + ".toml"));
    EXPECT_EQ(diff.status, 0) << diff.out << diff.err;
  }
}

// The example is what the command makes.
TEST(Flanks, TheExampleIsOneOfThem) {
  const Folder folder;
  const Outcome made = toolcomp("corpus flank --blocks 1200 --out " + folder.path("flank.nc"));
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_EQ(toolcomp::test::read(folder.path("flank.nc")), toolcomp::test::read(kFlank));
  EXPECT_EQ(toolcomp::test::read(folder.path("flank.toml")),
            toolcomp::test::read(kExamples + "blade-flank-tool-side/setup.toml"));
}

TEST(Flanks, BadUsage) {
  EXPECT_EQ(toolcomp("corpus flank").status, 2);
  EXPECT_EQ(toolcomp("corpus flank --out x.toml").status, 2);
  EXPECT_EQ(toolcomp("corpus flank --blocks 10 --out x.nc").status, 2);
  EXPECT_EQ(toolcomp("corpus flank --tool square --out x.nc").status, 2);
}

}  // namespace

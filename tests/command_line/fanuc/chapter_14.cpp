// SPDX-License-Identifier: Apache-2.0
// The manual's programs of chapter 14 as a user runs them, both engines, to twelve decimals of figures worked out by
// hand; what explain says of them; long contours.
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "tests/command_line/command.h"

namespace {

using nlohmann::json;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::toolcomp;

const std::string kExamples = TOOLCOMP_SOURCE_DIR "/examples/fanuc/";

constexpr double kLastDigit = 1.5e-12;  // the figures typed in have 12 decimals and more

class Chapter14 : public testing::TestWithParam<std::string> {
 protected:
  // The points of the moves are these, typed in from the derivation.
  static void expect_points(const std::string& arguments, const std::vector<std::vector<std::string>>& points) {
    const Outcome outcome = toolcomp("run " + kExamples + arguments + " --digits 18 --engine " + GetParam());
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    std::vector<json> moves;
    for (const json& event : outcome.events())
      if (event.at("kind") == "move") moves.push_back(event);
    ASSERT_EQ(moves.size(), points.size()) << outcome.out;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t axis = 0; axis < points[i].size(); ++axis) {
        const std::string& text = points[i][axis];
        EXPECT_NEAR(moves[i].at("point").at(std::string(1, "XYZ"[axis])).get<double>(), std::stod(text), kLastDigit)
            << "move " << i << ' ' << moves[i].dump();
      }
  }
};
INSTANTIATE_TEST_SUITE_P(BothEngines, Chapter14, testing::Values("model", "fast"),
                         [](const auto& engine) { return engine.param; });

TEST_P(Chapter14, TheFigureOfCutterCompensationC) {
  const std::string program = "arc-figure-cutter-compensation-c/arc-figure.nc";
  const std::string folder = kExamples + "arc-figure-cutter-compensation-c/";
  expect_points(program, {{"240", "550"},
                          {"240", "910"},
                          {"443.295878967653", "910"},
                          {"489.9915665097066", "1146.714456444996"},
                          {"910.0084334902934", "1146.714456444996"},
                          {"956.704121032347", "910"},
                          {"1160", "910"},
                          {"1160", "540"},
                          {"1157.592566023653", "538.0688248199739"},
                          {"700", "639.756061714119"},
                          {"252.1693045781866", "540.2381293981605"},
                          {"0", "0"}});
  expect_points(program + " --setup " + folder + "setup-20.toml", {{"230", "550"},
                                                                   {"230", "920"},
                                                                   {"436.5151319446072", "920"},
                                                                   {"479.9666946292995", "1143.522063767303"},
                                                                   {"920.0333053707005", "1143.522063767303"},
                                                                   {"963.4848680553928", "920"},
                                                                   {"1170", "920"},
                                                                   {"1170", "530"},
                                                                   {"1165.185132047306", "526.1376496399478"},
                                                                   {"700", "629.512123428238"},
                                                                   {"254.3386091563731", "530.4762587963209"},
                                                                   {"0", "0"}});
  expect_points(program + " --setup " + folder + "setup-minus-10.toml", {{"260", "550"},
                                                                         {"260", "890"},
                                                                         {"456.6666666666667", "890"},
                                                                         {"459.2307692307692", "896.1538461538462"},
                                                                         {"510", "1150"},
                                                                         {"510", "1153.333333333333"},
                                                                         {"508", "1156"},
                                                                         {"892", "1156"},
                                                                         {"890", "1153.333333333333"},
                                                                         {"890", "1150"},
                                                                         {"940.7692307692308", "896.1538461538462"},
                                                                         {"943.3333333333333", "890"},
                                                                         {"1140", "890"},
                                                                         {"1140", "562.4661605081032"},
                                                                         {"700", "660.243938285881"},
                                                                         {"247.8306954218134", "559.7618706018395"},
                                                                         {"0", "0"}});
}

TEST_P(Chapter14, TheFigureOfToolOffset) {
  expect_points("contour-tool-offset/contour.nc", {{"70", "40"},
                                                   {"140", "40"},
                                                   {"140", "80"},
                                                   {"160", "80"},
                                                   {"160", "40"},
                                                   {"200", "40"},
                                                   {"240", "80"},
                                                   {"240", "110"},
                                                   {"230", "110"},
                                                   {"210", "130"},
                                                   {"210", "140"},
                                                   {"70", "140"},
                                                   {"70", "40"},
                                                   {"0", "0"}});
}

TEST_P(Chapter14, TheFigureOfCutterCompensationB) {
  const std::string program = "plate-cutter-compensation-b/plate.nc";
  expect_points(program, {{"15", "20", "0"},
                          {"15", "20", "-25"},
                          {"15", "60", "-25"},
                          {"17.76393202250021", "64.47213595499958", "-25"},
                          {"57.76393202250021", "84.47213595499958", "-25"},
                          {"60", "85", "-25"},
                          {"105", "40", "-25"},
                          {"80", "15", "-25"},
                          {"20", "15", "-25"},
                          {"20", "15", "0"},
                          {"0", "0", "0"}});
  expect_points(program + " --setup " + kExamples + "plate-cutter-compensation-b/setup-10.toml",
                {{"10", "20", "0"},
                 {"10", "20", "-25"},
                 {"10", "60", "-25"},
                 {"15.52786404500042", "68.94427190999916", "-25"},
                 {"55.52786404500042", "88.94427190999916", "-25"},
                 {"60", "90", "-25"},
                 {"110", "40", "-25"},
                 {"80", "10", "-25"},
                 {"20", "10", "-25"},
                 {"20", "10", "0"},
                 {"0", "0", "0"}});
}

// G37 Z200 touched at 198: the offset 15 becomes 13, and the next G43 adds 13.
TEST_P(Chapter14, TheTouchPlate) {
  const std::string program = "touch-plate-length-measurement/touch-plate.nc";
  expect_points(
      program,
      {{"850", "0", "760"}, {"850", "0", "220"}, {"850", "0", "198"}, {"850", "0", "204"}, {"850", "0", "300"}});
  const Outcome outcome = toolcomp("run " + kExamples + program + " --engine " + GetParam());
  const std::vector<json> events = outcome.events();
  ASSERT_EQ(events.size(), 6U) << outcome.out;
  EXPECT_EQ(events[3].at("kind"), "setting");
  EXPECT_EQ(events[3].at("name"), "H1");
  EXPECT_EQ(events[3].at("value"), 13);
  EXPECT_EQ(outcome.events().back().at("axes").at("Z"), 313);
}

// The manual's formulas with Fm = 1000, by hand: ERRmax 0.0333333333333, Qmax 0.266666666667.
TEST(ExplainChapter14, TheErrorsOfMeasuring) {
  const Outcome outcome = toolcomp("explain " + kExamples + "touch-plate-length-measurement/touch-plate.nc --block 30");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* words : {"measuring feed 1000 mm/min", "0.033333333333333 mm", "0.266666666666667 mm"})
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words << '\n' << outcome.out;
}

TEST(ExplainChapter14, TheHeadsOfACorner) {
  const std::string program = kExamples + "arc-figure-cutter-compensation-c/arc-figure.nc";
  const Outcome outcome = toolcomp("explain " + program + " --block 8 --digits 9");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* words : {"2 heads to line 12: X1160 Y540 Z0 (vector X10 Y-10), X1157.592566024 Y538.06882482 Z0",
                            "decision fanuc.cutter-c."})
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words << '\n' << outcome.out;
}

// Both paths are drawn, the arcs as many chords.
TEST(PicturesChapter14, BothPathsWithTheirArcs) {
  for (const char* engine : {"model", "fast"}) {
    const Outcome outcome =
        toolcomp("run " + kExamples + "arc-figure-cutter-compensation-c/arc-figure.nc --format svg --engine " + engine);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    for (const char* words : {"tp-path tp-programmed\"", "tp-path tp-point\""})
      EXPECT_NE(outcome.out.find(words), std::string::npos) << words << '\n' << outcome.out.substr(0, 2000);
  }
}

TEST(Contours, AreMadeAndAgree) {
  const Folder folder;
  for (const char* variant : {"pocket", "island"}) {
    const std::string program = folder.path(std::string(variant) + ".nc");
    const Outcome made =
        toolcomp(std::string("corpus contour --blocks 800 --variant ") + variant + " --out " + program);
    ASSERT_EQ(made.status, 0) << made.err;
    const Outcome diff = toolcomp("diff " + program + " --setup " + folder.path(std::string(variant) + ".toml"));
    EXPECT_EQ(diff.status, 0) << diff.out << diff.err;
  }
}

TEST(Contours, TightOnesEndWhereTheCommandSays) {
  const Folder folder;
  const std::string program = folder.path("tight.nc");
  for (const char* place : {"arc", "groove"}) {
    const Outcome made = toolcomp(std::string("corpus contour --blocks 800 --variant tight --at 300 --place ") + place +
                                  " --out " + program);
    ASSERT_EQ(made.status, 0) << made.err;
    std::smatch line;
    ASSERT_TRUE(std::regex_search(made.out, line, std::regex("PS0041 at line ([0-9]+)"))) << made.out;
    for (const char* engine : {"model", "fast"}) {
      const Outcome run = toolcomp("run " + program + " --setup " + folder.path("tight.toml") + " --engine " + engine);
      EXPECT_EQ(run.status, 0) << run.err;
      ASSERT_FALSE(run.events().empty());
      EXPECT_EQ(run.events().back().value("number", ""), "PS0041");
      EXPECT_EQ(run.events().back().at("line"), std::stoi(line[1])) << place;
    }
  }
}

TEST(Contours, BadUsage) {
  EXPECT_EQ(toolcomp("corpus contour").status, 2);
  EXPECT_EQ(toolcomp("corpus contour --out x.toml").status, 2);
  EXPECT_EQ(toolcomp("corpus contour --blocks 10 --out x.nc").status, 2);
  EXPECT_EQ(toolcomp("corpus contour --variant square --out x.nc").status, 2);
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// `toolcomp run`: the manual's programs through both engines, as a user runs them.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tests/command_line/command.h"

namespace {

using nlohmann::json;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::toolcomp;

const std::string kExamples = TOOLCOMP_SOURCE_DIR "/examples/fanuc/";

class Run : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(BothEngines, Run, testing::Values("model", "fast"),
                         [](const auto& engine) { return engine.param; });

// Worked example of 14.1.1, three holes, H1 = -4: the Z values by sequence number.
TEST_P(Run, ThreeHoleBoring) {
  const Outcome outcome = toolcomp("run " + kExamples + "three-hole-boring/three-holes.nc --engine " + GetParam());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::map<int, double> expected{{2, -36}, {3, -57}, {5, -36}, {7, -77}, {8, -36}, {10, -61}, {12, 0}};
  std::map<int, double> z;
  for (const json& event : outcome.events()) z[event.at("n")] = event.at("axes").at("Z");
  for (const auto& [n, value] : expected) EXPECT_EQ(z.at(n), value) << "N" << n;
  EXPECT_EQ(outcome.events().back().at("axes").at("X"), 0);
}

// The manual's note in 14.1.1: H1 = 20, H2 = 30 give 120, then 130.
TEST_P(Run, OffsetsReplaceAndDoNotAccumulate) {
  const Folder folder;
  const std::string setup = folder.write("setup.toml", "control = \"fanuc\"\n[offsets.H]\n1 = 20\n2 = \"30\"\n");
  const std::string program = folder.write("p.nc", "G90 G43 Z100. H1\nG90 G43 Z100. H2\nM30\n");
  const Outcome outcome = toolcomp("run " + program + " --setup " + setup + " --engine " + GetParam());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  ASSERT_EQ(outcome.events().size(), 2U);
  EXPECT_EQ(outcome.events()[0].at("axes").at("Z"), 120);
  EXPECT_EQ(outcome.events()[1].at("axes").at("Z"), 130);
}

// Radii 5 and 3 about (5, 0); 10 and 11 about (10, 20) under G41; then 10 and 10 while D2 comes in. Without 3410 the
// first two are told.
TEST_P(Run, TellsRadiiThatDifferWhereTheSetupHasNoLimit) {
  const Folder folder;
  const std::string program = folder.write("p.nc",
                                           "G03 X8 Y0 I5 F100\nG41 D1 G01 X20\nY20\nG03 X10 Y31 I-10\n"
                                           "G03 X0 Y21 J-10 D2\nG01 X-10\n");
  const std::string start = "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[offsets.D]\n1 = 1\n2 = 2\n";
  const std::string run = "run " + program + " --engine " + GetParam() + " --setup ";
  EXPECT_EQ(toolcomp(run + folder.write("without.toml", start)).err,
            program +
                ":1: note: the start radius and the end radius of this arc and of 1 more differ by up to 2; the setup "
                "has no parameter 3410, the limit above which a control raises PS0020\n");
  const std::string with = folder.write("with.toml", start + "[parameters]\n3410 = 2\n");
  EXPECT_EQ(toolcomp(run + with).err, "");
  EXPECT_EQ(toolcomp(run + folder.write("quiet.toml", start) + " --quiet").err, "");
}

// LE1 and LE2 (corpus/examples/fanuc/leading_edge_offset.cpp): VT (±3/5, 0, 4/5), VM (100, 0, 0), R = 10 give VC (∓8,
// 0, 6).
TEST_P(Run, LeadingEdgeOfALeaningTool) {
  const Folder folder;
  const std::string setup = folder.write("setup.toml", "control = \"fanuc\"\n[offsets.D]\n1 = 10\n");
  for (const auto& [i, x] : std::map<std::string, double>{{"3", -8}, {"-3", 8}}) {
    const std::string program = folder.write(
        "p.nc", "G90 G00 G43.5 Z0 I" + i + " K4 H0\nG41.3 D1\nG01 X100. I" + i + " K4 F100\nX200.\nG40\nM30\n");
    const Outcome outcome = toolcomp("run " + program + " --setup " + setup + " --engine " + GetParam());
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto events = outcome.events();
    ASSERT_EQ(events.size(), 5U) << outcome.out;
    EXPECT_EQ(events[1].at("cause"), "start-up");
    EXPECT_EQ(events[1].at("point"), (json{{"X", x}, {"Y", 0}, {"Z", 6}}));
    EXPECT_EQ(events[2].at("point"), (json{{"X", 100 + x}, {"Y", 0}, {"Z", 6}}));
    EXPECT_EQ(events[3].at("point"), (json{{"X", 200 + x}, {"Y", 0}, {"Z", 6}}));
    EXPECT_EQ(events[4].at("cause"), "cancel");
    EXPECT_EQ(events[4].at("point"), (json{{"X", 200}, {"Y", 0}, {"Z", 0}}));
  }
}

// LE5 (corpus/examples/fanuc/leading_edge_offset.cpp): B = 15, C = 30 (C carries B), VM (40, -10, 5), R = 6.
TEST_P(Run, LeadingEdgeFromRotaryAxes) {
  const Folder folder;
  const std::string setup =
      folder.write("setup.toml",
                   "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n[parameters]\n"
                   "19680 = 2\n19681 = 5\n19682 = 3\n19686 = 4\n19687 = 2\n[offsets.D]\n1 = 6\n");
  const std::string program = folder.write("p.nc", "G90 G01 B15. C30. F100\nG41.3 D1\nX40. Y-10. Z5.\nG40\nM30\n");
  const Outcome outcome = toolcomp("run " + program + " --setup " + setup + " --digits 18 --engine " + GetParam());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const json start = outcome.events().at(1);
  EXPECT_EQ(start.at("cause"), "start-up");
  EXPECT_DOUBLE_EQ(start.at("point").at("X"), -5.635045313286906622);
  EXPECT_DOUBLE_EQ(start.at("point").at("Y"), 1.759957600658339579);
  EXPECT_DOUBLE_EQ(start.at("point").at("Z"), 1.071827206730734610);
  if (GetParam() == "model") {
    EXPECT_NE(outcome.out.find("\"X\":-5.635045313286906622"), std::string::npos) << "every printed digit";
    EXPECT_NE(outcome.out.find("0.224143868042013381"), std::string::npos) << outcome.out;
  }
}

// The same groove without the interference check, among lines that the fast engine takes together: 4 - 10 along its
// bottom, whatever the form of the output.
TEST_P(Run, NotesTellOfLinesAmongManyThatRunBack) {
  const Folder folder;
  const std::string setup = folder.write("setup.toml",
                                         "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[offsets.D]\n1 = 5\n"
                                         "[parameters]\n\"5008#0\" = 1\n");
  std::string text = "G90 G00 X-20.\nG01 G41 D1 X0. F100\n";
  for (int x = 1; x <= 12; ++x) text += "X" + std::to_string(x) + ". Y0.\n";
  text += "X12. Y-20.\nX16. Y-20.\nX16. Y0.\n";
  for (int x = 17; x <= 40; ++x) text += "X" + std::to_string(x) + ". Y0.\n";
  const std::string program = folder.write("p.nc", text);
  for (const char* const format : {"gcode", "csv"})
    EXPECT_EQ(toolcomp("run " + program + " --setup " + setup + " --engine " + GetParam() + " --format " + format).err,
              program + ":16: note: the tool runs 6 against the programmed direction in this block\n");
}

// By hand, D1 = 5: each note once, at its line, as an event and on standard error; none with --notes off.
TEST_P(Run, NotesTellWhatAReaderShouldKnow) {
  const Folder folder;
  const std::string setup =
      folder.write("setup.toml",
                   "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[offsets.D]\n1 = 5\n[offsets.H]\n5 = 5\n"
                   "[parameters]\n1411 = 200\n3410 = 1\n");
  const std::pair<const char*, const char*> cases[] = {
      {"G90 G01 X10. F100\nG41 Y10.\n", "2: note: G41 without a D other than 0"},
      {"G90 G01 X10. F100\nG41 D0 Y10.\n", "2: note: G41 without a D other than 0"},
      {"G90 G01 X10. F100\nG42 H5 Y10.\n", "2: note: G42 with H: the radius is that of D"},
      {"G90 G00 X10.\nG10 L10 P1\n", "2: note: G10 without R"},
      {"G91 G00 X10.\nG53 X0\n", "2: note: G53 under G91"},
      {"G90 G00 X10.\nG01 Y5.\n", "2: note: no F yet: the feed is 200, from parameter 1411"},
      {"G90 G01 X10. F100\nG41 D1 Y2.\nY20.\nX30.\nG40 X40.\n",
       "2: note: the start-up move of 2 is shorter than the radius 5"},
      // A groove 4 wide and a tool 10 wide: 4 - 10 along its bottom. An arc of radius 3 inside.
      {"G90 G00 X-20.\nG01 G41 D1 X0. F100\nY-20.\nX4.\nY0.\nX20.\nG40 X40.\n", "4: note: the paths cross by 6"},
      {"G90 G00 X-20.\nG01 G41 D1 X0. F100\nG03 Y6. J3.\nG01 X-20.\nG40 X-40.\n", "3: note: the paths cross by 2"},
  };
  for (const auto& [program, says] : cases) {
    const std::string run = "run " + folder.write("p.nc", program) + " --setup " + setup + " --engine " + GetParam();
    const Outcome outcome = toolcomp(run);
    const auto notes =
        std::ranges::count_if(outcome.events(), [](const json& event) { return event.at("kind") == "note"; });
    EXPECT_EQ(notes, 1) << program << outcome.out;
    EXPECT_NE(outcome.err.find(std::string("p.nc:") + says), std::string::npos) << program << outcome.err;
    const Outcome silent = toolcomp(run + " --notes off");
    EXPECT_EQ(silent.err.find("note"), std::string::npos) << silent.err;
    EXPECT_EQ(silent.events().size() + static_cast<std::size_t>(notes), outcome.events().size());
  }
}

TEST_P(Run, TheExamplesRun) {
  for (const char* program : {"length-offset-of-any-axis/shaft.nc", "wavy-strip-rotary-head/wavy-strip.nc",
                              "inclined-faces-tool-vector/faces.nc", "arc-figure-cutter-compensation-c/arc-figure.nc",
                              "contour-tool-offset/contour.nc", "plate-cutter-compensation-b/plate.nc",
                              "touch-plate-length-measurement/touch-plate.nc", "tapered-boss-tool-side/boss.nc",
                              "tapered-boss-tool-side/boss-vector.nc", "blade-flank-tool-side/flank.nc",
                              "pyramid-posture-control/pyramid.nc", "inclined-slot-tool-center-point/slot.nc"}) {
    const Outcome outcome = toolcomp("run " + kExamples + program + " --notes off --engine " + GetParam());
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "") << program;
    EXPECT_EQ(outcome.out.find("\"alarm\""), std::string::npos) << program;
    EXPECT_EQ(outcome.out.find("-0,"), std::string::npos) << "minus zero is never printed";
  }
}

TEST(RunFormats, CsvGcodeAndSvg) {
  const std::string program = kExamples + "three-hole-boring/three-holes.nc";
  const Outcome csv = toolcomp("run " + program + " --format csv");
  EXPECT_EQ(csv.status, 0);
  EXPECT_EQ(std::count(csv.out.begin(), csv.out.end(), '\n'), 12) << "a header and eleven moves";
  const Outcome gcode = toolcomp("run " + program + " --format gcode");
  EXPECT_EQ(gcode.status, 0);
  EXPECT_NE(gcode.out.find("Z-57"), std::string::npos) << gcode.out;
  const Outcome svg = toolcomp("run " + program + " --format svg");
  EXPECT_EQ(svg.status, 0);
  EXPECT_TRUE(svg.out.starts_with("<svg")) << svg.out.substr(0, 100);
}

TEST(RunDigits, RoundsCorrectly) {
  const Folder folder;
  const std::string setup = folder.write("setup.toml", "control = \"fanuc\"\nunits = \"inch\"\n");
  // 1 mm in an inch setup is 5/127 inch.
  const std::string program = folder.write("p.nc", "G21 G00 X1.\n");
  const Outcome outcome = toolcomp("run " + program + " --setup " + setup + " --digits 40");
  EXPECT_NE(outcome.out.find("\"X\":0.0393700787401574803149606299212598425197,"), std::string::npos) << outcome.out;
}

}  // namespace

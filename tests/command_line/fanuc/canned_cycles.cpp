// SPDX-License-Identifier: Apache-2.0
// Canned cycles between contours, as a user judges a controller by them.
#include <gtest/gtest.h>

#include <string>

#include "spec_engine/engine.h"
#include "tests/command_line/command.h"

namespace {

using nlohmann::json;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::toolcomp;

constexpr const char* kSetup = R"(control = "fanuc"
axes = ["X", "Y", "Z"]
[offsets.H]
1 = 100
2 = "87.5"
[offsets.D]
1 = 4
)";

// Three contours and two cycles, one with each level of return.
constexpr const char* kProgram = R"(%
N1 G90 G00 G43 H1 Z50.
N2 Z-2.
N3 G01 G41 D1 X10. Y0 F300
N4 Y30.
N5 X40.
N6 G40 X60.
N7 G00 Z50.
N8 G98 G81 X5. Y5. Z-12. R2. F120
N9 X15.
N10 G80
N11 G43 H2 Z50.
N12 G01 G42 D1 X80. Y0
N13 X120.
N14 Y25.
N15 G40 Y50.
N16 G00 Z20.
N17 G99 G83 X90. Y10. Z-30. R3. Q5.
N18 G91 X10. K2
N19 G80 G90
N20 G00 Z50.
N21 G01 G41 D1 X0 Y60.
N22 Y90.
N23 X-30.
N24 G40 X-50.
N25 G00 Z80.
N26 M30
%
)";

class CannedCycles : public testing::Test {
 protected:
  // What `certify` says of a controller that runs the program.
  Outcome certified(const std::string& controller) {
    return toolcomp("certify --controller '" + controller + "' --settle 0 --report " + folder_.path("report") + " " +
                    folder_.write("part.nc", kProgram) + " --setup " + folder_.write("setup.toml", kSetup));
  }
  static std::string faulty(const std::string& lie) { return TOOLCOMP_BINARY_DIR "/toolcomp_faulty_controller " + lie; }
  Folder folder_;
};

TEST_F(CannedCycles, AContourWithCyclesIsJudgedToItsEnd) {
  const std::string program = folder_.write("part.nc", kProgram);
  const std::string setup = folder_.write("setup.toml", kSetup);
  for (const std::string engine : {"model", "fast", "spec"}) {
    if (engine == "spec" && !::toolcomp::spec_engine::available()) continue;
    const Outcome run = toolcomp("run " + program + " --setup " + setup + " --notes off --engine " + engine);
    ASSERT_EQ(run.status, 0) << run.err;
    std::vector<std::string> holes;
    for (const json& event : run.events())
      if (event.at("kind") == "hole") {
        const auto number = [](const json& value) { return std::to_string(value.get<double>()); };
        holes.push_back(event.at("line").dump() + " " + number(event.at("point").at("X")) + " " +
                        number(event.at("return")) + " " + number(event.at("axes").at("Z")));
      }
    // By hand: the initial level 50 and H1 = 100; then point R 3 and H2 = 87.5.
    const std::vector<std::string> wanted{"9 5.000000 50.000000 150.000000", "10 15.000000 50.000000 150.000000",
                                          "18 90.000000 3.000000 90.500000", "19 100.000000 3.000000 90.500000",
                                          "19 110.000000 3.000000 90.500000"};
    EXPECT_EQ(holes, wanted) << engine;
    EXPECT_EQ(run.events().back().at("line"), 26);
  }
  EXPECT_EQ(toolcomp("diff " + program + " --setup " + setup).status, 0);
  const Outcome right = certified(TOOLCOMP_BINARY_DIR "/toolcomp serve --engine fast");
  EXPECT_EQ(right.status, 0) << right.out << right.err;
}

TEST_F(CannedCycles, AControllerThatReturnsToPointRUnderG98IsFound) {
  const Outcome wrong = certified(faulty("hole-to-point-r"));
  EXPECT_EQ(wrong.status, 1) << wrong.out << wrong.err;
  EXPECT_NE(wrong.out.find("return"), std::string::npos) << wrong.out;
}

TEST_F(CannedCycles, AControllerThatForgetsTheLengthOffsetInTheSecondContourIsFound) {
  const Outcome wrong = certified(faulty("no-length-behind-a-hole"));
  EXPECT_EQ(wrong.status, 1) << wrong.out << wrong.err;
  EXPECT_NE(wrong.out.find("axes.Z"), std::string::npos) << wrong.out;
}

TEST_F(CannedCycles, FollowAsAProgramAndAsATable) {
  const std::string files = folder_.write("part.nc", "G90 G00 G43 H1 Z50.\nG99 G81 X5. Y6. Z-12. R2. F120\n") +
                            " --setup " + folder_.write("setup.toml", kSetup) + " --notes off";
  EXPECT_NE(toolcomp("run " + files + " --format gcode").out.find("G00 X5 Y6\nG00 Z102\nG01 Z88\nG00 Z102\n"),
            std::string::npos);
  const Outcome table = toolcomp("run " + files + " --format csv --engine fast");
  EXPECT_NE(table.out.find(",r,bottom,return,t,clauses\n"), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("\nhole,2,"), std::string::npos) << table.out;
  EXPECT_NE(table.out.find(",2,-12,2,,\n"), std::string::npos) << table.out;
}

}  // namespace

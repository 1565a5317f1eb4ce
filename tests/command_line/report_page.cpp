// SPDX-License-Identifier: Apache-2.0
// Pages as a browser shows them: Chromium without a screen (tests/browser/look.py) presses keys, turns, prints.
#include <gtest/gtest.h>

#include <string>

#include "tests/command_line/command.h"

namespace {

using nlohmann::json;
using toolcomp::test::command;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::toolcomp;

// Upwards of what letters and lines alone would need on an empty paper.
constexpr int kDrawn = 50;

const std::string kSetup =
    "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[offsets]\nH = { 1 = 20 }\nD = { 1 = 5 }\n";

class ReportPage : public testing::Test {
 protected:
  void SetUp() override {
    if (command("command -v chromium").status != 0) GTEST_SKIP() << "chromium is not installed";
    if (command("command -v python3").status != 0) GTEST_SKIP() << "python3 is not installed";
  }
  Folder folder;

  // What the browser sees, its console and its requests empty, the page no wider than the window.
  [[nodiscard]] static json seen(const std::string& page, const std::string& options = "") {
    const Outcome outcome = command("python3 " TOOLCOMP_SOURCE_DIR "/tests/browser/look.py " + page + " " + options);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    if (outcome.status != 0) return json::object();
    json look = json::parse(outcome.out);
    EXPECT_EQ(look["console"], json::array());
    EXPECT_EQ(look["requests"], json::array());
    EXPECT_EQ(look["overflow"]["1280"], 0);
    EXPECT_EQ(look["overflow"]["400"], 0);
    EXPECT_NE(look["light_paper"], look["dark_paper"]);
    return look;
  }

  // The view draws and follows the keys: Home, right, left, End, Shift and right, ].
  static void expect_view(const json& look, bool deviates) {
    ASSERT_GT(look["live"], 0);
    const int blocks = look["blocks"];
    ASSERT_GT(blocks, 1);
    EXPECT_GT(look["colours"], kDrawn);
    const json& keys = look["keys"];
    ASSERT_EQ(keys.size(), 6U);
    EXPECT_EQ(keys[0]["step"], 0);
    EXPECT_EQ(keys[1]["step"], 1);
    EXPECT_EQ(keys[2]["step"], 0);
    EXPECT_EQ(keys[3]["step"], blocks - 1);
    EXPECT_EQ(keys[4]["step"], blocks - 1);
    for (const std::size_t i : {1U, 2U, 3U}) {
      EXPECT_TRUE(keys[i]["drawn_anew"]) << keys[i];
      EXPECT_TRUE(keys[i]["told_anew"]) << keys[i];
    }
    EXPECT_TRUE(keys[4]["drawn_anew"]) << "turned";
    EXPECT_FALSE(keys[4]["told_anew"]);
    EXPECT_EQ(keys[5]["drawn_anew"], deviates) << "deviations larger";
  }
};

// A controller that gives every position a block late, and one program, with a comment that would be a script.
TEST_F(ReportPage, OfFindings) {
  const std::string setup = folder.write("setup.toml", kSetup);
  const std::string program =
      folder.write("part.nc",
                   "N10 G90 G00 X5. Y5. (</script><script>alert`1`</script> <!-- & \")\n"
                   "N20 G01 G41 D1 X10. Y10. F100\nN30 Y50.\nN40 X60.\nN50 G40 X80. Y60.\nM30\n");
  const std::string report = folder.path("report");
  const Outcome outcome =
      toolcomp("certify --controller '" TOOLCOMP_BINARY_DIR "/toolcomp_faulty_controller late' --report " + report +
               " --operator 'A. <Body>' --serial 4711 " + program + " --setup " + setup);
  ASSERT_EQ(outcome.status, 1) << outcome.err;
  const std::string page = toolcomp::test::read(report + "/index.html");
  EXPECT_NE(page.find("A. &lt;Body&gt;"), std::string::npos);
  EXPECT_NE(page.find("4711"), std::string::npos);
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  const json look = seen(report + "/index.html");
  EXPECT_EQ(look["views"], 2) << "the finding and the program";
  EXPECT_EQ(look["pictures_shown"], look["views"].get<int>() - look["live"].get<int>());
  EXPECT_GE(look["printed_pages"], 2) << "the first page stands alone";
  expect_view(look, true);
}

TEST_F(ReportPage, OfATrace) {
  const std::string setup = folder.write("setup.toml", kSetup);
  const std::string program = folder.write("part.nc", "N10 G90 G01 X10. F100\nN20 Y10.\n");
  const std::string trace = folder.write("trace.csv", "X,Y\n0,0\n5,1\n10,0\n10,10\n");
  ASSERT_EQ(toolcomp("certify --trace " + trace + " --tolerance 0.01 " + program + " --setup " + setup + " --report " +
                     folder.path("report"))
                .status,
            1);
  const json look = seen(folder.path("report/index.html"));
  EXPECT_EQ(look["views"], 1);
  EXPECT_EQ(look["blocks"], 2);
  expect_view(look, true);
  // Where a browser cannot draw in space, the picture stays.
  const json flat = seen(folder.path("report/index.html"), "--without-webgl");
  EXPECT_EQ(flat["live"], 0);
  EXPECT_EQ(flat["pictures_shown"], 1);
}

// Five moves, no controller: nothing deviates.
TEST_F(ReportPage, OfARun) {
  const std::string setup = folder.write("setup.toml", kSetup);
  const std::string program =
      folder.write("part.nc", "G90 G00 Z5.\nG01 G41 D1 X10. Y10. F100\nY50.\nX60.\nG40 X80. Y60.\n");
  const Outcome outcome = toolcomp("run --format html --setup " + setup + " " + program);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string page = folder.write("run.html", outcome.out);
  const json look = seen(page);
  EXPECT_EQ(look["blocks"], 5);
  expect_view(look, false);
}

TEST_F(ReportPage, OfAControllerThatConforms) {
  const std::string report = folder.path("report");
  const Outcome outcome = toolcomp("certify --controller '" TOOLCOMP_BINARY_DIR
                                   "/toolcomp serve --engine fast' --section fanuc/tool-offset --cases 20 --report " +
                                   report);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const json look = seen(report + "/index.html");
  EXPECT_EQ(look["views"], 0);
  EXPECT_EQ(toolcomp::test::read(report + "/index.html").find("<script"), std::string::npos) << "nothing to draw";
  EXPECT_GE(look["printed_pages"], 2);
}

}  // namespace

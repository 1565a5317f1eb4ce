// SPDX-License-Identifier: Apache-2.0
// toolcomp view: the page as a file, in a browser (tests/browser/view.py) and served (served_page.py). Figures are
// those of the worked examples: the manual's three holes, and block 13 of the Heidenhain manual
// (examples/heidenhain/README.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/command_line/command.h"

namespace {

using nlohmann::json;
using toolcomp::test::command;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::toolcomp;
namespace fs = std::filesystem;

const std::string kExamples = TOOLCOMP_SOURCE_DIR "/examples/";
const std::string kHoles = kExamples + "fanuc/three-hole-boring/three-holes.nc";
const std::string kFlank = kExamples + "fanuc/blade-flank-tool-side/flank.nc";
const std::string kTip = kExamples + "heidenhain/reworked-ball-at-tip/reworked.h";

// Of the two an arc that no circle makes: R 10 over a chord longer than 20.
const std::string kSetup = "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n";
const std::string kAlarm = "N10 G90 G17 G01 X10. F100\nN20 G03 X50. R10.\nN30 X0\n";

std::string in(const Folder& folder, const std::string& arguments) {
  return "cd " + folder.path("") + " && " TOOLCOMP_BINARY_DIR "/toolcomp view " + arguments;
}

TEST(View, WritesAPageHereNamedLikeTheProgram) {
  const Folder folder;
  const Outcome outcome = command(in(folder, kHoles));
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "wrote three-holes.html\n");
  const std::string page = toolcomp::test::read(folder.path("three-holes.html"));
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(page.find("connect-src"), std::string::npos);
  EXPECT_EQ(page.find(" src="), std::string::npos);
  EXPECT_EQ(page.find(" href="), std::string::npos);
  // Again: its own page may be replaced.
  EXPECT_EQ(command(in(folder, kHoles)).status, 0);
  EXPECT_EQ(toolcomp::test::read(folder.path("three-holes.html")), page);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path("")), fs::directory_iterator()), 1) << "nothing beside it";
}

TEST(View, ReplacesNoFileOfAnotherKindUnlessNamed) {
  const Folder folder;
  const std::string mine = folder.write("three-holes.html", "<p>my notes</p>");
  const Outcome outcome = command(in(folder, kHoles));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "three-holes.html: exists and is not a page of toolcomp; name another file with --out\n");
  EXPECT_EQ(toolcomp::test::read(mine), "<p>my notes</p>");
  EXPECT_EQ(command(in(folder, kHoles + " --out three-holes.html")).status, 0);
  EXPECT_NE(toolcomp::test::read(mine), "<p>my notes</p>");
}

TEST(View, PrintsThePageThatRunPrints) {
  const Outcome printed = toolcomp("view --out - " + kTip);
  EXPECT_EQ(printed.status, 0);
  EXPECT_EQ(printed.err, "");
  EXPECT_EQ(toolcomp("run --format html " + kTip).out, printed.out);
  const Outcome piped =
      toolcomp("view - --setup " + kExamples + "heidenhain/reworked-ball-at-tip/setup.toml < " + kTip);
  EXPECT_EQ(piped.status, 0);
  EXPECT_NE(piped.out.find("data-program"), std::string::npos);
}

TEST(View, SaysAlarmsWithTheirPlace) {
  const Folder folder;
  const std::string setup = folder.write("setup.toml", kSetup);
  const std::string program = folder.write("part.nc", kAlarm);
  const Outcome outcome = command(in(folder, "part.nc"));
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, toolcomp("run " + program).err.substr(folder.path("").size()) + "wrote part.html\n");
}

TEST(View, RefusesWhatItCannotDo) {
  const Folder folder;
  const std::string setup = folder.write("setup.toml", kSetup);
  const std::string broken = folder.write("broken.nc", "N10 G01 X1.\nN20 G01 X\xff\n");
  const auto refused = [&](const std::string& arguments) {
    const Outcome outcome = command(in(folder, arguments));
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    return outcome.err;
  };
  EXPECT_EQ(refused("broken.nc").substr(0, 12), "broken.nc:2:");
  EXPECT_FALSE(fs::exists(folder.path("broken.html")));
  refused("missing.nc");
  refused("missing.nc --serve");
  refused(kHoles + " --out /dev/null/page.html");
  refused(kHoles + " --serve --out page.html");
  refused("- --serve --setup setup.toml < /dev/null");
}

class ViewPage : public testing::Test {
 protected:
  void SetUp() override {
    if (command("command -v chromium").status != 0) GTEST_SKIP() << "chromium is not installed";
    if (command("command -v python3").status != 0) GTEST_SKIP() << "python3 is not installed";
  }
  Folder folder;

  [[nodiscard]] json seen(const std::string& program, const std::string& options = "") const {
    const std::string page = folder.path("page.html");
    EXPECT_NE(toolcomp("view " + program + " --out " + page).status, 2);
    return looked_at(page, options);
  }
  [[nodiscard]] static json looked_at(const std::string& page, const std::string& options) {
    const Outcome outcome = command("python3 " TOOLCOMP_SOURCE_DIR "/tests/browser/view.py " + page + " " + options);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    if (outcome.status != 0) return json::object();
    json look = json::parse(outcome.out);
    EXPECT_EQ(look["console"], json::array());
    return look;
  }
  static bool has(const json& list, const std::string& text) {
    return std::ranges::any_of(
        list, [&](const json& item) { return item.get<std::string>().find(text) != std::string::npos; });
  }
  // Two widths, two schemes: no wider than the window.
  static void expect_sizes(const json& look, bool drawn) {
    constexpr int kDrawn = 50;
    for (const std::string width : {"1280", "400"}) {
      const json& light = look["sizes"][width + "-light"];
      const json& dark = look["sizes"][width + "-dark"];
      EXPECT_EQ(light["overflow"], 0) << width;
      EXPECT_EQ(dark["overflow"], 0) << width;
      EXPECT_NE(light["paper"], dark["paper"]);
      if (!drawn) continue;
      EXPECT_GT(light["colours"], kDrawn);
      EXPECT_GT(dark["colours"], kDrawn);
    }
  }
};

// The manual: N2 G43 Z-32.0 H1 with H1 = -4 goes to -36, N3 G01 Z-21.0 to -57.
TEST_F(ViewPage, OfThreeHoles) {
  const json look = seen(kHoles, "--search N3 --search 'z - 21' --search 4 --search nowhere");
  const json& keys = look["keys"];
  ASSERT_EQ(keys.size(), 7U);
  EXPECT_EQ(look["requests"], json::array());
  EXPECT_EQ(keys[0]["text"], "O0001 (THREE HOLES WITH TOOL LENGTH OFFSET, H1 = -4)");
  EXPECT_EQ(keys[1]["text"], "N1 G91 G00 X120.0 Y80.0");
  const json& second = keys[2];
  EXPECT_EQ(second["text"], "N2 G43 Z-32.0 H1");
  EXPECT_EQ(second["row"], second["text"]);
  EXPECT_TRUE(has(second["numbers"], "Z -32 -32 0"));
  EXPECT_TRUE(has(second["numbers"], "Z -36 -36 0"));
  EXPECT_TRUE(has(second["clauses"], "fanuc.length-offset.direction"));
  EXPECT_NE(second["picture"], keys[1]["picture"]);
  EXPECT_EQ(keys[3]["text"], keys[1]["text"]);
  EXPECT_EQ(keys[3]["picture"], keys[1]["picture"]) << "the same block, the same picture";
  EXPECT_EQ(keys[5]["block"], look["blocks"].get<int>() - 1);
  for (const json& key : keys) EXPECT_TRUE(key["in_view"]) << key["key"];
  EXPECT_EQ(look["burst"], look["blocks"].get<int>() - 1) << "300 keys in 14 blocks end at the last";
  EXPECT_TRUE(look["help"]);
  EXPECT_TRUE(look["help_closed"]);
  expect_sizes(look, true);
  EXPECT_TRUE(look["printed"]["picture"]);
  EXPECT_FALSE(look["printed"]["list"]);
  EXPECT_GE(look["printed_pages"], 1);
  const json& found = look["found"];
  EXPECT_EQ(found["N3"], json({"N3 G01 Z-21.0 F1000", "1 of 1"}));
  EXPECT_EQ(found["z - 21"], json({"N3 G01 Z-21.0 F1000", "1 of 1"}));
  EXPECT_EQ(found["4"], json({"N4 G04 P2000", "1 of 1"}));
  EXPECT_EQ(found["nowhere"][1], "none");
}

// Block 13 of the manual's example: the tip in the manual's own program, to 15 decimals.
TEST_F(ViewPage, OfKlartextWithExactNumbers) {
  const json look = seen(kTip, "--without-webgl --search 36.0");
  const json& blocks = look["keys"];
  ASSERT_FALSE(blocks.empty());
  // The block is the last that moves along a normal.
  const Outcome page = toolcomp("view " + kTip + " --out -");
  for (const std::string number : {"36.054981069776461~", "6.24258845869536~", "-1.933902321076868~"})
    EXPECT_NE(page.out.find("\"" + number + "\""), std::string::npos) << number;
  EXPECT_EQ(blocks[0]["picture"], blocks[5]["picture"]) << "no drawing";
  EXPECT_NE(blocks[0]["text"], blocks[5]["text"]);
  EXPECT_GE(look["pictures_shown"], 1);
  expect_sizes(look, false);
}

// 1,213 blocks: every key counts, few rows are there at once.
TEST_F(ViewPage, OfAThousandBlocks) {
  const json look = seen(kFlank, "--search N1000 --search 1000");
  EXPECT_GT(look["blocks"], 1000);
  EXPECT_EQ(look["burst"], 300);
  for (const json& key : look["keys"]) {
    EXPECT_LT(key["rows"], 120) << "of 1,217 lines";
    EXPECT_TRUE(key["in_view"]) << key["key"];
  }
  EXPECT_EQ(look["found"]["N1000"][1], "none") << "no block has a number";
  EXPECT_EQ(look["found"]["1000"][1], "1 of 1") << "so 1000 is a line";
  expect_sizes(look, true);
}

TEST_F(ViewPage, OfAnAlarm) {
  const std::string setup = folder.write("setup.toml", kSetup);
  const json look = seen(folder.write("part.nc", kAlarm));
  EXPECT_TRUE(has(look["keys"][0]["notes"], "line 2: alarm PS0020"));
  const json& last = look["keys"][5];
  EXPECT_EQ(last["text"], "N20 G03 X50. R10.") << "the run ends there";
  EXPECT_TRUE(has(last["alarms"], "PS0020"));
}

TEST_F(ViewPage, ServedIsMadeAnew) {
  const std::string setup = folder.write("setup.toml", kSetup);
  const std::string program = folder.write("part.nc", "N10 G90 G01 X10. F100\nN20 Y10.\nN30 X0\nN40 Y0\n");
  // The server ends with the shell that began it.
  const std::string begun = folder.path("address");
  const Outcome outcome =
      command("sh -c '" TOOLCOMP_BINARY_DIR "/toolcomp view " + program + " --serve --port 0 >" + begun +
              " & server=$!; for i in $(seq 100); do [ -s " + begun +
              " ] && break; sleep 0.1; done; python3 " TOOLCOMP_SOURCE_DIR "/tests/browser/view.py $(cat " + begun +
              ") --edits " + program + "; kill -INT $server; wait $server; echo status $? >&2'");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("status 0"), std::string::npos) << outcome.err;
  const json look = json::parse(outcome.out);
  EXPECT_EQ(look["console"], json::array());
  EXPECT_EQ(look["before"], "N30 X0");
  EXPECT_TRUE(look["came"]);
  EXPECT_EQ(look["after"], "N30 X0") << "two lines further down";
  EXPECT_TRUE(look["fault"]);
  EXPECT_NE(look["fault_text"].get<std::string>().find("part.nc:1:"), std::string::npos);
  EXPECT_TRUE(look["mended"]);
  EXPECT_EQ(look["at_last"], "N30 X0");
}

class ServedPage : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Signals, ServedPage, testing::Values("SIGINT", "SIGTERM"));

TEST_P(ServedPage, AnswersThisMachineAlone) {
  if (command("command -v python3").status != 0) GTEST_SKIP() << "python3 is not installed";
  const Outcome outcome =
      command("python3 " TOOLCOMP_SOURCE_DIR "/tests/command_line/served_page.py " TOOLCOMP_BINARY_DIR "/toolcomp " +
              kHoles + " " + GetParam());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const json said = json::parse(outcome.out);
  EXPECT_EQ(said["page"], 200);
  EXPECT_EQ(said["localhost"], 200);
  EXPECT_EQ(said["other_host"], 421);
  EXPECT_EQ(said["other_port"], 421);
  EXPECT_EQ(said["post"], 405);
  EXPECT_EQ(said["head"], 405);
  EXPECT_EQ(said["elsewhere"], 404);
  EXPECT_EQ(said["no_host"], "HTTP/1.1 421 Misdirected Request");
  EXPECT_EQ(said["no_http"], "HTTP/1.1 400 Bad Request");
  EXPECT_EQ(said["long_header"], "HTTP/1.1 431");
  EXPECT_EQ(said["beside_idle"], 200);
  EXPECT_TRUE(said["beside_idle_quick"]);
  EXPECT_EQ(said["beside_listeners"], 200);
  EXPECT_EQ(said["taken"], json({2, "", 1, true}));
  EXPECT_EQ(said["heard_on"], json({"0100007F"})) << "127.0.0.1";
  EXPECT_EQ(said["status"], 0);
  EXPECT_TRUE(said["ends_quickly"]);
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// What the command says beside its data: without arguments, where a word is misspelt, quiet, verbose, in colors, on a
// terminal.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/command_line/command.h"

namespace {

using toolcomp::test::command;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::toolcomp;

const std::string kTerminal = "/usr/bin/python3 " TOOLCOMP_SOURCE_DIR "/tests/command_line/terminal.py ";
const std::string kCommand = TOOLCOMP_BINARY_DIR "/toolcomp ";

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

class Manners : public testing::Test {
 protected:
  Folder folder;
  std::string setup = folder.write("setup.toml", "control = \"fanuc\"\n");
  std::string program = folder.write("part.nc", "G00 X1.\nG01 X2. F100\n");
  // Its alarm stands in line 2, column 5.
  std::string alarming = folder.write("alarm.nc", "G00 X1.\nN20 E1\n");

  static void suggests(const std::string& arguments, const std::string& meant) {
    const Outcome outcome = toolcomp(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_TRUE(has(outcome.err, "did you mean " + meant + "?")) << arguments << '\n' << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_TRUE(outcome.out.empty()) << outcome.out;
  }
};

TEST_F(Manners, WithoutArgumentsItSaysWhatToDoNext) {
  const Outcome outcome = toolcomp("");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_TRUE(outcome.out.empty());
  EXPECT_TRUE(has(outcome.err, "toolcomp --help")) << outcome.err;
  EXPECT_LE(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 10);
}

TEST_F(Manners, WhatIsMisspeltIsAnsweredWithTheNearest) {
  suggests("expalin " + program, "explain");
  suggests("cert", "certify");
  suggests("run --engin fast " + program, "--engine");
  suggests("run " + program + " --formt=csv", "--format");
  suggests("run " + program + " --format cvs", "csv");
  suggests("run " + program + " --engine Fast", "fast");
  suggests("run " + program + " --colour never", "--color");
  suggests("run " + program + " --color nevr", "never");
  suggests("config exampel", "example");
  suggests("config schema setpu", "setup");
  suggests("corpus generat", "generate");
  suggests("kit mak", "make");
  suggests("spec show fanuc.cutter-b.mod", "fanuc.cutter-b.mode");
  for (const std::string verb : {"certify --controller x", "fuzz", "corpus check", "fuzz --campaign none"})
    suggests(verb + " --section fanuc/tool-ofset", "fanuc/tool-offset");
  suggests("fuzz --campaign " + folder.path("c") + " --target tool_offset_directd", "tool_offset_directed");
  suggests("kit make --setup " + setup + " --out " + folder.path("k") + " --controller linuxnc", "linuxcnc");
  suggests("config check " + folder.write("key.toml", "unit = \"mm\"\n"), "units");
  suggests("config check " + folder.write("value.toml", "units = \"inhc\"\n"), "inch");
  suggests("config check " + folder.write("number.toml", "[parameters]\n19860 = 2\n"), "19680");
  suggests("config check " + folder.write("case.json", R"({"case":1,"setup":{},"progam":""})"), "program");
}

TEST_F(Manners, WhatIsNearNothingGetsNoSuggestion) {
  for (const std::string arguments :
       {"frobnicate", "run --zzzzzz x", "run x --format zzz", "fuzz --section zzz/zzz", "kit", "corpus lint x"}) {
    const Outcome outcome = toolcomp(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_FALSE(has(outcome.err, "did you mean")) << outcome.err;
  }
  EXPECT_TRUE(has(toolcomp("frobnicate").err, "expected one of run, ")) << toolcomp("frobnicate").err;
  EXPECT_TRUE(has(toolcomp("kit frobnicate").err, "expected one of make, judge")) << toolcomp("kit frobnicate").err;
}

TEST_F(Manners, HelpIsThereInEveryForm) {
  const Outcome whole = toolcomp("--help");
  EXPECT_EQ(whole.status, 0);
  EXPECT_TRUE(has(whole.out, "certify")) << whole.out;
  EXPECT_FALSE(has(whole.out, "fuzz-worker")) << whole.out;
  EXPECT_EQ(toolcomp("help").out, whole.out);
  const Outcome run = toolcomp("run --help");
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(has(run.out, "--engine fast|model")) << run.out;
  EXPECT_EQ(toolcomp("help run").out, run.out);
  EXPECT_EQ(toolcomp("run -h").out, run.out);
  EXPECT_TRUE(has(run.out, "$ toolcomp run part.nc --setup setup.toml")) << run.out;
  const Outcome corpus = toolcomp("corpus --help");
  EXPECT_EQ(corpus.status, 0);
  EXPECT_TRUE(has(corpus.out, "contour")) << corpus.out;
  EXPECT_FALSE(has(corpus.out, "--variant")) << corpus.out;
  EXPECT_TRUE(has(toolcomp("corpus contour --help").out, "--variant island|pocket|tight"));
  EXPECT_EQ(toolcomp("help corpus contour").out, toolcomp("corpus contour --help").out);
  EXPECT_EQ(toolcomp("-V").out, toolcomp("--version").out);
}

TEST_F(Manners, HelpIsAsWideAsTheTerminal) {
  for (const std::size_t columns : {50U, 80U, 100U}) {
    std::string help = toolcomp("certify --help", "COLUMNS=" + std::to_string(columns) + " ").out;
    help.resize(help.find("Examples:"));  // commands stay whole
    std::size_t widest = 0;
    for (std::size_t from = 0, to = help.find('\n'); to != std::string::npos;
         from = to + 1, to = help.find('\n', from)) {
      const std::string line = help.substr(from, to - from);
      // Bytes that continue a character take no column.
      widest = std::max(widest, static_cast<std::size_t>(std::count_if(
                                    line.begin(), line.end(), [](unsigned char c) { return (c & 0xC0U) != 0x80U; })));
    }
    EXPECT_LE(widest, columns) << help;
    EXPECT_GT(widest, columns - 15) << help;
  }
}

TEST_F(Manners, QuietLeavesErrorsAndData) {
  const Outcome usual = toolcomp("config check " + setup);
  EXPECT_EQ(usual.err, setup + ": a valid setup\n");
  EXPECT_EQ(toolcomp("config check --quiet " + setup).err, "");
  EXPECT_EQ(toolcomp("-q config check " + setup).err, "");
  const Outcome diff = toolcomp("diff -q " + program);
  EXPECT_EQ(diff.status, 0);
  EXPECT_EQ(diff.err, "");
  const Outcome run = toolcomp("run --quiet " + alarming);
  EXPECT_EQ(run.out, toolcomp("run " + alarming).out);
  EXPECT_EQ(run.err, toolcomp("run " + alarming).err);
  EXPECT_TRUE(has(run.err, "alarm.nc:2:5: PS0009")) << run.err;
  EXPECT_EQ(toolcomp("run --quiet " + folder.path("none.nc")).status, 2);
  EXPECT_FALSE(toolcomp("run --quiet " + folder.path("none.nc")).err.empty());
}

TEST_F(Manners, VerboseSaysWhatIsReadAndHowLong) {
  const Outcome run = toolcomp("run -v --engine fast " + program);
  EXPECT_EQ(run.out, toolcomp("run --engine fast " + program).out);
  for (const std::string part : {"part.nc", "setup.toml", "fast", " s\n"}) EXPECT_TRUE(has(run.err, part)) << run.err;
  EXPECT_TRUE(has(toolcomp("diff --verbose " + program).err, "toolcomp: ")) << "diff";
  const Outcome certify = toolcomp("certify --verbose --seed 7 --report " + folder.path("r") + " --controller '" +
                                   kCommand + "serve --engine fast' " + program);
  for (const std::string part : {"seed 7", "serve --engine fast"}) EXPECT_TRUE(has(certify.err, part)) << certify.err;
}

// Every verb takes them, and none of them changes the data.
TEST_F(Manners, EveryVerbTakesThem) {
  const std::string verbs = toolcomp("complete ''").out;
  std::size_t count = 0;
  for (std::size_t from = 0, to = verbs.find('\n'); to != std::string::npos;
       from = to + 1, to = verbs.find('\n', from)) {
    const std::string verb = verbs.substr(from, verbs.find('\t', from) - from);
    if (verb == "help") continue;
    ++count;
    const std::string help = toolcomp(verb + " --help").out;
    for (const std::string option : {"-q, --quiet", "-v, --verbose", "--color always|auto|never"})
      EXPECT_TRUE(has(help, option)) << verb << '\n' << help;
  }
  EXPECT_GT(count, 12U);
}

TEST_F(Manners, ColorsAreThereWhereTheyAreWanted) {
  const auto colored = [&](const std::string& environment, const std::string& options) {
    return has(toolcomp("run " + options + " " + alarming, environment).err, "\033[");
  };
  EXPECT_FALSE(colored("", ""));
  EXPECT_TRUE(colored("", "--color always"));
  EXPECT_TRUE(colored("CLICOLOR_FORCE=1 ", ""));
  EXPECT_FALSE(colored("CLICOLOR_FORCE=0 ", ""));
  EXPECT_FALSE(colored("CLICOLOR_FORCE=1 NO_COLOR=1 ", ""));
  EXPECT_TRUE(colored("NO_COLOR=1 ", "--color always"));
  EXPECT_FALSE(colored("CLICOLOR_FORCE=1 ", "--color never"));
  // An empty NO_COLOR asks for nothing.
  EXPECT_TRUE(colored("NO_COLOR= CLICOLOR_FORCE=1 ", ""));
  EXPECT_FALSE(has(toolcomp("run --color always " + alarming).out, "\033["));
}

TEST_F(Manners, ColorsOnATerminal) {
  const auto shown = [&](const std::string& environment) {
    return has(command(environment + kTerminal + "-- " + kCommand + "run " + alarming).out, "\033[");
  };
  EXPECT_TRUE(shown("TERM=xterm "));
  EXPECT_FALSE(shown("TERM=dumb "));
  EXPECT_FALSE(shown("TERM=xterm NO_COLOR=1 "));
  EXPECT_FALSE(shown("TERM=xterm CLICOLOR=0 "));
}

TEST_F(Manners, ProgressOnATerminalAlone) {
  const std::string certify = kCommand + "certify --controller '" + kCommand +
                              "serve --engine fast' --section fanuc/tool-offset --cases 20 --report " +
                              folder.path("r") + ' ';
  const auto shown = [&](const std::string& environment, const std::string& options, const std::string& more) {
    return command(environment + kTerminal + options + "-- " + certify + more).out;
  };
  const std::string usual = shown("TERM=xterm ", "", "");
  EXPECT_TRUE(has(usual, " cases, ")) << usual;
  EXPECT_TRUE(has(usual, "\033[K")) << usual;
  EXPECT_EQ(shown("TERM=dumb ", "", ""), "");
  EXPECT_EQ(shown("TERM=xterm ", "", "--quiet"), "");
  EXPECT_EQ(command(certify).err, "");
  const std::string narrow = shown("TERM=xterm ", "--columns 12 ", "");
  EXPECT_TRUE(has(narrow, " of ")) << narrow;
  EXPECT_FALSE(has(narrow, " cases, ")) << narrow;
  for (std::size_t from = narrow.find('\r'); from != std::string::npos; from = narrow.find('\r', from + 1))
    if (const std::size_t end = narrow.find("\033[K", from); end != std::string::npos) {
      EXPECT_LT(end - from - 1, 12U) << narrow;
    }
}

}  // namespace

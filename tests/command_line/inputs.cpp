// SPDX-License-Identifier: Apache-2.0
// The same inputs through every verb that takes a program: empty, of the other dialect, with carriage returns, from
// standard input, a folder, missing. On both controls.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>

#include "tests/command_line/command.h"

namespace {

using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::toolcomp;

struct Dialect {
  std::string name;
  std::string setup;
  std::string program;
  std::string ending;
  std::string alarm;  // of a program of the other dialect
};

const Dialect kFanuc{"fanuc", "control = \"fanuc\"\n[offsets.H]\n1 = 5\n", "%\nN10 G43 Z1. H1\nN20 G01 X2. F100\nM30\n",
                     ".nc", "PS0004"};
const Dialect kKlartext{"klartext", "control = \"heidenhain\"\n",
                        "0 BEGIN PGM A MM\n10 L Z+6 R0 FMAX\n20 L X+2\n30 END PGM A MM\n", ".h", "E_SYNTAX"};

std::string returned(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return out;
}

// A second may begin between two runs.
std::string without_times(const std::string& text) { return std::regex_replace(text, std::regex("; [0-9]+ s;"), ";"); }

class Inputs : public testing::TestWithParam<Dialect> {
 protected:
  Folder folder;
  Dialect dialect = GetParam();
  std::string setup = " --setup " + folder.write("control.toml", dialect.setup);
  std::string report = " --report " + folder.path("report");

  [[nodiscard]] std::string file(const std::string& name, const std::string& text) const {
    return folder.write(name + dialect.ending, text);
  }
  // Verb, and what else it needs; the program and its setup stand behind it.
  [[nodiscard]] std::vector<std::string> verbs() const {
    return {"run ", "run --engine fast ", "diff ", "explain ", certify()};
  }
  [[nodiscard]] std::string certify() const {
    return "certify --controller '" TOOLCOMP_BINARY_DIR "/toolcomp serve --engine fast'" + report + " ";
  }
};
INSTANTIATE_TEST_SUITE_P(BothControls, Inputs, testing::Values(kFanuc, kKlartext),
                         [](const auto& test) { return test.param.name; });

// The last move goes to X2 Z6, in every format and of both engines.
TEST_P(Inputs, EveryFormat) {
  const std::string program = file("p", dialect.program) + setup;
  for (const std::string engine : {"model", "fast"}) {
    const auto printed = [&](const std::string& format) {
      const Outcome outcome = toolcomp("run " + program + " --engine " + engine + " --format " + format);
      EXPECT_EQ(outcome.status, 0) << format << outcome.err;
      EXPECT_EQ(outcome.err, "") << format;
      return outcome;
    };
    const auto events = printed("jsonl").events();
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(events[1].at("axes").at("X"), 2);
    EXPECT_EQ(events[1].at("axes").at("Z"), 6);
    const std::string csv = printed("csv").out;
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
    const auto commas = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
    EXPECT_EQ(commas(csv.substr(0, csv.find('\n'))) * 3, commas(csv)) << "as many fields in every line";
    EXPECT_NE(printed("gcode").out.find("X2 Y0 Z6"), std::string::npos);
    EXPECT_TRUE(printed("svg").out.starts_with("<svg"));
  }
}

TEST_P(Inputs, CarriageReturnsAndStandardInput) {
  const std::string plain = file("plain", dialect.program);
  const std::string crlf = file("crlf", returned(dialect.program));
  const std::string crlf_setup = " --setup " + folder.write("crlf.toml", returned(dialect.setup));
  for (const std::string& verb : verbs()) {
    const Outcome as_file = toolcomp(verb + plain + setup);
    EXPECT_EQ(as_file.status, 0) << verb << as_file.err;
    const Outcome with_returns = toolcomp(verb + crlf + crlf_setup);
    EXPECT_EQ(with_returns.status, 0) << verb << with_returns.err;
    EXPECT_EQ(without_times(with_returns.out), without_times(as_file.out)) << verb;
    const Outcome piped = toolcomp(verb + "-" + setup, "cat " + crlf + " | ");
    EXPECT_EQ(piped.status, 0) << verb << piped.err;
    EXPECT_EQ(without_times(piped.out), without_times(as_file.out)) << verb;
  }
}

TEST_P(Inputs, AnEmptyProgramIsNoPass) {
  const std::string program = file("empty", "") + setup;
  EXPECT_EQ(toolcomp("run " + program).status, 0);
  EXPECT_EQ(toolcomp("explain " + program).status, 0);
  EXPECT_EQ(toolcomp("diff " + program).status, 3);
  EXPECT_EQ(toolcomp(certify() + program).status, 3);
}

// The control's own alarm, on standard error too in every format.
TEST_P(Inputs, AProgramOfTheOtherDialect) {
  const std::string other = dialect.name == "fanuc" ? kKlartext.program : kFanuc.program;
  const std::string program = file("other", other) + setup;
  for (const std::string format : {"jsonl", "csv", "gcode", "svg"})
    for (const std::string engine : {"model", "fast"}) {
      const Outcome outcome = toolcomp("run " + program + " --engine " + engine + " --format " + format);
      EXPECT_EQ(outcome.status, 0) << format;
      EXPECT_TRUE(outcome.err.starts_with(folder.path("other" + dialect.ending) + ":1:1: " + dialect.alarm))
          << format << outcome.err;
    }
  for (const std::string& verb : {std::string("diff "), std::string("explain "), certify()})
    EXPECT_EQ(toolcomp(verb + program).status, 0) << verb;
}

TEST_P(Inputs, WhatCannotBeReadIsRefusedByEveryVerb) {
  const auto refused = [&](const std::string& arguments, const std::string& words) {
    for (const std::string& verb : verbs()) {
      const Outcome outcome = toolcomp(verb + arguments);
      EXPECT_EQ(outcome.status, 2) << verb << arguments << '\n' << outcome.err;
      EXPECT_NE(outcome.err.find(words), std::string::npos) << verb << outcome.err;
      EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << "one line: " << outcome.err;
    }
  };
  const std::string program = file("p", dialect.program);
  refused(folder.path("") + setup, "Is a directory");
  refused(folder.path("none") + setup, "none: cannot be read");
  refused(program + " --setup " + folder.path(""), "Is a directory");
  refused(program + " --setup " + folder.path("none.toml"), "none.toml: cannot be read");
  refused(program + " --setup " + program, dialect.ending + ":1:");
  refused(file("nul", dialect.program.substr(0, dialect.program.find('\n') + 1) + std::string("N1 \0X1\n", 7)) + setup,
          "nul" + dialect.ending + ":2:4:");
  refused(folder.write("empty.json", ""), "empty.json:1:1:");
  refused(folder.write("array.json", "[]"), "array.json:1:1:");
  refused(folder.write("case.json", "{\"case\": 1, \"program\": \"\", \"setup\": {\"control\": \"" +
                                        std::string(dialect.name == "fanuc" ? "fanuc" : "heidenhain") +
                                        "\",\n \"axis\": []}}"),
          "case.json:2:2:");
  refused(program, "--setup");
}

TEST_P(Inputs, BlocksThatAreNotThere) {
  const std::string program = file("p", dialect.program) + setup;
  EXPECT_EQ(toolcomp("explain " + program + " --block 20").status, 0);
  const Outcome outcome = toolcomp("explain " + program + " --block 999");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("p" + dialect.ending + ": no block has the sequence number 999"), std::string::npos)
      << outcome.err;
}

TEST_P(Inputs, ConfigCheckReadsSetupsAndCases) {
  EXPECT_EQ(toolcomp("config check " + folder.write("crlf.toml", returned(dialect.setup))).status, 0);
  const std::string control = dialect.name == "fanuc" ? "fanuc" : "heidenhain";
  const Outcome example = toolcomp("config example --control " + control);
  EXPECT_EQ(toolcomp("config check " + folder.write("example.toml", example.out)).status, 0);
  const auto c = [&](const std::string& program) {
    return folder.write("case.json", "{\"case\": 1, \"dialect\": \"" + dialect.name +
                                         "\", \"setup\": {\"control\": \"" + control + "\"}, \"program\": \"" +
                                         program + "\"}");
  };
  EXPECT_EQ(toolcomp("config check " + c("X1\\n")).status, 0) << "an alarm is a result";
  const Outcome nul =
      toolcomp("config check " + c((dialect.name == "fanuc" ? "X1" : "L X1") + std::string("\\nY\\u00002\\n")));
  EXPECT_EQ(nul.status, 2);
  EXPECT_NE(nul.err.find("case.json: program:2:2:"), std::string::npos) << nul.err;
  for (const std::string& name : {folder.path(""), folder.path("none.toml"), file("p", dialect.program)})
    EXPECT_EQ(toolcomp("config check " + name).status, 2) << name;
}

TEST(Options, NamesThatAreNone) {
  const Outcome outcome = toolcomp("run p.nc --engine slow");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("--engine: \"slow\" is none of fast, model"), std::string::npos) << outcome.err;
}

// What the specification does not model is no pass, in a picture neither.
TEST(Formats, OutOfScopeIsSaidByTheExitStatus) {
  const Folder folder;
  const std::string program = folder.write("p.h", "TOOL CALL 1 Z\nL X+1 R0\nL X+2 RL\nL X+3 R0\n") + " --setup " +
                              folder.write("setup.toml", "control = \"heidenhain\"\n[[tool]]\nnumber = 1\nR = 5\n");
  for (const std::string format : {"jsonl", "csv", "gcode", "svg"})
    EXPECT_EQ(toolcomp("run " + program + " --format " + format).status, 3) << format;
}

// Output that has no place: said before the work, not behind it.
TEST(Outputs, NeedAPlace) {
  const Folder folder;
  const std::string file = folder.write("file", "");
  const auto refused = [&](const std::string& arguments, const std::string& words) {
    const Outcome outcome = toolcomp(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  };
  refused("certify --controller cat --report " + file, "--report: " + file + " is not a folder");
  refused("fuzz --section heidenhain/face-milling --runs 1 --findings " + file + "/a/b",
          "--findings: " + file + " is not a folder");
  refused("corpus flank --out " + file + "/a.nc", "--out: " + file + " is not a folder");
  refused("corpus flank --out " + folder.path(""), "is a folder");
}

// A file of cases without one.
TEST(Outputs, AFileOfCasesHoldsOne) {
  const Folder folder;
  const Outcome outcome =
      toolcomp("certify --controller cat " + folder.write("none.jsonl", "\n") + " --report " + folder.path("report"));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("none.jsonl:1:1: contains no case"), std::string::npos) << outcome.err;
}

}  // namespace

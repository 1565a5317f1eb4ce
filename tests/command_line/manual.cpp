// SPDX-License-Identifier: Apache-2.0
// Manual pages: without a warning of mandoc or groff, whole, and every command shown runs.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tests/command_line/command.h"

namespace {

namespace fs = std::filesystem;
using toolcomp::test::command;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::read;
using toolcomp::test::toolcomp;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t from = 0, to = text.find('\n'); to != std::string::npos; from = to + 1, to = text.find('\n', from))
    lines.push_back(text.substr(from, to - from));
  return lines;
}

class Manual : public testing::Test {
 protected:
  void SetUp() override {
    const Outcome outcome = toolcomp("manual --date 2026-01-31 " + folder.path("man"));
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    for (const auto& entry : fs::directory_iterator(folder.path("man"))) pages.push_back(entry.path().string());
  }

  // The verbs of the program; behind "corpus " those of `corpus`.
  static std::vector<std::string> verbs(const std::string& of = "") {
    std::vector<std::string> list;
    if (of == "completion ") return list;  // what stands there are shells
    for (const std::string& line : lines_of(toolcomp("complete " + of + "''").out))
      if (!line.starts_with(':') && !line.starts_with("help\t")) list.push_back(line.substr(0, line.find('\t')));
    return list;
  }

  Folder folder;
  std::vector<std::string> pages;
};

TEST_F(Manual, HasAPageForEveryVerb) {
  std::set<std::string> expected{"toolcomp.1"};
  for (const std::string& verb : verbs()) expected.insert("toolcomp-" + verb + ".1");
  std::set<std::string> names;
  for (const std::string& page : pages) names.insert(fs::path(page).filename());
  EXPECT_EQ(names, expected);
}

TEST_F(Manual, NoWarningOfMandocOrGroff) {
  for (const std::string& page : pages) {
    const Outcome lint = command("mandoc -T lint -W warning " + page);
    EXPECT_EQ(lint.out + lint.err, "");
    EXPECT_EQ(lint.status, 0);
    EXPECT_EQ(command("LC_ALL=C.UTF-8 MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 -Z " + page + " >/dev/null").err,
              "")
        << page;
  }
}

TEST_F(Manual, SaysEveryOptionAndHasItsSections) {
  for (const std::string& verb : verbs()) {
    const std::string page = read(folder.path("man/toolcomp-" + verb + ".1"));
    for (const std::string section : {"NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXAMPLES", "SEE ALSO"})
      EXPECT_NE(page.find(".SH " + section + '\n'), std::string::npos) << verb << ' ' << section;
    const std::string shown =
        command("mandoc -T ascii " + folder.path("man/toolcomp-" + verb + ".1") + " | col -bx").out;
    std::vector<std::string> said = lines_of(toolcomp("complete " + verb + " -").out);
    for (const std::string& inner : verbs(verb + ' '))
      for (const std::string& line : lines_of(toolcomp("complete " + verb + ' ' + inner + " -").out))
        said.push_back(line);
    for (const std::string& line : said)
      EXPECT_NE(shown.find(line.substr(0, line.find('\t'))), std::string::npos) << verb << ": " << line;
  }
}

TEST_F(Manual, ThatOfTheProgramSaysTheVerbsAndWhatHoldsForAll) {
  const std::string page = read(folder.path("man/toolcomp.1"));
  for (const std::string& verb : verbs()) EXPECT_NE(page.find(".B " + verb + '\n'), std::string::npos) << verb;
  for (const std::string section : {"EXIT STATUS", "ENVIRONMENT", "FILES"})
    EXPECT_NE(page.find(".SH " + section + '\n'), std::string::npos) << section;
}

TEST_F(Manual, WhatIsShownRuns) {
  const std::string example = TOOLCOMP_SOURCE_DIR "/examples/fanuc/plate-cutter-compensation-b/";
  std::size_t shown = 0;
  for (const std::string& page : pages) {
    const Folder place;
    fs::copy_file(example + "plate.nc", place.path("part.nc"));
    fs::copy_file(example + "setup.toml", place.path("setup.toml"));
    static_cast<void>(place.write("case.json", R"({"case":1,"setup":{"control":"fanuc"},"program":"G00 X1.\n"})"));
    const std::vector<std::string> lines = lines_of(command("mandoc -T ascii -O width=400 " + page + " | col -bx").out);
    for (auto line = lines.begin(); line != lines.end(); ++line) {
      const std::size_t prompt = line->find("$ ");
      if (prompt == std::string::npos || line->find_first_not_of(' ') != prompt) continue;
      ++shown;
      std::string typed = line->substr(prompt + 2);
      while (typed.ends_with('\\') && line + 1 != lines.end()) typed += '\n' + *++line;
      const std::string script = place.write("typed.sh", "cd " + place.path(".") + "\n" + typed + "\n");
      const Outcome outcome = command("PATH=" TOOLCOMP_BINARY_DIR ":$PATH bash -e " + script);
      EXPECT_EQ(outcome.status, 0) << page << ": " << typed << '\n' << outcome.out << outcome.err;
    }
  }
  EXPECT_GT(shown, 20U);
}

}  // namespace

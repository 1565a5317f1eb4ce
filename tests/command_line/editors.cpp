// SPDX-License-Identifier: Apache-2.0
// The files for editors find the place of what the command says: each line as it is printed, against the expression
// of VS Code and the errorformat of Vim.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "tests/command_line/command.h"

namespace {

using toolcomp::test::command;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::read;
using toolcomp::test::toolcomp;

const std::string kEditors = TOOLCOMP_SOURCE_DIR "/share/editors/";

struct Fault {
  std::string arguments;
  std::string file;
  std::string line;
  std::string column;   // in characters, from 1; empty: none
  std::string message;  // its beginning
};

class Editors : public testing::Test {
 protected:
  // Places counted by hand. Ä and Ö are two bytes each, and one character.
  std::vector<Fault> faults() {
    static_cast<void>(folder.write("setup.toml", "control = \"fanuc\"\n"));
    const std::string klartext = folder.write("klartext.toml", "control = \"heidenhain\"\n");
    const std::string key = folder.write("key.toml", "control = \"fanuc\"\n  unitz = \"mm\"\n");
    const std::string umlaut =
        folder.write("name.toml", "control = \"heidenhain\"\ntool = [{ number = 1, name = \"ÄÖ\", r = 1 }]\n");
    const std::string json = folder.write("case.json", "{\"case\":1,\"id\":\"ÄÖ\",\"progam\":\"\",\"setup\":{}}");
    const std::string alarm = folder.write("alarm.nc", "G00 X1.\nN20 Y2. X1.2.3\n");
    const std::string comment = folder.write("comment.nc", "G00 X1. (ÄÖ) E1\n");
    const std::string bytes = folder.write("bytes.nc", "G00 X1.\nX\xE4\n");
    const std::string late = folder.write("late.h", "L X+1 F100\nL X+2 Q$\n");
    return {{"config check " + key, key, "2", "3", "setup: unknown key \"unitz\""},
            {"config check " + umlaut, umlaut, "2", "36", "tool: unknown key \"r\""},
            {"config check " + json, json, "1", "21", "case: unknown key \"progam\""},
            {"run " + alarm, alarm, "2", "13", "PS0007"},
            {"run " + comment, comment, "1", "14", "PS0009"},
            {"run " + bytes, bytes, "2", "2", "byte 0xE4"},
            {"run " + late + " --setup " + klartext, late, "2", "7", "E_SYNTAX"}};
  }

  // The line in which the fault is named.
  static std::string said(const Fault& fault) {
    const Outcome outcome = toolcomp(fault.arguments);
    const std::size_t at = outcome.err.find(fault.file + ':');
    if (at == std::string::npos) return outcome.err;
    return outcome.err.substr(at, outcome.err.find('\n', at) - at);
  }

  Folder folder;
};

TEST_F(Editors, VisualStudioCode) {
  const auto tasks = nlohmann::json::parse(read(kEditors + "vscode/tasks.json")).at("tasks");
  ASSERT_EQ(tasks.size(), 2U);
  for (const auto& task : tasks) {
    const auto& pattern = task.at("problemMatcher").at("pattern");
    const std::regex expression(pattern.at("regexp").get<std::string>(), std::regex::ECMAScript);
    for (const Fault& fault : faults()) {
      const std::string line = said(fault);
      std::smatch match;
      ASSERT_TRUE(std::regex_match(line, match, expression)) << line;
      EXPECT_EQ(match[pattern.at("file").get<std::size_t>()], fault.file) << line;
      EXPECT_EQ(match[pattern.at("line").get<std::size_t>()], fault.line) << line;
      EXPECT_EQ(match[pattern.at("column").get<std::size_t>()], fault.column) << line;
      EXPECT_TRUE(match[pattern.at("message").get<std::size_t>()].str().starts_with(fault.message)) << line;
    }
    std::smatch match;
    const std::string event = R"({"kind":"move","line":1,"n":2,"t":"1:2:3: x"})";
    EXPECT_FALSE(std::regex_match(event, match, expression));
  }
}

TEST_F(Editors, Vim) {
  for (const Fault& fault : faults()) {
    static_cast<void>(folder.write("said.txt", said(fault) + '\n'));
    const std::string script = folder.write(
        "look.vim", "source " + kEditors + "vim/toolcomp.vim\nset encoding=utf-8\ncfile " + folder.path("said.txt") +
                        "\nlet found = getqflist()[0]\ncall writefile([bufname(found.bufnr), found.lnum, found.col, "
                        "found.vcol, found.text], '" +
                        folder.path("found.txt") + "')\nqa!\n");
    command("vim -u NONE -N -es -c 'set encoding=utf-8' -S " + script + " </dev/null");
    const std::string found = read(folder.path("found.txt"));
    EXPECT_TRUE(found.starts_with(fault.file + '\n' + fault.line + '\n' + fault.column + "\n1\n" + fault.message))
        << found;
  }
}

// The first line of the example names the schema, where an editor finds it.
TEST_F(Editors, TheExampleOfASetupNamesItsSchema) {
  for (const std::string control : {"fanuc", "heidenhain"}) {
    const std::string example = toolcomp("config example --control " + control).out;
    const std::string begin = "#:schema ";
    ASSERT_TRUE(example.starts_with(begin)) << example;
    const std::string file = example.substr(begin.size(), example.find('\n') - begin.size());
    EXPECT_EQ(read(file), toolcomp("config schema").out) << file;
    EXPECT_EQ(toolcomp("config check " + folder.write("example.toml", example)).status, 0);
  }
}

TEST(Schemas, SayWhatTheCommandSays) {
  const Outcome outcome =
      command("/usr/bin/python3 " TOOLCOMP_SOURCE_DIR "/tests/command_line/schemas.py " TOOLCOMP_BINARY_DIR
              "/toolcomp " TOOLCOMP_SOURCE_DIR);
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

}  // namespace

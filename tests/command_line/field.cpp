// SPDX-License-Identifier: Apache-2.0
// corpus/field: programs as shops and CAM systems write them run to the end that expected.toml states, which was
// written with each program; engines agree as far as they are judged.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "spec/language/document.h"
#include "tests/command_line/command.h"

namespace {

using nlohmann::json;
using toolcomp::spec::document::Member;
using toolcomp::spec::document::Node;
using toolcomp::test::Outcome;
using toolcomp::test::read;
using toolcomp::test::toolcomp;

const std::string kFolder = TOOLCOMP_SOURCE_DIR "/corpus/field/";

struct Program {
  std::string name;
  std::string ends;   // whole, not_supported, not_judged, alarm
  std::string place;  // LINE:COLUMN of what ends it
  std::string code;
  std::string moves;
  std::string open;
  std::string holes;
};

std::string text_of(const Node& entry, std::string_view key, const std::string& otherwise = {}) {
  const Node* const found = entry.find(key);
  return found == nullptr ? otherwise : found->text;
}

std::vector<Program> programs() {
  std::vector<Program> list;
  const Node root = toolcomp::spec::document::parse_toml(read(kFolder + "expected.toml"), "corpus/field/expected.toml");
  for (const Member& member : root.members) {
    const Node& entry = member.value;
    const std::string line = text_of(entry, "line");
    list.push_back({member.name, text_of(entry, "ends"), line.empty() ? line : line + ':' + text_of(entry, "column"),
                    text_of(entry, "code"), text_of(entry, "moves"), text_of(entry, "open", "0"),
                    text_of(entry, "holes", "0")});
  }
  return list;
}

class Field : public testing::TestWithParam<Program> {};
INSTANTIATE_TEST_SUITE_P(Programs, Field, testing::ValuesIn(programs()), [](const auto& p) {
  std::string name = p.param.name;
  std::ranges::replace_if(name, [](char c) { return c == '-' || c == '.'; }, '_');
  return name;
});

TEST_P(Field, EndsAsItSays) {
  const Program& program = GetParam();
  const std::string path = kFolder + program.name;
  const std::string files = path + " --setup " + path.substr(0, path.rfind('.')) + ".toml";
  const bool whole = program.ends == "whole";
  const int status = program.ends == "alarm" || (whole && program.open == "0") ? 0 : 3;
  for (const char* engine : {"model", "fast"}) {
    const Outcome run = toolcomp("run " + files + " --notes off --engine " + engine);
    EXPECT_EQ(run.status, status) << run.err;
    const std::vector<json> events = run.events();
    ASSERT_FALSE(events.empty());
    const auto count = [&events](const char* kind) {
      return std::to_string(std::ranges::count_if(events, [&](const json& e) { return e.at("kind") == kind; }));
    };
    EXPECT_EQ(count("move"), program.moves);
    EXPECT_EQ(count("undecided"), program.open);
    EXPECT_EQ(count("hole"), program.holes);
    const json& last = events.back();
    if (whole) {
      EXPECT_TRUE(last.at("kind") != "alarm" && last.at("kind") != "not_supported" && last.at("kind") != "not_judged");
      continue;
    }
    EXPECT_EQ(last.at("kind"), program.ends);
    EXPECT_EQ(last.value("code", last.value("number", "")), program.code);
    EXPECT_NE(run.err.find(program.name + ':' + program.place + ": "), std::string::npos) << run.err;
  }
  EXPECT_EQ(toolcomp("diff " + files).status, status);
}

}  // namespace

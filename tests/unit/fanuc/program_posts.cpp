// SPDX-License-Identifier: Apache-2.0
// Programs as post processors write them (tests/support/posts/fanuc): both engines agree on all of them, up to what is
// not supported, which says its name with its place.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "judge/oracle/trial.h"
#include "spec/language/alarm.h"
#include "spec/language/byte_source.h"
#include "spec/language/fanuc/program_files.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/setup_format.h"

namespace toolcomp {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(TOOLCOMP_SOURCE_DIR) / "tests/support/posts/fanuc";

// What is not supported: the text at whose first place in the file it stands, and what is said.
struct NotSupported {
  std::string at;
  std::string says;
};
const std::map<std::string, NotSupported> kNotSupported = {
    {"bolt_circle_polar", {"G16", "G16 (polar coordinate command) is not supported"}},
    {"corner_rounding", {",R5", ",R (corner rounding) is not supported"}},
    {"hand_loop_while",
     {"WHILE",
      "WHILE (a comparison that toolcomp does not evaluate, or whose result depends on the digits of the control) is "
      "not supported"}},
    {"head_jump",
     {"IF",
      "IF (a comparison that toolcomp does not evaluate, or whose result depends on the digits of the control) is not "
      "supported"}},
    {"mirror_image", {"G51.1", "G51.1 (programmable mirror image) is not supported"}},
    {"nx_probing_macro", {"G65", "G65 (macro call of a program that is missing) is not supported"}},
    {"nx_tilted_plane", {"G68.2", "G68.2 (tilted working plane) is not supported"}},
};

// The first block of which something is not supported.
std::optional<spec::Block> first_not_supported(const spec::Case& c) {
  spec::ProgramReader reader(spec::text_source(c.program), c.setup.axes);
  for (spec::Block block; reader.next(block);)
    if (spec::beyond(block) != nullptr) return block;
  return {};
}

std::string place(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t line_begin = before.find_last_of('\n') + 1;
  return std::to_string(std::ranges::count(before, '\n') + 1) + ':' + std::to_string(offset - line_begin + 1);
}

TEST(ProgramPosts, BothEnginesAgreeAndTheUnsupportedSaysItsName) {
  const spec::Setup setup = spec::read_setup_toml(spec::read_file((kFolder / "setup.toml").string()), "setup.toml");
  std::size_t programs = 0;
  std::size_t not_supported = 0;
  for (const auto& entry : fs::directory_iterator(kFolder)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".nc" || name == "O4001" || name == "CORNER") continue;  // called by another one
    SCOPED_TRACE(name);
    ++programs;
    spec::Case c;
    c.section = "fanuc/tool-length-offset";
    c.dialect = spec::dialect_of(setup.control);
    c.setup = setup;
    const std::string text = spec::read_file(entry.path().string());
    c.program = spec::joined_program(text, setup.axes, {.called_program = spec::programs_beside(kFolder)});
    const judge::Trial trial = judge::try_case(c);
    EXPECT_EQ(trial.verdict.outcome, judge::Outcome::agrees)
        << (trial.verdict.difference ? judge::explain(*trial.verdict.difference) : "");
    ASSERT_FALSE(trial.run.events.empty());
    EXPECT_GE(std::ranges::count(trial.run.events, spec::EventKind::move, &model::Event::kind), 3);
    const auto block = first_not_supported(c);
    const auto expected = kNotSupported.find(name);
    const model::Event& last = trial.run.events.back();
    if (expected == kNotSupported.end()) {
      EXPECT_FALSE(block) << spec::beyond(*block);
      EXPECT_TRUE(last.kind == spec::EventKind::move || last.hole)
          << last.line << ' ' << last.number.view() << ' ' << last.message;
      continue;
    }
    ++not_supported;
    ASSERT_TRUE(block);
    EXPECT_EQ(spec::beyond(*block), expected->second.says);
    EXPECT_EQ(last.kind, spec::EventKind::not_supported);
    EXPECT_EQ(last.message, expected->second.says);
    EXPECT_EQ(last.line, block->line);
    const std::size_t at = text.find(expected->second.at);
    ASSERT_NE(at, std::string::npos);
    EXPECT_EQ(std::to_string(block->line) + ':' + std::to_string(block->alarm->column), place(text, at));
  }
  EXPECT_EQ(programs, 34U);
  EXPECT_EQ(not_supported, kNotSupported.size());
}

}  // namespace
}  // namespace toolcomp

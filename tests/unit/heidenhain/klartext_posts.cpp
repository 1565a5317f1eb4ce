// SPDX-License-Identifier: Apache-2.0
// Programs as post processors write them (tests/support/posts/klartext): both engines agree on all of them, up to what
// is not supported, which says its name with its place.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "judge/oracle/trial.h"
#include "spec/language/alarm.h"
#include "spec/language/byte_source.h"
#include "spec/language/heidenhain/joined_program.h"
#include "spec/language/heidenhain/klartext_reader.h"
#include "spec/language/heidenhain/program_files.h"
#include "spec/language/setup_format.h"

namespace toolcomp {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(TOOLCOMP_SOURCE_DIR) / "tests/support/posts/klartext";

// What is not supported: the text whose first place in the file is that of the alarm, or of the block that is passed
// over; and what is said.
struct Unsupported {
  std::string at;
  std::string says;
};
const std::map<std::string, Unsupported> kUnsupported = {
    {"catia_tnc640_circle", {"C X+0 Y-20", "C (circle) is not supported"}},
    {"fusion_tnc640_tilted_plane", {"PLANE SPATIAL SPA+45", "PLANE SPATIAL (tilted working plane) is not judged"}},
    {"jump_to_label_99", {"FN 9", "FN 9 (jump if equal) is not supported"}},
    {"probing_and_probe_header_tnc7", {"TCH PROBE", "TCH PROBE (touch probe cycles) is not supported"}},
    {"rotation_cycle_10", {"ROT+35", "CYCL DEF 10 (rotation) is not supported"}},
    {"second_preset_tnc640", {"Q339=+2", "CYCL DEF 247 (a preset other than the first) is not judged"}},
};

// The first block of which something is not supported.
std::optional<spec::klartext::Block> first_unsupported(const spec::Case& c) {
  spec::klartext::Reader reader(spec::text_source(c.program), c.setup);
  for (spec::klartext::Block block; reader.next(block);)
    if (spec::beyond(block) != nullptr) return block;
  return {};
}

std::string place(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t line_begin = before.find_last_of('\n') + 1;
  return std::to_string(std::ranges::count(before, '\n') + 1) + ':' + std::to_string(offset - line_begin + 1);
}

TEST(KlartextPosts, BothEnginesAgreeAndTheUnsupportedSaysItsName) {
  const spec::Setup setup = spec::read_setup_toml(spec::read_file((kFolder / "setup.toml").string()), "setup.toml");
  std::size_t programs = 0;
  std::size_t unsupported = 0;
  for (const auto& entry : fs::directory_iterator(kFolder)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".H" || name == "PASS") continue;  // called by another one
    SCOPED_TRACE(name);
    ++programs;
    spec::Case c;
    c.section = "heidenhain/face-milling";
    c.dialect = spec::dialect_of(setup.control);
    c.setup = setup;
    const std::string text = spec::read_file(entry.path().string());
    c.program = spec::klartext::joined_klartext(text, spec::klartext::programs_beside(kFolder));
    const judge::Trial trial = judge::try_case(c);
    EXPECT_EQ(trial.verdict.outcome, judge::Outcome::agrees)
        << (trial.verdict.difference ? judge::explain(*trial.verdict.difference) : "");
    ASSERT_FALSE(trial.run.events.empty());
    const auto block = first_unsupported(c);
    const auto expected = kUnsupported.find(name);
    EXPECT_GE(std::ranges::count(trial.run.events, spec::EventKind::move, &model::Event::kind),
              expected == kUnsupported.end() ? 2 : 1);
    const model::Event& last = trial.run.events.back();
    if (expected == kUnsupported.end()) {
      EXPECT_FALSE(block) << spec::beyond(*block);
      EXPECT_TRUE(last.kind == spec::EventKind::move || last.hole || last.out_of_scope) << last.number.view();
      EXPECT_TRUE(std::ranges::none_of(trial.run.events, [](const model::Event& event) {
        const bool open = event.kind == spec::EventKind::undecided && !event.out_of_scope;
        return event.kind == spec::EventKind::alarm || open;
      }));
      continue;
    }
    ++unsupported;
    ASSERT_TRUE(block);
    EXPECT_EQ(spec::beyond(*block), expected->second.says);
    const std::size_t at = text.find(expected->second.at);
    ASSERT_NE(at, std::string::npos);
    EXPECT_TRUE(last.kind != spec::EventKind::alarm && spec::ends_run(last.kind));
    EXPECT_EQ(last.message, expected->second.says);
    EXPECT_EQ(std::to_string(block->alarm->line) + ':' + std::to_string(block->alarm->column), place(text, at));
  }
  EXPECT_EQ(programs, 32U);
  EXPECT_EQ(unsupported, kUnsupported.size());
}

}  // namespace
}  // namespace toolcomp

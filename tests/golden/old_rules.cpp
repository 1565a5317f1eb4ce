// SPDX-License-Identifier: Apache-2.0
// Rules that pages of manuals contradicted, planted back in all engines at once: each engine is handed the case that
// the old rule made of it, so all agree. The vector of the rule still refuses what they say, and its figures were
// worked out by hand (corpus/examples, golden/figures.cpp). Those that a law finds stand in fuzz/faults/wrong_clauses.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "certify/exactly.h"
#include "spec_engine/engine.h"
#include "tests/golden/worked_examples.h"

namespace toolcomp::corpus {
namespace {

struct OldRule {
  const char* name;
  const char* section;
  const char* comment;  // how that of the vector begins, in the file of rules
  // What the old rule made of the case: words of the program replaced, a parameter that is not known or has a value.
  std::string_view words;
  std::string_view instead;
  spec::ParameterId parameter = {0, -1};
  std::int64_t value = 0;  // 0: the parameter is not known
};

constexpr const char* kLength = "fanuc/tool-length-offset";
constexpr const char* kCutter = "fanuc/cutter-compensation-c";
constexpr const char* kSide = "fanuc/tool-side-compensation";
constexpr const char* kTip = "fanuc/tool-center-point-control";

constexpr OldRule kOld[] = {
    {"r_without_a_way_alarms", kLength, "An R block whose end is its start is an arc of 0", "X0 Y0 R10.", "X1 R0."},
    {"cir_not_known", kLength, "With CIR = 0 an arc without", "", "", {3403, 5}},
    {"radii_not_compared", kLength, "The same, with 3410 = 1.999", "", "", {3410, -1}},
    {"no_feed_runs", kLength, "No F: PS0011", "", "", {1411, -1}, 100},
    {"stops_are_read_past", kCutter, "M00 stops the look-ahead", "M00", "M05"},
    {"codes_of_stops_not_known", kCutter, "M08 stops the look-ahead if No.", "", "", {3411, -1}},
    {"look_ahead_of_two", kCutter, "The 30i reads five blocks", "", "", {19625, -1}},
    {"cnc_not_known", kCutter, "CNC = 1, a groove of width 15", "", "", {5008, 1}},
    {"cnv_not_known", kCutter, "CNV = 1 on series 30i: no vector is dropped", "", "", {5008, 3}},
    {"tos_not_known", kLength, "5006#6 = 1: G43, H, G49 alone move nothing", "", "", {5006, 6}},
    {"p_of_g54_not_read", kLength, "G54 P2 is G54.1 P2", "G54 P2", "G54"},
    {"vector_left_by_a_way_of_0", kCutter, "After a lone G40 an axis word removes the vector",
     "G00 Z5.\nG00 X-20. Y-20.", "G00 Z5.\nG00"},
    {"turned_before_refused", kTip, "WKP = 1, A and C turned before G43.4", "A90. C10. F100\nG43.4 H0\n",
     "A90. F100\nG43.4 H0\nC10.\n"},
    {"tbp_not_known", kSide, "30i with 19746#4 = 1: VT is seen from the table", "", "", {19746, 4}},
};

std::string text_of(const std::vector<spec::TextEvent>& events, const spec::Axes& axes) {
  std::string text;
  for (const spec::TextEvent& event : events) text += event_text(event, axes) + '\n';
  return text;
}

class OldRules : public testing::TestWithParam<OldRule> {};
INSTANTIATE_TEST_SUITE_P(Each, OldRules, testing::ValuesIn(kOld), [](const auto& p) { return p.param.name; });

TEST_P(OldRules, IsRefusedByAVectorThoughAllEnginesFollowIt) {
  const OldRule& rule = GetParam();
  const spec::Case& vector = worked::vector_of(rule.section, "rules", rule.comment);
  spec::Case old = vector;
  if (const std::size_t at = old.program.find(rule.words); !rule.words.empty()) {
    ASSERT_NE(at, std::string::npos);
    old.program.replace(at, rule.words.size(), rule.instead);
  }
  if (rule.value != 0)
    old.setup.parameters[rule.parameter] = spec::decimal(rule.value);
  else
    old.setup.parameters.erase(rule.parameter);
  ASSERT_FALSE(old.program == vector.program && old.setup == vector.setup);

  const judge::Trial agreed = judge::try_case(old);
  EXPECT_FALSE(agreed.verdict.difference) << judge::explain(*agreed.verdict.difference);
  if (spec_engine::available()) {
    const certify::Exactly held =
        certify::hold_exactly(old.setup.axes, agreed.run.events, spec_engine::run(old).events);
    EXPECT_FALSE(held.difference) << judge::explain(*held.difference);
  }
  const std::string figures = text_of(vector.expect, vector.setup.axes);
  EXPECT_EQ(text_of(expected_events(judge::run_model(vector)), vector.setup.axes), figures);
  EXPECT_NE(text_of(expected_events(agreed.run), vector.setup.axes), figures);
}

}  // namespace
}  // namespace toolcomp::corpus

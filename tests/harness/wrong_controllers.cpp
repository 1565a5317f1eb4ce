// SPDX-License-Identifier: Apache-2.0
// Controllers that are wrong in one way, each asked cases of every section: each is found, its findings stand in three
// groups at most, the first of which names the mistake where it is one of those that have a name, and replay sees the
// one that stands for each again.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "certify/certification.h"
#include "certify/replay.h"
#include "certify/report.h"
#include "certify/selection.h"
#include "fuzz/gen/generator.h"
#include "tests/support/controllers/wrong_events.h"

namespace toolcomp::certify {
namespace {

constexpr std::size_t kCases = 5;  // a section
constexpr std::size_t kMostGroups = 3;
// Of those that are waited for. The time-out is how long they are, and bounds nothing else.
constexpr std::size_t kCasesOfHangs = 12;
constexpr std::chrono::seconds kWait{1};
constexpr std::chrono::seconds kWaitForAnswers{5};
constexpr std::chrono::seconds kNever{120};

// The same cases for all of them.
const std::vector<CaseInput>& cases() {
  static const std::vector<CaseInput> all = [] {
    std::vector<CaseInput> inputs;
    for (const std::string_view section : fuzz::sections())
      for (spec::Case& c : select_cases(section, 3, kCases).cases) inputs.push_back({std::move(c), Origin::generated});
    return inputs;
  }();
  return all;
}

CertificationOptions options(const std::string& fault) {
  CertificationOptions o;
  o.controller = std::string("'") + TOOLCOMP_BINARY_DIR + "/toolcomp_faulty_controller' " + fault;
  o.cases = cases();
  if (fault.find("hang") != std::string::npos) o.cases.resize(kCasesOfHangs);
  o.generated = 0;
  o.shrink_runs = 0;
  o.timeout = fault.find("hang") != std::string::npos ? kWait : fault == "rubbish" ? kWaitForAnswers : kNever;
  o.settling.clock = [] { return std::chrono::steady_clock::time_point(); };
  return o;
}

struct Wrong {
  std::string fault;
  std::string named;  // how the first cause begins; empty: by whatever name
};
class Controllers : public testing::TestWithParam<Wrong> {};

TEST_P(Controllers, AreFoundInFewGroups) {
  const CertificationOptions asked = options(GetParam().fault);
  const Certificate c = certify::certify(asked);
  EXPECT_EQ(exit_status(c), 1);
  ASSERT_FALSE(c.findings.empty());
  ASSERT_FALSE(c.causes.empty());
  std::string causes;
  for (const SharedCause& cause : c.causes) causes += fmt::format("{} ({})\n", cause.words, cause.findings.size());
  EXPECT_LE(c.causes.size(), kMostGroups) << causes;
  EXPECT_TRUE(c.causes.front().words.starts_with(GetParam().named)) << causes;
  const auto folder = std::filesystem::path(testing::TempDir()) / ("toolcomp-wrong-" + GetParam().fault);
  const auto paths = write_report(c, folder);
  const bool by_chance = GetParam().fault.starts_with("sometimes");
  for (const SharedCause& group : c.causes) {
    const std::size_t i = group.findings.front();
    EXPECT_EQ(c.findings[i].not_settled, "");
    if (by_chance) continue;
    ReplayOptions how;
    how.timeout = asked.timeout;
    EXPECT_EQ(replay(paths[i], how).judgement.result, Result::differs) << paths[i];
  }
  std::filesystem::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(
    Each, Controllers,
    testing::Values(
        Wrong{"constant-x", "X of every position is off by 1e-06"},
        Wrong{"constant-z", "Z of every position is off by -0.25"}, Wrong{"bias", "every position is off by 1e-05"},
        Wrong{"scaled-z", "Z of every position is scaled by 1.0001"}, Wrong{"inches", "every linear axis is in inches"},
        Wrong{"radians", "every rotary axis is in radians"},
        Wrong{"sign-y", "Y of every position has the opposite sign"},
        Wrong{"rotary-sense", "every rotary axis has the opposite sign"},
        Wrong{"rounded-3", "positions look rounded to 3 decimals, to nearest"},
        Wrong{"down-2", "positions look rounded to 2 decimals, down"},
        Wrong{"truncated-4", "positions look rounded to 4 decimals, toward zero"}, Wrong{"huge", ""},
        Wrong{"zero", "every position is always 0"}, Wrong{"exchanged", "X and Y are exchanged"},
        Wrong{"late", "positions come one block late"}, Wrong{"feed", "feed is scaled by 60"},
        Wrong{"no-feed", "feed is always 0"}, Wrong{"sweep", "sweep has the opposite sign"},
        Wrong{"tool-axis", "tool_axis has the opposite sign"}, Wrong{"line", "lines are one too high"},
        Wrong{"sequence", ""}, Wrong{"rapid", "type is always rapid"}, Wrong{"cause", ""}, Wrong{"direction", ""},
        Wrong{"plane", ""}, Wrong{"alarm", "number is always PS0001"}, Wrong{"no-alarm", ""}, Wrong{"alarm-alone", ""},
        Wrong{"no-settings", ""}, Wrong{"no-corners", ""}, Wrong{"nothing", "all events are missing"},
        Wrong{"drop-last", "the last event is missing"}, Wrong{"twice", "the last event comes twice"},
        Wrong{"reversed", "events come in reverse order"}, Wrong{"offset-sign", ""}, Wrong{"no-offsets", ""},
        Wrong{"sides", ""}, Wrong{"previous", "the answer belongs to the previous case"},
        Wrong{"duplicate-keys", "malformed reply"}, Wrong{"seventh-exit", "crash"}, Wrong{"sometimes-drop-last", ""},
        Wrong{"not-a-number", "malformed reply"}, Wrong{"error", "error"}, Wrong{"hang", "hang"},
        Wrong{"hello-hang", "hang"}, Wrong{"rubbish", "malformed reply"}, Wrong{"wrong-id", "malformed reply"},
        Wrong{"two-lines", "malformed reply"}, Wrong{"missing-axes", "missing field: axes"}),
    [](const auto& test) {
      std::string name = test.param.fault;
      std::ranges::replace(name, '-', '_');
      return name;
    });

}  // namespace
}  // namespace toolcomp::certify

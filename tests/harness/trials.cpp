// SPDX-License-Identifier: Apache-2.0
// Why a case was or was not judged, or not to its end.
#include "judge/oracle/trial.h"

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

#include "certify/convert.h"
#include "fuzz/campaign/driver.h"
#include "fuzz/campaign/long_program.h"
#include "fuzz/gen/encode.h"
#include "spec/language/byte_source.h"

namespace toolcomp::judge {
namespace {

Acceptance acceptance(const std::string& program, int angle = 45) {
  spec::Case c;
  c.section = "fanuc/tool-side-compensation";
  c.setup.axes = spec::Axes("XYZ");
  c.setup.parameters[{6261, -1}] = spec::decimal(angle);
  c.program = program;
  const Trial trial = try_case(c);
  EXPECT_FALSE(trial.found()) << program;
  return trial.acceptance;
}

// No. 6261 is an angle up to 180 degrees; a Ctrl-Z ends a file, and nothing but that.
TEST(Trials, SayWhyNothingWasJudged) {
  EXPECT_EQ(acceptance("G01 X1 F100\n"), Acceptance::accepted);
  EXPECT_EQ(acceptance("G99999\nG01 X1 F100\n"), Acceptance::no_number);
  EXPECT_EQ(acceptance("G01 X1 F100\n", 181), Acceptance::no_setup);
  EXPECT_EQ(acceptance("G01 X1\x1a F100\n"), Acceptance::no_text);
}

// Repeats in repeats: a million blocks and more, which nobody waits for.
TEST(Trials, AreNotMadeOfWhatRepeatsMuch) {
  spec::Case c;
  c.section = "fanuc/tool-offset";
  c.setup.axes = spec::Axes("XYZ");
  c.program = "G01 X1 F100\nM98 P1 L5000\nM30\nO1\nM98 P2 L9999999\nM99\nO2\nX2\nM99\n";
  const Trial trial = fuzz::try_short(c);
  EXPECT_EQ(trial.acceptance, Acceptance::too_long);
  EXPECT_EQ(name(trial.acceptance), "too long");
  EXPECT_FALSE(trial.found());
  EXPECT_TRUE(trial.run.events.empty());
  fuzz::DriverOptions options;
  options.section = c.section;
  fuzz::Driver driver(options);
  driver.revisit(c);
  EXPECT_EQ(driver.result().executions, 1U);
  EXPECT_EQ(driver.result().count(Acceptance::too_long), 1U);
  c.program = "G01 X1 F100\nM98 P1 L100\nM30\nO1\nX2\nM99\n";
  EXPECT_EQ(fuzz::try_short(c).acceptance, Acceptance::accepted);
}

// The axes of a tip far from the origin, which one axis of the table turns: 9 u M by the derivation in judge/README.md,
// and no vector has a part in it.
TEST(Trials, JudgeAxesTurnedFromFar) {
  const spec::Case c =
      fuzz::decode("fanuc/leading-edge-offset",
                   spec::read_file(TOOLCOMP_SOURCE_DIR "/corpus/seeds/fanuc/leading_edge_offset_unrestricted/"
                                                       "axes_turned_from_far.txt"));
  const ModelRun run = run_model(c);
  const std::vector<fast::Event> events = run_fast(c);
  const auto worst = [&](const char* field) {
    const Verdict v = judge::judge(c, run, events, {{"kind", "line", field}, {}});
    EXPECT_EQ(v.outcome, Outcome::agrees) << field;
    return v.worst_ulp;
  };
  EXPECT_GT(worst("axes"), 1.5);
  EXPECT_LE(worst("axes"), 9);
  EXPECT_LE(worst("point"), 1.5);
}

// The fast engine has to say where a run ends, at what, and of which kind: each of them is judged.
TEST(Trials, TheEndWithoutAnAlarmIsJudged) {
  for (const bool klartext : {false, true}) {
    spec::Case c;
    c.setup.control = klartext ? spec::Control::heidenhain : spec::Control::fanuc;
    c.setup.axes = spec::Axes("XYZ");
    c.program = klartext ? "L X+1 R0 F100\nPLANE SPATIAL SPA+0 SPB+45 SPC+0 TURN\nL X+3\n"
                         : "G01 X1 F100\nG68 X2 Y5 R1\nG01 X3\n";
    const ModelRun run = run_model(c);
    const std::vector<fast::Event> right = run_fast(c);
    ASSERT_EQ(right.size(), 2U);
    const Verdict v = judge::judge(c, run, right);
    EXPECT_EQ(v.outcome, Outcome::agrees);
    EXPECT_TRUE(v.beyond);
    const auto differs = [&](auto change) {
      std::vector<fast::Event> events = right;
      change(events);
      return judge::judge(c, run, events).outcome == Outcome::differs;
    };
    EXPECT_TRUE(differs([](auto& events) { events.back().number = "G82"; }));
    EXPECT_TRUE(differs([](auto& events) { events.back().line = 3; }));
    EXPECT_TRUE(differs([](auto& events) { events.back().kind = spec::EventKind::alarm; }));
    EXPECT_TRUE(differs([&](auto& events) {
      events.back().kind = klartext ? spec::EventKind::not_supported : spec::EventKind::not_judged;
    }));
    EXPECT_TRUE(differs([](auto& events) { events.pop_back(); }));
    EXPECT_TRUE(differs([](auto& events) { events.push_back(events.front()); }));
  }
}

// A drilling cycle is not known here: of a controller what goes before it is judged, and nothing it does from there on.
TEST(Trials, EndWhereAControllerIsNotKnown) {
  spec::Case c;
  c.setup.axes = spec::Axes("XYZ");
  c.program = "G01 X1 F100\nG68 X2 Y5 R1\nG01 X3\n";
  const ModelRun run = run_model(c);
  ASSERT_TRUE(run.beyond);
  EXPECT_EQ(run.beyond->line, 2U);
  EXPECT_EQ(run.beyond->events, 1U);
  std::vector<spec::TextEvent> answer = {certify::in_text(run.events.at(0), 20)};
  answer.push_back(answer[0]);
  answer.back().line = 3;
  const Verdict v = judge::judge(c, run, std::span<const spec::TextEvent>(answer));
  EXPECT_EQ(v.outcome, Outcome::agrees);
  ASSERT_TRUE(v.beyond);
  EXPECT_EQ(v.events, 1U);
  answer[0].line = 7;
  EXPECT_EQ(judge::judge(c, run, std::span<const spec::TextEvent>(answer)).outcome, Outcome::differs);
}

}  // namespace
}  // namespace toolcomp::judge

// SPDX-License-Identifier: Apache-2.0
// Exact events against exact events: what counts as a difference, and how it is named.
#include "certify/exactly.h"

#include <gtest/gtest.h>

#include <utility>

#include "certify/judge.h"
#include "judge/oracle/verdict.h"

namespace toolcomp::certify {
namespace {

using exact::Real;

spec::Case offset_case() {
  spec::Case c;
  c.section = "fanuc/tool-length-offset";
  c.setup.h[1].geometry = spec::decimal(4);
  c.program = "G43 Z10. H1\nG01 X5. F100.\nG49\n";
  return c;
}

class Exact : public testing::Test {
 protected:
  spec::Case c = offset_case();
  std::vector<model::Event> model = judge::run_model(c).events;
  std::vector<model::Event> said = model;

  [[nodiscard]] Exactly held() const { return hold_exactly(c.setup.axes, model, said); }
};

TEST_F(Exact, TheSameEventsAgree) {
  const Exactly result = held();
  EXPECT_FALSE(result.difference);
  EXPECT_EQ(result.undecided, "");
  EXPECT_GT(result.values, 10U);
}

TEST_F(Exact, ClausesAndMessagesAreNotSaid) {
  for (model::Event& event : said) event.clauses = {};
  EXPECT_FALSE(held().difference);
}

// 2 by its root, squared, is made otherwise than 2, and is 2.
TEST_F(Exact, EqualNumbersMadeOtherwiseAgree) {
  said[1].axes.set(0, sqrt(Real(2)) * sqrt(Real(2)) + Real(3));
  EXPECT_FALSE(held().difference);
}

TEST_F(Exact, ANumberIsNamedByItsField) {
  said[1].axes.set(0, Real(5) + Real(exact::Rational(1) / exact::Rational("1000000000000000000000000000000")));
  const Exactly result = held();
  ASSERT_TRUE(result.difference);
  EXPECT_EQ(result.difference->kind, kSpecificationKind);
  EXPECT_EQ(result.difference->field, "axes.X");
  EXPECT_EQ(result.difference->expected, "5");
  EXPECT_EQ(result.difference->actual, "5.000000000000000000000000000001");
  EXPECT_EQ(result.difference->line, 2U);
  EXPECT_EQ(result.difference->event, 1U);
}

TEST_F(Exact, AnEventTooFewIsADifferenceAtItsClause) {
  said.pop_back();
  const Exactly result = held();
  ASSERT_TRUE(result.difference);
  EXPECT_EQ(result.difference->field, "event");
  EXPECT_EQ(result.difference->actual, "no more events");
  ASSERT_TRUE(result.difference->clause);
  EXPECT_TRUE(model.back().clauses.contains(*result.difference->clause));
}

TEST_F(Exact, WhoCouldNotDecideIsNoDifference) {
  said[1] = {};
  said[1].kind = spec::EventKind::undecided;
  said[1].number = spec::Name("fanuc.cutter.side");
  said.resize(2);
  const Exactly result = held();
  EXPECT_FALSE(result.difference);
  EXPECT_EQ(result.undecided.find("the formal specification could not decide: undecided fanuc.cutter.side"), 0U)
      << result.undecided;
}

// Exact events are not judged by the oracle, which would grant this one.
TEST_F(Exact, AJudgeGrantsThemNothing) {
  said[1].axes.set(0, Real(5) + Real(exact::Rational(1) / exact::Rational("1000000000000000000000000000000")));
  Capabilities able;
  able.fields = all_fields();
  const judge::ModelRun run = judge::run_model(c);
  EXPECT_EQ(judge_answer(able, c, run, {ExactEvents(said), {}, {}}).result, Result::differs);
  EXPECT_EQ(judge_answer(able, c, run, {ExactEvents(model), {}, {}}).result, Result::agrees);
}

}  // namespace
}  // namespace toolcomp::certify

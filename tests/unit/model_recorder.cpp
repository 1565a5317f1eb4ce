// SPDX-License-Identifier: Apache-2.0
// The recorder: what is counted, what is listed, what can be forced.
#include <gtest/gtest.h>

#include "model/basis/recorder.h"

namespace {

using namespace toolcomp::model;
using toolcomp::exact::Rational;

constexpr Clause kSign = Clause::fanuc_leading_edge_sign;
constexpr Clause kFact = Clause::fanuc_program_incremental;
constexpr Clause kReach = Clause::fanuc_leading_edge_vector;

const ClauseCount& count(const Recorder& recorder, Clause clause) {
  return recorder.counts().at(static_cast<std::size_t>(clause));
}

TEST(ModelRecorder, CountsOutcomes) {
  Recorder recorder;
  EXPECT_EQ(recorder.decide(kSign, 3, 5), Sign::positive);
  EXPECT_EQ(recorder.decide(kSign, -3, 5), Sign::negative);
  EXPECT_EQ(recorder.decide(kSign, 0, 5), Sign::zero);
  EXPECT_TRUE(recorder.decide(kFact, true));
  EXPECT_FALSE(recorder.decide(kFact, false));
  recorder.reach(kReach);
  EXPECT_EQ(count(recorder, kSign).reached, 3U);
  EXPECT_EQ(count(recorder, kSign).positive, 1U);
  EXPECT_EQ(count(recorder, kSign).negative, 1U);
  EXPECT_EQ(count(recorder, kSign).tie, 1U);
  EXPECT_EQ(count(recorder, kFact).reached, 2U);
  EXPECT_EQ(count(recorder, kFact).positive, 1U);
  EXPECT_EQ(count(recorder, kFact).negative, 1U);
  EXPECT_EQ(count(recorder, kReach).reached, 1U);
  // Only decisions by sign are numbered.
  EXPECT_EQ(recorder.decision_count(), 3U);
  EXPECT_TRUE(recorder.decisions().empty());
}

TEST(ModelRecorder, KeepsDecisionsWithTheirLine) {
  Recorder recorder(true);
  recorder.at(7);
  recorder.decide(kSign, Rational(1, 3), 1);
  recorder.at(8);
  recorder.decide(kSign, -2, 4);
  ASSERT_EQ(recorder.decisions().size(), 2U);
  EXPECT_EQ(recorder.decisions()[0].line, 7U);
  EXPECT_EQ(recorder.decisions()[1].line, 8U);
  EXPECT_TRUE(recorder.decisions()[0].quantity == Real(Rational(1, 3)));
  EXPECT_TRUE(recorder.decisions()[1].scale == Real(4));
  EXPECT_EQ(recorder.decisions()[1].outcome, Sign::negative);
}

TEST(ModelRecorder, ForcesByNumber) {
  Recorder recorder(true);
  recorder.force(1, Sign::zero);
  EXPECT_EQ(recorder.decide(kSign, 3, 5), Sign::positive);
  EXPECT_TRUE(recorder.decide(kFact, true));  // no number
  EXPECT_EQ(recorder.decide(kSign, 3, 5), Sign::zero);
  EXPECT_EQ(recorder.decide(kSign, 3, 5), Sign::positive);
  EXPECT_EQ(recorder.decisions()[1].outcome, Sign::zero);
  EXPECT_EQ(count(recorder, kSign).tie, 1U);
}

TEST(ModelRecorder, ListsClausesOnce) {
  Recorder recorder;
  recorder.reach(kReach);
  recorder.decide(kFact, false);  // does not hold: not listed
  recorder.decide(kSign, 1, 1);
  recorder.reach(kReach);
  const toolcomp::spec::ClauseList list = recorder.take_clauses();
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0], kReach);
  EXPECT_EQ(list[1], kSign);
  EXPECT_TRUE(recorder.take_clauses().empty());
  EXPECT_EQ(recorder.latest(), kReach);
}

// No block asks as many.
TEST(ModelRecorder, ListsAllClauses) {
  Recorder recorder;
  for (std::size_t i = 0; i < toolcomp::spec::kClauseCount; ++i) recorder.reach(static_cast<Clause>(i));
  const toolcomp::spec::ClauseList list = recorder.take_clauses();
  ASSERT_EQ(list.size(), toolcomp::spec::kClauseCount);
  EXPECT_EQ(list.back(), static_cast<Clause>(toolcomp::spec::kClauseCount - 1));
}

}  // namespace

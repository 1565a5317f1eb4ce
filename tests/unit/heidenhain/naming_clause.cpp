// SPDX-License-Identifier: Apache-2.0
// A finding about a Heidenhain move is named by the clause that makes its value, whatever was applied behind it.
#include "spec/language/naming_clause.h"

#include <gtest/gtest.h>

#include <string>

#include "corpus/golden.h"
#include "corpus/vector.h"
#include "judge/oracle/trial.h"
#include "judge/oracle/verdict.h"
#include "tests/unit/heidenhain/klartext_run.h"

namespace toolcomp::test {
namespace {

std::string naming(const model::Event& event) {
  const auto clause = spec::naming_clause(event.clauses);
  return clause ? std::string(spec::info(*clause).id) : "";
}
std::string naming(const std::string& keys, std::string_view program) { return naming(last_move(tool(keys), program)); }

constexpr const char* kBall = "R = 3\nR2 = 3\nDR = -0.1\nDR2 = -0.1\n";

TEST(NamingClause, IsTheOneThatMakesTheValue) {
  EXPECT_EQ(naming(kBall, "TOOL CALL 1 Z\nL X1\n"), "heidenhain.program.no-compensation");
  EXPECT_EQ(naming(kBall, "TOOL CALL 1 Z\nLN X1 Y2 Z3 NX0.6 NY0 NZ0.8\n"), "heidenhain.face.effective-tip");
  EXPECT_EQ(naming(kBall, "TOOL CALL 1 Z\nFUNCTION PROG PATH IS CONTOUR\nLN X1 Y2 Z3 NX0.6 NY0 NZ0.8\n"),
            "heidenhain.contour.face");
  const std::string flank = "TOOL CALL 1 Z\nM128\nL X10 RL\n";
  EXPECT_EQ(naming(kBall, flank + "L Y10 R0\n"), "heidenhain.program.no-compensation") << "not the cancel";
  EXPECT_EQ(naming(kBall, flank), "heidenhain.peripheral.first-block");
  EXPECT_EQ(naming(kBall, flank + "L Y10\n"), "heidenhain.peripheral.last-block");
  EXPECT_EQ(naming(moves(run_klartext(tool(kBall), flank + "L Y10\nL X0\n"))[1]), "heidenhain.peripheral.mitre");
}

TEST(NamingClause, IsTheLastWhereNoneMakesAValue) {
  spec::ClauseList clauses;
  EXPECT_FALSE(spec::naming_clause(clauses));
  clauses.add(spec::Clause::heidenhain_program_many_digits);
  clauses.add(spec::Clause::heidenhain_face_side);
  EXPECT_EQ(spec::naming_clause(clauses), spec::Clause::heidenhain_face_side);
}

// Of the moves of the golden corpus none is named by another.
TEST(NamingClause, OfEveryMoveOfTheCorpus) {
  std::size_t named = 0;
  for (const char* file : {"face-milling/rules", "peripheral-milling/rules", "programmed-contour/rules"})
    for (const spec::Case& c :
         corpus::read_cases(corpus::default_folder() / "heidenhain" / (std::string(file) + ".jsonl")))
      for (const spec::TextEvent& event : c.expect) {
        if (event.kind != spec::EventKind::move) continue;
        EXPECT_TRUE(spec::info(*spec::naming_clause(event.clauses)).makes_value) << c.id;
        ++named;
      }
  EXPECT_GT(named, 100U);
}

// What an oracle says of a wrong position and of a wrong cause.
TEST(NamingClause, NamesADifference) {
  spec::Case c;
  c.setup = spec::read_setup_toml("control = \"heidenhain\"\n" + tool(kBall), "setup.toml");
  c.program = "TOOL CALL 1 Z\nM128\nL X10 RL\nL Y10 R0\n";
  std::vector<fast::Event> events = judge::run_fast(c);
  ASSERT_EQ(events.back().cause, spec::Cause::cancel);
  std::vector<fast::Event> moved = events;
  moved.back().point.set(1, moved.back().point[1] + 1);
  const judge::Verdict position = judge::judge(c, judge::run_model(c), moved);
  ASSERT_TRUE(position.difference);
  EXPECT_EQ(position.difference->clause, spec::Clause::heidenhain_program_no_compensation);
  events.back().cause = spec::Cause::programmed;
  const judge::Verdict cause = judge::judge(c, judge::run_model(c), events);
  ASSERT_TRUE(cause.difference);
  EXPECT_EQ(cause.difference->clause, spec::Clause::heidenhain_peripheral_cancel);
}

}  // namespace
}  // namespace toolcomp::test

// SPDX-License-Identifier: Apache-2.0
// Cutter compensation C in the exact engine: blocks between those that move. The worked examples of 14.5 and 14.6 stand
// in golden/fanuc/corpus_examples_cutter_c.cpp.
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/fanuc/model_cutter_run.h"

namespace {

using namespace toolcomp;
using test::cutter_setup;
using test::expect_points;
using test::points_from;
using test::run;

// A = (0,0) → (40,0) in the offset mode; the start-up before it comes along X.
std::string from_left() { return cutter_setup("", "[position]\nX = -40\n"); }
std::string after_a(const std::string& program) { return "G01 G41 D1 X0 F100\nX40\n" + program + "\n"; }

TEST(ModelCutterC, BlocksWithoutMotionBetween) {
  // A line without words is no block; O alone is one.
  expect_points({{30, 10}, {30, 40}, {80, 40}}, points_from(run(from_left(), after_a("\nM05\n\nX40 Y30\nX80")), 2),
                "empty");
  expect_points({{40, 10}, {30, 40}, {80, 40}}, points_from(run(from_left(), after_a("O7\nM05\nX40 Y30\nX80")), 2),
                "O");
}

TEST(ModelCutterC, CodeRepeatedInABlockBetween) {
  expect_points({{40, 10}}, test::heads_at(run(from_left(), after_a("G41\nX40 Y30")), {40, 0}), "G41");
}

}  // namespace

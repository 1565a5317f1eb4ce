// SPDX-License-Identifier: Apache-2.0
// Exact values as text. Digits of 1/3, 2/3 and of the square root of 2 are the known ones.
#include "model/basis/print.h"

#include <gtest/gtest.h>

#include "tests/unit/model_run.h"

namespace {

using namespace toolcomp;
using exact::Rational;
using model::number_text;

TEST(ModelPrint, AppendsRoundedDecimals) {
  std::string text = "x";
  model::append_number(text, Rational(2, 3), 4);
  model::append_number(text, Rational(-1, 3), 0);
  EXPECT_EQ(text, "x0.66670");
}

TEST(ModelPrint, GoldenNumbers) {
  EXPECT_EQ(number_text(Rational(1, 3), 15), (spec::NumberText{"0.333333333333333", "5e-16", "1/3"}));
  EXPECT_EQ(number_text(Rational(-3, 2), 15), (spec::NumberText{"-1.5", "0", "-3/2"}));
  EXPECT_EQ(number_text(7, 15), (spec::NumberText{"7", "0", "7/1"}));
  EXPECT_EQ(number_text(Rational(1, 8), 2), (spec::NumberText{"0.12", "5e-3", "1/8"}));
  EXPECT_EQ(number_text(sqrt(exact::Real(2)), 15), (spec::NumberText{"1.414213562373095", "5e-16", ""}));
}

TEST(ModelPrint, Events) {
  const test::Run done =
      test::run("control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[offsets.H]\n1 = 1\n", "N3 G43.5 H1 I1 J1\n");
  const spec::TextEvent event = model::text_event(done.events().at(0), 15);
  EXPECT_EQ(event.line, 1U);
  EXPECT_EQ(event.n, 3U);
  EXPECT_EQ(event.programmed[0], (spec::NumberText{"0", "0", "0/1"}));
  EXPECT_EQ(event.axes[0], (spec::NumberText{"0.707106781186548", "5e-16", ""}));
  EXPECT_EQ((*event.tool_axis)[2], (spec::NumberText{"0", "0", "0/1"}));
}

}  // namespace

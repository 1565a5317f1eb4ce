// Why a case was or was not judged.
#include "fuzz/oracle/trial.h"

#include <gtest/gtest.h>

#include <string>

namespace toolcomp::fuzz {
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

}  // namespace
}  // namespace toolcomp::fuzz

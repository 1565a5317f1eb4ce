// SPDX-License-Identifier: Apache-2.0
// --jobs: several processors say the bytes that one says, whatever ends the run.
#include <gtest/gtest.h>

#include <string>

#include "tests/command_line/command.h"
#include "tests/effort.h"

namespace {

using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::toolcomp;

const std::string kSetup = "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[offsets.D]\n1 = 2\n";

// Larger than what one processor does anyway, in a circle of four lines under compensation.
std::string program(const std::string& last) {
  std::string text = "G21 G90 G17\nG01 G41 D1 X10. F100\n";
  const std::string corners[] = {"X100.000 Y0.000 Z0.0000\n", "X100.000 Y100.000 Z1.0000\n",
                                 "X0.000 Y100.000 Z0.0000\n", "X0.000 Y0.000 Z1.0000\n"};
  const int blocks = toolcomp::test::effort(13'000, 20'000);
  for (int i = 0; i < blocks; ++i) text += corners[i % 4];
  return text + last;
}

void expect_the_same(const std::string& command, int status) {
  const Outcome one = toolcomp(command + " --jobs 1");
  EXPECT_EQ(one.status, status) << one.err;
  for (const char* jobs : {" --jobs 2", " --jobs 3"}) {
    const Outcome several = toolcomp(command + jobs);
    EXPECT_EQ(several.status, one.status);
    EXPECT_EQ(several.err, one.err);
    EXPECT_TRUE(several.out == one.out) << command << jobs << ": " << several.out.size() << " bytes instead of "
                                        << one.out.size();
  }
}

TEST(Jobs, SayWhatOneSays) {
  const Folder folder;
  const std::string setup = " --setup " + folder.write("setup.toml", kSetup);
  const std::string ends = folder.write("ends.nc", program("M30\n"));
  expect_the_same("run " + ends + setup + " --engine fast", 0);
  expect_the_same("run " + ends + setup + " --engine fast --format csv", 0);
  expect_the_same("run " + ends + setup + " --engine model", 0);
  expect_the_same("diff " + ends + setup, 0);
}

TEST(Jobs, EndInTheSameAlarm) {
  const Folder folder;
  const std::string setup = " --setup " + folder.write("setup.toml", kSetup);
  const std::string alarm = folder.write("alarm.nc", program("G41 X1.\nG02 X5. R0.1\nX1.\n"));
  expect_the_same("run " + alarm + setup + " --engine fast", 0);
  expect_the_same("run " + alarm + setup + " --engine model", 0);
  expect_the_same("diff " + alarm + setup, 0);
}

// No text: the events before stand, and the message names the line.
TEST(Jobs, RefuseTheSameBytes) {
  const Folder folder;
  const std::string setup = " --setup " + folder.write("setup.toml", kSetup);
  const std::string bytes = folder.write("bytes.nc", program(std::string("X1.\x01\nX2.\n")));
  expect_the_same("run " + bytes + setup + " --engine fast", 2);
  expect_the_same("run " + bytes + setup + " --engine model", 2);
  expect_the_same("diff " + bytes + setup, 2);
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// An interrupted certify leaves no controller behind.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>

#include "tests/command_line/command.h"

namespace {

using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::read;
using toolcomp::test::toolcomp;

constexpr int kSignalled = 128;

bool alive(int process) { return ::kill(process, 0) == 0; }

class Interrupted : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Signals, Interrupted, testing::Values(SIGINT, SIGTERM));

TEST_P(Interrupted, CertifyEndsItsController) {
  const Folder folder;
  const std::string number = folder.path("process");
  // A controller that says who it is, sends the signal to the command that runs it, and never answers.
  const std::string command = folder.path("command");
  const std::string signal = "kill -" + std::to_string(GetParam()) + " $(cat " + command + ")";
  const std::string controller = "sh " + folder.write("hang", "echo $$ >" + number + "\n" + signal + "\nsleep 1000\n");
  const Outcome outcome =
      toolcomp("certify --controller '" + controller + "' --timeout 500 --report " + folder.path("r"),
               "sh -c 'echo $$ >" + command + "; exec \"$@\"' sh ");
  EXPECT_NE(outcome.status, 0);
  EXPECT_LE(outcome.status, kSignalled + GetParam());
  const std::string text = read(number);
  ASSERT_FALSE(text.empty());
  const int process = std::stoi(text);
  for (int i = 0; i < 50 && alive(process); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_FALSE(alive(process));
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// Child processes that answer, end, hang, flood and refuse to read.
#include "host/process.h"

#include <gtest/gtest.h>

#include <csignal>
#include <thread>

namespace toolcomp::host {
namespace {

using std::chrono::milliseconds;
constexpr std::size_t kLimit = 1 << 20;

Clock::time_point in(int ms) { return Clock::now() + milliseconds(ms); }

TEST(Process, SendsALineAndReadsALine) {
  Process p("cat");
  std::string reply;
  EXPECT_EQ(p.exchange("hello", reply, in(5000), kLimit), Exchange::line);
  EXPECT_EQ(reply, "hello");
  EXPECT_EQ(p.exchange("again", reply, in(5000), kLimit), Exchange::line);
  EXPECT_EQ(reply, "again");
  EXPECT_FALSE(p.take_line(reply));
}

TEST(Process, MoreThanOneLineForOne) {
  Process p("read line; echo one; echo two; echo three; read line; echo four");
  std::string reply;
  EXPECT_EQ(p.exchange("x", reply, in(5000), kLimit), Exchange::line);
  EXPECT_EQ(reply, "one");
  EXPECT_EQ(p.receive_line(reply, in(5000), kLimit), Exchange::line);
  EXPECT_EQ(reply, "two");
  EXPECT_EQ(p.receive_line(reply, in(5000), kLimit), Exchange::line);
  EXPECT_EQ(reply, "three");
  EXPECT_FALSE(p.take_line(reply));
  EXPECT_EQ(p.receive_line(reply, in(50), kLimit), Exchange::timed_out);
  EXPECT_EQ(p.exchange("x", reply, in(5000), kLimit), Exchange::line);
  EXPECT_EQ(reply, "four");
}

// Both directions are far larger than a pipe holds: writing all before reading would block for ever.
TEST(Process, LongLinesDoNotBlockEitherSide) {
  Process p("cat");
  const std::string line(8 << 20, 'a');
  std::string reply;
  EXPECT_EQ(p.exchange(line, reply, in(20'000), 16 << 20), Exchange::line);
  EXPECT_EQ(reply, line);
}

TEST(Process, ReportsTheExitStatus) {
  Process p("read line; exit 3");
  std::string reply;
  EXPECT_EQ(p.exchange("x", reply, in(5000), kLimit), Exchange::closed);
  EXPECT_EQ(p.finish(milliseconds(2000)), "exit status 3");
  EXPECT_EQ(p.exit_status(), 3);
}

TEST(Process, ReportsTheSignal) {
  Process p("read line; kill -SEGV $$");
  std::string reply;
  EXPECT_EQ(p.exchange("x", reply, in(5000), kLimit), Exchange::closed);
  EXPECT_EQ(p.finish(milliseconds(2000)).substr(0, 19), "killed by signal 11");
  EXPECT_EQ(p.exit_status(), -1);
}

TEST(Process, TimesOutAndKillsTheWholeGroup) {
  std::string reply;
  pid_t grandchild = 0;
  {
    Process p("sleep 1000 & echo $!; wait");
    ASSERT_EQ(p.exchange("x", reply, in(5000), kLimit), Exchange::line);
    grandchild = std::stoi(reply);
    const auto begin = Clock::now();
    EXPECT_EQ(p.exchange("y", reply, in(100), kLimit), Exchange::timed_out);
    EXPECT_LT(Clock::now() - begin, milliseconds(5000));
    EXPECT_EQ(::kill(grandchild, 0), 0);
  }
  // The grandchild belongs to init now, which may take a moment to reap it.
  for (int i = 0; i < 200 && ::kill(grandchild, 0) == 0; ++i) std::this_thread::sleep_for(milliseconds(10));
  EXPECT_NE(::kill(grandchild, 0), 0);
}

TEST(Process, BoundsALineWithoutEnd) {
  Process p("yes x | tr -d '\\n'");
  std::string reply;
  EXPECT_EQ(p.exchange("x", reply, in(10'000), kLimit), Exchange::too_long);
}

TEST(Process, AProcessThatReadsNothingMayStillAnswer) {
  Process p("exec 0<&-; sleep 0.2; echo done");
  std::string reply;
  EXPECT_EQ(p.exchange(std::string(1 << 20, 'x'), reply, in(5000), kLimit), Exchange::line);
  EXPECT_EQ(reply, "done");
}

// Writing to a process that has gone must not raise SIGPIPE here; this test would die of it.
TEST(Process, SurvivesABrokenPipe) {
  Process p("exit 0");
  std::this_thread::sleep_for(milliseconds(200));
  std::string reply;
  EXPECT_EQ(p.exchange(std::string(1 << 20, 'x'), reply, in(5000), kLimit), Exchange::closed);
}

TEST(Process, KeepsTheLastOfStandardError) {
  Process p(
      "read line; i=0; while [ $i -lt 2000 ]; do echo \"message $i\" >&2; i=$((i+1)); done; echo answer; cat "
      ">/dev/null");
  std::string reply;
  EXPECT_EQ(p.exchange("x", reply, in(20'000), kLimit), Exchange::line);
  p.finish();
  EXPECT_EQ(p.errors().size(), 4096U);
  EXPECT_NE(p.errors().find("message 1999"), std::string::npos);
}

TEST(Process, KillProcessesEndsThemAll) {
  Process p("sleep 1000");
  kill_processes();
  std::string reply;
  EXPECT_EQ(p.exchange("x", reply, in(5000), kLimit), Exchange::closed);
  EXPECT_EQ(p.finish(milliseconds(2000)).substr(0, 18), "killed by signal 9");
}

}  // namespace
}  // namespace toolcomp::host

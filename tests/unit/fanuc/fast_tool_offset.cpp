// SPDX-License-Identifier: Apache-2.0
// Tool offset G45 to G48 of the fast engine, by hand. The worked examples of 14.3 stand in
// golden/fanuc/corpus_examples_chapter_14.cpp.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/fanuc/fast_run.h"

namespace toolcomp::fast {
namespace {

using Path = std::vector<double>;

std::string setup(const std::string& parameters, const std::string& rest) {
  return "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\",\"C\"]\n[parameters]\n" + parameters + "\n" + rest;
}

std::string offset(const std::string& value) { return setup("", "[offsets.D]\n1=\"" + value + "\"\n"); }

Path points(const ProgramRun& run, char letter) {
  Path path;
  for (std::size_t i = 0; i < run.events.size(); ++i)
    if (run.events[i].kind == spec::EventKind::move) path.push_back(run.point(i, letter));
  return path;
}

TEST(ToolOffset, NoTravelUnderG90) {
  // The move is made, without travel.
  for (const char* word : {"X0", "X-0"}) {
    const ProgramRun run(offset("12.34"), std::string("G90 G45 ") + word + " D1\n");
    EXPECT_EQ(run.moves(), 1U);
    EXPECT_EQ(run.point(0, 'X'), 0);
  }
}

TEST(ToolOffset, RotaryAxesGoAsProgrammed) {
  const ProgramRun run(offset("30"), "G91 G45 G1 X100 Y40 D1 C7\n");
  EXPECT_EQ(run.point(0, 'Y'), 70);
  EXPECT_EQ(run.axis(0, 'C'), 7);
}

TEST(ToolOffset, ShiftPersists) {
  // Example 6, then by hand: the shift is kept in incremental moves, arcs and beside the length offset.
  const ProgramRun run(setup("", "[offsets.D]\n1=10\n[offsets.H]\n2=5\n[position]\nX=100\n"),
                       "G90 G45 X150 D1\nX200\nG46 X250\nG46 X250\nG45 X300\nG91 X1\nG90 G02 X311 Y10 I10\nG43 Z0 H2\n"
                       "D0\nG49\nG92 X0\nG00 G55 X5\n");
  EXPECT_EQ(points(run, 'X'), (Path{160, 210, 250, 250, 310, 311, 321, 321, 321, 15}));
  EXPECT_EQ(run.events[6].arc->center[0], 321);
  EXPECT_EQ(run.programmed(6, 'X'), 311);
  EXPECT_EQ(run.axis(7, 'Z'), 5);
}

TEST(ToolOffset, MachinePositions) {
  const std::string s = setup("", "[offsets.D]\n1=10\n[workpiece.G54]\nX=100\nY=50\n");
  // By hand: G28 reaches its intermediate point with the shift; Y is not named and keeps its own.
  const ProgramRun run(s, "G91 G45 X0 Y0 D1\nG90 G28 X20\nX30\nG45 X40\nG53 X0\nG29 Y3\n");
  EXPECT_EQ(points(run, 'X'), (Path{10, 30, -100, 30, 50, -100, -100, -100}));
  EXPECT_EQ(points(run, 'Y'), (Path{10, 10, 10, 10, 10, 10, 10, 13}));
  EXPECT_EQ(run.machine(1, 'X'), 130);
  EXPECT_EQ(run.machine(2, 'X'), 0);
  EXPECT_EQ(run.machine(1, 'Y'), 60);
}

TEST(ToolOffset, Numbers) {
  const std::string tables = "[offsets]\nmemory=\"C\"\n[offsets.D]\n1=1\n2=2\n[offsets.H]\n1=10\n2=20\n";
  const auto end = [&](const char* parameters, const char* program) {
    return ProgramRun(setup(parameters, tables), program).point(0, 'X');
  };
  EXPECT_EQ(end("", "G91 G45 X0 D1 H2\n"), 1);
  EXPECT_EQ(end("\"5001#5\"=1", "G91 G45 X0 D1 H2\n"), 20);
  EXPECT_EQ(end("\"5001#2\"=1", "G91 G45 X0 H2\n"), 20);
  EXPECT_EQ(end("\"5001#2\"=1", "D1\nG91 G45 X0\n"), 1);
  EXPECT_EQ(end("\"5001#2\"=1\n\"5001#5\"=1", "G91 G45 X0 D1 H2\n"), 1);
  EXPECT_EQ(end("", "G91 G45 X0\n"), 0);
  const std::string by_h = setup("\"5001#5\"=1", tables);
  EXPECT_EQ(ProgramRun(by_h, "G43 Z0 H1\nG45 X1\n").alarm(), "G45_LENGTH_OFFSET@2");
  EXPECT_EQ(ProgramRun(by_h, "G43 Z0 H1\nG49 G45 X1 H1\n").alarm(), "");
}

TEST(ToolOffset, Alarms) {
  const std::string s = offset("10");
  for (const char* program : {"G91 G45 G02 X30 Y-20 I30 D1\n", "G91 G45 G02 X30 Y30 R30 D1\n", "G45 G02 I5 D1\n",
                              "G91 G45 G02 X30 Y-30 I30 J1 D1\n", "G91 G45 G02 X30 I30 D1\n"})
    EXPECT_EQ(ProgramRun(s, program).alarm(), "G45_ARC@1") << program;
  EXPECT_EQ(ProgramRun(s, "G91 G46 G02 X5 Y5 I5 D1\n").alarm(), "PS0038@1");
  const ProgramRun point(s, "G91 G46 G02 X10 Y10 I10 D1\n");
  EXPECT_EQ(point.point(0, 'X'), 0);
  EXPECT_EQ(point.events[0].arc->center[0], 0);
  EXPECT_FALSE(point.events[0].arc->sweep);
  EXPECT_EQ(ProgramRun(s, "G41 X10 D1\nG45 X20\n").alarm(), "PS0042@2");
  EXPECT_EQ(ProgramRun(s, "G45 G41 X10 D1\n").alarm(), "PS0042@1");
  EXPECT_EQ(ProgramRun(offset("1000"), "G45 X10 D1\n").alarm(), "PS0029@1");
  EXPECT_EQ(ProgramRun(offset("1000"), "G45 D1\n").alarm(), "");
}

}  // namespace
}  // namespace toolcomp::fast

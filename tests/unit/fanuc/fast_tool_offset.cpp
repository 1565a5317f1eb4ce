// Tool offset G45 to G48 of the fast engine. Expected values: the fact sheet's 14.3 where an example is named,
// otherwise by hand.
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

Path programmed(const ProgramRun& run, char letter) {
  Path path;
  for (std::size_t i = 0; i < run.events.size(); ++i)
    if (run.events[i].kind == spec::EventKind::move) path.push_back(run.programmed(i, letter));
  return path;
}

TEST(ToolOffset, Table) {
  // Table 14.1 of the sheet.
  const struct {
    const char* code;
    double result[4];  // x, l: +1000 +10, +1000 -10, -1000 +10, -1000 -10
  } rows[] = {{"G45", {1010, 990, -1010, -990}},
              {"G46", {990, 1010, -990, -1010}},
              {"G47", {1020, 980, -1020, -980}},
              {"G48", {980, 1020, -980, -1020}}};
  for (const auto& row : rows)
    for (int i = 0; i < 4; ++i)
      for (const char* mode : {"G90", "G91"}) {
        const std::string word = i < 2 ? "X1000" : "X-1000";
        const ProgramRun run(offset(i % 2 == 0 ? "10" : "-10"), std::string(mode) + row.code + word + "D1\n");
        EXPECT_EQ(run.point(0, 'X'), row.result[i]) << row.code << i << mode;
        EXPECT_EQ(run.axis(0, 'X'), row.result[i]);
        EXPECT_EQ(run.programmed(0, 'X'), i < 2 ? 1000 : -1000);
      }
}

TEST(ToolOffset, ZeroTravel) {
  const std::string s = offset("12.34");
  const auto end = [&](const char* program) { return ProgramRun(s, program).point(0, 'X'); };
  EXPECT_EQ(end("G91 G45 X0 D1\n"), 12.34);
  EXPECT_EQ(end("G91 G45 X-0 D1\n"), -12.34);
  EXPECT_EQ(end("G91 G46 X0 D1\n"), -12.34);
  EXPECT_EQ(end("G91 G46 X-0 D1\n"), 12.34);
  EXPECT_EQ(end("G91 G47 X0 D1\n"), 24.68);
  EXPECT_EQ(end("G91 G48 X0 D1\n"), -24.68);
  EXPECT_EQ(end("G90 G45 X0 D1\n"), 0);
  // G90: the move is made, without travel.
  EXPECT_EQ(ProgramRun(s, "G90 G45 X-0 D1\n").moves(), 1U);
}

TEST(ToolOffset, ReversalAndSeveralAxes) {
  EXPECT_EQ(ProgramRun(offset("3.7"), "G91 G46 X2.5 D1\n").point(0, 'X'), -1.2);
  EXPECT_EQ(ProgramRun(offset("15"), "G91 G48 X20 D1\n").point(0, 'X'), -10);
  const ProgramRun both(offset("200"), "G91 G45 G01 X1000 Y500 D1\n");
  EXPECT_EQ(both.point(0, 'X'), 1200);
  EXPECT_EQ(both.point(0, 'Y'), 700);
  const ProgramRun nct(offset("30"), "G91 G45 G1 X100 Y40 D1 C7\n");
  EXPECT_EQ(nct.point(0, 'X'), 130);
  EXPECT_EQ(nct.point(0, 'Y'), 70);
  EXPECT_EQ(nct.axis(0, 'C'), 7);  // rotary: as programmed
}

TEST(ToolOffset, FigureOfTheManual) {
  const ProgramRun run(offset("10"),
                       "N1 G91 G46 G00 X80 Y50 D01\nN2 G47 G01 X50 F100\nN3 Y40\nN4 G48 X40\nN5 Y-40\nN6 G45 X30\n"
                       "N7 G45 G03 X30 Y30 J30\nN8 G45 G01 Y20\nN9 G46 X0\nN10 G46 G02 X-30 Y30 J30\nN11 G45 G01 Y0\n"
                       "N12 G47 X-120\nN13 G47 Y-80\nN14 G46 G00 X-80 Y-50\n");
  EXPECT_EQ(points(run, 'X'), (Path{70, 140, 140, 160, 160, 200, 240, 240, 230, 210, 210, 70, 70, 0}));
  EXPECT_EQ(points(run, 'Y'), (Path{40, 40, 80, 80, 40, 40, 80, 110, 110, 130, 140, 140, 40, 0}));
  EXPECT_EQ(programmed(run, 'X'), (Path{80, 130, 130, 170, 170, 200, 230, 230, 230, 200, 200, 80, 80, 0}));
  EXPECT_EQ(programmed(run, 'Y'), (Path{50, 50, 90, 90, 50, 50, 80, 100, 100, 130, 130, 130, 50, 0}));
  const auto& convex = *run.events[6].arc;
  EXPECT_EQ(convex.center[0], 200);
  EXPECT_EQ(convex.center[1], 80);
  EXPECT_EQ(convex.sweep, 90);
  EXPECT_FALSE(convex.radius);
  const auto& concave = *run.events[9].arc;
  EXPECT_EQ(concave.center[0], 230);
  EXPECT_EQ(concave.center[1], 130);
  EXPECT_EQ(concave.sweep, 90);
}

TEST(ToolOffset, ThreeQuarterCircle) {
  const ProgramRun run(offset("10"), "G91 G45 G02 X30 Y-30 I30 D1\n");
  EXPECT_EQ(run.point(0, 'X'), 40);
  EXPECT_EQ(run.point(0, 'Y'), -40);
  EXPECT_EQ(run.events[0].arc->center[0], 40);
  EXPECT_EQ(run.events[0].arc->center[1], 0);
  EXPECT_EQ(run.events[0].arc->sweep, 270);
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

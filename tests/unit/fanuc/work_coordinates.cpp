// SPDX-License-Identifier: Apache-2.0
// Where the workpiece stands: G54 to G59, G54.1, G52, G92, G10 L2 L20, in both engines. Expected values are by hand:
// machine coordinate = workpiece coordinate + origins, local system and shift.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "tests/unit/fanuc/fast_run.h"
#include "tests/unit/model_run.h"

namespace {

using namespace toolcomp;
using test::Lines;
using test::Show;

// X stands at machine 105, Y at 10.
const std::string kOrigins = "[workpiece.G54]\nX = 100\nY = 10\n[workpiece.G55]\nX = 150\n[workpiece.P3]\nX = 500\n";
std::string setup(const std::string& origins = kOrigins) {
  return "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"C\"]\n[position]\nX = 5\n" + origins;
}

// As test::lines().
Lines fast_lines(const std::string& setup, const std::string& program, Show show) {
  const fast::ProgramRun run(setup, program);
  const spec::Axes axes = spec::read_setup_toml(setup, "setup").axes;
  Lines lines;
  for (const fast::Event& event : run.events) {
    std::string line = std::to_string(event.line) + ' ';
    if (event.kind == spec::EventKind::move) {
      line += std::string(spec::name(event.type));
      const auto& values = show == Show::machine ? event.machine : event.axes;
      std::string text;
      for (std::size_t i = 0; i < axes.size(); ++i)
        if (values.has(i)) text += fmt::format("{}{}{:.12g}", text.empty() ? "" : " ", axes.letter(i), values[i] + 0.0);
      line += ' ' + text;
      if (event.cause != spec::Cause::programmed) line += " (" + std::string(spec::name(event.cause)) + ')';
    } else {
      line += event.number.view();
    }
    lines.push_back(line);
  }
  return lines;
}

// Of both engines, that of the model.
Lines lines(const std::string& program, const std::string& keys = setup(), Show show = Show::axes) {
  const Lines model = test::lines(test::run(keys, program), show);
  EXPECT_EQ(fast_lines(keys, program, show), model) << program;
  return model;
}
std::string last(const std::string& program, const std::string& keys = setup()) {
  const Lines all = lines(program, keys);
  return all.empty() ? "" : all.back();
}

TEST(WorkCoordinates, TheLocalSystemHoldsInAllSystems) {
  // 5 - 20 = -15; in G55 105 - 150 - 20 = -65.
  EXPECT_EQ(lines("G52 X20\nY0\nG55 Y0\nG52 X0\nY0\n"),
            (Lines{"2 rapid X-15 Y0 Z0 C0", "3 rapid X-65 Y0 Z0 C0", "5 rapid X-45 Y0 Z0 C0"}));
  EXPECT_EQ(lines("G52 X20\nG52 Y1\nG52\nZ0\nX0\n"), (Lines{"4 rapid X-15 Y-1 Z0 C0", "5 rapid X0 Y-1 Z0 C0"}));
  EXPECT_EQ(last("G52 C30\nX5\n"), "2 rapid X5 Y0 Z0 C-30");
}

TEST(WorkCoordinates, TheLocalSystemIsNotAddedTo) {
  EXPECT_EQ(last("G91 G52 X20\nG52 X20\nY1\n"), "3 rapid X-15 Y1 Z0 C0");
  EXPECT_EQ(last("G52 X20\nG91 G52 X0\nY1\n"), "3 rapid X5 Y1 Z0 C0");
}

TEST(WorkCoordinates, ShiftsAndTheLocalSystem) {
  EXPECT_EQ(last("G92 X20\nG52 X30\nY0\n"), "3 rapid X-10 Y0 Z0 C0");
  EXPECT_EQ(last("G92 X20\nG52 X30\nG52 X0\nY0\n"), "4 rapid X20 Y0 Z0 C0");
  // G92 ends the local system of the axes it names.
  EXPECT_EQ(last("G52 X30 Y4\nG92 X20\nG52 X0\nZ0\n"), "4 rapid X20 Y-4 Z0 C0");
  EXPECT_EQ(last("G52 X30 Y4\nG92 X20\nG55\nZ0\n"), "4 rapid X-30 Y6 Z0 C0");
  EXPECT_EQ(lines("G52 X30\nG92 X20\nG53 Z0\n", setup(), Show::machine), (Lines{"3 rapid X105 Y10 Z0 C0"}));
}

TEST(WorkCoordinates, AdditionalSystems) {
  EXPECT_EQ(last("G54.1 P3 Y0\n"), "1 rapid X-395 Y0 Z0 C0");
  EXPECT_EQ(last("P3. G54.10 Y0\n"), "1 rapid X-395 Y0 Z0 C0");
  EXPECT_EQ(last("G54.1 Y0\n"), "1 rapid X105 Y0 Z0 C0");
  EXPECT_EQ(last("G54.1\nY0\n", setup("[workpiece.P1]\nX = -1\n")), "2 rapid X6 Y0 Z0 C0");
  EXPECT_EQ(last("G54.1 P48\nY0\n", setup("[workpiece.P48]\nC = 7\n")), "2 rapid X5 Y0 Z0 C-7");
  EXPECT_EQ(last("G54.1 P3\nG54\nZ0\n"), "3 rapid X5 Y0 Z0 C0");
  EXPECT_EQ(last("G54 P3 Y0\n"), "1 rapid X-395 Y0 Z0 C0") << "as G54.1";
  EXPECT_EQ(last("G55 P3\nY0\n"), last("G55\nY0\n")) << "P means nothing there";
  EXPECT_EQ(last("G54.1 P3 G55 Y0\n"), "1 rapid X-45 Y0 Z0 C0") << "the last one counts";
  for (const char* block : {"G54.1 P49", "G54.1 P0", "G54.1 P1.5", "G54.1 P-1", "G54.1 P3000000000"})
    EXPECT_EQ(last(block), "1 PS0030") << block;
}

TEST(WorkCoordinates, TheExternalOriginIsAddedToAll) {
  const std::string keys = setup(kOrigins + "[workpiece.external]\nX = 1000\n");
  EXPECT_EQ(lines("Y0\nG54.1 P3 Y0\nG53 Z0\n", keys),
            (Lines{"1 rapid X5 Y0 Z0 C0", "2 rapid X-395 Y0 Z0 C0", "3 rapid X-395 Y0 Z0 C0"}));
  EXPECT_EQ(lines("G53 Z0\n", keys, Show::machine), (Lines{"1 rapid X1105 Y10 Z0 C0"}));
  EXPECT_EQ(last("G53 X0\n", keys), "1 rapid X-1100 Y0 Z0 C0");
}

TEST(WorkCoordinates, OriginsAreWritten) {
  EXPECT_EQ(last("G10 L2 P1 X200\nZ0\n"), "2 rapid X-95 Y0 Z0 C0");
  EXPECT_EQ(last("G91 G10 L2 P1 X200\nZ0\n"), "2 rapid X-195 Y0 Z0 C0");
  EXPECT_EQ(lines("G10 L2 P2 X7\nZ0\nG55 Z0\n"), (Lines{"2 rapid X5 Y0 Z0 C0", "3 rapid X98 Y10 Z0 C0"}));
  EXPECT_EQ(last("G10 L2 P6 C-3\nG59\nZ0\n"), "3 rapid X105 Y10 Z0 C3");
  // 105 - (150 + 50).
  EXPECT_EQ(lines("G10 L2 P0 X50\nZ0\nG55 Z0\nG91 G10 L2 P0 X50\nZ0\n"),
            (Lines{"2 rapid X-45 Y0 Z0 C0", "3 rapid X-95 Y10 Z0 C0", "5 rapid X-145 Y10 Z0 C0"}));
  EXPECT_EQ(last("G10 L20 P3 X1\nG54.1 P3\nZ0\n"), "3 rapid X104 Y10 Z0 C0");
  EXPECT_EQ(last("G54.1 P3\nG91 G10 L20 P3 X1\nZ0\n"), "3 rapid X-396 Y10 Z0 C0");
  EXPECT_EQ(last("G10 L2 P1\nZ0\n"), "2 rapid X5 Y0 Z0 C0") << "no axis, nothing written";
  EXPECT_EQ(lines("G10 L2 P1 X200\nG53 X0\n", setup(), Show::machine), (Lines{"2 rapid X0 Y10 Z0 C0"}));
  // The block moves nothing; codes beside it hold.
  EXPECT_EQ(lines("G91 G55 G10 L2 P2 X1\nX1\n"), (Lines{"2 rapid X-45 Y10 Z0 C0"}));
}

TEST(WorkCoordinates, InchPrograms) {
  EXPECT_EQ(last("G20 G10 L2 P1 X1 C1\nG21 Z0\n"), "2 rapid X79.6 Y0 Z0 C-1");
  EXPECT_EQ(last("G20 G52 X1 C1\nG21 Z0\n"), "2 rapid X-20.4 Y0 Z0 C-1");
  EXPECT_EQ(last("G91 G20 G10 L2 P1 X-1\nG21 Z0\n"), "2 rapid X30.4 Y0 Z0 C0");
}

TEST(WorkCoordinates, NumbersOfNoOrigin) {
  for (const char* block : {"G10 L2 P7 X1", "G10 L2 X1", "G10 L2 P-1 X1", "G10 L2 P1.5 X1", "G10 L20 P0 X1",
                            "G10 L20 P49 X1", "G10 L20 X1", "G10 L2 P7", "G10 L2 P1000000"})
    EXPECT_EQ(last(block), "1 PS0031") << block;
  for (const char* block : {"G10 L4 P1 X1", "G10 P1 X1", "G10 L200 P1 X1"}) EXPECT_EQ(last(block), "1 PS0010") << block;
}

// The same path in cutter compensation, whatever its points are called: the corner lies behind the block that renames.
TEST(WorkCoordinates, RenamingInCutterCompensation) {
  const std::string keys =
      "[workpiece.P3]\nX = 500\nY = -20\n[workpiece.G56]\nX = 500\nY = -20\n[offsets.D]\n1 = "
      "4\n[parameters]\n\"5003#0\" = "
      "1\n";
  const std::string head = "G41 D1 G01 X10 Y0 F100\nX50\n";
  const auto path = [&](const std::string& rename) {
    const bool renamed = rename != "M50";
    std::vector<double> machine;
    const std::string tail = renamed ? "X-450 Y70\nX-500\nG40 X-510\n" : "X50 Y50\nX0\nG40 X-10\n";
    const fast::ProgramRun run(setup(keys), head + rename + '\n' + tail);
    const auto exact = test::run(setup(keys), head + rename + '\n' + tail);
    EXPECT_EQ(run.events.size(), exact.events().size());
    for (std::size_t i = 0; i < run.events.size(); ++i) {
      EXPECT_EQ(run.events[i].kind, spec::EventKind::move) << rename;
      const bool behind = renamed && run.events[i].line > 3;
      for (const char letter : {'X', 'Y'}) {
        const double zero = !behind ? 0 : letter == 'X' ? 500 : -20;
        machine.push_back(run.axis(i, letter) + zero);
        const auto axis = exact.setup.axes.index(letter);
        EXPECT_NEAR(run.axis(i, letter), std::stod(exact.events()[i].axes[axis].decimal(15)), 1e-9) << rename;
      }
    }
    return machine;
  };
  const std::vector<double> plain = path("M50");
  ASSERT_GE(plain.size(), 10U);
  for (const char* rename :
       {"G56", "G54.1 P3", "G10 L2 P1 X500 Y-20", "G10 L2 P0 X500 Y-20", "G91 G10 L2 P1 X500 Y-20 G90"}) {
    const std::vector<double> renamed = path(rename);
    ASSERT_EQ(renamed.size(), plain.size()) << rename;
    for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_NEAR(renamed[i], plain[i], 1e-9) << rename << ' ' << i;
  }
}

TEST(WorkCoordinates, TheLocalSystemInCutterCompensation) {
  const std::string keys = setup("[offsets.D]\n1 = 4\n[parameters]\n\"5003#0\" = 1\n");
  const auto kind = [&keys](const std::string& program) {
    const auto exact = test::run(keys, program);
    const fast::ProgramRun run(keys, program);
    EXPECT_EQ(run.events.size(), exact.events().size());
    EXPECT_EQ(run.events.back().kind, exact.events().back().kind);
    EXPECT_EQ(run.events.back().number, exact.events().back().number);
    return exact.events().back().kind;
  };
  EXPECT_EQ(kind("G41 D1 G01 X10 F100\nX50\nG52 X5\nX80\nX90\n"), spec::EventKind::move) << "in the plane";
  EXPECT_EQ(kind("G41 D1 G01 X10 F100\nX50\nG52 Z5\nX80\nX90\nG40 X100\n"), spec::EventKind::move) << "beside it";
  EXPECT_EQ(kind("G52 X5\nG41 D1 G01 X10 F100\nX50\nG40 X100\nG52 X0\nX0\n"), spec::EventKind::move);
}

TEST(WorkCoordinates, ForbiddenUnderToolDirection) {
  const std::string keys =
      "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n[parameters]\n19680 = 2\n19681 = 5\n19682 = "
      "3\n19686 = 4\n19687 = 2\n[offsets.H]\n1 = 100\n";
  for (const char* block : {"G52 X1", "G54.1 P1", "G10 L2 P1 X1", "G10 L20 P1 X1", "G92 X1", "G55"})
    for (const char* mode : {"G43.4 H1", "G43.5 H1"})
      EXPECT_EQ(last(std::string(mode) + "\nX1\n" + block + '\n', keys), "3 FORBIDDEN_UNDER_TOOL_DIRECTION") << block;
  EXPECT_EQ(last("G43.4 H1\nG49\nG54.1 P1\nG52 X1\nG10 L2 P0 Y1\nZ0\n", keys).substr(0, 10), "6 rapid X-");
}

TEST(WorkCoordinates, LettersOfOtherCodesAreData) {
  EXPECT_EQ(lines("X5 Y1\nG05.1 Q1 X0 Y0 Z0\nG22 X9 Z9 I1 J1 K1\nG50.1 X0\nG05 P0 X7\nG04 X2\nG91 G01 Y1\n"),
            (Lines{"1 rapid X5 Y1 Z0 C0", "7 linear X5 Y2 Z0 C0"}));
  EXPECT_EQ(lines("G80 X7\nG69 Y1\nG15 Z2\n"),
            (Lines{"1 rapid X7 Y0 Z0 C0", "2 rapid X7 Y1 Z0 C0", "3 rapid X7 Y1 Z2 C0"}));
}

TEST(WorkCoordinates, FeedsOfOtherKindsAreNone) {
  const std::string program =
      "G01 X1 F100\nG93 X2 F5\nX3\nG00 G94 X4\nG01 X5 F7\nG95 F2 X6\nG94 F9 X7\nG94 X8\nG93\nG94\nG00 X9\n"
      "G01 G99 F3 X10\nG93\nG94 X11\n";
  // At last no F, which is an alarm: after G93 and G95 F has to be given again.
  const std::vector<std::string> expected{"100", "-", "-", "-", "7", "-", "9", "9", "-", "3", "-"};
  std::vector<std::string> model;
  const auto exact = test::run(setup(), program);
  for (const auto& event : exact.events()) model.push_back(event.feed ? event.feed->decimal(3) : "-");
  EXPECT_EQ(model, expected);
  std::vector<std::string> fast;
  for (const auto& event : fast::ProgramRun(setup(), program).events)
    fast.push_back(event.feed ? fmt::format("{}", *event.feed) : "-");
  EXPECT_EQ(fast, expected);
}

TEST(WorkCoordinates, SpindlesAndHighSpeedInThreeDimensionalCompensation) {
  const std::string keys =
      "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n[parameters]\n19680 = 2\n19681 = 5\n19682 = "
      "3\n19686 = 4\n19687 = 2\n[offsets.D]\n1 = 3\n";
  for (const std::string start : {"G41.2 D1\n", "G41.3 D1\n"}) {
    for (const char* block : {"G96 S100", "G97 S1000", "G160", "G05 P2", "G05", "G05 P0"})
      EXPECT_EQ(last(start + "G01 X10 F100\nX20\n" + block + '\n', keys), "4 FORBIDDEN_IN_3D_COMPENSATION")
          << start << block;
    for (const char* block : {"G05 P10000", "G05.1 Q1", "G61", "G80", "M98 P1"})
      EXPECT_EQ(last(start + "G01 X10 F100\nX20\n" + block + "\nX30\nG40\n", keys).find("FORBIDDEN"), std::string::npos)
          << start << block;
  }
}

// The law: what is renamed stays where it is. G53 Z0 tells where X and Y stand.
TEST(WorkCoordinates, TheMachineNeverMovesByANewName) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937 random(seed);
    const auto below = [&random](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
    const auto number = [&] { return std::to_string(below(200) - 100) + ".5"; };
    const auto words = [&] {
      return (below(2) != 0 ? " X" + number() : "") + (below(2) != 0 ? " Y" + number() : "") +
             (below(2) != 0 ? " Z" + number() : "");
    };
    std::string program;
    std::vector<std::string> expected;
    int x = 105;
    int y = 10;
    for (int block = 0; block < 30; ++block) {
      program += below(2) != 0 ? "G91 " : "G90 ";
      if (below(4) == 0) program += "G20 ";
      switch (below(7)) {
        case 0:
          program += "G52" + words();
          break;
        case 1:
          program += "G92" + words();
          break;
        case 2:
          program += "G10 L2 P" + std::to_string(below(7)) + words();
          break;
        case 3:
          program += "G10 L20 P" + std::to_string(1 + below(4)) + words();
          break;
        case 4:
          program += "G54.1 P" + std::to_string(1 + below(4));
          break;
        case 5:
          program += 'G' + std::to_string(54 + below(6));
          break;
        default:
          program += "\nG21 G91 G01 X3 Y-2";
          x += 3;
          y -= 2;
      }
      program += "\nG21 G90 G53 Z0\n";
      expected.push_back("rapid X" + std::to_string(x) + " Y" + std::to_string(y) + " Z0 C0");
    }
    std::vector<std::string> machine;
    for (const std::string& line : lines(program, setup(), Show::machine))
      if (line.find("rapid") != std::string::npos) machine.push_back(line.substr(line.find(' ') + 1));
    EXPECT_EQ(machine, expected) << program;
    lines(program);
  }
}

}  // namespace

// Tool center point control and tool posture control: the worked examples 3 to 5, 7 to 9 and 11 of the posture sheet
// (50 digits, printed to 15), end to end.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/fanuc/engine.h"
#include "spec/language/fanuc/program_reader.h"
#include "tests/unit/model_run.h"
#include "tests/unit/sheet_digits.h"

namespace {

using namespace toolcomp;
using test::sheet_digits;
using Lines = std::vector<std::string>;

// The machines of the sheet, on axes X1 Y2 Z3 A4 B5 C6.
const std::string kHC = "19680 = 2\n19681 = 6\n19682 = 3\n19686 = 5\n19687 = 2\n";
const std::string kTAC = "19680 = 12\n19681 = 4\n19682 = 1\n19684 = 1\n19686 = 6\n19687 = 3\n19689 = 1\n";
const std::string kMBC = "19680 = 21\n19681 = 5\n19682 = 2\n19686 = 6\n19687 = 3\n19689 = 1\n";
const std::string kN45 = "19680 = 2\n19681 = 6\n19682 = 3\n19686 = 5\n19687 = 5\n19688 = 45\n";

// Ranges of a table or mixed machine that leave the first pair only.
const std::string kPositive = "19741 = 90\n19742 = 0\n19743 = 400\n19744 = 0\n";

struct Done {
  spec::Setup setup;
  test::Collector sink;
};

// H1 is the length, D2 the radius 5.
Done run(const std::string& parameters, int length, const std::string& program, std::uint32_t samples,
         const std::string& more = "") {
  const std::string text = "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"A\", \"B\", \"C\"]\n[parameters]\n" +
                           parameters + "[offsets.H]\n1 = " + std::to_string(length) + "\n[offsets.D]\n2 = 5\n" + more;
  Done result{spec::read_setup_toml(text, "setup.toml"), {}};
  model::Recorder recorder;
  model::Engine engine(result.setup, recorder, result.sink, samples);
  spec::ProgramReader reader(spec::text_source(program), result.setup.axes);
  spec::Block block;
  while (!engine.stopped() && reader.next(block)) engine.block(block);
  engine.end();
  return result;
}

std::string values(const Done& run, const spec::AxisValues<exact::Real>& of, const std::string& letters, int digits) {
  std::string text;
  for (const char letter : letters) {
    const std::size_t axis = run.setup.axes.index(letter);
    text += (text.empty() ? "" : " ") + (of.has(axis) ? sheet_digits(of[axis], digits) : std::string("-"));
  }
  return text;
}

std::string tool_axis(const model::Event& event, int digits) {
  if (!event.tool_axis) return "-";
  std::string text;
  for (const exact::Real& component : *event.tool_axis)
    text += (text.empty() ? "" : " ") + sheet_digits(component, digits);
  return text;
}

// What a line shows of an event: axes by letter, the tool axis as V, the point as P.
std::string shown(const Done& run, const model::Event& event, const std::string& what, int digits) {
  switch (event.kind) {
    case spec::EventKind::sample:
    case spec::EventKind::move:
      break;
    default:
      return std::string(event.number.view());
  }
  std::string text;
  if (event.kind == spec::EventKind::sample)
    text = std::to_string(event.t_numerator) + '/' + std::to_string(event.t_denominator) + ": ";
  if (event.cause != spec::Cause::programmed) text += std::string(spec::name(event.cause)) + ": ";
  if (what == "V") return text + tool_axis(event, digits);
  if (what == "P") return text + values(run, event.point, "XYZ", digits);
  return text + values(run, event.axes, what, digits);
}

// All events of a line of the program.
Lines of_line(const Done& run, std::uint64_t line, const std::string& what, int digits = 15) {
  Lines result;
  for (const model::Event& event : run.sink.events)
    if (event.line == line) result.push_back(shown(run, event, what, digits));
  return result;
}

// The pyramid's edge, the tool of its start found from the positions of `start`.
std::string edge(const std::string& posture, const std::string& start) {
  return "G90 G00 X20 Y-20 Z0\n" + start + "\nG43.5 H1 " + posture +
         "\nG01 X20 Y-20 I-1 J1 K2 F500\nX20 Y20 I-1 J-1 K2\n";
}

TEST(Example3, EdgeOfThePyramidUnderPostureControl) {
  const Done done = run(kHC, 100, edge("P1", "C100"), 4);
  EXPECT_EQ(of_line(done, 5, "CB"), (Lines{"1/4: 154.488330009362 28.9872466142404", "1/2: 180 26.565051177078",
                                           "3/4: 205.511669990638 28.9872466142404", "225 35.2643896827547"}));
  EXPECT_EQ(of_line(done, 5, "V"), (Lines{"1/4: -0.437363799276446 0.208721190616481 0.874727598552893",
                                          "1/2: -0.447213595499958 0 0.894427190999916",
                                          "3/4: -0.437363799276446 -0.208721190616481 0.874727598552893",
                                          "-0.408248290463863 -0.408248290463863 0.816496580927726"}));
  EXPECT_EQ(of_line(done, 5, "XYZ"), (Lines{"1/4: -23.7363799276446 10.8721190616481 87.4727598552893",
                                            "1/2: -24.7213595499958 0 89.4427190999916",
                                            "3/4: -23.7363799276446 -10.8721190616481 87.4727598552893",
                                            "-20.8248290463863 -20.8248290463863 81.6496580927726"}));
  EXPECT_EQ(of_line(done, 4, "CB").back(), "135 35.2643896827547");
}

TEST(Example3, ConventionalControlLeansIntoTheWork) {
  const Done done = run(kHC, 100, edge("P0", "C100"), 4);
  const Lines tool = of_line(done, 5, "V");
  EXPECT_EQ(tool.at(0), "1/4: -0.533402096794177 0.220942382690395 0.816496580927726");
  EXPECT_EQ(tool.at(1), "1/2: -0.577350269189626 0 0.816496580927726");
  EXPECT_EQ(of_line(done, 5, "XYZ").at(1), "1/2: -37.7350269189626 0 81.6496580927726");
  EXPECT_EQ(of_line(done, 5, "CB").at(1), "1/2: 180 35.2643896827547");
}

TEST(Example3, OtherMachines) {
  EXPECT_EQ(of_line(run(kTAC + kPositive, 100, edge("P1", "C0"), 4), 5, "AC"),
            (Lines{"1/4: 28.9872466142404 244.488330009362", "1/2: 26.565051177078 270",
                   "3/4: 28.9872466142404 295.511669990638", "35.2643896827547 315"}));
  EXPECT_EQ(of_line(run(kMBC + kPositive, 100, edge("P1", "C0"), 4), 5, "CB"),
            (Lines{"1/4: 154.488330009362 28.9872466142404", "1/2: 180 26.565051177078",
                   "3/4: 205.511669990638 28.9872466142404", "225 35.2643896827547"}));
  const Done nutating = run(kN45, 100, edge("P1", "C100 B30"), 4);
  EXPECT_EQ(of_line(nutating, 4, "CB").back(), "116.467819046821 50.7287005490466");
  EXPECT_EQ(of_line(nutating, 5, "CB"),
            (Lines{"1/4: 139.507322177772 41.4567926002351", "1/2: 166.345415254024 37.921419763845",
                   "3/4: 190.530662159048 41.4567926002351", "206.467819046821 50.7287005490466"}));
}

TEST(Example4, TypeOne) {
  const std::string program = "G90 G00 X0 Y0 Z0 B20\nG43.4 H1 P1\nG01 C90 B40 F500\n";
  const Done done = run(kHC, 150, program, 4);
  EXPECT_EQ(of_line(done, 3, "CB"),
            (Lines{"1/4: 33.3593629436283 18.7250240410852", "1/2: 61.9830533459686 23.1158568832211",
                   "3/4: 79.441555265135 30.8375489371282", "90 40"}));
  EXPECT_EQ(of_line(done, 3, "V").at(0), "1/4: 0.268133688322374 0.176528861603656 0.947070159073528");
  EXPECT_EQ(of_line(done, 3, "V").at(2), "3/4: 0.0939290453595435 0.503926496601286 0.858624143884272");
  EXPECT_EQ(of_line(done, 3, "XYZ").at(1), "1/2: 27.6619712970299 51.9875006084212 137.956932136271");
  const Done conventional = run(kHC, 150, "G90 G00 X0 Y0 Z0 B20\nG43.4 H1 P0\nG01 C90 B40 F500\n", 2);
  EXPECT_EQ(of_line(conventional, 3, "XYZ").at(0), "1/2: 53.0330085889911 53.0330085889911 129.903810567666");
  // The work side would have to swing by 200.
  const Done wide = run(kHC, 150, "G90 G00 X0 Y0 Z0 B20\nG43.4 H1 P1\nG01 C200 B20 F500\n", 2);
  EXPECT_EQ(of_line(wide, 3, "CB"), (Lines{"posture-branch", "1/2: 100 20", "200 20"}));
}

// From C0 B10, the tool of the block at polar angle 12 and azimuth 176, all but for the last digit.
std::string beside_pole(const std::string& more = "") {
  return "G90 G00 X0 Y0 Z0 B10\nG43.5 H1 P1\nG01 X50 I-.207405228388532 J.014503186401626 K.978147600733806 F500\n" +
         more;
}

TEST(Example5, BesideTheSingularPostureTheWorkSideSwings) {
  const Done done = run(kHC + "19738 = 1\n19739 = 3\n", 80, beside_pole(), 10);
  const Lines axes = of_line(done, 3, "CB", 11);
  EXPECT_EQ(axes.at(0), "1/10: 0.6271605329 7.8034559584");
  EXPECT_EQ(axes.at(2), "3/10: 4.2797031688 3.4184533773");
  EXPECT_EQ(axes.at(3), "2/5: 15.644747692 1.2584903951");
  EXPECT_EQ(axes.at(4), "1/2: 156.74998159 1.0722825229");
  EXPECT_EQ(axes.at(5), "3/5: 170.9513213 3.2223902159");
  EXPECT_EQ(axes.back(), "176 12");
  const Done refused = run(kHC + "19738 = 1\n19739 = 3\n\"19696#3\" = 1\n", 80, beside_pole(), 10);
  EXPECT_EQ(of_line(refused, 3, "CB"), (Lines{"PS5421"}));
}

TEST(Example5, ChangedEndPassesTheSingularPosture) {
  const std::string next = "I-.469846310392954 J-.171010071662834 K.866025403784439\n";
  const Done done = run(kHC + "19738 = 1\n19739 = 5\n", 80, beside_pole(next), 4);
  EXPECT_EQ(of_line(done, 3, "CB", 12), (Lines{"1/4: 0 4.5", "1/2: 0 -1", "3/4: 0 -6.5", "0 -12"}));
  EXPECT_EQ(of_line(done, 3, "XYZ", 12),
            (Lines{"1/4: 18.7767276582 0 79.7533866987", "1/2: 23.603807485 0 79.9878156125",
                   "3/4: 28.4437428986 0 79.4857484541", "33.3670647346 0 78.2518080587"}));
  EXPECT_EQ(of_line(done, 3, "V", 12).back(), "-0.207911690818 0 0.978147600734");
  EXPECT_EQ(of_line(done, 4, "CB", 12).back(), "20 -30");
  const Done halves = run(kHC + "19738 = 1\n19739 = 5\n", 80, beside_pole(next), 2);
  EXPECT_EQ(of_line(halves, 4, "CB", 11).front(), "1/2: 14.161136812 -20.75828295");
}

TEST(Example5, TableTwinAndTheOtherPole) {
  // The table frame is frozen at its zero pose.
  const Done table = run(kTAC + "19738 = 1\n19739 = 5\n", 80,
                         "G90 G00 X0 Y0 Z0\nG43.5 H1 P1\nG01 J-.17364817766693 K.984807753012208 F500\n"
                         "X50 I.014503186401626 J.207405228388532 K.978147600733806\n",
                         2);
  EXPECT_EQ(of_line(table, 3, "AC", 12).back(), "10 0");
  EXPECT_EQ(of_line(table, 4, "AC", 12), (Lines{"1/2: -1 0", "-12 0"}));
  EXPECT_EQ(of_line(table, 4, "V", 12).front(), "1/2: 0 0.0174524064373 0.999847695156");
  const Done below = run(kHC + "19738 = 1\n19739 = 5\n", 80,
                         "G90 G00 X0 Y0 Z0 B172\nG43.5 H1 P1\n"
                         "G01 X50 I-.173410198874506 J.009088043428043 K-.984807753012208 F500\n",
                         0);
  EXPECT_EQ(of_line(below, 3, "CB", 12), (Lines{"0 190"}));
}

TEST(Example7, RationalNearTest) {
  const auto end = [](const std::string& limit) {
    return of_line(run(kHC + "19738 = 1\n19739 = " + limit + "\n", 80,
                       "G90 G00 X0 Y0 Z0\nG43.5 H1 P1 I1 K5\nG01 X50 I-1 J.1 K5 F500\n", 0),
                   3, "CB");
  };
  EXPECT_EQ(end("5.71059313749965"), (Lines{"0 -11.3648769670337"}));
  EXPECT_EQ(end("5.71059313749963"), (Lines{"174.2894068625 11.3648769670337"}));
}

TEST(Example7, ExactCrossingIsNotChanged) {
  const Done done =
      run(kHC + "19738 = 1\n19739 = 10\n", 80, "G90 G00 X0 Y0 Z0\nG43.5 H1 P1 I1 K2\nG01 X50 I-2 K3 F500\n", 2);
  EXPECT_EQ(of_line(done, 3, "CB"), (Lines{"1/2: 0 -3.5625081744509", "0 -33.6900675259798"}));
}

// O0010 with the blocks behind N40 as the sheet restores them.
const std::string kO0010 =
    "N10 G90 G00 X30.0 Y-30.0 Z0.0\nN20 G43.5 H1 P1\nN30 G42.6 D2\nN40 G01 X20.0 Y-20.0 I-1 J1 K2 F500\n"
    "N50 X20.0 Y20.0 I-1 J-1 K2\nN60 X-20.0 Y20.0 I1 J-1 K2\nN70 X-20.0 Y-20.0 I1 J1 K2\nN80 X20.0 Y-20.0 I-1 J1 K2\n"
    "N90 G40\nM30\n";

TEST(Example8, TheProgramAsAWholeOnThreeMachines) {
  const Done head = run(kHC, 100, kO0010, 4);
  EXPECT_EQ(of_line(head, 4, "V"),
            (Lines{"pre-turn: 0 0 1", "1/4: -0.108373643161723 0.108373643161723 0.988185360615968",
                   "1/2: -0.214186495298066 0.214186495298066 0.953020613871423",
                   "3/4: -0.314938275028657 0.314938275028657 0.895336677369998",
                   "start-up: -0.408248290463863 0.408248290463863 0.816496580927726"}));
  EXPECT_EQ(of_line(head, 4, "CB").front(), "pre-turn: -45 0");
  EXPECT_EQ(of_line(head, 4, "CB").back(), "start-up: -45 -35.2643896827547");
  EXPECT_EQ(of_line(head, 5, "CB").at(1), "1/2: 0 -26.565051177078");
  EXPECT_EQ(of_line(head, 5, "CB").at(3), "45 -35.2643896827547");
  EXPECT_EQ(of_line(head, 6, "CB").at(1), "1/2: 90 -26.565051177078");
  EXPECT_EQ(of_line(head, 6, "CB").at(3), "135 -35.2643896827547");
  EXPECT_EQ(of_line(head, 7, "CB").at(3), "225 -35.2643896827547");
  EXPECT_EQ(of_line(head, 8, "CB").at(3), "315 -35.2643896827547");
  EXPECT_EQ(of_line(head, 4, "P").back(), "start-up: 24.4721359549996 -20 2.23606797749979");
  EXPECT_EQ(of_line(head, 5, "P").at(3), "23.7267799624996 23.7267799624996 3.72677996249965");
  EXPECT_EQ(of_line(head, 6, "P").at(3), "-23.7267799624996 23.7267799624996 3.72677996249965");
  EXPECT_EQ(of_line(head, 7, "P").at(3), "-23.7267799624996 -23.7267799624996 3.72677996249965");
  EXPECT_EQ(of_line(head, 4, "XYZ").back(), "start-up: -16.3526930913867 20.8248290463863 83.8857260702724");
  EXPECT_EQ(of_line(head, 5, "XYZ").at(3), "-17.0980490838867 -17.0980490838867 85.3764380552723");
  EXPECT_EQ(of_line(head, 5, "P").at(1), "1/2: 24.0994579587496 1.86338998124982 2.98142396999972");
  EXPECT_EQ(of_line(head, 5, "XYZ").at(1), "1/2: -20.6219015912462 1.86338998124982 92.4241430699913");
  const Done table = run(kTAC, 100, kO0010, 0);
  const Done mixed = run(kMBC, 100, kO0010, 0);
  const std::vector<std::string> work_of_table{"45", "135", "225", "315", "405"};
  const std::vector<std::string> work_of_mixed{"-45", "45", "135", "225", "315"};
  for (std::uint64_t line = 4; line <= 8; ++line) {
    const Lines of_table = of_line(table, line, "AC");
    const Lines of_mixed = of_line(mixed, line, "BC");
    const std::string own = line == 4 ? "start-up: -35.2643896827547 " : "-35.2643896827547 ";
    EXPECT_EQ(of_table.back(), own + work_of_table[line - 4]);
    EXPECT_EQ(of_mixed.back(), own + work_of_mixed[line - 4]);
    if (line > 4) {
      EXPECT_EQ(of_line(table, line, "P").at(0), of_line(head, line, "P").at(3));
    }
  }
}

// The distance of tip and control point from the face 2x + z = 40 of N50, times √5.
TEST(Example8, FlankAndTipKeepTheRadiusFromTheFace) {
  const Done head = run(kHC, 100, kO0010, 16);
  std::size_t seen = 0;
  for (const model::Event& event : head.sink.events) {
    if (event.line != 5 || event.kind != spec::EventKind::sample) continue;
    ++seen;
    for (const auto* at : {&event.point, &event.axes}) {
      const exact::Real off = 2 * (*at)[0] + (*at)[2] - 40;
      const exact::Real error = off - 5 * sqrt(exact::Real(5));
      EXPECT_EQ(error.decimal(30), "0");
    }
  }
  EXPECT_EQ(seen, 15U);
}

// Every direction is taken as it was commanded, and only the branch and the whole turns from where the axes stand: the
// numbers of a block do not grow with the blocks before it.
TEST(Example3, ExactNumbersDoNotChain) {
  struct Counter final : model::EventSink {
    void on(const model::Event& event) override { moves += event.kind == spec::EventKind::move ? 1 : 0; }
    int moves = 0;
  };
  for (const std::string& machine : {kHC, kTAC, kN45}) {
    const spec::Setup setup = spec::read_setup_toml(
        "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"A\", \"B\", \"C\"]\n[parameters]\n" + machine,
        "setup.toml");
    std::string program = "G90 G00 X0 A10 B10\nG43.5 H0 P1\nG01 F500\n";
    for (int i = 0; i < 300; ++i)
      program += "X" + std::to_string(i % 7) + " I" + std::to_string(i % 5 + 1) + " J" + std::to_string(i % 11 - 5) +
                 " K" + std::to_string(i % 3 + 1) + ".7\n";
    Counter counter;
    model::Recorder recorder;
    model::Engine engine(setup, recorder, counter);
    spec::ProgramReader reader(spec::text_source(program), setup.axes);
    spec::Block block;
    std::size_t early = 0;
    std::size_t late = 0;
    while (!engine.stopped() && reader.next(block)) {
      engine.block(block);
      std::size_t& most = block.line < 100 ? early : late;
      most = std::max(most, exact::live_nodes());
    }
    engine.end();
    EXPECT_GT(counter.moves, 300);
    EXPECT_LE(late, early + early / 4);
    EXPECT_LT(late, 400U);
  }
}

TEST(Example9, TableWithOffsets) {
  const Done done = run(kTAC + "19702 = -100\n19704 = 30\n19705 = 50\n", 100,
                        "G90 G00 X30 Y-30 Z0\nG43.5 H1 P1\nG01 X20 Y-20 I-1 J1 K2 F500\nX20 Y20 I-1 J-1 K2\n", 4,
                        "[workpiece.G54]\nX = 5\nY = 10\nZ = 20\n");
  EXPECT_EQ(of_line(done, 2, "XYZ"), (Lines{"30 -30 100"}));
  EXPECT_EQ(of_line(done, 3, "AC").back(), "-35.2643896827547 45");
  EXPECT_EQ(of_line(done, 3, "XYZ", 14).back(), "-15.606601717798 -92.314902372249 68.763958906865");
  EXPECT_EQ(of_line(done, 4, "AC"), (Lines{"1/4: -28.9872466142404 64.488330009362", "1/2: -26.565051177078 90",
                                           "3/4: -28.9872466142404 115.511669990638", "-35.2643896827547 135"}));
  EXPECT_EQ(
      of_line(done, 4, "XYZ", 13),
      (Lines{"1/4: -21.30755422116 -72.95017405019 82.31002896252", "1/2: -25 -59.193495505 89.56733089749",
             "3/4: -24.7923489481 -57.88054450893 90.65887658718", "-22.67766952966 -69.22089160466 85.09389052542"}));
  // The last move also in machine coordinates.
  EXPECT_EQ(values(done, done.sink.events.back().machine, "XYZ", 15),
            "-17.6776695296637 -59.220891604664 105.093890525419");
}

TEST(Example11, LeanTowardTheTravel) {
  const Done along_x = run(kHC, 100, "G90 G00 X0 Y0 Z0\nG43.5 H1 P0 Q2\nG01 X10 K1 F500\n", 0);
  EXPECT_EQ(of_line(along_x, 3, "V"), (Lines{"0.034899496702501 0 0.999390827019096"}));
  EXPECT_EQ(of_line(along_x, 3, "CB"), (Lines{"0 2"}));
  const Done along_y = run(kHC, 100, "G90 G00 X0 Y0 Z0 C100\nG43.5 H1 P0 Q3\nG01 Y10 I-1 J1 K2 F500\n", 0);
  EXPECT_EQ(of_line(along_y, 3, "V"), (Lines{"-0.398133605769323 0.45546477337505 0.796267211538646"}));
  EXPECT_EQ(of_line(along_y, 3, "CB"), (Lines{"131.157551336705 37.2248886695106"}));
}

TEST(Example11, HeadOffsets) {
  const std::string offsets = "19711 = 40\n19712 = 25\n19714 = 60\n19666 = 30\n";
  const Done done = run(kHC + offsets, 100, "G90 G00 X30 Y-30 Z0\nG43.5 H1 P0\nG01 X20 Y-20 I-1 J1 K2 F500\n", 0);
  EXPECT_EQ(of_line(done, 3, "CB"), (Lines{"-45 -35.2643896827547"}));
  EXPECT_EQ(of_line(done, 3, "XYZ"), (Lines{"-31.724539849193 31.724539849193 198.804418757713"}));
}

TEST(Example11, OppositeVectorsRunConventionally) {
  const Done done = run(kHC, 100, "G90 G00 X0 Y0 Z0 B30\nG43.4 H1 P1\nG01 C180 B150 F500\n", 4);
  EXPECT_EQ(of_line(done, 3, "CB"), (Lines{"1/4: 45 60", "1/2: 90 90", "3/4: 135 120", "180 150"}));
  EXPECT_EQ(of_line(done, 3, "V").at(0), "1/4: 0.612372435695795 0.612372435695795 0.5");
  EXPECT_EQ(of_line(done, 3, "V").at(1), "1/2: 0 1 0");
}

}  // namespace

// G37, G45 to G48 and cutter compensation B: the vectors written by hand hold the worked examples of 14.2, 14.3
// and 14.4, typed in from the derivation. Figures that is without are worked out by hand: d times the unit normal of a
// block at its end.
#include "tests/golden/rows.h"

namespace toolcomp::corpus {
namespace {

using rows::expect;
using rows::Rows;

// Approach to B at 220, the measuring move, the setting, the retraction to 204.
TEST(LengthMeasurementVectors, WorkedExamples) {
  const auto measured = [](const std::string& touch, const std::string& setting) {
    return Rows{"2 p G0 850 0 760", "4 p G0 850 0 220", "4 m G1 850 0 " + touch, "4 " + setting, "5 p G0 850 0 204"};
  };
  const auto failed = [](const std::string& end) {
    return Rows{"2 p G0 850 0 760", "4 p G0 850 0 220", "4 m G1 850 0 " + end, "4 PS0080"};
  };
  expect("fanuc/tool-length-measurement", "examples",
         {{"14.2, G37 Z200 touched at 198", measured("198", "H1=13")},
          {"14.2, touched at 205, the near end", measured("205", "H1=20")},
          {"14.2, touched at 195, the far end", measured("195", "H1=10")},
          {"14.2, touched at 206", failed("206")},
          {"14.2, touched at 205.001", failed("205.001")},
          {"14.2, no signal", failed("195")},
          {"14.2, memory B", measured("198", "H1.wear=-2")},
          {"14.2, memory C", measured("198", "H1.wear=-1.5")},
          {"14.2, H in the block of G37", {"2 PS0082"}},
          {"14.2, no H number", {"1 PS0081"}},
          {"14.2, G37 under G91", {"2 PS0083"}},
          {"14.2, G37 with two axes", {"2 PS0083"}}});
}

TEST(ToolOffsetVectors, WorkedExamples) {
  const auto along_x = [](std::initializer_list<const char*> points) {
    Rows rows;
    std::size_t line = 2;
    for (const char* x : points) rows.push_back(std::to_string(line++) + " p G1 " + x + " 0");
    return rows;
  };
  expect("fanuc/tool-offset", "examples",
         {{"Table 14.1, G45", along_x({"1010", "2000", "990", "0"})},
          {"Table 14.1, G46", along_x({"990", "2000", "1010", "0"})},
          {"Table 14.1, G47", along_x({"1020", "2000", "980", "0"})},
          {"Table 14.1, G48", along_x({"980", "2000", "1020", "0"})},
          {"Travel 0 under G91, offset 12.34, G45", along_x({"12.34", "0"})},
          {"Travel 0 under G91, offset 12.34, G46", along_x({"-12.34", "0"})},
          {"Travel 0 under G91, offset 12.34, G47", along_x({"24.68", "0"})},
          {"Travel 0 under G91, offset 12.34, G48", along_x({"-24.68", "0"})},
          {"14.3, G45 X1000 Y500", {"1 p G1 1200 700"}},
          {"14.3, G45 X220 Y60", {"1 p G0 270 110"}},
          {"14.3, G45 X100 Y40", {"1 p G1 130 70"}},
          {"14.3, the manual's figure",
           {"1 p G0 70 40", "2 p G1 140 40", "3 p G1 140 80", "4 p G1 160 80", "5 p G1 160 40", "6 p G1 200 40",
            "7 p G3 240 80 O 200 80 w 90", "8 p G1 240 110", "9 p G1 230 110", "10 p G2 210 130 O 230 130 w 90",
            "11 p G1 210 140", "12 p G1 70 140", "13 p G1 70 40", "14 p G0 0 0"}},
          {"14.3, the shift stays", {"1 p G0 160 0", "2 p G0 210 0", "3 p G0 250 0", "4 p G0 250 0"}},
          {"14.3, three quarters of a circle", {"1 p G2 40 -40 O 40 0 w 270"}},
          {"14.3, an offset greater than the travel", {"1 p G0 -1.2 0"}},
          {"14.3, G48 X20", {"1 p G0 -10 0"}},
          {"14.3, D0 has no offset", {"1 p G0 50 0"}},
          {"14.3, G45 under G41", {"1 s G1 50 10", "2 PS0042"}}});
}

TEST(CutterBVectors, WorkedExamples) {
  expect(
      "fanuc/cutter-compensation-b", "examples",
      {{"14.4 example 1", {"1 s G0 22 46"}},
       {"14.4 example 2", {"1 s G0 20 40"}},
       {"14.4 example 3", {"1 s G0 38 34"}},
       {"14.4 example 4", {"1 s G0 22.92893218813452 47.07106781186548"}},
       {"14.4 example 6, the manual's figure",
        {"1 s G0 15 20 0", "2 p G1 15 20 -25", "3 p G1 15 60 -25",
         "4 c G2 17.76393202250021 64.47213595499958 -25 O 20 60 w 63.434948822922",
         "5 p G1 57.76393202250021 84.47213595499958 -25", "6 c G2 60 85 -25 O 60 80", "7 p G2 105 40 -25 O 60 40 w 90",
         "8 p G2 80 15 -25 O 80 40 w 90", "9 p G1 20 15 -25", "10 p G0 20 15 0", "11 e G0 0 0 0"}},
       {"14.4 example 6 with H08 = 10",
        {"1 s G0 10 20 0", "2 p G1 10 20 -25", "3 p G1 10 60 -25",
         "4 c G2 15.52786404500042 68.94427190999916 -25 O 20 60", "5 p G1 55.52786404500042 88.94427190999916 -25",
         "6 c G2 60 90 -25 O 60 80", "7 p G2 110 40 -25 O 60 40", "8 p G2 80 10 -25 O 80 40", "9 p G1 20 10 -25",
         "10 p G0 20 10 0", "11 e G0 0 0 0"}},
       {"14.4 example 7", {"1 s G1 5 60", "2 c G3 0 65 O 0 60", "3 p G1 -40 65"}},
       {"14.4 example 8", {"1 s G1 40 10", "2 p G1 80 -10"}},
       {"14.4, G40 alone", {"1 s G1 40 10", "2 e G1 40 0"}},
       {"14.4, a negative value", {"1 s G0 38 34"}},
       {"14.4, no intersection at a corner", {"1 s G1 40 10", "2 p G1 30 30"}},
       {"14.4, a block without movement in the plane", {"1 s G1 40 10 0", "2 p G1 40 10 5"}},
       {"14.4, another value in G01", {"1 s G1 40 10", "2 p G1 80 4"}},
       {"14.4, an arc at the start-up", {"1 PS0034"}},
       {"14.4, G39 outside the mode", {"1 p G1 10 0", "2 PS0035"}},
       {"14.4, the plane changes", {"1 s G1 40 10", "2 PS0037"}},
       {"14.4, G45 in the mode", {"1 s G1 40 10", "2 PS0042"}}});
}

TEST(LengthMeasurementVectors, Rules) {
  expect("fanuc/tool-length-measurement", "rules",
         {{"The tool stands on", {"2 p G0 0 0 200", "3 fanuc.length-measurement.start-on-the-coordinate"}},
          {"The block starts at B", {"2 p G0 0 0 220", "3 m G1 0 0 198", "3 H1=13"}},
          {"The signal comes on exactly", {"2 p G0 0 0 220", "2 PS0080"}},
          {"G44 is in force, H1 = 15: ", {"1 p G0 0 0 760", "2 p G0 0 0 220", "2 m G1 0 0 213", "2 PS0080"}},
          {"G44 is in force, H1 = 15, signal", {"1 p G0 0 0 760", "2 p G0 0 0 220", "2 m G1 0 0 198", "2 H1=13"}},
          {"G43 in the block of G37", {"2 MEASUREMENT_FORMAT"}},
          {"G43 and H in the block of G37", {"1 PS0082"}},
          {"G37 in cutter compensation", {"2 s G1 50 10", "3 PS0036"}}});
}

TEST(ToolOffsetVectors, Rules) {
  expect("fanuc/tool-offset", "rules",
         {{"TPH = 1", {"1 p G0 54 0"}},
          {"G53 takes the shift", {"1 p G0 60 0", "2 p G0 0 0", "3 p G0 20 0"}},
          {"G53 of another axis", {"1 p G0 60 0 0", "2 p G0 60 0 5", "3 p G0 80 0 5"}},
          {"A quarter of a circle", {"1 p G3 0 0 O 0 0"}},
          {"A radius below 0", {"1 PS0038"}},
          {"An arc that is no quarter", {"1 G45_ARC"}},
          {"A number beyond the memory", {"1 PS0030"}}});
}

TEST(CutterBVectors, Rules) {
  // The start-up of the last one: d times the left normal of (40, -10).
  expect("fanuc/cutter-compensation-b", "rules",
         {{"I0 J0 is no direction", {"1 s G1 40 10", "2 p G1 40 40"}},
          {"A travel of zero", {"1 s G1 40 10", "2 p G1 40 10"}},
          {"The code of the side", {"1 s G1 40 10", "2 p G1 30 30"}},
          {"A new number in an arc block", {"1 s G1 40 10", "2 PS0034"}},
          {"A tangent arc of R10", {"1 s G1 40 10", "2 p G3 40 10 O 40 10"}},
          {"An arc that ends in its centre", {"1 s G1 40 10", "2 PS0038"}},
          {"G53 of an axis outside", {"1 s G1 40 10 0", "2 p G0 40 10 5", "3 p G1 80 10 5"}},
          {"The vector (-10, 0) at the end",
           {"1 s G1 42.42535625036333 -0.298574998546681", "2 p G1 30 10",
            "3 p G3 80 50 O 40 50 r 41.2310562561766 40"}}});
}

}  // namespace
}  // namespace toolcomp::corpus

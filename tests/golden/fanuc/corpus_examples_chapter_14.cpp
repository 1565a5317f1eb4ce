// SPDX-License-Identifier: Apache-2.0
// G37 and G45 to G48: the vectors written by hand hold the worked examples of 14.2 and 14.3, typed in from the
// derivation. Of the rules, and of cutter compensation B, figures stand beside the examples (golden/figures.cpp).
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

}  // namespace
}  // namespace toolcomp::corpus

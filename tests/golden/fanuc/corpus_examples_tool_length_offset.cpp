// Tool length offset: the worked examples of 14.1.1, 14.1.2 and 14.8, and the rules. Every figure is typed in from
// the derivation or worked out by hand in the vector's comment.
#include "tests/golden/rows.h"

namespace toolcomp::corpus {
namespace {

using rows::expect;
using rows::Rows;

TEST(LengthOffsetVectors, WorkedExamples) {
  expect("fanuc/tool-length-offset", "examples",
         {{"14.1.1, three holes",
           {"1 G0 X120 Y80 Z0", "2 G0 X120 Y80 Z-36", "3 G1 X120 Y80 Z-57", "5 G0 X120 Y80 Z-36", "6 G0 X150 Y30 Z-36",
            "7 G1 X150 Y30 Z-77", "8 G0 X150 Y30 Z-36", "9 G0 X200 Y60 Z-36", "10 G1 X200 Y60 Z-61",
            "12 G0 X200 Y60 Z0", "13 G0 X0 Y0 Z0"}},
          {"14.1.1, H1 = 20, then H2 = 30", {"1 X0 Y0 Z120", "2 X0 Y0 Z130"}},
          {"14.1.1, OFH = 0", {"2 X0 Y0 Z-10", "3 X0 Y0 Z-37", "4 X0 Y0 Z-33"}},
          {"14.1.1, OFH = 1", {"2 X0 Y0 Z-20", "3 X0 Y0 Z-37"}},
          {"14.1.1, G91", {"2 X0 Y0 Z-5", "3 X0 Y0 Z-12"}},
          {"14.1.1, type C, TAL = 0", {"1 X14 Y0 Z0", "2 X16 Y0 Z0", "3 PS0027"}},
          {"14.1.1, type C, TAL = 1", {"1 X14 Y0 Z0", "2 X16 Y0 Z0", "3 X16 Y2 Z0", "4 X16 Y4 Z0"}},
          {"14.1.1, G49 alone", {"1 X0 Y0 Z120", "2 X0 Y0 Z100"}},
          // Work zero at machine Z-300: a machine position of the comment plus 300.
          {"14.1.2, work zero", {"1 X0 Y0 Z20", "2 X0 Y0 Z70", "3 X0 Y0 Z290", "4 X0 Y0 Z50", "5 X0 Y0 Z70"}},
          {"14.1.2, the same with EVO = 1", {"1 X0 Y0 Z20", "2 X0 Y0 Z70", "3 X0 Y0 Z290", "4 X0 Y0 Z70"}},
          {"14.1.2, G53 X0", {"1 X0 Y0 Z20", "2 X0 Y0 Z70", "3 X0 Y0 Z70", "4 X0 Y0 Z70"}},
          {"14.1.2, G28 Z80", {"1 X0 Y0 Z70", "2 X0 Y0 Z100", "2 X0 Y0 Z300", "3 X0 Y0 Z50"}},
          {"14.1.2, G49 G28 Z80", {"1 X0 Y0 Z70", "2 X0 Y0 Z80", "2 X0 Y0 Z300", "3 X0 Y0 Z50"}},
          {"14.1.2, type B",
           {"1 p G0 X4 Y0 Z0", "2 p G0 X4 Y0 Z20", "3 r G0 X4 Y0 Z100", "3 r G0 X0 Y0 Z0", "4 p G0 X5 Y0 Z5",
            "5 p G0 X5 Y0 Z25"}},
          {"14.1.2, EVO = 1", {"1 X0 Y0 Z70", "2 X0 Y0 Z290", "3 X10 Y0 Z290", "4 X50 Y0 Z310"}},
          {"14.8, memory C", {"1 X0 Y0 Z100.25", "2 H5.wear=-0.2", "3 X0 Y0 Z100.3"}},
          {"14.8, memory A", {"1 H3=12", "2 X0 Y0 Z12"}},
          {"14.8, a wear of 100 mm", {"1 PS0032"}},
          {"14.8, number 1000", {"1 PS0031"}}});
}

TEST(LengthOffsetVectors, Rules) {
  expect("fanuc/tool-length-offset", "rules",
         {{"Arcs by I J",
           {"1 X0 Y0 Z20", "2 X10 Y0 Z20", "3 X0 Y10 Z20 O 0 0 w 90", "4 X-20 Y0 Z20 O 0 0 r 10 20 w 90",
            "5 X10 Y0 Z20 O 0 0 r 20 10 w 180", "6 X0 Y0 Z20 O 0 0 r 10 0 w 0"}},
          {"Arcs by R", {"1 X20 Y0 Z0 O 10 0 w 180", "2 X10 Y0 Z0 O 15 -8.660254037844386 w 300", "3 PS0023"}},
          {"R with the start", {"1 PS0023"}},
          {"An arc without centre", {"1 PS0023"}},
          {"Geometry 999.999", {"1 PS0029"}},
          {"G10 without R", {"2 X0 Y0 Z20", "3 H1=7", "4 X0 Y0 Z7"}},
          {"After G53 an H", {"1 X0 Y0 Z70", "2 X0 Y0 Z-10", "4 X0 Y0 Z50", "5 X0 Y0 Z57"}},
          {"G49 while three axes", {"1 X4 Y0 Z0", "2 X4 Y7 Z0", "3 X4 Y7 Z20", "4 PS0015"}},
          {"EVO = 1: X5 brings back",
           {"1 X0 Y0 Z15", "2 X0 Y0 Z25", "2 X0 Y0 Z100", "3 X5 Y0 Z105", "4 H1=7", "5 X6 Y0 Z107", "6 X7 Y0 Z107"}},
          {"Type C without an axis", {"1 PS0027"}},
          {"An H beyond", {"1 PS0030"}},
          {"G53 under G91", {"1 X0 Y0 Z20", "3 X0 Y0 Z20"}},
          {"OFH = 1, the first G43", {"2 X0 Y0 Z5", "3 X0 Y0 Z25", "4 X0 Y0 Z26"}}});
}

}  // namespace
}  // namespace toolcomp::corpus

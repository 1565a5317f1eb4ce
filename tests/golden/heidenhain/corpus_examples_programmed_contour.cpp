// SPDX-License-Identifier: Apache-2.0
// The vectors of the programmed contour hold the figures of the worked examples E9, E10, E13, E16 under IS CONTOUR, and
// E1 at its contact point, to the last digit typed in. The figures of the rules are by hand from
// heidenhain.contour.nominal-tip and heidenhain.peripheral.direction, checked by a computation with 70 digits that
// shares nothing with the engines.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/golden/heidenhain/space_rows.h"

namespace toolcomp::corpus {
namespace {

constexpr const char* kSection = "heidenhain/programmed-contour";

TEST(ProgrammedContourVectors, Examples) {
  const std::vector<worked::Example> table = {
      {"E9 and E10 under RL",
       {"3 start-up tip=48.4073700528354,108.01588519507885,-5.090877672017165 "
        "shift=0.000000507579061,-0.093969240594557,-0.034202073355641 "
        "axes=48.4073700528354,108.01588519507885,-5.090877672017165 "
        "axis=0.012071843178365,-0.341995753836205,0.939623954015798 B=-20.0115 C=-267.9784",
        "4 programmed tip=60.659270036811243,108.013176869339626,-5.083254797428416 "
        "shift=0.000000507850657,-0.093969099480333,-0.034202461060535 "
        "axes=60.659270036811243,108.013176869339626,-5.083254797428416 "
        "axis=-0.080702224991015,-0.340909399001698,0.93662582312992"}},
      {"E9 and E10 under RR",
       {"3 start-up tip=48.4074299471646,96.92751480492115,-9.126722327982835 "
        "shift=-0.000000507579061,0.093969240594557,0.034202073355641 "
        "axes=48.4074299471646,96.92751480492115,-9.126722327982835 "
        "axis=0.012071843178365,-0.341995753836205,0.939623954015798 B=-20.0115 C=-267.9784",
        "4 programmed tip=60.659329963188757,96.924823130660374,-9.119145202571584 "
        "shift=-0.000000507850657,0.093969099480333,0.034202461060535 "
        "axes=60.659329963188757,96.924823130660374,-9.119145202571584 "
        "axis=-0.080702224991015,-0.340909399001698,0.93662582312992"}},
      {"E13: normal and tool",
       {"4 programmed tip=10,20,5 shift=0,0,0 tool=0,0,0.05 axes=10,20,5.05 center=10,20,5.98 normal=0,0,1 "
        "contact=10,20,5 flat"}},
      {"E16: the tool touches",
       {"3 programmed tip=4.46,0,-0.42 shift=0.26,0,-0.02 tool=0.26,0,0.23 axes=4.46,0,-0.17 center=4.46,0,1.68 "
        "normal=0.6,0,0.8 contact=0,0,0"}},
      {"E16 at its contact",
       {"3 programmed tip=0.26,0,-0.02 shift=0.26,0,-0.02 tool=0.26,0,0.23 axes=0.26,0,0.23 center=0.26,0,2.08 "
        "normal=0.6,0,0.8 contact=-4.2,0,0.4"}},
      {"Block 13 of face milling",
       {"3 W_DIGITS",
        "3 programmed tip=36.054981069776461,6.24258845869536,-1.933902321076868 "
        "shift=0.046581069776461,0.06558845869536,-0.013002321076868 "
        "axes=36.054981069776461,6.24258845869536,-1.933902321076868 "
        "center=36.054981069776461,8.144653760860809,0.255195115379139 normal=-0.465810697764609,0,0.884884395753506 "
        "axis=0,0.655884586953603,0.75486118498483 contact=37.405832093293828,8.144653760860809,-2.310969632306029"}},
  };
  space::expect(kSection, "examples", table);
}

TEST(ProgrammedContourVectors, Rules) {
  const std::vector<worked::Example> table = {
      {"From IS CONTOUR to",
       {"2 programmed tip=0.74,2,3.02 shift=-0.26,0,0.02 contact=-3.2,2,3.4",
        "4 programmed tip=4.94,2,2.62 shift=-0.26,0,0.02 contact=1,2,3", "5 programmed tip=5,2,3",
        "7 programmed tip=4.94,2,2.62 shift=-0.26,0,0.02 contact=1,2,3",
        "9 programmed tip=0.74,2,3.02 shift=-0.26,0,0.02 contact=-3.2,2,3.4"}},
      {"CNT-CNT has no effect",
       {"4 programmed tip=4.94,2,2.62 shift=-0.26,0,0.02 contact=1,2,3", "5 programmed tip=5,2,1",
        "6 programmed tip=1,2,3 axis=0.6,0,0.8 contact=1,2,3 flat"}},
      {"Round a square under",
       {"4 programmed tip=0,-10,-2", "5 start-up tip=0,4.7,0 shift=0,-0.3,0",
        "6 programmed tip=15.3,4.7,0 shift=0.3,-0.3,0", "7 programmed tip=15.3,15.3,0 shift=0.3,0.3,0",
        "8 programmed tip=0,15.3,0 shift=0,0.3,0", "9 cancel tip=0,-10,-2"}},
      {"Outside it under RR",
       {"3 programmed tip=0,-10,0", "4 start-up tip=0,-4.7,0 shift=0,0.3,0",
        "5 programmed tip=24.7,-4.7,0 shift=-0.3,0.3,0", "6 programmed tip=24.7,24.7,0 shift=-0.3,-0.3,0",
        "7 programmed tip=0,24.7,0 shift=0,-0.3,0", "8 cancel tip=0,-10,0"}},
      {"IS CONTOUR begins and",
       {"2 programmed tip=0,-10,0", "3 start-up tip=0,-0.1,0 shift=0,-0.1,0",
        "4 programmed tip=20.1,-0.1,0 shift=0.1,-0.1,0", "6 programmed tip=14.1,14.1,0 shift=0.1,0.1,0",
        "8 programmed tip=0,20.1,0 shift=0,0.1,0", "9 cancel tip=0,40,0"}},
      {"The nominal radius",
       {"3 programmed tip=0,-10,0", "4 start-up tip=0,6,0", "5 programmed tip=20,6,0", "6 cancel tip=20,20,0"}},
      {"A corner radius beyond", {"3 programmed tip=2.98,2,2.34 shift=0.18,0,-0.06 contact=1,2,3"}},
      {"The flat touches: the", {"3 W_NOT_NORMALIZED", "3 programmed tip=1,2,3 contact=1,2,3 flat"}},
      {"An undercut.", {"3 W_N_BELOW", "3 programmed tip=4.94,2,-0.42 shift=-0.26,0,0.18 contact=1,2,3"}},
      {"A table of deviations", {"3 programmed tip=3.96,2,0.04 shift=-0.04,0,0.04 contact=1,2,3 angle=90"}},
      {"A program in inches",
       {"4 programmed tip=5.24,2,2.62 shift=0.04,0,0.02 contact=1,2,3", "5 programmed tip=0,-10,3",
        "6 start-up tip=0,5,3", "7 programmed tip=20,5,3"}},
      {"LN without a normal", {"3 W_NO_LATERAL", "3 programmed tip=1,2,3"}},
      {"RL without TCPM stays", {"3 OUT_OF_SCOPE", "4 programmed tip=2,0,0"}},
  };
  space::expect(kSection, "rules", table);
}

// E16 is rational: the fractions by hand.
TEST(ProgrammedContourVectors, Fractions) {
  const spec::TextEvent& e16 = worked::vector_of(kSection, "examples", "E16: ").expect.back();
  EXPECT_EQ(e16.point[0].q, "223/50");
  EXPECT_EQ(e16.point[2].q, "-21/50");
  EXPECT_EQ(e16.axes[2].q, "-17/100");
}

}  // namespace
}  // namespace toolcomp::corpus

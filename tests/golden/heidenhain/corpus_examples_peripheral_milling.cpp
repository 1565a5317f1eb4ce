// SPDX-License-Identifier: Apache-2.0
// The vectors of peripheral milling hold the figures of the worked examples E8, E9 and E10, to the last digit typed in.
// The figures of the rules are by hand from heidenhain.peripheral.direction (tool along Z: -0.1 of the left of the
// travel), checked by a computation with 70 digits that shares nothing with the engines.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/golden/heidenhain/space_rows.h"

namespace toolcomp::corpus {
namespace {

constexpr const char* kSection = "heidenhain/peripheral-milling";

TEST(PeripheralMillingVectors, Examples) {
  const std::vector<worked::Example> table = {
      {"E8: block 12, LN with",
       {"2 programmed tip=60.659300214108896,102.375030908653109,-7.135402483409745 "
        "shift=0.000000214108896,-0.093969091346891,-0.034202483409745 "
        "axes=60.659300214108896,102.375030908653109,-7.135402483409745 normal=0,0.939699957713503,0.341999984610001 "
        "axis=-0.080702224991015,-0.340909399001698,0.93662582312992 "
        "contact=60.659312846533784,96.83085451918656,-9.153349004584695"}},
      {"E9 and E10: blocks",
       {"2 start-up tip=48.407400507579061,102.377730759405443,-7.143002073355641 "
        "shift=0.000000507579061,-0.093969240594557,-0.034202073355641 "
        "axes=48.407400507579061,102.377730759405443,-7.143002073355641 "
        "axis=0.012071843178365,-0.341995753836205,0.939623954015798 B=-20.0115 C=-267.9784",
        "3 programmed tip=60.659300507850657,102.375030900519667,-7.135402461060535 "
        "shift=0.000000507850657,-0.093969099480333,-0.034202461060535 "
        "axes=60.659300507850657,102.375030900519667,-7.135402461060535 "
        "axis=-0.080702224991015,-0.340909399001698,0.93662582312992"}},
      {"E9 and E10 under RR",
       {"2 start-up tip=48.407399492420939,102.565669240594557,-7.074597926644359 "
        "shift=-0.000000507579061,0.093969240594557,0.034202073355641 "
        "axes=48.407399492420939,102.565669240594557,-7.074597926644359 "
        "axis=0.012071843178365,-0.341995753836205,0.939623954015798 B=-20.0115 C=-267.9784",
        "3 programmed tip=60.659299492149343,102.562969099480333,-7.066997538939465 "
        "shift=-0.000000507850657,0.093969099480333,0.034202461060535 "
        "axes=60.659299492149343,102.562969099480333,-7.066997538939465 "
        "axis=-0.080702224991015,-0.340909399001698,0.93662582312992"}},
      {"E10 under R0: block",
       {"2 programmed tip=48.4074,102.4717,-7.1088 shift=0,0,0 axes=48.4074,102.4717,-7.1088 "
        "axis=0.012071843178365,-0.341995753836205,0.939623954015798 B=-20.0115 C=-267.9784",
        "3 W_NO_LATERAL",
        "3 programmed tip=60.6593,102.469,-7.1012 shift=0,0,0 axes=60.6593,102.469,-7.1012 "
        "axis=-0.080702224991015,-0.340909399001698,0.93662582312992"}},
      {"Blocks 11, 12 and 13",
       {"2 start-up tip=48.407400507579061,102.377730759405443,-7.143002073355641 "
        "shift=0.000000507579061,-0.093969240594557,-0.034202073355641 "
        "axes=48.407400507579061,102.377730759405443,-7.143002073355641 "
        "axis=0.012071843178365,-0.341995753836205,0.939623954015798 B=-20.0115 C=-267.9784",
        "3 cancel tip=60.659300214108896,102.375030908653109,-7.135402483409745 "
        "shift=0.000000214108896,-0.093969091346891,-0.034202483409745 "
        "axes=60.659300214108896,102.375030908653109,-7.135402483409745 normal=0,0.939699957713503,0.341999984610001 "
        "axis=-0.080702224991015,-0.340909399001698,0.93662582312992 "
        "contact=60.659312846533784,96.83085451918656,-9.153349004584695",
        "4 W_NO_LATERAL",
        "4 programmed tip=60.6593,102.469,-7.1012 shift=0,0,0 axes=60.6593,102.469,-7.1012 "
        "axis=-0.080702224991015,-0.340909399001698,0.93662582312992"}},
  };
  space::expect(kSection, "examples", table);
}

TEST(PeripheralMillingVectors, Rules) {
  const std::vector<worked::Example> table = {
      {"Round a square under",
       {"2 programmed tip=0,-10,0", "3 start-up tip=0,-0.1,0 shift=0,-0.1,0",
        "4 programmed tip=20.1,-0.1,0 shift=0.1,-0.1,0", "5 programmed tip=20.1,20.1,0 shift=0.1,0.1,0",
        "6 programmed tip=0,20.1,0 shift=0,0.1,0", "7 cancel tip=0,-10,0"}},
      {"The same under RR.",
       {"2 programmed tip=0,-10,0", "3 start-up tip=0,0.1,0 shift=0,0.1,0",
        "4 programmed tip=19.9,0.1,0 shift=-0.1,0.1,0", "5 programmed tip=19.9,19.9,0 shift=-0.1,-0.1,0",
        "6 programmed tip=0,19.9,0 shift=0,-0.1,0", "7 cancel tip=0,-10,0"}},
      {"Nothing follows the first compensated block:",
       {"2 programmed tip=0,-10,0", "3 start-up tip=3.08,-6.06,0 shift=0.08,-0.06,0"}},
      {"Nothing follows the first compensated block,", {"2 programmed tip=0,-10,0", "3 E_NO_DIRECTION"}},
      {"An alarm follows the",
       {"2 programmed tip=0,-10,0", "3 start-up tip=3.08,-6.06,0 shift=0.08,-0.06,0", "4 E_SYNTAX"}},
      {"An alarm follows a", {"2 programmed tip=0,-10,0", "3 E_NO_DIRECTION"}},
      {"The first compensated",
       {"2 programmed tip=0,-10,0", "3 start-up tip=0,-0.1,0 shift=0,-0.1,0", "4 cancel tip=20,0,0",
        "5 programmed tip=30,0,0"}},
      {"An LN block with a",
       {"2 programmed tip=0,-10,0", "3 start-up tip=0,-0.1,0 shift=0,-0.1,0",
        "4 cancel tip=20,-0.1,0 shift=0,-0.1,0 contact=20,-6,0"}},
      {"M30 in a compensated",
       {"2 programmed tip=0,-10,0", "3 start-up tip=0,-0.1,0 shift=0,-0.1,0",
        "4 programmed tip=20,-0.1,0 shift=0,-0.1,0"}},
      {"END PGM after a",
       {"2 programmed tip=0,-10,0", "3 start-up tip=0,-0.1,0 shift=0,-0.1,0",
        "4 programmed tip=20,-0.1,0 shift=0,-0.1,0"}},
      {"RL from an L block",
       {"2 programmed tip=0,-10,0", "4 start-up tip=0,-0.1,0 shift=0,-0.1,0 feed=500",
        "6 programmed tip=20,-0.1,0 shift=0,-0.1,0 feed=500", "8 cancel tip=20,20,0 feed=500"}},
      {"Blocks without movement",
       {"2 programmed tip=0,-10,0", "3 start-up tip=0,-0.1,0 shift=0,-0.1,0",
        "4 programmed tip=20,-0.1,0 shift=0,-0.1,0", "5 programmed tip=20,-0.1,0 shift=0,-0.1,0",
        "6 programmed tip=20.1,-0.1,5 shift=0.1,-0.1,0", "7 programmed tip=20.1,20,5 shift=0.1,0,0",
        "8 programmed tip=20.1,20,5 shift=0.1,0,0", "9 cancel tip=0,20,5"}},
      {"A rotary word alone",
       {"2 programmed tip=0,-10,0", "3 start-up tip=0,-0.1,0 shift=0,-0.1,0",
        "4 programmed tip=20,-0.1,0 shift=0,-0.1,0",
        "5 programmed tip=20,-0.1,-0.026794919243112 shift=0,-0.1,-0.026794919243112 axis=0,-0.5,0.866025403784439 "
        "A=30",
        "6 programmed tip=40,-0.086602540378444,-0.05 shift=0,-0.086602540378444,-0.05 axis=0,-0.5,0.866025403784439",
        "7 cancel tip=40,0,50 axis=0,-0.5,0.866025403784439"}},
      {"No direction at the", {"2 programmed tip=0,-10,0", "3 E_NO_DIRECTION"}},
      {"Directions are forgotten",
       {"2 programmed tip=0,-10,0", "3 start-up tip=0,-0.1,0 shift=0,-0.1,0",
        "4 programmed tip=20,-0.1,0 shift=0,-0.1,0", "5 cancel tip=20,20,0", "6 E_NO_DIRECTION"}},
      {"A reversal under RL", {"2 programmed tip=0,-10,0", "3 start-up tip=0,-0.1,0 shift=0,-0.1,0", "4 E_REVERSAL"}},
      {"Nearly a reversal:",
       {"2 programmed tip=0,-10,0", "3 start-up tip=0,-0.1,0 shift=0,-0.1,0",
        "4 programmed tip=24.133333333333333,-0.1,0 shift=0.133333333333333,-0.1,0",
        "5 programmed tip=17.096,24.028,0 shift=0.096,0.028,0", "6 cancel tip=0,24,0"}},
      {"RL to RR at a reversal",
       {"2 programmed tip=0,-10,0", "3 start-up tip=0,-0.1,0 shift=0,-0.1,0",
        "4 programmed tip=20,-0.1,0 shift=0,-0.1,0", "5 programmed tip=5,-0.1,0 shift=0,-0.1,0", "6 cancel tip=5,5,0"}},
      {"RL to RR straight on", {"2 programmed tip=0,-10,0", "3 start-up tip=0,-0.1,0 shift=0,-0.1,0", "4 E_REVERSAL"}},
      {"RL to RR at a corner",
       {"2 programmed tip=0,-10,0", "3 start-up tip=0,-0.1,0 shift=0,-0.1,0",
        "4 programmed tip=19.9,-0.1,0 shift=-0.1,-0.1,0", "5 programmed tip=19.9,20,0 shift=-0.1,0,0",
        "6 cancel tip=0,20,0"}},
      {"The tool inclined by LN",
       {"2 programmed tip=0,-10,0 tool=0,0,0.5 axes=0,-10,0.5",
        "3 start-up tip=0,-0.08,0.06 shift=0,-0.08,0.06 tool=0,0.22,0.46 axes=0,0.22,0.46 axis=0,0.6,0.8",
        "4 programmed tip=20.1,-0.08,0.06 shift=0.1,-0.08,0.06 tool=0.1,0.22,0.46 axes=20.1,0.22,0.46 axis=0,0.6,0.8",
        "5 programmed tip=20.1,12.1,9 shift=0.1,0.1,0 tool=0.1,0.1,0.5 axes=20.1,12.1,9.5",
        "6 programmed tip=0,12.1,9 shift=0,0.1,0 tool=0,0.1,0.5 axes=0,12.1,9.5",
        "7 cancel tip=0,12,50 tool=0,0,0.5 axes=0,12,50.5"}},
      {"The tool inclined by rotary",
       {"2 programmed tip=0,-10,0",
        "3 start-up tip=0,-0.086602540378444,-0.05 shift=0,-0.086602540378444,-0.05 axis=0,-0.5,0.866025403784439 A=30",
        "4 programmed tip=20.1,-0.086602540378444,-0.05 shift=0.1,-0.086602540378444,-0.05 "
        "axis=0,-0.5,0.866025403784439",
        "5 programmed tip=20,20,-0.1 shift=0,0,-0.1 axis=1,0,0 A=0 B=90",
        "6 programmed tip=0,20.1,0 shift=0,0.1,0 axis=0.6,0,0.8",
        "7 programmed tip=-20,20.1,0 shift=0,0.1,0 axis=0.6,0,0.8", "8 cancel tip=-20,20,50 axis=0.6,0,0.8"}},
      {"A tool vector of any",
       {"2 programmed tip=0,-10,0", "3 W_NOT_NORMALIZED",
        "3 start-up tip=0,-0.08,0.06 shift=0,-0.08,0.06 axis=0,0.6,0.8", "4 W_NOT_NORMALIZED",
        "4 programmed tip=20,-0.08,0.06 shift=0,-0.08,0.06 axis=0,0.6,0.8"}},
      {"The delta of the former",
       {"2 programmed tip=0,-10,0", "3 start-up tip=0,-0.1,0 shift=0,-0.1,0",
        "4 programmed tip=20.1,-0.1,0 shift=0.1,-0.1,0", "6 programmed tip=20.4,20,0 shift=0.4,0,0",
        "7 cancel tip=0,20,0"}},
      {"Another DL acts along",
       {"2 programmed tip=0,-10,0 carrier=0,-10,75", "3 start-up tip=0,-0.1,0 shift=0,-0.1,0 carrier=0,-0.1,75",
        "5 programmed tip=20,-0.1,0 shift=0,-0.1,0 tool=0,-0.1,2 axes=20,-0.1,2 carrier=20,-0.1,77",
        "6 cancel tip=20,20,0 tool=0,0,2 axes=20,20,2 carrier=20,20,77"}},
      {"Under CNT-CNT the tip",
       {"3 programmed tip=0,-10,-1", "4 start-up tip=0,-0.1,-1 shift=0,-0.1,0",
        "5 programmed tip=20,-0.1,-1 shift=0,-0.1,0"}},
      {"A program in inches",
       {"3 programmed tip=0,-10,0", "4 start-up tip=0,-0.1,0 shift=0,-0.1,0",
        "5 programmed tip=20,-0.1,0 shift=0,-0.1,0", "6 cancel tip=20,20,0"}},
      {"DR 0.1 without M107", {"2 programmed tip=0,-10,0", "3 E_OVERSIZE_DR"}},
      {"DR 0.1 under M107:",
       {"2 programmed tip=0,-10,0", "3 start-up tip=0,0.1,0 shift=0,0.1,0", "4 programmed tip=20,0.1,0 shift=0,0.1,0",
        "5 cancel tip=20,20,0", "7 start-up tip=20,30,0", "8 programmed tip=0,30,0"}},
      {"R -1 in the table:", {"2 programmed tip=0,-10,0", "3 E_TOOL"}},
      {"No tool: L with R0", {"1 programmed tip=5,0,0", "2 E_NO_TOOL"}},
      {"RL before a tool call",
       {"2 programmed tip=0,-10,0", "3 start-up tip=0,-0.1,0 shift=0,-0.1,0",
        "4 programmed tip=20,-0.1,0 shift=0,-0.1,0", "6 cancel tip=30,0,0", "7 programmed tip=30,5,0"}},
      {"RL without TCPM: out", {"2 OUT_OF_SCOPE", "3 programmed tip=10,10,0"}},
      {"LN without a normal under RL", {"2 W_T_IGNORED", "2 OUT_OF_SCOPE", "3 programmed tip=10,10,0"}},
      {"TCPM ends under RL",
       {"2 programmed tip=0,-10,0", "3 start-up tip=0,-0.1,0 shift=0,-0.1,0",
        "4 programmed tip=20,-0.1,0 shift=0,-0.1,0", "5 OUT_OF_SCOPE", "6 programmed tip=0,20,0"}},
      {"RL before TCPM: the",
       {"2 OUT_OF_SCOPE", "3 start-up tip=10,9.9,0 shift=0,-0.1,0", "4 programmed tip=20,9.9,0 shift=0,-0.1,0",
        "5 cancel tip=20,0,0"}},
      {"DR 0.1: LN without", {"2 OUT_OF_SCOPE", "3 E_OVERSIZE_DR"}},
      {"LN without a normal under R0",
       {"2 W_DIGITS", "2 W_T_IGNORED", "2 W_NO_LATERAL",
        "2 programmed tip=10.000001,0,0 tool=0,0,0.5 axes=10.000001,0,0.5", "3 W_NOT_NORMALIZED", "3 W_NO_LATERAL",
        "3 programmed tip=10,0,0 tool=0,0.3,0.4 axes=10,0.3,0.4 axis=0,0.6,0.8"}},
      {"A block with a normal",
       {"2 programmed tip=0,-10,0", "3 start-up tip=0,-0.1,0 shift=0,-0.1,0",
        "4 programmed tip=20,-0.1,0 shift=0,-0.1,0", "5 cancel tip=20,19.9,0 shift=0,-0.1,0 contact=20,14,0",
        "6 start-up tip=0.1,20,0 shift=0.1,0,0", "7 programmed tip=0.1,40,0 shift=0.1,0,0"}},
      {"A normal at right angles", {"2 programmed tip=20,-0.1,0.02 shift=0,-0.1,0.02 contact=20,-6,1"}},
  };
  space::expect(kSection, "rules", table);
}

}  // namespace
}  // namespace toolcomp::corpus

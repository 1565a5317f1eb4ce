// SPDX-License-Identifier: Apache-2.0
// Leading edge offset: the worked examples LE1 to LE10 and the rules. Every figure is typed in from the derivation or
// worked out by hand in the vector's comment; fifteen decimals, as vectors have.
#include "tests/golden/rows.h"

namespace toolcomp::corpus {
namespace {

using rows::expect;
using rows::Rows;

const std::string kSection = "fanuc/leading-edge-offset";

TEST(LeadingEdgeVectors, WorkedExamples) {
  expect(kSection, "examples",
         {{"LE1:", {"1 X0 Y0 Z0", "2 X-8 Y0 Z6", "3 X92 Y0 Z6", "4 X100 Y0 Z0"}},
          {"LE2:", {"1 X0 Y0 Z0", "2 X8 Y0 Z6", "3 X108 Y0 Z6", "4 X100 Y0 Z0"}},
          {"LE5: B 15",
           {"1 X0 Y0 Z0", "2 X-5.635045313286907 Y1.75995760065834 Z1.071827206730735",
            "3 X34.364954686713093 Y-8.24004239934166 Z6.071827206730735", "4 X40 Y-10 Z5"}},
          {"LE5 the other way",
           {"1 X0 Y0 Z0", "2 X-5.635045313286907 Y1.75995760065834 Z1.071827206730735",
            "3 X-45.635045313286907 Y11.75995760065834 Z-3.928172793269265", "4 X-40 Y10 Z-5"}},
          {"LE7: VT along",
           {"1 X0 Y0 Z0", "2 X8 Y0 Z6", "3 X109.999500012499688 Y0 Z-0.099997500062498",
            "4 X209.999500012499688 Y0 Z-0.099997500062498", "5 X200 Y0 Z0"}},
          {"LE7 with VC backward before",
           {"1 X0 Y0 Z0", "2 X-8 Y0 Z6", "3 X90.000499987500312 Y0 Z0.099997500062498",
            "4 X190.000499987500312 Y0 Z0.099997500062498", "5 X200 Y0 Z0"}},
          {"LE7 with 19631 = 0.5",
           {"1 X0 Y0 Z0", "2 X8 Y0 Z6", "3 X90.000499987500312 Y0 Z0.099997500062498",
            "4 X190.000499987500312 Y0 Z0.099997500062498", "5 X200 Y0 Z0"}},
          {"LE9: exactly 90 twice",
           {"1 X0 Y0 Z0", "2 X-8 Y0 Z6", "3 X90 Y0 Z0", "4 X190 Y0 Z0", "5 X290 Y0 Z0", "6 X300 Y0 Z0"}},
          {"LE9 with VC forward before",
           {"1 X0 Y0 Z0", "2 X8 Y0 Z6", "3 X110 Y0 Z0", "4 X210 Y0 Z0", "5 X310 Y0 Z0", "6 X300 Y0 Z0"}},
          {"LE10: VM (60, 0, 80)", {"1 X0 Y0 Z0", "2 PS5408"}},
          {"LE10: VM (-60, 0, -80)", {"1 X0 Y0 Z0", "2 PS5408"}},
          {"A block without movement between",
           {"1 X0 Y0 Z0", "2 X-8 Y0 Z6", "3 X100 Y-10 Z0", "4 X100 Y-10 Z0", "5 X100 Y90 Z0", "6 X100 Y100 Z0"}},
          {"A movement along the",
           {"1 X0 Y0 Z0", "2 X-8 Y0 Z6", "3 X92 Y0 Z6", "4 X152 Y0 Z86", "5 X92 Y0 Z6", "6 X-8 Y0 Z6", "7 X0 Y0 Z0"}},
          {"A negative offset value", {"1 X0 Y0 Z0", "2 X8 Y0 Z-6", "3 X108 Y0 Z-6", "4 X100 Y0 Z0"}}});
}

TEST(LeadingEdgeVectors, ToolAxisOfLE5) {
  const Rows axis{"0.224143868042013", "0.12940952255126", "0.965925826289068"};
  worked::hold(worked::vector_of(kSection, "examples", "LE5: B 15"), [&](const auto& events) {
    ASSERT_TRUE(events.at(0).tool_axis.has_value());
    for (std::size_t i = 0; i < axis.size(); ++i) EXPECT_EQ(rows::as((*events[0].tool_axis)[i], axis, i), axis[i]);
  });
}

// LE7 is rational: the fractions by hand, to the last digit.
TEST(LeadingEdgeVectors, FractionsOfLE7) {
  const spec::Case& c = worked::vector_of(kSection, "examples", "LE7: VT along");
  EXPECT_EQ(c.expect[2].point[0].q, "4400090/40001");  // 100 + 399990/40001
  EXPECT_EQ(c.expect[2].point[2].q, "-4000/40001");
}

TEST(LeadingEdgeVectors, Rules) {
  const Rows start = {"1 X-10 Y0 Z0", "2 X-9 Y0 Z0"};  // VT = Z, VM = (1, 0, 0), exactly 90 at the start: backward
  const auto after_start = [&](const std::string& alarm) { return Rows{start[0], start[1], "3 " + alarm}; };
  expect(
      kSection, "rules",
      {{"19631 = 30",
        {"1 X0 Y0 Z0", "2 X-7.071067811865475 Y7.071067811865475 Z0",
         "3 X104.08248290463863 Y-4.08248290463863 Z8.16496580927726",
         "4 X94.08248290463863 Y-4.08248290463863 Z-1.83503419072274", "5 X90 Y0 Z-10"}},
       {"19631 = 45, VT (1, 0, 1), VM (100, 0, 0)", {"1 X0 Y0 Z0", "2 PS5408"}},
       {"19631 = 45, VT (1, 0, 1), VM (-100, 0, 0)", {"1 X0 Y0 Z0", "2 PS5408"}},
       {"19631 = 0", {"1 X0 Y0 Z0", "2 X-8 Y0 Z6", "3 X92 Y0 Z6", "4 X100 Y0 Z0"}},
       {"Two blocks without movement",
        {"1 X0 Y0 Z0", "2 X-8 Y0 Z6", "3 X92 Y0 Z6", "4 X92 Y0 Z6", "6 X190 Y0 Z0", "7 X200 Y0 Z0"}},
       {"M00 stops", {"1 X0 Y0 Z0", "2 X-8 Y0 Z6", "3 X92 Y0 Z6", "5 X100 Y90 Z0", "6 X100 Y100 Z0"}},
       {"Another D", {"1 X0 Y0 Z0", "2 X-8 Y0 Z6", "3 X104 Y0 Z-3", "4 X204 Y0 Z-3", "5 X200 Y0 Z0"}},
       {"D0 cancels", {"1 X0 Y0 Z0", "2 X-8 Y0 Z6", "3 X92 Y0 Z6", "4 X100 Y0 Z0", "6 X150 Y0 Z0"}},
       {"An axis word in the block of G41.3", {"1 PS5406"}},
       {"G41.3 under G02", {"2 PS5408"}},
       {"No movement after G41.3", {"1 PS5407"}},
       {"G41.3 again", after_start("PS5407")},
       {"G02 in the mode", after_start("PS5407")},
       {"G54 in the mode", after_start("FORBIDDEN_IN_3D_COMPENSATION")},
       {"An axis word in the block of G40", after_start("PS5406")},
       {"I J K all zero", {"1 PS5421"}},
       {"A rotary word under G43.5", {"1 PS5421"}},
       {"G43.5 under G02", {"1 TOOL_DIRECTION_FORMAT"}},
       {"G28 under G43.5", {"1 X0 Y0 Z0", "2 FORBIDDEN_UNDER_TOOL_DIRECTION"}},
       {"G43 under G43.5", {"1 X0 Y0 Z0", "2 LENGTH_OFFSET_EXCLUSION"}},
       // VT along (-1, 0, 1000): V = (VM . VT) VT - |VT|^2 VM, so VC = 10 (1000, 0, 1) / sqrt 1000001 for VM along X.
       {"VT nearly at right angles",
        {"1 X0 Y0 Z0", "2 X9.99999500000375 Y0 Z0.009999995000004", "3 X109.99999500000375 Y0 Z0.009999995000004",
         "4 X100 Y0 Z0"}}});
}

}  // namespace
}  // namespace toolcomp::corpus

// SPDX-License-Identifier: Apache-2.0
// MDI intervention in cutter compensation C (14.6.7): five examples. A(0,0) → B(40,0) → C(70,-40) →
// D(110,-40), G41, d = 10; the program stops at B.
#include "model/fanuc/cutter_compensation_c/intervention.h"

#include <gtest/gtest.h>

#include <string>

#include "spec/language/setup_format.h"

namespace {

using namespace toolcomp;
using namespace toolcomp::model;

std::string text(const PlanePoint& point) { return '(' + point[0].decimal(13) + ", " + point[1].decimal(13) + ')'; }

class ModelCutterCIntervention : public ::testing::Test {
 protected:
  Recorder recorder;
  CornerRules rules{recorder};

  // The heads at B and at C.
  std::string heads(const PlanePoint& moved, bool incremental = false) {
    Intervention stop;
    stop.stop = {40, 0};
    stop.end = {70, -40};
    stop.moved = moved;
    stop.incremental = incremental;
    stop.offset = 10;
    stop.next = line_path({40, 0}, 10, 10).start;
    const OffsetPath before = line_path({40, 0}, 10, 10);
    const OffsetPath block = line_path({30, -40}, 10, 10);
    stop.group = rules.offset_mode(before.end, block.start).value();
    const auto after = after_intervention(rules, stop);
    if (!after) return "none";
    std::string line;
    for (const PlanePoint& head : after->at_stop) line += text(head);
    line += " to ";
    for (const PlanePoint& head : after->at_end) line += text(head);
    return line;
  }
};

TEST_F(ModelCutterCIntervention, VectorsAtTheStopAreShifted) {
  EXPECT_EQ(heads({10, 20}), "(55, 30) to (77.2075922005613, -30)");
}

TEST_F(ModelCutterCIntervention, NothingMoved) {
  EXPECT_EQ(heads({0, 0}), "(45, 10) to (75, -30)");  // also MDI outside the plane
}

TEST_F(ModelCutterCIntervention, AlongTheBlock) { EXPECT_EQ(heads({3, -4}), "(48, 6) to (75, -30)"); }

TEST_F(ModelCutterCIntervention, IncrementalEndShiftsToo) { EXPECT_EQ(heads({10, 20}, true), "(55, 30) to (85, -10)"); }

TEST_F(ModelCutterCIntervention, NothingLeftOfTheBlock) { EXPECT_EQ(heads({30, -40}), "none"); }

}  // namespace

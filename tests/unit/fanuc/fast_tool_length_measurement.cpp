// SPDX-License-Identifier: Apache-2.0
// Tool length measurement G37 of the fast engine, by hand. The worked examples of 14.2 stand in
// golden/fanuc/corpus_examples_chapter_14.cpp.
#include <gtest/gtest.h>

#include "tests/unit/fanuc/fast_run.h"

namespace toolcomp::fast {
namespace {

std::string setup(const std::string& touch, const std::string& parameters = "", const std::string& rest = "") {
  std::string text = "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\",\"B\"]\n[parameters]\n\"6241\"=1000\n" +
                     parameters + "\n" + (rest.empty() ? "[offsets.H]\n1=15\n" : rest) + "\n[position]\nZ=760\n";
  if (!touch.empty()) text += "[measurement]\nZ=\"" + touch + "\"\n";
  return text;
}

// The last event but one is a setting: its name and value.
std::string written(const ProgramRun& run) {
  for (const Event& event : run.events)
    if (event.kind == spec::EventKind::setting) {
      std::string text = std::to_string(event.value);
      return std::string(event.setting.view()) + "=" + text;
    }
  return "";
}

TEST(ToolLengthMeasurement, BehindTheZone) {
  // The zone ends at 195; the signal a thousandth behind it is none.
  const ProgramRun run(setup("194.999"), "H1\nG37 Z200\n");
  EXPECT_EQ(run.point(1, 'Z'), 195);
  EXPECT_EQ(run.alarm(), "PS0080@2");
  EXPECT_EQ(run.events[1].type, spec::MoveType::linear);
  EXPECT_EQ(run.events[1].feed, 1000);
}

TEST(ToolLengthMeasurement, SignalAlreadyOn) {
  // By hand: at B = 220 the signal is on, so B is reached, far outside the zone; no measuring move.
  const ProgramRun run(setup("230"), "H1\nG37 Z200\n");
  EXPECT_EQ(run.moves(), 1U);
  EXPECT_EQ(run.point(0, 'Z'), 220);
  EXPECT_EQ(run.alarm(), "PS0080@2");
  // From 203 there is no rapid part; the signal is on: one move without travel, 3 are added.
  const ProgramRun close(setup("204"), "H1\nZ203\nG37 Z200\nG91 Z1\n");
  ASSERT_EQ(close.moves(), 3U);
  EXPECT_EQ(close.events[1].type, spec::MoveType::rapid);
  EXPECT_EQ(close.point(1, 'Z'), 203);
  EXPECT_EQ(written(close), "H1=18.000000");
  EXPECT_EQ(close.point(3, 'Z'), 204);
}

TEST(ToolLengthMeasurement, Upwards) {
  // By hand: from 100 to 200, B = 180, the signal at 202.
  const ProgramRun run(setup("202"), "H1\nZ100\nG37 Z200\nG91 Z1\n");
  EXPECT_EQ(run.point(1, 'Z'), 180);
  EXPECT_EQ(run.point(2, 'Z'), 202);
  EXPECT_EQ(written(run), "H1=17.000000");
  EXPECT_EQ(run.point(4, 'Z'), 203);
}

TEST(ToolLengthMeasurement, Memories) {
  const std::string b = "[offsets]\nmemory=\"B\"\n[offsets.H]\n1={geometry=15,wear=0}\n";
  EXPECT_EQ(written(ProgramRun(setup("198", "", b), "H1\nG37 Z200\n")), "H1.wear=-2.000000");
  const std::string c = "[offsets]\nmemory=\"C\"\n[offsets.H]\n1={geometry=15,wear=\"0.5\"}\n[offsets.D]\n1=7\n";
  const ProgramRun run(setup("198", "", c), "H1\nG37 Z200\nG43 Z0 H1\nG91 G45 X0 D1\n");
  EXPECT_EQ(written(run), "H1.wear=-1.500000");
  EXPECT_EQ(run.axis(3, 'Z'), 13.5);
  EXPECT_EQ(run.point(4, 'X'), 7);
  // No range: 999 + 4 is written, and refused where it is applied.
  const std::string far = "[offsets.H]\n1=999\n";
  const ProgramRun big(setup("204", "", far), "H1\nG37 Z200\nG43 Z0 H1\n");
  EXPECT_EQ(written(big), "H1=1003.000000");
  EXPECT_EQ(big.alarm(), "PS0029@3");
}

TEST(ToolLengthMeasurement, LengthOffsetInForce) {
  // By hand: G43 H1 = 15 in force; the signal at axis position 198 is the coordinate 183, 2 ahead of 185.
  const std::string program = "G43 Z760 H1\nG37 Z185\nX1\n";
  const ProgramRun later(setup("198"), program);
  EXPECT_EQ(later.point(1, 'Z'), 205);
  EXPECT_EQ(later.axis(1, 'Z'), 220);
  EXPECT_EQ(later.point(2, 'Z'), 183);
  EXPECT_EQ(later.axis(2, 'Z'), 198);
  EXPECT_EQ(written(later), "H1=13.000000");
  EXPECT_EQ(later.axis(4, 'Z'), 198);  // EVO = 0: the value waits
  const ProgramRun now(setup("198", "\"5001#6\"=1"), program);
  EXPECT_EQ(now.axis(4, 'Z'), 196);
  // Under G44 the same formula.
  EXPECT_EQ(written(ProgramRun(setup("198"), "G44 Z760 H1\nG37 Z215\n")), "H1=13.000000");
}

TEST(ToolLengthMeasurement, Parameters) {
  // By hand: 6251 = 30, 6254 = 1; inch: 20 mm and 5 mm.
  const ProgramRun run(setup("199.5", "\"6251\"=30\n\"6254\"=1"), "H1\nG37 Z200\n");
  EXPECT_EQ(run.point(0, 'Z'), 230);
  EXPECT_EQ(written(run), "H1=14.500000");
  EXPECT_EQ(ProgramRun(setup("198", "\"6254\"=20"), "H1\nG37 Z200\n").alarm(), "MEASUREMENT_PARAMETERS@2");
  EXPECT_EQ(ProgramRun(setup("198", "\"6254\"=-1"), "H1\nG37 Z200\n").alarm(), "MEASUREMENT_PARAMETERS@2");
  const std::string inch =
      "control=\"fanuc\"\nunits=\"inch\"\naxes=[\"X\",\"Y\",\"Z\"]\n[offsets.H]\n1=1\n"
      "[position]\nZ=10\n[measurement]\nZ=2\n";
  const ProgramRun in(inch, "G01 F30 H1\nG37 Z2\n");
  EXPECT_EQ(in.point(0, 'Z'), 354.0 / 127.0);
  EXPECT_EQ(in.events[1].feed, 30);
}

TEST(ToolLengthMeasurement, Alarms) {
  const std::string s = setup("198");
  const auto alarm = [&](const char* program) { return ProgramRun(s, program).alarm(); };
  EXPECT_EQ(alarm("G37 Z200 H01\n"), "PS0082@1");
  EXPECT_EQ(alarm("G37 Z200\n"), "PS0081@1");
  EXPECT_EQ(alarm("H1\nG91 G37 Z-5\n"), "PS0083@2");
  EXPECT_EQ(alarm("H1\nG37 X1 Z1\n"), "PS0083@2");
  EXPECT_EQ(alarm("H1\nG37\n"), "PS0083@2");
  EXPECT_EQ(alarm("H1\nG37 B5\n"), "PS0083@2");
  // The order of alarms comes before the format.
  for (const char* code : {"G43", "G44", "G49"}) {
    const std::string block = std::string("G37 ") + code;
    EXPECT_EQ(alarm((block + " Z200 H01\n").c_str()), "PS0082@1");
    EXPECT_EQ(alarm((block + " Z200\n").c_str()), "PS0081@1");
    EXPECT_EQ(alarm(("H1\n" + block + " X1 Z1\n").c_str()), "PS0083@2");
    EXPECT_EQ(alarm(("H1\n" + block + " Z200\n").c_str()), "MEASUREMENT_FORMAT@2");
  }
  EXPECT_EQ(alarm("H1\nG41 X1 D1\nG37 Z200\n"), "PS0036@3");
  const ProgramRun same(s, "H1\nG37 Z760\n");
  ASSERT_EQ(same.events.size(), 1U);
  EXPECT_EQ(same.events[0].kind, spec::EventKind::undecided);
  EXPECT_EQ(same.events[0].number.view(), "fanuc.length-measurement.start-on-the-coordinate");
}

}  // namespace
}  // namespace toolcomp::fast

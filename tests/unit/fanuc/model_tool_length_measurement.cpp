// SPDX-License-Identifier: Apache-2.0
// Automatic tool length measurement G37 in the exact engine, by hand. The worked examples of 14.2 stand in
// golden/fanuc/corpus_examples_chapter_14.cpp.
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/model_run.h"

namespace {

using namespace toolcomp;
using test::Lines;
using test::lines;
using test::run;
using test::Show;

// Signal at Z `signal`; 6251 = 20, 6254 = 5; H1 = 15.
std::string setup(const std::string& signal, const std::string& more = "", const std::string& parameters = "") {
  return "control = \"fanuc\"\naxes = [\"X\", \"Z\", \"B\"]\n[parameters]\n" + parameters +
         "[offsets.H]\n1 = 15\n[position]\nZ = 760\n" +
         (signal.empty() ? "" : "[measurement]\nZ = \"" + signal + "\"\n") + more;
}
Lines measured(const std::string& signal, const std::string& program = "H01\nG90 G37 Z200\n",
               const std::string& parameters = "") {
  return lines(run(setup(signal, "", parameters), program), Show::point);
}

// B = 220, C = 205, F = 195.
TEST(ModelToolLengthMeasurement, Zones) {
  const std::string rapid = "2 rapid X0 Z220";
  EXPECT_EQ(measured("194.999"), (Lines{rapid, "2 linear X0 Z195 (measure)", "2 PS0080"}));
  // On already at B, before it or exactly there: no measuring move.
  EXPECT_EQ(measured("220"), (Lines{rapid, "2 PS0080"}));
  EXPECT_EQ(measured("500"), (Lines{rapid, "2 PS0080"}));
}

TEST(ModelToolLengthMeasurement, WithoutARapidPart) {
  // From 210, past B: the measuring part begins there.
  EXPECT_EQ(measured("198", "G00 Z210 H1\nG37 Z200\n"),
            (Lines{"1 rapid X0 Z210", "2 linear X0 Z198 (measure)", "2 H1=13"}));
  EXPECT_EQ(measured("198", "G00 Z220 H1\nG37 Z200\n").at(1), "2 linear X0 Z198 (measure)");
  // From 203 with the signal on since 204: 203 is the position reached, 3 too high.
  EXPECT_EQ(measured("204", "G00 Z203 H1\nG37 Z200\n"), (Lines{"1 rapid X0 Z203", "2 rapid X0 Z203", "2 H1=18"}));
  // The other way, from 0 up to 100: B = 80, touched at 101.
  EXPECT_EQ(measured("101", "G00 Z0 H1\nG37 Z100\n"),
            (Lines{"1 rapid X0 Z0", "2 rapid X0 Z80", "2 linear X0 Z101 (measure)", "2 H1=16"}));
}

TEST(ModelToolLengthMeasurement, StartOnTheCommandedCoordinateIsLeftOpen) {
  const test::Run made = run(setup("198"), "H1\nG37 Z760\n");
  EXPECT_EQ(lines(made), (Lines{"2 fanuc.length-measurement.start-on-the-coordinate"}));
  EXPECT_EQ(made.events().at(0).kind, spec::EventKind::undecided);
}

TEST(ModelToolLengthMeasurement, IsNoArcUnderG02) {
  EXPECT_EQ(measured("198", "G02 H1\nG37 Z200\n"), (Lines{"2 rapid X0 Z220", "2 linear X0 Z198 (measure)", "2 H1=13"}));
}

TEST(ModelToolLengthMeasurement, StandsWhereItHasStopped) {
  EXPECT_EQ(measured("198", "H1\nG37 Z200\nG91 Z10\n").back(), "3 rapid X0 Z208");
}

// In force by EVO: with EVO = 0 the next H, with EVO = 1 the next block; the G37 block itself measures with 15, where
// a signal at 213 of the axis is a programmed coordinate of 198.
TEST(ModelToolLengthMeasurement, TakesEffectAsAnEditedValue) {
  const std::string program = "G43 Z760 H1\nG37 Z200\nX1\nH1\n";
  EXPECT_EQ(lines(run(setup("213"), program)),
            (Lines{"1 rapid X0 Z775 B0", "2 rapid X0 Z235 B0", "2 linear X0 Z213 B0 (measure)", "2 H1=13",
                   "3 rapid X1 Z213 B0", "4 rapid X1 Z211 B0"}));
  EXPECT_EQ(lines(run(setup("213", "", "\"5001#6\" = 1\n"), program)).back(), "3 rapid X1 Z211 B0");
}

TEST(ModelToolLengthMeasurement, ShiftOfToolOffsetIsNoLength) {
  // G46 towards smaller Z: the shift is +10, so the signal at 208 is 198.
  EXPECT_EQ(lines(run(setup("208", "[offsets.D]\n2 = 10\n"), "G46 Z750 D2 H1\nG37 Z200\nZ300\n"), Show::point),
            (Lines{"1 rapid X0 Z760", "2 rapid X0 Z230", "2 linear X0 Z208 (measure)", "2 H1=13", "3 rapid X0 Z310"}));
}

TEST(ModelToolLengthMeasurement, Memories) {
  const auto made = [](const std::string& memory) {
    return lines(run("control = \"fanuc\"\naxes = [\"X\", \"Z\"]\n[offsets]\nmemory = \"" + memory +
                         "\"\n[offsets.H]\n1 = { geometry = 15, wear = \"0.5\" }\n[offsets.D]\n1 = { geometry = 7, "
                         "wear = 0 }\n"
                         "[position]\nZ = 760\n[measurement]\nZ = 198\n",
                     "H1\nG37 Z200\n"))
        .back();
  };
  EXPECT_EQ(made("B"), "2 H1.wear=-1.5");
  EXPECT_EQ(made("C"), "2 H1.wear=-1.5");
}

TEST(ModelToolLengthMeasurement, FeedOfTheMeasuringMove) {
  const test::Run without = run(setup("198"), "F100 H1\nG37 Z200\n");
  EXPECT_FALSE(without.events().at(0).feed);
  EXPECT_EQ(without.events().at(1).feed->decimal(3), "100");
  const test::Run with = run(setup("198", "", "6241 = 1000\n"), "F100 H1\nG37 Z200\nG01 Z300\n");
  EXPECT_EQ(with.events().at(1).feed->decimal(3), "1000");
  EXPECT_EQ(with.events().back().feed->decimal(3), "100");
}

TEST(ModelToolLengthMeasurement, Alarms) {
  EXPECT_EQ(measured("198", "G37 Z200 H01\n").back(), "1 PS0082");
  EXPECT_EQ(measured("198", "G37 Z200\n").back(), "1 PS0081");
  EXPECT_EQ(measured("198", "H1\nG91 G37 Z-5\n").back(), "2 PS0083");
  EXPECT_EQ(measured("198", "H1\nG90 G37 X1 Z1\n").back(), "2 PS0083");
  EXPECT_EQ(measured("198", "H1\nG37 B10.\n").back(), "2 PS0083");
  EXPECT_EQ(measured("198", "H1\nG37\n").back(), "2 PS0083");
  // The order of alarms comes before the format.
  for (const std::string code : {"G43", "G44", "G49"}) {
    EXPECT_EQ(measured("198", "H1\n" + code + " G37 Z200 H1\n").back(), "2 PS0082");
    EXPECT_EQ(measured("198", code + " G37 Z200\n").back(), "1 PS0081");
    EXPECT_EQ(measured("198", "H1\n" + code + " G37 X1 Z1\n").back(), "2 PS0083");
    EXPECT_EQ(measured("198", "H1\n" + code + " G37 Z200\n").back(), "2 MEASUREMENT_FORMAT");
  }
  EXPECT_EQ(measured("198", "H1\nG37 Z200\n", "6251 = 5\n").back(), "2 MEASUREMENT_PARAMETERS");
  EXPECT_EQ(measured("198", "H1\nG37 Z200\n", "6254 = -1\n").back(), "2 MEASUREMENT_PARAMETERS");
  EXPECT_EQ(measured("198", "H1\nG37 Z200\n", "6241 = 0\n").back(), "2 MEASUREMENT_PARAMETERS");
  EXPECT_EQ(
      lines(run("control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[offsets.D]\n1 = 1\n", "H1\nG41 D1\nG37 Z200\n")),
      (Lines{"3 PS0036"}));
}

// In inch setups the zones are the same lengths; 6251 = 20/25.4, so B = 10 + 20/25.4.
TEST(ModelToolLengthMeasurement, InchZones) {
  EXPECT_EQ(lines(run("control = \"fanuc\"\nunits = \"inch\"\naxes = [\"Z\"]\n[offsets.H]\n1 = 1\n[position]\nZ = 20\n"
                      "[measurement]\nZ = 10\n",
                      "H1\nG37 Z10\n")),
            (Lines{"2 rapid Z10.78740157480315", "2 linear Z10 (measure)", "2 H1=1"}));
}

}  // namespace

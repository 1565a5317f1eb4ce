// The worked examples of the sheets' two parts, tool length offset (chapter 14, 14.1.1 and 14.1.2) and leading edge
// offset (3-dimensional cutter compensation, LE1 to LE10), under the exact engine. Every expected value is typed in
// from the sheet.
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/model_run.h"

namespace {

using namespace toolcomp;
using test::Lines;
using test::lines;
using test::run;
using test::Show;

std::string setup(const std::string& keys) { return "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n" + keys; }

// Only Z of every move.
Lines z(const test::Run& run) {
  Lines result;
  for (const model::Event& event : run.events())
    result.push_back(event.kind == spec::EventKind::move ? event.axes[2].decimal(15)
                                                         : std::string(event.number.view()));
  return result;
}

// 14.1.1

TEST(LengthOffsetExamples, ThreeHoleBoring) {
  const auto drilled = run(setup("[offsets.H]\n1 = \"-4.0\"\n"),
                           "N1 G91 G00 X120.0 Y80.0\n"
                           "N2 G43 Z-32.0 H1\n"
                           "N3 G01 Z-21.0 F1000\n"
                           "N4 G04 P2000\n"
                           "N5 G00 Z21.0\n"
                           "N6 X30.0 Y-50.0\n"
                           "N7 G01 Z-41.0\n"
                           "N8 G00 Z41.0\n"
                           "N9 X50.0 Y30.0\n"
                           "N10 G01 Z-25.0\n"
                           "N11 G04 P2000\n"
                           "N12 G00 Z57.0 H0\n"
                           "N13 X-200.0 Y-60.0\n"
                           "N14 M2\n");
  EXPECT_EQ(lines(drilled),
            (Lines{"1 rapid X120 Y80 Z0", "2 rapid X120 Y80 Z-36", "3 linear X120 Y80 Z-57", "5 rapid X120 Y80 Z-36",
                   "6 rapid X150 Y30 Z-36", "7 linear X150 Y30 Z-77", "8 rapid X150 Y30 Z-36", "9 rapid X200 Y60 Z-36",
                   "10 linear X200 Y60 Z-61", "12 rapid X200 Y60 Z0", "13 rapid X0 Y0 Z0"}));
}

TEST(LengthOffsetExamples, ANewOffsetReplacesTheOld) {
  EXPECT_EQ(z(run(setup("[offsets.H]\n1 = 20\n2 = 30\n"), "G90 G43 Z100 H1\nG90 G43 Z100 H2\n")),
            (Lines{"120", "130"}));
}

TEST(LengthOffsetExamples, NumbersCountByThemselvesWithoutOfh) {
  EXPECT_EQ(z(run(setup("[offsets.H]\n1 = 10\n2 = 7\n3 = 3\n"), "H01\nG90 G43 Z-20\nG44 Z-30 H02\nH03\n")),
            (Lines{"-10", "-37", "-33"}));
}

TEST(LengthOffsetExamples, NumbersNeedTheirCodeWithOfh) {
  EXPECT_EQ(z(run(setup("[parameters]\n\"5001#2\" = 1\n[offsets.H]\n1 = 10\n2 = 7\n3 = 3\n"),
                  "H01\nG43 Z-20\nG44 Z-30 H02\nH03\n")),
            (Lines{"-20", "-37"}));
}

TEST(LengthOffsetExamples, Incremental) {
  EXPECT_EQ(z(run(setup("[offsets.H]\n1 = 5\n2 = 8\n"), "G91\nG43 Z-10 H1\nZ-10 H2\n")), (Lines{"-5", "-12"}));
}

TEST(LengthOffsetExamples, TypeC) {
  const std::string memory = "[offsets.H]\n1 = 4\n2 = 6\n3 = 2\n";
  const std::string program = "G90 G43 X10 H1\nH2\nG43 Y0 H3\nH1\n";
  EXPECT_EQ(lines(run(setup("[parameters]\n\"5001#0\" = 1\n" + memory), program)),
            (Lines{"1 rapid X14 Y0 Z0", "2 rapid X16 Y0 Z0", "3 PS0027"}));
  EXPECT_EQ(lines(run(setup("[parameters]\n\"5001#0\" = 1\n\"5001#3\" = 1\n" + memory), program)),
            (Lines{"1 rapid X14 Y0 Z0", "2 rapid X16 Y0 Z0", "3 rapid X16 Y2 Z0", "4 rapid X16 Y4 Z0"}));
}

TEST(LengthOffsetExamples, LoneCancel) {
  EXPECT_EQ(z(run(setup("[offsets.H]\n1 = 20\n"), "G43 Z100 H1\nG49\n")), (Lines{"120", "100"}));
}

// 14.1.2: work zero at machine Z = -300, H1 = 20, G43 H1 in force. Machine positions of Z.

std::string with_zero(const std::string& parameters) {
  return setup("[parameters]\n" + parameters + "[offsets.H]\n1 = 20\n[workpiece.G54]\nZ = -300\n");
}
constexpr const char* kEvo = "\"5001#6\" = 1\n";

// Z in machine coordinates, also of moves that do not report them.
Lines machine_z(const test::Run& run) {
  Lines result;
  for (const model::Event& event : run.events())
    result.push_back(event.kind == spec::EventKind::move ? (event.axes[2] - 300).decimal(15)
                                                         : std::string(event.number.view()));
  return result;
}

TEST(LengthOffsetAtMachinePositions, MachinePositionOfTheOffsetAxis) {
  const std::string program = "G43 H1\nG90 G00 Z50\nG53 Z-10\nZ50\nH1\n";
  EXPECT_EQ(machine_z(run(with_zero(""), program)), (Lines{"-280", "-230", "-10", "-250", "-230"}));
  // With EVO the vector is back in the first Z50; the H1 after it changes nothing.
  EXPECT_EQ(machine_z(run(with_zero(kEvo), program)), (Lines{"-280", "-230", "-10", "-230"}));
}

TEST(LengthOffsetAtMachinePositions, MachinePositionOfAnotherAxis) {
  EXPECT_EQ(machine_z(run(with_zero(""), "G43 H1\nG90 G00 Z50\nG53 X0\nZ50\n")),
            (Lines{"-280", "-230", "-230", "-230"}));
}

TEST(LengthOffsetAtMachinePositions, ReferenceReturn) {
  EXPECT_EQ(machine_z(run(with_zero(""), "G43 Z50 H1\nG28 Z80\nZ50\n")), (Lines{"-230", "-200", "0", "-250"}));
}

TEST(LengthOffsetAtMachinePositions, ReferenceReturnWithCancel) {
  EXPECT_EQ(machine_z(run(with_zero(kEvo), "G43 Z50 H1\nG49 G28 Z80\nZ50\nH1\n")),
            (Lines{"-230", "-220", "0", "-250"}));
}

TEST(LengthOffsetAtMachinePositions, OnlyTheAxisOffsetLastComesBack) {
  // Type B, X offset 4 first, Z offset 20 last.
  const auto done = run(setup("[parameters]\n\"5001#1\" = 1\n[offsets.H]\n1 = 20\n4 = 4\n"),
                        "G19 G43 X0 H4\nG17 G43 Z0 H1\nG28 X0 Z80\nG00 X5 Z5\nH1\n");
  EXPECT_EQ(lines(done), (Lines{"1 rapid X4 Y0 Z0", "2 rapid X4 Y0 Z20", "3 rapid X4 Y0 Z100 (reference)",
                                "3 rapid X0 Y0 Z0 (reference)", "4 rapid X5 Y0 Z5", "5 rapid X5 Y0 Z25"}));
}

// The sheet has G41 X10 D1 here; G40 is the code of the same rule that is supported.
TEST(LengthOffsetAtMachinePositions, NoRestorationBesideACutterCode) {
  const auto done = run(with_zero(kEvo), "G43 Z50 H1\nG53 Z-10\nG40 X10\nX50\n");
  EXPECT_EQ(machine_z(done), (Lines{"-230", "-10", "-10", "10"}));
}

// Leading edge offset

std::string edge(const std::string& radius, const std::string& fluctuation = "1.0") {
  return setup("[parameters]\n19631 = \"" + fluctuation + "\"\n[offsets.D]\n1 = \"" + radius + "\"\n");
}

// The vector of the move on this line: point less programmed.
std::string vector(const test::Run& run, std::uint64_t line, int digits) {
  for (const model::Event& event : run.events()) {
    if (event.line != line || event.kind != spec::EventKind::move) continue;
    std::string text;
    for (std::size_t i = 0; i < 3; ++i)
      text += (i == 0 ? "" : " ") + (event.point[i] - event.programmed[i]).decimal(digits);
    return text;
  }
  return "no move";
}

TEST(LeadingEdgeExamples, LE1ToolLeansForward) {
  EXPECT_EQ(vector(run(edge("10"), "G43.5 I3 J0 K4\nG41.3 D1\nG01 X100\nG40\n"), 2, 18), "-8 0 6");
}

TEST(LeadingEdgeExamples, LE2ToolLeansBack) {
  EXPECT_EQ(vector(run(edge("10"), "G43.5 I-3 J0 K4\nG41.3 D1\nG01 X100\nG40\n"), 2, 18), "8 0 6");
}

TEST(LeadingEdgeExamples, LE5RotaryAxes) {
  const std::string head =
      "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n[parameters]\n19680 = 2\n19681 = 5\n19682 = 3\n"
      "19686 = 4\n19687 = 2\n19631 = 1\n[offsets.D]\n1 = 6\n";
  const auto there = run(head, "G00 B15. C30.\nG41.3 D1\nG91 G01 X40 Y-10 Z5\nG40\n");
  EXPECT_EQ(vector(there, 2, 18), "-5.635045313286906622 1.759957600658339579 1.07182720673073461");
  const auto& axis = there.events().front().tool_axis;
  ASSERT_TRUE(axis.has_value());
  EXPECT_EQ((*axis)[0].decimal(18), "0.224143868042013381");
  EXPECT_EQ((*axis)[1].decimal(18), "0.129409522551260381");
  EXPECT_EQ((*axis)[2].decimal(18), "0.965925826289068287");
  EXPECT_EQ(vector(run(head, "G00 B15. C30.\nG41.3 D1\nG91 G01 X-40 Y10 Z-5\nG40\n"), 2, 18),
            "-5.635045313286906622 1.759957600658339579 1.07182720673073461");
}

TEST(LeadingEdgeExamples, LE7NearARightAngle) {
  const std::string after_forward = "G43.5 I-3 J0 K4\nG41.3 D1\nG01 X100 I400 J0 K39999\nX200\nG40\n";
  const std::string after_backward = "G43.5 I3 J0 K4\nG41.3 D1\nG01 X100 I400 J0 K39999\nX200\nG40\n";
  const auto forward = run(edge("10"), after_forward);
  // 15 significant digits, as the sheet prints them.
  EXPECT_EQ(vector(forward, 3, 14), "9.99950001249969 0 -0.0999975000625");
  EXPECT_EQ((forward.events()[2].point[2]).decimal(16), "-0.0999975000624984");
  EXPECT_TRUE(forward.events()[2].point[0] - 100 == model::Real(exact::Rational(399990, 40001)));
  EXPECT_TRUE(forward.events()[2].point[2] == model::Real(exact::Rational(-4000, 40001)));
  EXPECT_EQ(vector(run(edge("10"), after_backward), 3, 14), "-9.99950001249969 0 0.0999975000625");
  EXPECT_EQ(vector(run(edge("10", "0.5"), after_forward), 3, 14), "-9.99950001249969 0 0.0999975000625");
}

TEST(LeadingEdgeExamples, LE9ExactRightAngleTwice) {
  const std::string moves = "G41.3 D1\nG01 X100 I0 J0 K1\nX200\nX300\nG40\n";
  const auto backward = run(edge("10"), "G43.5 I3 J0 K4\n" + moves);
  EXPECT_EQ(vector(backward, 3, 15), "-10 0 0");
  EXPECT_EQ(vector(backward, 4, 15), "-10 0 0");
  const auto forward = run(edge("10"), "G43.5 I-3 J0 K4\n" + moves);
  EXPECT_EQ(vector(forward, 3, 15), "10 0 0");
  EXPECT_EQ(vector(forward, 4, 15), "10 0 0");
}

TEST(LeadingEdgeExamples, LE10ToolAlongTheMovementAtTheStart) {
  EXPECT_EQ(lines(run(edge("10"), "G43.5 I3 J0 K4\nG41.3 D1\nG01 X60 Z80\n")), (Lines{"1 rapid X0 Y0 Z0", "2 PS5408"}));
  EXPECT_EQ(lines(run(edge("10"), "G43.5 I3 J0 K4\nG41.3 D1\nG01 X-60 Z-80\n")),
            (Lines{"1 rapid X0 Y0 Z0", "2 PS5408"}));
}

}  // namespace

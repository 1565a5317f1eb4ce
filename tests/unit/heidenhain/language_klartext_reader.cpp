// SPDX-License-Identifier: Apache-2.0
// The rules of the Klartext reader (spec/language/README.md), one test a rule; positions are counted by hand.
#include "spec/language/heidenhain/klartext_reader.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/targets/pieces.h"
#include "spec/language/input_error.h"
#include "tests/support/usual_number.h"

namespace {

namespace spec = toolcomp::spec;
using namespace toolcomp::spec;
using namespace toolcomp::spec::klartext;
using namespace std::string_literals;
using klartext::Block;

Setup setup_with(std::string_view axes, bool block_skip = false) {
  Setup setup;
  setup.control = Control::heidenhain;
  setup.axes = Axes(axes);
  setup.block_skip = block_skip;
  setup.tcs[3] = {decimal(1), {}, {}};
  return setup;
}
const Setup kSetup = setup_with("XYZABC");

// Every block as "LINE: canonical text", with " !CODE@LINE:COLUMN" for an alarm; then nothing but the alarm counts.
std::vector<std::string> read(std::string_view text, const Setup& setup = kSetup) {
  Reader reader(text_source(text), setup, {.file = "p.h"});
  std::vector<std::string> blocks;
  Block block;
  while (reader.next(block)) {
    std::string shown = std::to_string(block.line) + ": ";
    if (block.alarm)
      shown += "!" + toolcomp::test::usual_number(block.alarm->cause) + "@" + std::to_string(block.alarm->line) + ":" +
               std::to_string(block.alarm->column);
    else
      shown += to_string(block);
    blocks.push_back(shown);
  }
  EXPECT_FALSE(reader.next(block));
  return blocks;
}
using Blocks = std::vector<std::string>;

// The only block of a text, without the number of its line where that is 1.
std::string one(std::string_view text, const Setup& setup = kSetup) {
  const Blocks blocks = read(text, setup);
  if (blocks.size() != 1) return std::to_string(blocks.size()) + " blocks";
  return blocks[0].starts_with("1: ") ? blocks[0].substr(3) : blocks[0];
}

Block block_of(std::string_view text) {
  Reader reader(text_source(text), kSetup);
  Block block;
  EXPECT_TRUE(reader.next(block)) << text;
  return block;
}

std::string error(std::string_view text, const Setup& setup = kSetup) {
  try {
    read(text, setup);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

// A whole program of the manual's blocks.
constexpr std::string_view kExample = R"(0 BEGIN PGM HHFACE MM
1 BLK FORM 0.1 Z X-50 Y-50 Z-20
2 BLK FORM 0.2 X+50 Y+50 Z+0
3 TOOL CALL 1 Z S12000 F1000
4 L Z+100 R0 FMAX M3
5 L X+36.0084 Y+6.177 Z-1.9209 R0
6 LN X+36.0084 Y+6.177 Z-1.9209 NX-0.4658107 NY+0 NZ+0.8848844 R0
7 LN X+36.0084 Y+6.177 Z-1.9209 NX-0.4658107 NY+0 NZ+0.8848844 TX+0.0000000 TY+0.6558846 TZ+0.7548612 R0 M128
8 LN X+36.0084 Y+6.177 Z-1.9209 NX-0.4658107 NY+0 NZ+0.8848844 R0
9 L Z+100 R0 FMAX M129
10 M30
11 END PGM HHFACE MM
)";

TEST(Klartext, WholeProgram) {
  EXPECT_EQ(read(kExample),
            (Blocks{"1: 0 BEGIN PGM P MM", "2: 1 BLK FORM 0.1 Z X0 Y0 Z0", "3: 2 BLK FORM 0.1 Z X0 Y0 Z0",
                    "4: 3 TOOL CALL 1 Z F1000", "5: 4 L Z100 R0 FMAX M3", "6: 5 L X36.0084 Y6.177 Z-1.9209 R0",
                    "7: 6 LN X36.0084 Y6.177 Z-1.9209 NX-.4658107 NY0 NZ.8848844 R0",
                    "8: 7 LN X36.0084 Y6.177 Z-1.9209 NX-.4658107 NY0 NZ.8848844 TX.0000000 TY.6558846 TZ.7548612 R0 "
                    "M128",
                    "9: 8 LN X36.0084 Y6.177 Z-1.9209 NX-.4658107 NY0 NZ.8848844 R0", "10: 9 L Z100 R0 FMAX M129",
                    "11: 10 M30", "12: 11 END PGM P MM"}));
}

TEST(Klartext, LineWithVectors) {
  const Block block = block_of("12 LN X+1.5 Y-Q2 Z,25 NX0.6 NY-0 NZ0,8 TX0 TY0 TZ1 RL FQL7 M128 F500 M8");
  EXPECT_EQ(block.statement, Statement::line_with_vectors);
  EXPECT_EQ(block.n, 12U);
  EXPECT_EQ(block.column, 4U);
  EXPECT_EQ(block.axes, 7);
  EXPECT_EQ(block.axis[0], (Value{{15, 1, false, true}, {}}));
  EXPECT_EQ(block.axis[1], (Value{{0, 0, true, false}, {ParameterKind::q, 2}}));
  EXPECT_EQ(block.axis[2], (Value{{25, 2, false, true}, {}}));
  ASSERT_TRUE(block.has_normal);
  EXPECT_EQ(block.normal[1], (Decimal{0, 0, true, false}));
  EXPECT_EQ(block.normal[2], (Decimal{8, 1, false, true}));
  ASSERT_TRUE(block.has_tool_vector);
  EXPECT_EQ(block.tool_vector[2], decimal(1));
  EXPECT_EQ(block.radius, RadiusWord::rl);
  EXPECT_EQ(block.feed, FeedWord::f);
  EXPECT_EQ(block.feed_value.parameter, (Parameter{ParameterKind::ql, 7}));
  ASSERT_EQ(block.functions, 2);
  EXPECT_EQ(block.function[0], 128);
  EXPECT_EQ(block.function[1], 8);
  EXPECT_FALSE(block.many_digits);
  const Block next = block_of("LN X1 Y2 Z3 TX0 TY0 TZ1");
  EXPECT_FALSE(next.has_normal);
  EXPECT_EQ(next.radius, RadiusWord::none);
  EXPECT_EQ(next.feed, FeedWord::none);
  EXPECT_EQ(next.functions, 0);
}

// One wrong block each.
TEST(Klartext, NegativeSyntaxTests) {
  EXPECT_EQ(one("LN X+1 Y+2 NX0 NY0 NZ1"), "!E_LN_COORD@1:1");
  EXPECT_EQ(one("LN Y+1 X+2 Z+3 NX0 NY0 NZ1"), "!E_LN_ORDER@1:8");
  EXPECT_EQ(one("LN X+1 Y+2 Z+3 NX0 NZ1"), "!E_VEC_INCOMPLETE@1:1");
  EXPECT_EQ(one("LN X+1 Y+2 Z+3 TX0 TY0 TZ1 NX0 NY0 NZ1"), "!E_LN_ORDER@1:28");
  EXPECT_EQ(one("LN X+1 Y+2 Z+3 NX0 NY0 NZ0"), "!E_VEC_ZERO@1:16");
  EXPECT_EQ(one("LN X+1 Y+2 Z+3 NX+10 NY0 NZ1"), "!E_VEC_RANGE@1:16");
  EXPECT_EQ(one("LN X+1 Y+2 Z+3 NX0 NY0 NZ1 M1 M2 M3 M4 M5"), "!E_TOO_MANY_M@1:40");
  EXPECT_EQ(one("LN X+1 Y+2 Z+3 NX0 NY0 NZ1 TX+Q1 TY0 TZ1"), "!E_SYNTAX@1:28");
  // These two have a meaning, which the engines refuse.
  EXPECT_EQ(one("LN X+1 Y+2 Z+3 NX0 NY0 NZ1 RL"), "LN X1 Y2 Z3 NX0 NY0 NZ1 RL");
  EXPECT_EQ(read("M128\nTOOL CALL 1 Z"), (Blocks{"1: M128", "2: TOOL CALL 1 Z"}));
}

TEST(Klartext, OrderOfFaultsInLN) {
  // Each text has the fault of the next one too, and all that follow.
  EXPECT_EQ(one("LN Y1 X1 NX99 NY0 TX0 M1 M2 M3 M4 M5 G1"), "!E_SYNTAX@1:38");
  EXPECT_EQ(one("LN Y1 X1 NX99 NY0 TX0 M1 M2 M3 M4 M5"), "!E_TOO_MANY_M@1:35");
  EXPECT_EQ(one("LN Y1 X1 NX99 NY0 TX0"), "!E_LN_ORDER@1:7");
  EXPECT_EQ(one("LN X1 Y1 NX99 NY0 TX0"), "!E_LN_COORD@1:1");
  EXPECT_EQ(one("LN X1 Y1 Z1 NX99 NY0 TX0"), "!E_VEC_INCOMPLETE@1:1");
  EXPECT_EQ(one("LN X1 Y1 Z1"), "!E_SYNTAX@1:1");
  EXPECT_EQ(one("LN X1 Y1 Z1 NX0 NY0 NZ0 TX0 TY0 TZ99"), "!E_VEC_RANGE@1:33");
  EXPECT_EQ(one("LN X1 Y1 Z1 NX0 NY0 NZ0 TX0 TY0 TZ0"), "!E_VEC_ZERO@1:13");
  EXPECT_EQ(one("LN X1 Y1 Z1 NX0 NY0 NZ1 TX0 TY0 TZ0"), "!E_VEC_ZERO@1:25");
  EXPECT_EQ(one("LN X1 Y1 Z1 TX0.0 TY,0 TZ-0"), "!E_VEC_ZERO@1:13");
}

TEST(Klartext, KeysOfLNAscend) {
  EXPECT_EQ(one("LN X1 X1 Y1 Z1 NX0 NY0 NZ1"), "!E_LN_ORDER@1:7");
  EXPECT_EQ(one("LN X1 Z1 Y1 NX0 NY0 NZ1"), "!E_LN_ORDER@1:10");
  EXPECT_EQ(one("LN X1 Y1 Z1 NX0 NZ1 NY0"), "!E_LN_ORDER@1:21");
  EXPECT_EQ(one("LN NX0 NY0 NZ1 X1 Y1 Z1"), "!E_LN_ORDER@1:16");
  EXPECT_EQ(one("LN X1 Y1 R0 Z1 NX0 NY0 NZ1"), "!E_SYNTAX@1:13");
  EXPECT_EQ(one("LN IX1 Y1 Z1 NX0 NY0 NZ1"), "!E_SYNTAX@1:4");
  EXPECT_EQ(one("LN X1 Y1 Z1 B1 NX0 NY0 NZ1"), "!E_SYNTAX@1:13");
  EXPECT_EQ(one("LN X1 Y1 Z1 NX0 NY0 NZQ1"), "!E_SYNTAX@1:21");
}

TEST(Klartext, RangeOfComponents) {
  const auto with = [](const std::string& component) { return one("LN X0 Y0 Z0 NX" + component + " NY0 NZ1"); };
  for (const char* in : {"9.99999999", "-9.99999999", "9", "009.99999999", "9.999999990000000"})
    EXPECT_NE(with(in).substr(0, 2), "!E") << in;
  for (const char* out : {"10", "-10", "9.999999991", "9.9999999900000001", "999999999999999999"})
    EXPECT_EQ(with(out), "!E_VEC_RANGE@1:13") << out;
}

TEST(Klartext, ManyDigits) {
  const auto many = [](const std::string& text) {
    const Block block = block_of(text);
    EXPECT_FALSE(block.alarm) << text;
    return block.many_digits;
  };
  EXPECT_FALSE(many("L X99999.99999"));
  EXPECT_TRUE(many("L X1.000000"));  // digits as written
  EXPECT_TRUE(many("L X100000"));
  EXPECT_TRUE(many("L X99999,999991"));
  EXPECT_TRUE(many("L X1 C-100000.0"));
  EXPECT_FALSE(many("L X1 F1.2345678"));
  EXPECT_FALSE(many("LN X0 Y0 Z0 NX0.12345678 NY0 NZ1"));
  EXPECT_TRUE(many("LN X0 Y0 Z0 NX0.123456789 NY0 NZ1"));
  EXPECT_TRUE(many("LN X0 Y0 Z0 NX0 NY0 NZ1 TX0 TY0 TZ1.000000000"));
  EXPECT_TRUE(many("LN X0 Y0 Z0.000001 NX0 NY0 NZ1"));
}

TEST(Klartext, Numbers) {
  EXPECT_EQ(one("L X+10 Y-10 Z10"), "L X10 Y-10 Z10");
  EXPECT_EQ(one("L X1.50 Y1,50 Z-,5"), "L X1.50 Y1.50 Z-.5");
  EXPECT_EQ(one("L X\u22121.5 Y\u20131,5"), "L X-1.5 Y-1.5");
  EXPECT_EQ(one("LN X0 Y0 Z0 NX\u20130.6 NY0 NZ\u22120.8"), "LN X0 Y0 Z0 NX-.6 NY0 NZ-.8");
  EXPECT_EQ(one("L X-Q1 Y+QL499 Z\u2212QR0 A\u2013Q1999"), "L X-Q1 YQL499 Z-QR0 A-Q1999");
  EXPECT_EQ(one("L X123456789012345678 Y.123456789012345678 Z1234567,12345678"),
            "L X123456789012345678 Y.123456789012345678 Z1234567.12345678");
  EXPECT_EQ(block_of("L X00012.3400").axis[0].number, (Decimal{123400, 4, false, true}));
  for (const char* bad : {"X1234567890123456789",
                          "X0000000000000000000",
                          "X,",
                          "X.",
                          "X",
                          "X+",
                          "X-",
                          "X+-1",
                          "X--1",
                          "X1.2.3",
                          "X1,2.3",
                          "X1e5",
                          "X1E-5",
                          "X1-",
                          "XQ",
                          "XQ2000",
                          "XQL500",
                          "XQR500",
                          "XQS1",
                          "X+-Q1",
                          "XQ1.5",
                          "X0x1",
                          "X\u2212",
                          "X1Y2",
                          "X#1",
                          "XQ12345678901234567890"})
    EXPECT_EQ(one("L Y1 "s + bad), "!E_SYNTAX@1:6") << bad;
}

TEST(Klartext, CapitalsAndBlanksDoNotMatter) {
  EXPECT_EQ(one("  7\tln x1 Y2\t z3  nX0 nY0 NZ1   rl  f  max m3 \r\n"), "7 LN X1 Y2 Z3 NX0 NY0 NZ1 RL FMAX M3");
  EXPECT_EQ(one("function   prog\tpath is   contour"), "FUNCTION PROG PATH IS CONTOUR");
  EXPECT_EQ(one("tool  call 5.1 z dr2:+0.3"), "TOOL CALL 5.1 Z DR2:.3");
  EXPECT_EQ(one("L IX1 iY2 r0"), "L IX1 IY2 R0");
}

TEST(Klartext, BlocksAndLines) {
  EXPECT_EQ(read("\n\r\n \t\nL X1\n12\n13 ;only text\n* - part one\n14 * part two\n/\nL X2"),
            (Blocks{"4: L X1", "10: L X2"}));
  EXPECT_EQ(read(""), Blocks{});
  EXPECT_EQ(read("L X1"), Blocks{"1: L X1"});
  EXPECT_EQ(one("999999999999999999 M3"), "999999999999999999 M3");
  EXPECT_EQ(one("1000000000000000000 M3"), "!E_SYNTAX@1:1");
  EXPECT_EQ(one("7L X1"), "!E_SYNTAX@1:1");
  EXPECT_EQ(one("-7 L X1"), "!E_SYNTAX@1:1");
  EXPECT_EQ(one("7 8 L X1"), "!E_SYNTAX@1:3");
  EXPECT_EQ(one("7 LX1"), "!E_SYNTAX@1:3");
}

TEST(Klartext, CommentsEndTheirLine) {
  EXPECT_EQ(read("L X1 ; Y2 \"\n;L X3\nL X4;~ no end\n* L X5 ; Y6"), (Blocks{"1: L X1", "3: L X4"}));
  EXPECT_EQ(one("TOOL CALL \"A;B\" Z"), "TOOL CALL \"A;B\" Z");
}

TEST(Klartext, LinesGoOnBehindATilde) {
  EXPECT_EQ(read("L X1 ~\n  Y2 ~ \r\n\tR0\nL X3"), (Blocks{"1: L X1 Y2 R0", "4: L X3"}));
  EXPECT_EQ(read("LN X1~\nY2 Z3 ;text ~\nNX0 NY0 NZ1 ;text\nL X3"), (Blocks{"1: LN X1 Y2 Z3 NX0 NY0 NZ1", "4: L X3"}));
  EXPECT_EQ(read("CYCL DEF 247 DATUM SETTING ~\n  Q339=+1 ;DATUM NUMBER ~\n Q1=2\nM3"),
            (Blocks{"1: CYCL DEF 247.0", "4: M3"}));
  EXPECT_EQ(read("F~\nMAX"), Blocks{"1: !E_SYNTAX@1:1"});
  EXPECT_EQ(one("L X1 F ~\nMAX"), "L X1 FMAX");
  EXPECT_EQ(one("L X1 ~"), "L X1");
  EXPECT_EQ(one("L X1 ~\n"), "L X1");
  EXPECT_EQ(one("12 ~\n L X1"), "12 L X1");
  // Not at the end of a line it is no word; faults name their own line, events the first one.
  EXPECT_EQ(one("L X1 ~ Y2"), "!E_SYNTAX@1:6");
  EXPECT_EQ(one("L X1 ~\n Y2 ~\n  13 Z3"), "!E_SYNTAX@3:3");
  EXPECT_EQ(one("LN X1 Y2 ~\n Z3 NX0 NY0 ~\n NZ1 M1 M2 M3 ~\n M4 M5"), "!E_TOO_MANY_M@4:5");
  EXPECT_EQ(one("\nLN X1 Y2 ~\n NX0 NY0 NZ1"), "2: !E_LN_COORD@2:1");
}

TEST(Klartext, BlockSkip) {
  const spec::Setup skipping = setup_with("XYZ", true);
  constexpr std::string_view kText = "/L X1\n12 /L X2\n/ 13 L X3\n/G99 ~\n Y\nL X4\n/* text\n";
  EXPECT_EQ(read(kText), (Blocks{"1: L X1", "2: 12 L X2", "3: 13 L X3", "4: !E_SYNTAX@4:2", "6: L X4"}));
  EXPECT_EQ(read(kText, skipping), Blocks{"6: L X4"});
  EXPECT_EQ(one("//L X1"), "!E_SYNTAX@1:2");
  EXPECT_EQ(one("/12/ L X1"), "!E_SYNTAX@1:4");
  EXPECT_EQ(one("L / X1"), "!E_SYNTAX@1:3");
  EXPECT_EQ(one("L / X1", skipping), "!E_SYNTAX@1:3");
  EXPECT_EQ(read("/7L X1\nM3", skipping), Blocks{"2: M3"});
  EXPECT_EQ(read("/END PGM A MM\nM3", skipping), Blocks{"2: M3"});
}

TEST(Klartext, AxesAreThoseOfTheSetup) {
  EXPECT_EQ(one("L Z1 C2 IX3 B-4 Y5 A6"), "L IX3 Y5 Z1 A6 B-4 C2");
  EXPECT_EQ(one("L U1"), "!E_SYNTAX@1:3");
  EXPECT_EQ(one("L U1 IV2 W3", setup_with("XYZUVW")), "L U1 IV2 W3");
  EXPECT_EQ(one("L A1", setup_with("XYZUVW")), "!E_SYNTAX@1:3");
  EXPECT_EQ(one("L X1 IX2"), "!E_SYNTAX@1:6");
  EXPECT_EQ(one("L I X1"), "!E_SYNTAX@1:3");
  EXPECT_EQ(one("L S1"), "!E_SYNTAX@1:3");
}

TEST(Klartext, WordsBehindTheAxes) {
  EXPECT_EQ(one("L"), "L");
  EXPECT_EQ(one("L R0 FMAX M3"), "L R0 FMAX M3");
  EXPECT_EQ(one("L X1 RR F AUTO"), "L X1 RR FAUTO");
  EXPECT_EQ(one("L X1 FAUTO"), "L X1 FAUTO");
  EXPECT_EQ(one("L X1 FZ0.1"), "L X1 FZ.1");
  EXPECT_EQ(one("L X1 FU-QR2"), "L X1 FU-QR2");
  EXPECT_EQ(one("L X1 F Q1"), "L X1 FQ1");
  EXPECT_EQ(one("L X1 F 100"), "L X1 F100");
  EXPECT_EQ(one("L X1 F"), "L X1");
  EXPECT_EQ(one("L X1 FMIN"), "!E_SYNTAX@1:6");
  EXPECT_EQ(one("L X1 FZ"), "!E_SYNTAX@1:6");
  EXPECT_EQ(one("L X1 F100 R0"), "!E_SYNTAX@1:11");
  EXPECT_EQ(one("L X1 M3 F100"), "!E_SYNTAX@1:9");
  EXPECT_EQ(one("L X1 F100 F200"), "!E_SYNTAX@1:11");
  EXPECT_EQ(one("L X1 R1"), "!E_SYNTAX@1:6");
  EXPECT_EQ(one("L X1 R+"), "!E_SYNTAX@1:6");
  EXPECT_EQ(one("L X1 R0 Y2"), "!E_SYNTAX@1:9");
  EXPECT_EQ(one("L X1 M3 Y2"), "!E_SYNTAX@1:9");
}

TEST(Klartext, Functions) {
  EXPECT_EQ(one("L X1 F125 M128 F1000"), "L X1 F125 M128");
  EXPECT_EQ(one("M128 FQ1 M3"), "M128 M3");
  EXPECT_EQ(one("M128 FMAX"), "!E_SYNTAX@1:6");
  // Words without an effect on the path.
  EXPECT_EQ(one("M138 A C"), "M138");
  EXPECT_EQ(one("L X1 M118 X10 Y2 M120 LA3 M8"), "L X1 M118 M120 M8");
  EXPECT_EQ(one("M120 LA"), "!E_SYNTAX@1:6");
  EXPECT_EQ(one("M120 LB3"), "!E_SYNTAX@1:6");
  EXPECT_EQ(one("M118 X1.x"), "!E_SYNTAX@1:6");
  EXPECT_EQ(one("M8 A"), "!E_SYNTAX@1:4");
  EXPECT_EQ(one("M129 F100"), "!E_SYNTAX@1:6");
  EXPECT_EQ(one("M3 M3 M9999 M0000"), "M3 M3 M9999 M0");
  EXPECT_EQ(one("M10000"), "!E_SYNTAX@1:1");
  EXPECT_EQ(one("M"), "!E_SYNTAX@1:1");
  EXPECT_EQ(one("M+3"), "!E_SYNTAX@1:1");
  EXPECT_EQ(one("MQ1"), "!E_SYNTAX@1:1");
  EXPECT_EQ(one("M3.1"), "!E_SYNTAX@1:1");
  EXPECT_EQ(one("L X1 M1 M2 M3 M4"), "L X1 M1 M2 M3 M4");
  EXPECT_EQ(one("L X1 M1 M2 M3 M4 M5 M6"), "!E_TOO_MANY_M@1:18");
  EXPECT_EQ(one("L X1 M1 M2 M3 M4 M5 Y1"), "!E_SYNTAX@1:21");
  EXPECT_EQ(one("M1 M2 M3 M4 M5"), "!E_TOO_MANY_M@1:13");
  EXPECT_EQ(one("STOP M1 M2 M3 M4 M5"), "!E_TOO_MANY_M@1:18");
  EXPECT_EQ(one("STOP"), "STOP");
  EXPECT_EQ(one("STOP M30"), "STOP M30");
  EXPECT_EQ(one("STOPP"), "!E_SYNTAX@1:1");
  EXPECT_EQ(read("M1 M2 M3 M4 M5\nM6"), (Blocks{"1: !E_TOO_MANY_M@1:13", "2: M6"}));
}

TEST(Klartext, ToolCall) {
  EXPECT_EQ(one("TOOL CALL 5 Z S1000 F250 DL+0.2 DR-,1 DR2+0.3"), "TOOL CALL 5 Z F250 DL.2 DR:-.1 DR2:.3");
  EXPECT_EQ(one("TOOL CALL 5 Z DR2:+0.3 DL:-1 S1 DR:2"), "TOOL CALL 5 Z DL-1 DR:2 DR2:.3");
  EXPECT_EQ(one("TOOL CALL 5 Z DR2.5"), "TOOL CALL 5 Z DR2:.5");  // DR2 wins over DR
  EXPECT_EQ(one("TOOL CALL 5 DR+2.5"), "TOOL CALL 5 DR:2.5");
  EXPECT_EQ(one("TOOL CALL 0 X"), "TOOL CALL 0 X");
  EXPECT_EQ(one("TOOL CALL 32767.9"), "TOOL CALL 32767.9");
  EXPECT_EQ(one("TOOL CALL"), "TOOL CALL");
  EXPECT_EQ(one("TOOL CALL S500"), "TOOL CALL");
  EXPECT_EQ(one("TOOL CALL Y FZQ1"), "TOOL CALL Y FZQ1");
  EXPECT_EQ(one("TOOL CALL \"Kugel \xC3\xA4 6\" Z"), "TOOL CALL \"Kugel \xC3\xA4 6\" Z");
  EXPECT_EQ(one("TOOL CALL QS1 Z"), "TOOL CALL QS0 Z");
  EXPECT_EQ(one("TOOL CALL 5 Z DRQ1 F AUTO"), "TOOL CALL 5 Z FAUTO DR:Q1");
  EXPECT_EQ(one("TOOL CALL \"" + std::string(32, 'A') + "\""), "TOOL CALL \"" + std::string(32, 'A') + "\"");
  const Block call = block_of("TOOL CALL 5.1");
  EXPECT_EQ(call.tool_number, 51U);
  EXPECT_EQ(call.tool_axis, '\0');
  for (const char* bad : {"5.0",
                          "5.",
                          "5.12",
                          "5,1",
                          "32768",
                          "-1",
                          "+5",
                          "\"\"",
                          "\"A",
                          "\"A\"Z",
                          "QS",
                          "Q5",
                          "5Z",
                          "D1",
                          "DX1",
                          "DR",
                          "DR2",
                          "DL",
                          "Z5",
                          "S",
                          "M3",
                          "R0",
                          "\"AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA\""})
    EXPECT_EQ(one("TOOL CALL "s + bad), "!E_SYNTAX@1:11") << bad;
  for (const char* bad : {"5", "X", "S1", "F1", "DL1", "DR+1", "DR2:1"})
    EXPECT_EQ(one("TOOL CALL 1 Z S1 F1 DL1 DR:1 DR2:1 "s + bad), "!E_SYNTAX@1:36") << bad;
  EXPECT_EQ(one("TOOL CALL Z 5"), "!E_SYNTAX@1:13");
}

TEST(Klartext, ToolDefinition) {
  EXPECT_EQ(one("TOOL DEF 5 L+10 R5"), "TOOL DEF 0");
  EXPECT_EQ(one("TOOL DEF \"A\" RQ1"), "TOOL DEF 0");
  EXPECT_EQ(one("TOOL DEF 5"), "TOOL DEF 0");
  EXPECT_EQ(one("TOOL DEF"), "!E_SYNTAX@1:9");
  EXPECT_EQ(one("TOOL DEF 5 L1 L2"), "!E_SYNTAX@1:15");
  EXPECT_EQ(one("TOOL DEF 5 S1"), "!E_SYNTAX@1:12");
  EXPECT_EQ(one("TOOL 5"), "!E_SYNTAX@1:1");
}

TEST(Klartext, BeginAndEnd) {
  EXPECT_EQ(read("; head\n*-\n0 BEGIN PGM A-1.\xE4 INCH\nEND PGM A INCH\nno \x01 program"),
            (Blocks{"3: 0 BEGIN PGM P INCH", "4: END PGM P INCH"}));
  EXPECT_EQ(read("M3\nBEGIN PGM A MM"), (Blocks{"1: M3", "2: !E_SYNTAX@2:1"}));
  EXPECT_EQ(read("G1\nBEGIN PGM A MM"), (Blocks{"1: !E_SYNTAX@1:1", "2: !E_SYNTAX@2:1"}));
  EXPECT_EQ(read("END PGM A\nM3"), (Blocks{"1: !E_SYNTAX@1:10", "2: M3"}));
  EXPECT_EQ(one("BEGIN PGM"), "!E_SYNTAX@1:10");
  EXPECT_EQ(one("BEGIN PGM MM"), "!E_SYNTAX@1:13");
  EXPECT_EQ(one("BEGIN PGM A CM"), "!E_SYNTAX@1:13");
  EXPECT_EQ(one("BEGIN PGM A MM X"), "!E_SYNTAX@1:16");
  EXPECT_EQ(one("BEGIN A MM"), "!E_SYNTAX@1:1");
  EXPECT_EQ(one("END"), "!E_SYNTAX@1:1");
}

TEST(Klartext, BlockForm) {
  EXPECT_EQ(block_of("BLK FORM 0.1 Z X-50 Y-50 ZQ1").statement, Statement::block_form);
  EXPECT_EQ(block_of("BLK FORM 0.2 IX50 IY50 IZ20").statement, Statement::block_form);
  EXPECT_EQ(one("BLK FORM 0.1 X0 Y0 Z0"), "!E_SYNTAX@1:14");
  EXPECT_EQ(one("BLK FORM 0.1 Z IX0 Y0 Z0"), "!E_SYNTAX@1:16");
  EXPECT_EQ(one("BLK FORM 0.1 Z X0 Z0 Y0"), "!E_SYNTAX@1:19");
  EXPECT_EQ(one("BLK FORM 0.2 X0 Y0"), "!E_SYNTAX@1:19");
  EXPECT_EQ(one("BLK FORM 0.3 X0 Y0 Z0"), "!E_SYNTAX@1:10");
  EXPECT_EQ(one("BLK FORM CUBE Z R50 L100"), "!E_SYNTAX@1:10");
  EXPECT_EQ(one("BLK 0.1"), "!E_SYNTAX@1:1");
}

TEST(Klartext, ToolCenterPointManagement) {
  constexpr const char* kTcpm = "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT ";
  EXPECT_EQ(one("FUNCTION TCPM F TCP AXIS SPAT PATHCTRL VECTOR"), kTcpm + "TIP-TIP"s);
  EXPECT_EQ(one("FUNCTION TCPM F CONT AXIS POS PATHCTRL AXIS REFPNT TIP-TIP"), kTcpm + "TIP-TIP"s);
  for (const char* word : {"TIP-CNT", "TIP-CENTER"})
    EXPECT_EQ(one("FUNCTION TCPM F CONT AXIS POS PATHCTRL AXIS REFPNT "s + word + " F500"), kTcpm + "TIP-CNT"s);
  for (const char* word : {"CNT-CNT", "center-center"})
    EXPECT_EQ(one("FUNCTION TCPM F CONT AXIS POS PATHCTRL AXIS REFPNT "s + word), kTcpm + "CNT-CNT"s);
  EXPECT_EQ(one("FUNCTION TCPM OFF"), "FUNCTION RESET TCPM");
  EXPECT_EQ(one("FUNCTION RESET TCPM"), "FUNCTION RESET TCPM");
  EXPECT_EQ(one("FUNCTION TCPM"), "!E_SYNTAX@1:14");
  EXPECT_EQ(one("FUNCTION TCPM F MAX AXIS POS PATHCTRL AXIS"), "!E_SYNTAX@1:15");
  EXPECT_EQ(one("FUNCTION TCPM AXIS POS F TCP PATHCTRL AXIS"), "!E_SYNTAX@1:15");
  EXPECT_EQ(one("FUNCTION TCPM F TCP AXIS POS"), "!E_SYNTAX@1:29");
  EXPECT_EQ(one("FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT CNT-TIP"), "!E_SYNTAX@1:51");
  EXPECT_EQ(one("FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS F500 REFPNT TIP-TIP"), "!E_SYNTAX@1:49");
  EXPECT_EQ(one("FUNCTION RESET"), "!E_SYNTAX@1:10");
  EXPECT_EQ(one("FUNCTION MILL"), "!E_SYNTAX@1:10");
}

TEST(Klartext, ProgrammedPath) {
  EXPECT_EQ(one("FUNCTION PROG PATH IS CONTOUR"), "FUNCTION PROG PATH IS CONTOUR");
  EXPECT_EQ(one("FUNCTION PROG PATH OFF"), "FUNCTION PROG PATH OFF");
  EXPECT_EQ(one("FUNCTION PROG PATH"), "!E_SYNTAX@1:19");
  EXPECT_EQ(one("FUNCTION PROG PATH CONTOUR"), "!E_SYNTAX@1:20");
  EXPECT_EQ(one("FUNCTION PROG PATH OFF M3"), "!E_SYNTAX@1:24");
}

TEST(Klartext, CorrectionTables) {
  EXPECT_EQ(one("SEL CORR-TABLE TCS \"TNC:\\table\\corr.tco\""), "SEL CORR-TABLE TCS \"\"");
  EXPECT_EQ(one("SEL CORR-TABLE WPL \"a\" ; b"), "SEL CORR-TABLE WPL \"\"");
  EXPECT_EQ(one("SEL CORR-TABLE \"a\""), "!E_SYNTAX@1:16");
  EXPECT_EQ(one("SEL CORR-TABLE TCS a"), "!E_SYNTAX@1:20");
  EXPECT_EQ(one("FUNCTION CORRDATA TCS #3"), "FUNCTION CORRDATA TCS #3");
  EXPECT_EQ(one("FUNCTION CORRDATA WPL #4"), "FUNCTION CORRDATA WPL #4");
  EXPECT_EQ(one("FUNCTION CORRDATA RESET"), "FUNCTION CORRDATA RESET");
  EXPECT_EQ(one("FUNCTION CORRDATA RESET TCS"), "FUNCTION CORRDATA RESET TCS");
  EXPECT_EQ(one("FUNCTION CORRDATA RESET WPL"), "FUNCTION CORRDATA RESET WPL");
  EXPECT_EQ(one("FUNCTION CORRDATA TCS 3"), "!E_SYNTAX@1:23");
  EXPECT_EQ(one("FUNCTION CORRDATA TCS #1000000000"), "!E_SYNTAX@1:23");
  EXPECT_EQ(one("FUNCTION CORRDATA TCS #4 M3"), "!E_SYNTAX@1:26");
  EXPECT_EQ(one("FUNCTION CORRDATA #3"), "!E_SYNTAX@1:19");
  EXPECT_EQ(error("M3\nFUNCTION CORRDATA ~\n TCS #4"), "p.h:3:6: the setup has no [[correction.tcs]] with number = 4");
}

TEST(Klartext, CyclesAndPlanes) {
  EXPECT_EQ(read("CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+10\nCYCL DEF 7.2 IY-5 Z0\nCYCL DEF 7.3"),
            (Blocks{"1: CYCL DEF 7.0", "2: CYCL DEF 7.1 X10", "3: CYCL DEF 7.2 IY-5 Z0", "4: CYCL DEF 7.3"}));
  EXPECT_EQ(one("CYCL DEF 32.2 HSC-MODE:0 TA0.5"), "CYCL DEF 32.2");
  EXPECT_EQ(one("CYCL DEF 247"), "CYCL DEF 247.0");
  EXPECT_EQ(one("CYCL DEF 7 X1"), "CYCL DEF 7.0");
  EXPECT_EQ(one("CYCL DEF 7.1 #5"), "!NOT_SUPPORTED@1:14");
  EXPECT_EQ(one("CYCL DEF 7.1 X1 X2"), "!E_SYNTAX@1:17");
  EXPECT_EQ(one("CYCL DEF 7.1 A1"), "!E_SYNTAX@1:14");
  EXPECT_EQ(one("CYCL DEF 7.1 U1"), "!E_SYNTAX@1:14");
  EXPECT_EQ(one("CYCL DEF 7.1 IX"), "!E_SYNTAX@1:14");
  EXPECT_EQ(one("CYCL DEF 7.A"), "!E_SYNTAX@1:10");
  EXPECT_EQ(one("CYCL DEF"), "!E_SYNTAX@1:9");
  EXPECT_EQ(one("CYCL CALL"), "!NOT_SUPPORTED@1:1");
  EXPECT_EQ(one("PLANE RESET STAY"), "PLANE RESET STAY");
  EXPECT_EQ(one("PLANE SPATIAL SPA+0 SPB-QL1 SPC,5 TURN MB MAX FMAX SEQ-"), "!NOT_JUDGED@1:1");
  EXPECT_EQ(one("PLANE SPATIAL SPA+0 SPB-,0 SPC0. TURN MB MAX FMAX SEQ-"), "PLANE RESET STAY");
  EXPECT_EQ(one("PLANE SPATIAL SPA0 SPC0 SPB0 STAY"), "!E_SYNTAX@1:20");
  EXPECT_EQ(one("PLANE SPATIAL SPA0 SPB0 SPC0"), "!E_SYNTAX@1:29");
  EXPECT_EQ(one("PLANE EULER"), "!NOT_JUDGED@1:1");
  EXPECT_EQ(one("PLANE"), "!E_SYNTAX@1:6");
}

TEST(Klartext, Assignments) {
  EXPECT_EQ(one("Q1 = +5.5"), "Q1 = 5.5");
  EXPECT_EQ(one("ql499=-q3"), "QL499 = -Q3");
  EXPECT_EQ(one("QR0 ~\n =1"), "QR0 = 1");
  EXPECT_EQ(one("FN 0: Q1999 = -,5"), "Q1999 = -.5");
  EXPECT_EQ(one("fn  0:Q1=1"), "Q1 = 1");
  EXPECT_EQ(one("FN 0: QL1 = 1"), "!E_SYNTAX@1:7");
  EXPECT_EQ(one("FN0: Q1 = 2."), "Q1 = 2");
  EXPECT_EQ(one("Q1 = - 200"), "Q1 = -200");
  EXPECT_EQ(one("Q1"), "!E_SYNTAX@1:3");
  EXPECT_EQ(one("Q1 ="), "!E_SYNTAX@1:5");
  EXPECT_EQ(one("Q2000 = 1"), "!E_SYNTAX@1:1");
  EXPECT_EQ(one("QS1 = \"A\""), "!NOT_SUPPORTED@1:1");
}

// By hand: what is a decimal is worked out where it is read, in the order in which blocks run.
TEST(Klartext, Formulas) {
  EXPECT_EQ(one("FN 1: Q1 = 1 + 2"), "Q1 = 3");
  EXPECT_EQ(one("FN 2: Q1 = +1.5 - +2"), "Q1 = -.5");
  EXPECT_EQ(one("FN 3: Q1 = -1,5 * -2"), "Q1 = 3");
  EXPECT_EQ(one("FN 4: Q1 = 1 DIV 8"), "Q1 = .125");
  EXPECT_EQ(one("Q1 = Q2 + 1"), "Q1 = 1") << "a parameter that was never set is 0";
  EXPECT_EQ(read("Q1 = 5\nQ2 = Q1 * ( 3 - 1.5 ) + 2 / 4\nQL3 = - ( Q2 - Q1 )\nQ1 = Q1 - 7 - -QL3"),
            (Blocks{"1: Q1 = 5", "2: Q2 = 8", "3: QL3 = -3", "4: Q1 = -5"}));
  EXPECT_EQ(read("LBL 1\nQ1 = Q1 + 1\nCALL LBL 1 REP 2").size(), 9U);
  EXPECT_EQ(read("Q1 = 1\nLBL 1\nQ1 = Q1 * 10\nCALL LBL 1 REP 2\n").back(), "4: CALL LBL 1 REP 2");
}

// As programs of old controls and of people are written.
TEST(Klartext, LooseSpelling) {
  EXPECT_EQ(one("L X-450. Y+5,"), "L X-450 Y5");
  EXPECT_EQ(one("L Z 25.0 X - 200"), "L X-200 Z25.0");
  EXPECT_EQ(one("L X+5 R F M"), "L X5");
  EXPECT_EQ(one("L X+5 R F"), "L X5");
  EXPECT_EQ(one("L X+5 F\r"), "L X5");
  EXPECT_EQ(one("L X+5 R0 F M3"), "L X5 R0 M3");
  EXPECT_EQ(one("L X+5 F 500"), "L X5 F500");
  EXPECT_EQ(one("L X+5 ; right ~\n Y+6"), "L X5 Y6");
}

TEST(Klartext, OtherLanguagesAreFaults) {
  EXPECT_EQ(read("%1 G71 *\nN10 G00 X1 *\nG01 X1\nX1\nCIRC X1\nCYCLE81(5)\nL1"),
            (Blocks{"1: !E_SYNTAX@1:1", "2: !E_SYNTAX@2:1", "3: !E_SYNTAX@3:1", "4: !E_SYNTAX@4:1", "5: !E_SYNTAX@5:1",
                    "6: !E_SYNTAX@6:1", "7: !E_SYNTAX@7:1"}));
}

TEST(Klartext, AFaultKeepsStatementAndNumber) {
  const Block block = block_of(" 17 TOOL CALL Z 5");
  EXPECT_EQ(block.statement, Statement::tool_call);
  EXPECT_EQ(block.n, 17U);
  EXPECT_EQ(block.column, 5U);
  EXPECT_EQ(block_of("17 NIX").statement, Statement::miscellaneous);
}

TEST(Klartext, BytesThatAreNoText) {
  EXPECT_EQ(error("L X1\nL \x01X2"), "p.h:2:3: control character 0x01; a program is ASCII text");
  EXPECT_EQ(error("L X1 ;a\x7F"), "p.h:1:8: control character 0x7F; a program is ASCII text");
  EXPECT_EQ(error("L X1\n\x1A"), "p.h:2:1: control character 0x1A; a program is ASCII text");
  EXPECT_EQ(error("L X1 ~\n ~\n Y\xE4"), "p.h:3:3: byte 0xE4 outside comments and strings; a program is ASCII text");
  EXPECT_EQ(error("L X\xE2\x88 1"), "p.h:1:4: byte 0xE2 outside comments and strings; a program is ASCII text");
  EXPECT_EQ(error("L X\xE2"), "p.h:1:4: byte 0xE2 outside comments and strings; a program is ASCII text");
  EXPECT_EQ(error("G1 \xE4"), "p.h:1:4: byte 0xE4 outside comments and strings; a program is ASCII text");
  EXPECT_EQ(error("/G1 \xE4", setup_with("XYZ", true)),
            "p.h:1:5: byte 0xE4 outside comments and strings; a program is ASCII text");
  EXPECT_EQ(error("CYCL DEF 4.0 TASCHENFR\xC4SEN"),
            "p.h:1:23: byte 0xC4 outside comments and strings; a program is ASCII text");
  EXPECT_EQ(error("* - \x02"), "p.h:1:5: control character 0x02; a program is ASCII text");
  EXPECT_EQ(error("L X1 ;\xE4\n* \xE4 \"\nTOOL CALL \"\xE4\"\n\u2212"), "no error");
  EXPECT_EQ(error("/* \xE4", setup_with("XYZ", true)), "no error");
  EXPECT_EQ(one("\u2212"), "!E_SYNTAX@1:1");
  EXPECT_EQ(one("L \u2212X1"), "!E_SYNTAX@1:3");
  Reader reader(text_source("\x01\nL X1"), kSetup);
  Block block;
  EXPECT_THROW((void)reader.next(block), InputError);
  EXPECT_FALSE(reader.next(block));
}

TEST(Klartext, ByteOrderMark) {
  EXPECT_EQ(read("\xEF\xBB\xBFL X1\nL X2"), (Blocks{"1: L X1", "2: L X2"}));
  EXPECT_EQ(one("\xEF\xBB\xBFL X1 !"), "!E_SYNTAX@1:9");  // columns count bytes
  EXPECT_EQ(error("\xEF\xBB\xBFL X1 \xE4"), "p.h:1:9: byte 0xE4 outside comments and strings; a program is ASCII text");
  EXPECT_EQ(error("L X1\n\xEF\xBB\xBFL X1").substr(0, 8), "p.h:2:1:");
}

// Text in pieces of every size.
TEST(Klartext, PiecesDoNotMatter) {
  const std::string text = "\xEF\xBB\xBF" + std::string(kExample) + "more";
  const Blocks whole = read(text);
  for (std::size_t size = 1; size < 40; ++size) {
    Reader reader(std::make_unique<toolcomp::fuzz::Pieces>(text, size), kSetup);
    Block block;
    std::size_t count = 0;
    while (reader.next(block)) ASSERT_EQ(std::to_string(block.line) + ": " + to_string(block), whole.at(count++));
    EXPECT_EQ(count, whole.size());
  }
}

// A block has room for 65535 bytes.
TEST(Klartext, LongBlocks) {
  const std::string room(65535 - 5, ' ');
  EXPECT_EQ(read("L X1" + room + ";\nM3"), (Blocks{"1: L X1", "2: M3"}));
  EXPECT_EQ(read("L X1" + room + ";;\nM3"), (Blocks{"1: !E_SYNTAX@1:1", "2: M3"}));
  EXPECT_EQ(read("12 L X1 " + room + "~\n Y1 ~\n\nM3"), (Blocks{"1: !E_SYNTAX@1:4", "4: M3"}));
  EXPECT_EQ(read("/" + room + room + "~\n Y1\nM3", setup_with("XYZ", true)), Blocks{"3: M3"});
  EXPECT_EQ(read("* " + room + room + "\nM3"), (Blocks{"1: !E_SYNTAX@1:1", "2: M3"}));
  EXPECT_EQ(error("L X1 " + room + room + "\n\x01").substr(0, 8), "p.h:2:1:");
  EXPECT_EQ(error("L X1 " + room + room + "\x01").substr(0, 11), "p.h:1:13106");
  EXPECT_EQ(error("L X1 ;" + room + room + "\xE4"), "no error");
}

class Lines final : public ByteSource {
 public:
  std::size_t read(char* buffer, std::size_t size) override {
    std::size_t count = 0;
    for (; count < size && left_ != 0; ++count) {
      buffer[count] = kLine[at_];
      if (++at_ == kLine.size()) at_ = 0, --left_;
    }
    return count;
  }

 private:
  static constexpr std::string_view kLine = "LN X+36.0084 Y+6.177 Z-1.9209 NX-0.4658107 NY+0 NZ+0.8848844\n";
  std::size_t at_ = 0;
  std::size_t left_ = 1'000'000;
};

// A program far longer than the buffer, in constant memory.
TEST(Klartext, LongPrograms) {
  Reader reader(std::make_unique<Lines>(), kSetup);
  rusage before{};
  getrusage(RUSAGE_SELF, &before);
  Block block;
  std::uint64_t count = 0;
  while (reader.next(block)) {
    ASSERT_EQ(block.line, ++count);
    ASSERT_FALSE(block.alarm);
    ASSERT_EQ(block.normal[2].digits, 8848844U);
  }
  rusage after{};
  getrusage(RUSAGE_SELF, &after);
  EXPECT_EQ(count, 1'000'000U);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 4096) << "KiB";
}

}  // namespace

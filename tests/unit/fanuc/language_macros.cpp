// SPDX-License-Identifier: Apache-2.0
// Custom macros in FANUC programs (fanuc.program.macro-variable, .macro-statement): blocks by hand.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <string_view>

#include "fuzz/targets/pieces.h"
#include "spec/language/alarm.h"
#include "spec/language/fanuc/program_reader.h"

#include "tests/support/usual_number.h"

namespace {

using namespace toolcomp;

spec::ReaderOptions told(unsigned decimals) {
  spec::ReaderOptions options;
  options.decimals = decimals;
  options.most_repeated = 1000;
  return options;
}

// The blocks in the order of the run, each with its line; what is not supported, or an alarm, ends them.
std::string blocks(std::string_view text, const spec::ReaderOptions& options = told(3)) {
  spec::ProgramReader reader(spec::text_source(text), spec::Axes("XYZAB"), options);
  std::string all;
  for (spec::Block block; reader.next(block);) {
    if (block.alarm) {
      const char* const message = spec::beyond(block);
      return all + std::to_string(block.line) + ':' + std::to_string(block.alarm->column) + ' ' +
             (message != nullptr ? std::string(message) : test::usual_number(block.alarm->cause)) + '\n';
    }
    all += std::to_string(block.line) + ' ' + to_string(block) + '\n';
  }
  return all;
}

TEST(Macros, NumbersOfWords) {
  EXPECT_EQ(blocks("O1\nG90\n#100 = 5.\nX#100 Y-#100\n"), "1 O1\n2 G90\n4 X5. Y-5.\n");
  EXPECT_EQ(blocks("#100=5\n#101=-[#100+2.5]*2\nX[#101] Y[#100-[#101*2]+1]\n"), "3 X-15. Y36.\n");
  EXPECT_EQ(blocks("N10 #1=3\nD#1 H#1 F[#1*100]\n"), "2 D3 H3 F300.\n");
  EXPECT_EQ(blocks("#1=2.5\nX#1 (of five)\n"), "2 X2.5\n");
  EXPECT_EQ(blocks("X1\n#1=2\nX#1\n#1=#1/4\nX#1"), "1 X1\n3 X2.\n5 X.5\n") << "anywhere";
  const std::string not_taken = " # (a macro variable whose value this address does not accept) is not supported\n";
  EXPECT_EQ(blocks("#1=2.5\nD#1"), "2:1" + not_taken);
  EXPECT_EQ(blocks("#1=-2\nH#1"), "2:1" + not_taken);
}

// 57.5 cos 22.5 = 53.1230…, 57.5 sin 22.5 = 22.0043…, 10 / 3, 2 / 3, the root of 2.
TEST(Macros, TheControlRoundsWordsOfLengthsAndAngles) {
  EXPECT_EQ(blocks("#1=57.5*COS[22.5]\n#2=57.5*SIN[22.5]\nX#1 Y-#2"), "3 X53.123 Y-22.004\n");
  EXPECT_EQ(blocks("X[10/3] A[2/3] I[SQRT[2]]"), "1 X3.333 A.667 I1.414\n");
  EXPECT_EQ(blocks("X[10/3]", told(4)), "1 X3.3333\n");
  EXPECT_EQ(blocks("G20\nX[10/3] A[10/3]"), "1 G20\n2 X3.3333 A3.333\n") << "inches have one decimal more";
  EXPECT_EQ(blocks("X[TAN[45]] Y[ABS[-2]] Z[FIX[2.7]+FUP[2.1]+ROUND[2.5]]"), "1 X1. Y2. Z8.\n");
  const std::string not_taken = " # (a macro variable whose value this address does not accept) is not supported\n";
  EXPECT_EQ(blocks("X[1/3]", told(0)), "1:1" + not_taken) << "nobody knows the increments";
  EXPECT_EQ(blocks("F[1/3]"), "1:1" + not_taken);
  EXPECT_EQ(blocks("X[0.0005]"), "1:1" + not_taken) << "half an increment: its rounding is not said";
  EXPECT_EQ(blocks("X[0.1*0.125+0.0000]"), "1:1" + not_taken);
}

TEST(Macros, Loops) {
  EXPECT_EQ(blocks("#1=0\nWHILE [#1 LT 3] DO1\n#1=#1+1\nX#1\nEND1\nY1"), "4 X1.\n4 X2.\n4 X3.\n6 Y1\n");
  EXPECT_EQ(blocks("#1=5\nwhile[#1gt5]do2\nX1\nWHILE[1 EQ 1]DO1\nEND1\nEND2\nY1"), "7 Y1\n") << "not once";
  EXPECT_EQ(blocks("#1=0\nWHILE[#1LE1]DO1\n#2=0\nWHILE[#2NE2]DO2\n#2=#2+1\nX#1 Y#2\nEND2\n#1=#1+1\nEND1"),
            "6 X0. Y1.\n6 X0. Y2.\n6 X1. Y1.\n6 X1. Y2.\n");
  EXPECT_EQ(blocks("#1=0\nDO1\n#1=#1+1\nX#1\nIF[#1 GE 2]GOTO 9\nEND1\nN9 Y1"), "4 X1.\n4 X2.\n7 N9 Y1\n");
  EXPECT_EQ(blocks("WHILE[1 EQ 0]DO1\nX1"), "1:1 WHILE (without its END) is not supported\n");
  EXPECT_EQ(blocks("END1"), "1:1 END (without DO) is not supported\n");
}

TEST(Macros, Jumps) {
  EXPECT_EQ(blocks("#1=0\nN5 X#1\n#1=#1+1\nIF [#1 LT 3] GOTO 5\nY1"), "2 N5 X0.\n2 N5 X1.\n2 N5 X2.\n5 Y1\n");
  EXPECT_EQ(blocks("N1 #1=1\nGOTO 7\nX1\nN7 Y1\nM30"), "4 N7 Y1\n5 M30\n") << "ahead";
  EXPECT_EQ(blocks("#1=0\nN1 X1\n#1=#1+1\nIF[#1 EQ 1] GOTO#1\nY1\nN1 Z#1"), "2 N1 X1\n6 N1 Z1.\n")
      << "the next of two blocks with the number";
  EXPECT_EQ(blocks("IF[1 EQ 1] #2=9"), "1:1 IF (without GOTO or THEN) is not supported\n");
  EXPECT_EQ(blocks("#1=1\nIF[#1 EQ 1] THEN #2=9\nIF[#1 EQ 2] THEN #2=8\nX#2"), "4 X9.\n");
  EXPECT_EQ(blocks("N1 #1=#2"),
            "1:4 # (a macro statement other than a variable set to an expression that toolcomp evaluates) is not "
            "supported\n");
  EXPECT_EQ(blocks("N1 X1\n#1=1\nGOTO 1"),
            "1 N1 X1\n3:1 GOTO (no block after the first macro statement has this number) is not supported\n");
  EXPECT_EQ(blocks("N3 #1=0\nX1\n#1=1\nIF[#1NE1]GOTO3\nY1"), "2 X1\n5 Y1\n");
  EXPECT_EQ(blocks("N1 GOTO 1"), "1:4 GOTO (more jumps than toolcomp follows) is not supported\n") << "an endless loop";
}

// 0.1 has no end in binary digits: whether three of it are 0.3 is the business of the control.
TEST(Macros, ComparisonsThatTheControlDecides) {
  const std::string undecided =
      " IF (a comparison that toolcomp does not evaluate, or whose result depends on the digits of the control) is not "
      "supported\n";
  EXPECT_EQ(blocks("IF[0.1+0.1+0.1 EQ 0.3]GOTO1\nN1 X1"), "1:1" + undecided);
  EXPECT_EQ(blocks("IF[0.1 EQ 0.10]GOTO1\nX2\nN1 X1"), "3 N1 X1\n") << "as it is written";
  EXPECT_EQ(blocks("IF[0.5+0.25 EQ 0.75]GOTO1\nX2\nN1 X1"), "3 N1 X1\n");
  EXPECT_EQ(blocks("IF[0.1+0.1+0.1 LT 0.31]GOTO1\nX2\nN1 X1"), "3 N1 X1\n");
  EXPECT_EQ(blocks("IF[SIN[30] EQ 0.5]GOTO1\nN1 X1"), "1:1" + undecided);
  EXPECT_EQ(blocks("IF[#5 EQ #0]GOTO1\nN1 X1"), "1:1" + undecided) << "vacant variables are not followed";
}

TEST(Macros, Calls) {
  EXPECT_EQ(blocks("#1=1\nM98 P2\nM30\nO2\nX#1\nM99\n"), "2 M98 P2\n4 O2\n5 X1.\n6 M99\n3 M30\n");
  EXPECT_EQ(blocks("#1=1\nG65 P2 A5. H3 F100 X-2.5\nX#1\nM30\nO2\nX#1 Y#24 H#11 F#9\nM99\n"),
            "5 O2\n6 X5. Y-2.5 H3 F100.\n7 M99\n3 X1.\n4 M30\n")
      << "local variables of its own";
  EXPECT_EQ(blocks("#1=30\n#2=4\nG65 P2 X-#2 Y-[#2] Z-SIN[#1]\nM30\nO2\nX#24 Y#25 Z#26\nM99"),
            "5 O2\n6 X-4. Y-4. Z-.5\n7 M99\n4 M30\n")
      << "a sign before a variable, which has no point of its own";
  EXPECT_EQ(blocks("G65 P2 X--1.\nM30\nO2\nM99"), "1:1 G65 (with this argument) is not supported\n");
  EXPECT_EQ(blocks("#100=2\nG65 P#100 Z1.\nM30\nO2\n#100=#26\nM99"), "4 O2\n6 M99\n3 M30\n");
  EXPECT_EQ(blocks("G65 P2 X10\nM30\nO2\nM99"), "1:8 G65 (an argument without a decimal point) is not supported\n");
  EXPECT_EQ(blocks("G65 P2 I1. I2.\nM30\nO2\nM99"), "1:1 G65 (with this argument) is not supported\n");
  EXPECT_EQ(blocks("N1 G65 P3"), "1:4 G65 (macro call of a program that is missing) is not supported\n");
  EXPECT_EQ(blocks("#1=3\nM98 P#1"), "2:1 # (the number of a program that is missing) is not supported\n");
  EXPECT_EQ(blocks("#1=0\nWHILE[#1LT2]DO1\n#1=#1+1\nM98P2\nEND1\nM30\nO2\nX#1\nM99"),
            "4 M98 P2\n7 O2\n8 X1.\n9 M99\n4 M98 P2\n7 O2\n8 X2.\n9 M99\n6 M30\n");
}

TEST(Macros, InSmallPieces) {
  constexpr std::string_view kText = "O1\nN1 #1=0\nWHILE[#1LT2]DO1\nN2 #1=#1+1\nX#1\nEND1\nIF[#1EQ2]GOTO3\nX9\nN3 Y1\n";
  spec::ProgramReader reader(std::make_unique<fuzz::Pieces>(kText, 1), spec::Axes("XYZAB"), told(3));
  std::string all;
  for (spec::Block block; reader.next(block);) all += std::to_string(block.line) + ' ' + to_string(block) + '\n';
  EXPECT_EQ(all, blocks(kText));
  EXPECT_EQ(all, "1 O1\n5 X1.\n5 X2.\n9 N3 Y1\n");
}

TEST(Macros, RepeatedBlocksAreCounted) {
  const std::string said = blocks("#1=0\nWHILE[#1LT1000]DO1\n#1=#1+1\nX1\nY1\nEND1");
  EXPECT_TRUE(said.ends_with(" GOTO (more blocks than toolcomp runs) is not supported\n"))
      << said.substr(said.size() - 90);
}

}  // namespace

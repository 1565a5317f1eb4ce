// SPDX-License-Identifier: Apache-2.0
// Usual lines as columns (ProgramReader::lines). Numbers, places and line numbers are counted by hand; then random
// lines are held against the same reader block by block.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "spec/language/fanuc/program_reader.h"
#include "spec/language/line_columns.h"

namespace {

using namespace toolcomp::spec;

struct Reading {
  explicit Reading(std::string_view given) : text(given), reader(text_source(text), Axes("XYZBC")) {
    EXPECT_TRUE(reader.next(block));
  }
  std::size_t lines(std::size_t most = LineColumns::kMost) {
    reader.lines(*columns, most);
    return columns->size;
  }
  [[nodiscard]] double word(char letter, std::size_t line) const { return columns->columns[word_place(letter)][line]; }

  std::string text;
  ProgramReader reader;
  Block block;
  std::unique_ptr<LineColumns> columns = std::make_unique<LineColumns>();
};

TEST(LineReader, GivesWordsAsWholeNumbersOfSixPlaces) {
  Reading of("G01 X0\nX1.5 Y-0.000001\nX-2 Y+3.25\nX.5Y1234567.\n");
  ASSERT_EQ(of.lines(), 3U);
  EXPECT_EQ(of.columns->words, place_bit(word_place('X')) | place_bit(word_place('Y')));
  EXPECT_EQ(of.columns->line, 2U);
  EXPECT_EQ(of.columns->code, LineColumns::kNoCode);
  EXPECT_FALSE(of.columns->numbered);
  EXPECT_EQ(of.word('X', 0), 1'500'000);
  EXPECT_EQ(of.word('Y', 0), -1);
  EXPECT_EQ(of.word('X', 1), -2'000'000);
  EXPECT_EQ(of.word('Y', 1), 3'250'000);
  EXPECT_EQ(of.word('X', 2), 500'000);
  EXPECT_EQ(of.word('Y', 2), 1'234'567'000'000);
}

TEST(LineReader, AnAxisThatIsNotNamedStays) {
  Reading of("G01 X0\nX1 Y2\nY3\nX4\n");
  ASSERT_EQ(of.lines(), 3U);
  EXPECT_EQ(of.word('X', 1), 1'000'000);
  EXPECT_EQ(of.word('Y', 1), 3'000'000);
  EXPECT_EQ(of.word('X', 2), 4'000'000);
  EXPECT_EQ(of.word('Y', 2), 3'000'000);
  // I J K are those of one block: one that lacks them is another line.
  Reading directed("G01 X0\nX1 I1 J0 K0\nX2 I0 J1 K0\nX3\n");
  EXPECT_EQ(directed.lines(), 2U);
}

TEST(LineReader, NumbersAndCodesGoAlong) {
  Reading of("N10 G01 X0\nN020 G01 X1\nN30 X2\r\nN40 G1X3\n");
  ASSERT_EQ(of.lines(), 3U);
  EXPECT_EQ(of.columns->code, 1);
  EXPECT_TRUE(of.columns->numbered);
  EXPECT_EQ(of.columns->n[0], 20U);
  EXPECT_EQ(of.columns->n[2], 40U);
  EXPECT_EQ(of.columns->column[0], 6U);  // G stands after N020 and a blank
  EXPECT_EQ(of.columns->column[1], 5U);
}

TEST(LineReader, StopsAtAnyOtherLine) {
  for (const std::string_view other :
       {"G02 X1", "G00 X1", "X1 F100", "X1.1234567", "X12345678", "X",   "X1 X2",  "Y1",  "X1;",   "X1 (text)",
        "/X1",    "#1=2",   "X#1",     "X[1]",       "X--1",      "X1-", "X1.2.3", "M08", "",      "N5",
        "N5 X1",  "x1",     "%",       "X 1",        "X1  ",      "D1",  "G01",    "U1",  "X1 M30"}) {
    Reading of("G01 X0\nG01 X1\nX2\n" + std::string(other) + "\nX3\n");
    EXPECT_EQ(of.lines(), 2U) << other;
  }
  // Where the text ends within a line, it may go on.
  Reading open("G01 X0\nX1\nX2");
  EXPECT_EQ(open.lines(), 1U);
}

TEST(LineReader, LinesThatAreNotPassedAreBlocks) {
  Reading of("G01 X0\nX1\nX2\nX3\nM30\n");
  ASSERT_EQ(of.lines(), 3U);
  of.reader.pass_lines(2);
  ASSERT_TRUE(of.reader.next(of.block));
  EXPECT_EQ(to_string(of.block), "X3");
  EXPECT_EQ(of.block.line, 4U);
  EXPECT_EQ(of.lines(), 0U);
  ASSERT_TRUE(of.reader.next(of.block));
  EXPECT_EQ(to_string(of.block), "M30");
}

TEST(LineReader, IsAskedForAsManyAsAreWanted) {
  std::string text = "G01 X0\n";
  for (int i = 0; i < 1000; ++i) text += "X1\n";
  Reading of(text);
  EXPECT_EQ(of.lines(8), 8U);
  EXPECT_EQ(of.lines(), LineColumns::kMost);
}

// Not in a program that is called: its blocks come from another text.
TEST(LineReader, GivesNoneInsideACall) {
  Reading of("M98 P100\nX1\nX2\nM30\nO100\nX5\nX6\nX7\nM99\n");
  ASSERT_TRUE(of.reader.next(of.block));
  ASSERT_TRUE(of.reader.next(of.block));
  EXPECT_EQ(to_string(of.block), "X5");
  EXPECT_EQ(of.lines(), 0U);
}

TEST(LineReader, ReadsWhatBlocksHave) {
  std::mt19937_64 random(1);
  const auto below = [&](unsigned n) { return static_cast<unsigned>(random() % n); };
  std::size_t in_columns = 0;
  for (int round = 0; round < 300; ++round) {
    // Longer than the buffer of the reader now and then.
    std::string text = "G01 X0\n";
    const unsigned size = round % 50 == 0 ? 6000 : below(60);
    for (unsigned i = 0; i < size; ++i) {
      if (round % 3 == 0) text += "N" + std::to_string(below(100000)) + (below(2) == 0 ? " " : "");
      if (below(5) == 0) text += "G01";
      for (const char letter : std::string_view("XYZ"))
        if (below(20) != 0) {
          text += letter;
          if (const unsigned sign = below(3); sign != 0) text += sign == 1 ? "-" : "+";
          text += std::to_string(below(3) == 0 ? below(10) : below(10'000'000)).substr(0, 1 + below(7));
          if (below(4) != 0) text += "." + std::to_string(1'000'000 + below(1'000'000)).substr(1, below(7));
          if (below(4) == 0) text += " ";
        }
      text += below(30) == 0 ? "F1\n" : "\n";
    }
    Reading of(text);
    ProgramReader blocks(text_source(text), Axes("XYZBC"));
    Block block;
    ASSERT_TRUE(blocks.next(block));
    for (;;) {
      const std::size_t lines = of.lines(1 + below(LineColumns::kMost));
      const std::size_t passed = lines == 0 ? 0 : below(static_cast<unsigned>(lines) + 1);
      for (std::size_t i = 0; i < passed; ++i) {
        ASSERT_TRUE(blocks.next(block));
        EXPECT_EQ(block.line, of.columns->line + i);
        EXPECT_EQ(block.n.has_value(), of.columns->numbered);
        EXPECT_EQ(block.n.value_or(0), of.columns->numbered ? of.columns->n[i] : 0);
        EXPECT_EQ(block.word[0].column, of.columns->column[i]);
        for (const Word& word : block.words()) {
          const auto digits = static_cast<double>(word.value.digits);
          if (word.address == 'G')
            EXPECT_EQ(digits, of.columns->code);
          else  // Exact: no more than 13 digits.
            EXPECT_EQ(digits * std::pow(10.0, 6 - word.value.decimals) * (word.value.negative ? -1 : 1),
                      of.word(word.address, i));
        }
        ++in_columns;
      }
      if (passed > 0) of.reader.pass_lines(passed);
      const bool more = blocks.next(block);
      ASSERT_EQ(of.reader.next(of.block), more);
      if (!more) break;
      EXPECT_EQ(to_string(of.block), to_string(block));
      EXPECT_EQ(of.block.line, block.line);
    }
  }
  EXPECT_GT(in_columns, 5000U);
}

}  // namespace

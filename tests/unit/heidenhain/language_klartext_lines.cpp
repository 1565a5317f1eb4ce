// SPDX-License-Identifier: Apache-2.0
// Usual LN blocks as columns (klartext::Reader::lines). Numbers, places and line numbers are counted by hand; then
// random lines are held against the same reader block by block.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <string_view>

#include "spec/language/heidenhain/klartext_reader.h"
#include "spec/language/line_columns.h"

namespace {

using namespace toolcomp::spec;

Setup milling() {
  Setup setup;
  setup.control = Control::heidenhain;
  setup.axes = Axes("XYZAC");
  return setup;
}

struct Reading {
  explicit Reading(std::string_view given) : text(given), reader(text_source(text), setup) {
    EXPECT_TRUE(reader.next(block));
  }
  std::size_t lines(std::size_t most = LineColumns::kMost) {
    reader.lines(*columns, most);
    return columns->size;
  }
  [[nodiscard]] double at(std::size_t place, std::size_t line) const { return columns->columns[place][line]; }

  Setup setup = milling();
  std::string text;
  klartext::Reader reader;
  klartext::Block block;
  std::unique_ptr<LineColumns> columns = std::make_unique<LineColumns>();
};

constexpr std::string_view kBegin = "BEGIN PGM T MM\n";

TEST(KlartextLines, GivesWordsAsWholeNumbersOfSixAndEightPlaces) {
  Reading of(std::string(kBegin) + "LN X+1.5 Y-0.00001 Z99999 NX0.6 NY-.8 NZ+0\n" +
             "LN X2. Y+3.25 Z-.5 NX0.29940801 NY-0.1984229 NZ9.99999999\r\n");
  ASSERT_EQ(of.lines(), 2U);
  EXPECT_EQ(of.columns->words, 0b111U << word_place('X') | 0b111U << kNormalPlace);
  EXPECT_EQ(of.columns->line, 2U);
  EXPECT_FALSE(of.columns->numbered);
  EXPECT_EQ(of.columns->column[0], 1U);
  EXPECT_EQ(of.at(word_place('X'), 0), 1'500'000);
  EXPECT_EQ(of.at(word_place('Y'), 0), -10);
  EXPECT_EQ(of.at(word_place('Z'), 0), 99'999'000'000);
  EXPECT_EQ(of.at(kNormalPlace, 0), 60'000'000);
  EXPECT_EQ(of.at(kNormalPlace + 1, 0), -80'000'000);
  EXPECT_EQ(of.at(kNormalPlace + 2, 0), 0);
  EXPECT_EQ(of.at(word_place('X'), 1), 2'000'000);
  EXPECT_EQ(of.at(word_place('Z'), 1), -500'000);
  EXPECT_EQ(of.at(kNormalPlace, 1), 29'940'801);
  EXPECT_EQ(of.at(kNormalPlace + 1, 1), -19'842'290);
  EXPECT_EQ(of.at(kNormalPlace + 2, 1), 999'999'999);
}

TEST(KlartextLines, ToolVectorsAndNumbersGoAlong) {
  Reading of(std::string(kBegin) +
             "7 LN X1 Y2 Z3 NX0 NY0 NZ1 TX0 TY.6 TZ.8\n0012 LN X1 Y2 Z3 NX0 NY0 NZ1 TX0 TY0 TZ1\n");
  ASSERT_EQ(of.lines(), 2U);
  EXPECT_TRUE(of.columns->numbered);
  EXPECT_EQ(of.columns->n[0], 7U);
  EXPECT_EQ(of.columns->n[1], 12U);
  EXPECT_EQ(of.columns->column[1], 6U);
  EXPECT_EQ(of.at(kToolVectorPlace + 1, 0), 60'000'000);
  EXPECT_EQ(of.at(kToolVectorPlace + 2, 0), 80'000'000);
}

TEST(KlartextLines, StopsAtAnyOtherBlock) {
  for (const std::string_view other : {"LN X1 Y1 Z1 NX0 NY0 NZ1 F500",
                                       "LN X1 Y1 Z1 NX0 NY0 NZ1 F MAX",
                                       "LN X1 Y1 Z1 NX0 NY0 NZ1 M8",
                                       "LN X1 Y1 Z1 NX0 NY0 NZ1 R0",
                                       "LN X1 Y1 Z1 NX0 NY0 NZ1 ; text",
                                       "LN X1 Y1 Z1 NX0 NY0 NZ1 ~",
                                       "LN X1.000001 Y1 Z1 NX0 NY0 NZ1",
                                       "LN X100000 Y1 Z1 NX0 NY0 NZ1",
                                       "LN X1 Y1 Z1 NX0.123456789 NY0 NZ1",
                                       "LN X1 Y1 Z1 NX10 NY0 NZ1",
                                       "LN X1 Y1 Z1 NX0 NY0 NZ0",
                                       "LN X1 Y1 Z1 NX-0 NY+0 NZ0.0",
                                       "LN X1,5 Y1 Z1 NX0 NY0 NZ1",
                                       "LN X\u22121 Y1 Z1 NX0 NY0 NZ1",
                                       "LN XQ1 Y1 Z1 NX0 NY0 NZ1",
                                       "ln X1 Y1 Z1 NX0 NY0 NZ1",
                                       "LN X1 Y1 Z1 NX0 NY0",
                                       "LN Y1 X1 Z1 NX0 NY0 NZ1",
                                       "LN X1 Y1 Z1 NY0 NX0 NZ1",
                                       "LN X1 Y1 NX0 NY0 NZ1",
                                       "LN X1 Y1 Z1 TX0 TY0 TZ1",
                                       "LN X1 Y1 Z1",
                                       "LN X1 Y1 Z1NX0 NY0 NZ1",
                                       "LN  X1 Y1 Z1 NX0 NY0 NZ1",
                                       "LN\tX1 Y1 Z1 NX0 NY0 NZ1",
                                       "L X1 Y1 Z1",
                                       "LN IX1 Y1 Z1 NX0 NY0 NZ1",
                                       "LN X1 Y1 Z1 NX0 NY0 NZ1 TX0 TY0 TZ1",
                                       "5 LN X1 Y1 Z1 NX0 NY0 NZ1",
                                       "/LN X1 Y1 Z1 NX0 NY0 NZ1",
                                       " LN X1 Y1 Z1 NX0 NY0 NZ1",
                                       "LN X1.2.3 Y1 Z1 NX0 NY0 NZ1",
                                       "LN X- Y1 Z1 NX0 NY0 NZ1",
                                       "END PGM T MM",
                                       "* - text",
                                       ""}) {
    Reading of(std::string(kBegin) + "LN X1 Y1 Z1 NX0 NY0 NZ1\nLN X2 Y1 Z1 NX0 NY0 NZ1\n" + std::string(other) +
               "\nLN X3 Y1 Z1 NX0 NY0 NZ1\n");
    EXPECT_EQ(of.lines(), 2U) << other;
  }
  // Where the text ends within a line, it may go on.
  Reading open(std::string(kBegin) + "LN X1 Y1 Z1 NX0 NY0 NZ1\nLN X1 Y1 Z1 NX0 NY0 NZ1");
  EXPECT_EQ(open.lines(), 1U);
}

TEST(KlartextLines, LinesThatAreNotPassedAreBlocks) {
  Reading of(std::string(kBegin) +
             "LN X1 Y1 Z1 NX0 NY0 NZ1\nLN X2 Y1 Z1 NX0 NY0 NZ1\nLN X3 Y1 Z1 NX0 NY0 NZ1\nEND PGM T MM\n");
  EXPECT_EQ(of.lines(1), 1U);
  ASSERT_EQ(of.lines(), 3U);
  of.reader.pass_lines(2);
  ASSERT_TRUE(of.reader.next(of.block));
  EXPECT_EQ(klartext::to_string(of.block), "LN X3 Y1 Z1 NX0 NY0 NZ1");
  EXPECT_EQ(of.block.line, 4U);
  EXPECT_EQ(of.lines(), 0U);
  EXPECT_TRUE(of.reader.next(of.block));
  EXPECT_FALSE(of.reader.next(of.block));
  EXPECT_EQ(of.lines(), 0U);
}

// The blocks after a call come from where it says.
TEST(KlartextLines, GivesNoneInAProgramThatCalls) {
  Reading of(std::string(kBegin) + "LBL 1\nLN X1 Y1 Z1 NX0 NY0 NZ1\nLN X2 Y1 Z1 NX0 NY0 NZ1\nCALL LBL 1 REP 2\n");
  ASSERT_TRUE(of.reader.next(of.block));
  EXPECT_EQ(of.lines(), 0U);
}

TEST(KlartextLines, ReadsWhatBlocksHave) {
  std::mt19937_64 random(1);
  const auto below = [&](unsigned n) { return static_cast<unsigned>(random() % n); };
  std::size_t in_columns = 0;
  for (int round = 0; round < 200; ++round) {
    // Longer than the buffer of the reader now and then.
    std::string text(kBegin);
    const unsigned size = round % 40 == 0 ? 4000 : below(60);
    const auto number = [&](unsigned before, unsigned after) {
      std::string digits =
          std::string(below(3) == 0 ? "-" : "") + std::to_string(random()).substr(0, 1 + below(before));
      if (below(5) != 0) digits += "." + std::to_string(random() | 1U << 30U).substr(0, 1 + below(after));
      return digits;
    };
    for (unsigned i = 0; i < size; ++i) {
      if (round % 3 == 0) text += std::to_string(below(100000)) + " ";
      text += "LN X" + number(5, 5) + " Y" + number(5, below(30) == 0 ? 6 : 5) + " Z" + number(5, 5);
      for (const std::string_view vector : {"N", "T"}) {
        if (vector == "T" && round % 2 == 0) continue;
        for (const char letter : std::string_view("XYZ")) text += fmt::format(" {}{}{}", vector, letter, number(1, 8));
      }
      text += below(30) == 0 ? " F1\n" : "\n";
    }
    Reading of(text);
    klartext::Reader blocks(text_source(text), of.setup);
    klartext::Block block;
    ASSERT_TRUE(blocks.next(block));
    for (;;) {
      const std::size_t lines = of.lines(1 + below(LineColumns::kMost));
      const std::size_t passed = lines == 0 ? 0 : below(static_cast<unsigned>(lines) + 1);
      for (std::size_t i = 0; i < passed; ++i) {
        ASSERT_TRUE(blocks.next(block));
        ASSERT_FALSE(block.alarm.has_value());
        ASSERT_FALSE(block.many_digits);
        EXPECT_EQ(block.line, of.columns->line + i);
        EXPECT_EQ(block.n.has_value(), of.columns->numbered);
        EXPECT_EQ(block.column, of.columns->column[i]);
        // Exact: no more than 13 digits.
        const auto is = [&](const Decimal& value, std::size_t place, int places) {
          EXPECT_EQ(
              static_cast<double>(value.digits) * std::pow(10.0, places - value.decimals) * (value.negative ? -1 : 1),
              of.at(place, i));
        };
        for (std::size_t k = 0; k < 3; ++k) {
          is(block.axis.at(k).number, word_place('X') + k, 6);
          is(block.normal.at(k), kNormalPlace + k, 8);
          if (block.has_tool_vector) is(block.tool_vector.at(k), kToolVectorPlace + k, 8);
        }
        ++in_columns;
      }
      if (passed > 0) of.reader.pass_lines(passed);
      const bool more = of.reader.next(of.block);
      ASSERT_EQ(blocks.next(block), more);
      if (!more) break;
      EXPECT_EQ(block.line, of.block.line);
    }
  }
  EXPECT_GT(in_columns, 1000U);
}

}  // namespace

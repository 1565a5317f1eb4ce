// SPDX-License-Identifier: Apache-2.0
// The reading rules of spec/language/README.md, one test a rule; positions are counted by hand.
#include "spec/language/fanuc/program_reader.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/targets/pieces.h"
#include "spec/language/input_error.h"
#include "tests/support/usual_number.h"

namespace {

using namespace toolcomp::spec;
using namespace std::string_view_literals;

// Every block as "LINE: text", with " !NUMBER@COLUMN" for an alarm.
std::vector<std::string> read(std::string_view text, std::string_view axes = "XYZBC", ReaderOptions options = {}) {
  ProgramReader reader(text_source(text), Axes(axes), std::move(options));
  std::vector<std::string> blocks;
  Block block;
  while (reader.next(block)) {
    std::string shown = std::to_string(block.line) + ": " + to_string(block);
    if (block.alarm)
      shown += " !" + toolcomp::test::usual_number(block.alarm->cause) + "@" + std::to_string(block.alarm->column);
    blocks.push_back(shown);
  }
  return blocks;
}

using Blocks = std::vector<std::string>;

// The one alarm of a text of one block: "NUMBER@COLUMN".
std::string alarm(std::string_view text) {
  const Blocks blocks = read(text);
  if (blocks.size() != 1) return std::to_string(blocks.size()) + " blocks";
  const std::size_t mark = blocks[0].find('!');
  return mark == std::string::npos ? "no alarm" : blocks[0].substr(mark + 1);
}

std::string error(std::string_view text, ReaderOptions options = {}) {
  try {
    read(text, "XYZBC", std::move(options));
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

TEST(ProgramReader, WordsKeepTheirNumbersAsWritten) {
  ProgramReader reader(text_source("G1X-0 Y1.50Z+.5 F1000."), Axes("XYZ"));
  Block block;
  ASSERT_TRUE(reader.next(block));
  ASSERT_EQ(block.size, 5U);
  EXPECT_EQ(block.word[0], (Word{'G', {1, 0, false, false}}));
  EXPECT_EQ(block.word[1], (Word{'X', {0, 0, true, false}}));
  EXPECT_EQ(block.word[2], (Word{'Y', {150, 2, false, true}}));
  EXPECT_EQ(block.word[3], (Word{'Z', {5, 1, false, true}}));
  EXPECT_EQ(block.word[4], (Word{'F', {1000, 0, false, true}}));
  EXPECT_EQ(block.word[1].column, 3U);
  EXPECT_EQ(block.word[4].column, 17U);
  EXPECT_FALSE(reader.next(block));
  EXPECT_FALSE(reader.next(block));
}

TEST(ProgramReader, LinesAndSemicolonsEndBlocks) {
  EXPECT_EQ(read("G0\nX1;Y2\r\n\n;;Z3"), (Blocks{"1: G0", "2: X1", "2: Y2", "4: Z3"}));
}

TEST(ProgramReader, BlanksDoNotMatterButEndANumber) {
  EXPECT_EQ(read(" \tG 1 X\t- 5\r\n"), (Blocks{"1: G1 !PS0005@7"}));
  EXPECT_EQ(read("G 1X \t -5Y6"), (Blocks{"1: G1 X-5 Y6"}));
  EXPECT_EQ(alarm("X1 2"), "PS0004@4");
  EXPECT_EQ(alarm("X1. 5"), "PS0004@5");
}

TEST(ProgramReader, LowerCaseReadsAsUpperCase) { EXPECT_EQ(read("g01 x1 n5"), (Blocks{"1: N5 G1 X1"})); }

TEST(ProgramReader, SequenceNumbersAreNoWords) {
  ProgramReader reader(text_source("N10 X1 N20\nN30\nN007(only a number)\nX2"), Axes("XYZ"));
  Block block;
  ASSERT_TRUE(reader.next(block));
  EXPECT_EQ(block.n, 20U);
  EXPECT_EQ(block.size, 1U);
  ASSERT_TRUE(reader.next(block));  // N alone makes no block
  EXPECT_EQ(block.line, 4U);
  EXPECT_EQ(block.n, std::nullopt);
  EXPECT_FALSE(reader.next(block));
}

TEST(ProgramReader, ProgramNumbersStayWords) {
  EXPECT_EQ(read("O0001\n:22\nX1"), (Blocks{"1: O1", "2: O22", "3: X1"}));
}

TEST(ProgramReader, CommentsAreIgnored) {
  EXPECT_EQ(read("(one; % / two)G0(#=\xC3\xA4\xFF)X1(unclosed ;\nY1)"sv), (Blocks{"1: G0 X1", "2: Y1 !PS0004@3"}));
  EXPECT_EQ(read("X(no number)1"), (Blocks{"1:  !PS0005@1"}));
  EXPECT_EQ(read("( ( nested ends here ) X1"), (Blocks{"1: X1"}));
}

TEST(ProgramReader, PercentBeginsAndEnds) {
  EXPECT_EQ(read("%\nO1\nG0\n%\nX1"), (Blocks{"2: O1", "3: G0"}));
  EXPECT_EQ(read("G0 X1 %Y2\nZ3"), (Blocks{"1: G0 X1"}));
  EXPECT_EQ(read(" (title)\n%\n(more)\nX1"), (Blocks{"4: X1"}));
  EXPECT_EQ(read("%\n%\nX1"), Blocks{});
  EXPECT_EQ(read("% X1"), (Blocks{"1: X1"}));
}

TEST(ProgramReader, NothingIsReadBehindTheEnd) { EXPECT_EQ(read("X1\n%\n\0\xFF"sv), (Blocks{"1: X1"})); }

TEST(ProgramReader, BlockSkip) {
  const char* text = "/X1\n/2 Y2; Z3\nN5 X4 /\nX5";
  EXPECT_EQ(read(text), (Blocks{"1: X1", "2: Y2", "2: Z3", "3: N5 X4 !PS0004@7", "4: X5"}));
  EXPECT_EQ(read(text, "XYZ", {.block_skip = true}), (Blocks{"2: Z3", "3: N5 X4 !PS0004@7", "4: X5"}));
  EXPECT_EQ(read("/X1.2.3 (;) Y--1\nX2", "XYZ", {.block_skip = true}), (Blocks{"2: X2"}));
  EXPECT_EQ(read("/1/3 X1"), (Blocks{"1: X1"}));
  EXPECT_EQ(alarm("/0 X1"), "PS0004@2");
  EXPECT_EQ(alarm("N1 /X1"), "PS0004@4");
}

// docs/events.md, rule 5.
TEST(ProgramReader, AlarmsByPosition) {
  EXPECT_EQ(alarm("X123456789012345"), "no alarm");
  EXPECT_EQ(alarm("X1234567890123456"), "PS0003@17");
  EXPECT_EQ(alarm("X-12345678.12345678"), "PS0003@19");
  EXPECT_EQ(alarm("N1234567890123456 X1"), "PS0003@17");
  EXPECT_EQ(alarm("5"), "PS0004@1");
  EXPECT_EQ(alarm("-X5"), "PS0004@1");
  EXPECT_EQ(alarm("X1-"), "PS0004@3");
  EXPECT_EQ(alarm("X1 -2"), "PS0004@4");
  EXPECT_EQ(alarm(".5"), "PS0004@1");
  EXPECT_EQ(alarm("X"), "PS0005@1");
  EXPECT_EQ(alarm("G1 X Y1"), "PS0005@4");
  EXPECT_EQ(alarm("X."), "PS0005@1");
  EXPECT_EQ(alarm("X-"), "PS0005@1");
  EXPECT_EQ(alarm("X--1"), "PS0006@3");
  EXPECT_EQ(alarm("X-1-2"), "PS0006@4");
  EXPECT_EQ(alarm("X+-1"), "PS0006@3");
  EXPECT_EQ(alarm("X1.2.3"), "PS0007@5");
  EXPECT_EQ(alarm("X1..2"), "PS0007@4");
  EXPECT_EQ(alarm("G1 A5"), "PS0009@4");
  EXPECT_EQ(alarm("E5"), "PS0009@1");
}

TEST(ProgramReader, AddressesWithoutSignOrPoint) {
  for (const char letter : "NOGMTDHL"sv) {
    EXPECT_EQ(alarm(std::string("X1 ") + letter + "-1"), "PS0006@5") << letter;
    EXPECT_EQ(alarm(std::string("X1 ") + letter + "+1"), "PS0006@5") << letter;
  }
  for (const char letter : "NOMTDHL"sv) EXPECT_EQ(alarm(std::string("X1 ") + letter + "1.5"), "PS0007@6") << letter;
  EXPECT_EQ(read("G41.3 F-1.5 S1.5 P-1.5 Q-1.5 R-1.5 I-1.5 J-1.5 K-1.5 X-1.5 C-1.5"),
            (Blocks{"1: G41.3 F-1.5 S1.5 P-1.5 Q-1.5 R-1.5 I-1.5 J-1.5 K-1.5 X-1.5 C-1.5"}));
}

TEST(ProgramReader, AddressesAreThoseOfTheSetup) {
  EXPECT_EQ(read("A1", "XYZA"), (Blocks{"1: A1"}));
  EXPECT_EQ(read("Y1", "XZ"), (Blocks{"1:  !PS0009@1"}));
}

TEST(ProgramReader, OtherPrintableCharactersAreNoAddresses) {
  for (const char c : R"x(!"$&'),<=>?@\]^_`{|}~*)x"sv) EXPECT_EQ(alarm(std::string("X1 ") + c + "Y2"), "PS0004@4") << c;
  for (const char c : "#["sv) EXPECT_EQ(alarm(std::string("X1 ") + c + "Y2"), "NOT_SUPPORTED@4") << c;
}

TEST(ProgramReader, AnAlarmKeepsTheWordsBeforeItAndSkipsItsBlockOnly) {
  EXPECT_EQ(read("N7 G1 X1.2.3 Y-- (;) Z1; X9\nY8"), (Blocks{"1: N7 G1 !PS0007@11", "1: X9", "2: Y8"}));
  EXPECT_EQ(read("X1. Y.. % \nZ1"), (Blocks{"1: X1. !PS0007@7", "2: Z1"}));
}

TEST(ProgramReader, WordsAreCounted) {
  std::string text;
  for (std::size_t i = 0; i < Block::kMaxWords; ++i) text += "X1";
  EXPECT_EQ(alarm(text + "N5"), "no alarm");
  EXPECT_EQ(alarm(text + "N5Y1"), "TOO_MANY_WORDS@131");
}

TEST(ProgramReader, BytesThatAreNoText) {
  EXPECT_EQ(error("G0\nX1\0"sv), "program:2:3: control character 0x00; a program is ASCII text");
  EXPECT_EQ(error("\x07"), "program:1:1: control character 0x07; a program is ASCII text");
  EXPECT_EQ(error("X1 \x7F"), "program:1:4: control character 0x7F; a program is ASCII text");
  EXPECT_EQ(error("G0 \xC3\xA4"), "program:1:4: byte 0xC3 outside a comment; a program is ASCII text");
  EXPECT_EQ(error("(\x01)"), "program:1:2: control character 0x01; a program is ASCII text");
  // Bytes are looked at in skipped text too.
  EXPECT_EQ(error("X1.2.3 \x80", {.file = "O1.nc"}), "O1.nc:1:8: byte 0x80 outside a comment; a program is ASCII text");
  EXPECT_EQ(error("/ \x80", {.file = "f", .block_skip = true}),
            "f:1:3: byte 0x80 outside a comment; a program is ASCII text");
}

TEST(ProgramReader, AByteOrderMarkAtTheStart) {
  EXPECT_EQ(read("\xEF\xBB\xBF"
                 "G0 X1.\nY2."),
            (Blocks{"1: G0 X1.", "2: Y2."}));
  EXPECT_EQ(read("\xEF\xBB\xBF"), Blocks{});
  EXPECT_EQ(read("\xEF\xBB\xBF%\nX1"), Blocks{"2: X1"});
  EXPECT_EQ(error("\xEF\xBB\xBFX1 \x7F"), "program:1:7: control character 0x7F; a program is ASCII text");
  // Half of one, and one that comes later, are bytes as any others.
  EXPECT_EQ(error("\xEF\xBB"), "program:1:1: byte 0xEF outside a comment; a program is ASCII text");
  EXPECT_EQ(error("X1\n\xEF\xBB\xBF"), "program:2:1: byte 0xEF outside a comment; a program is ASCII text");
}

TEST(ProgramReader, CtrlZPadsTheEnd) {
  EXPECT_EQ(read("X1\n\x1A\x1A"), (Blocks{"1: X1"}));
  EXPECT_EQ(read("X1 (comment\x1A"), (Blocks{"1: X1"}));
  EXPECT_EQ(error("X1\n\x1AY1"), "program:2:1: Ctrl-Z (0x1A) before the end of the file");
}

TEST(ProgramReader, BlocksBeforeABadByteStand) {
  ProgramReader reader(text_source("X1\nY1\nZ\0"sv), Axes("XYZ"));
  Block block;
  EXPECT_TRUE(reader.next(block));
  EXPECT_TRUE(reader.next(block));
  EXPECT_THROW(reader.next(block), InputError);
  EXPECT_FALSE(reader.next(block));
}

// Bytes in pieces of any size give the same blocks.
TEST(ProgramReader, BufferBordersDoNotMatter) {
  const std::string_view text = "%\nN10 G01 X-12.345 (a comment) Y 6.7; Z8.9.1\n/3 F100\n";
  for (std::size_t size = 1; size < 8; ++size) {
    ProgramReader reader(std::make_unique<toolcomp::fuzz::Pieces>(text, size), Axes("XYZ"));
    Block block;
    ASSERT_TRUE(reader.next(block));
    EXPECT_EQ(to_string(block), "N10 G1 X-12.345 Y6.7");
    EXPECT_EQ(block.word[2].column, 30U);
    ASSERT_TRUE(reader.next(block));
    EXPECT_EQ(block.alarm->column, 41U);
    ASSERT_TRUE(reader.next(block));
    EXPECT_EQ(to_string(block), "F100");
    EXPECT_EQ(block.line, 3U);
    EXPECT_FALSE(reader.next(block));
  }
}

TEST(ProgramReader, StreamsAreSources) {
  std::istringstream stream("G0 X1\nX2");
  ProgramReader reader(stream_source(stream), Axes("XYZ"));
  Block block;
  EXPECT_TRUE(reader.next(block));
  EXPECT_TRUE(reader.next(block));
  EXPECT_FALSE(reader.next(block));
}

// A line that never ends, made as it is read.
class EndlessLine final : public ByteSource {
 public:
  EndlessLine(std::string_view head, std::string_view pattern, std::size_t length)
      : head_(head), pattern_(pattern), left_(length) {}
  std::size_t read(char* buffer, std::size_t size) override {
    if (!head_.empty()) {
      const std::size_t count = head_.copy(buffer, size);
      head_.remove_prefix(count);
      return count;
    }
    const std::size_t count = std::min(size, left_);
    for (std::size_t i = 0; i < count; ++i) buffer[i] = pattern_[i % pattern_.size()];
    left_ -= count;
    return count;
  }

 private:
  std::string_view head_;
  std::string_view pattern_;
  std::size_t left_;
};

long peak_kilobytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

TEST(ProgramReader, ALineOf100MegabytesInBoundedMemory) {
  constexpr std::size_t kLength = 100'000'000;
  struct Case {
    std::string_view head, pattern;
    std::string alarm;
  };
  const std::vector<Case> cases = {
      {"", "X1 ", "TOO_MANY_WORDS@193"},  // the 65th word, 3 bytes each
      {"X", "1", "PS0003@17"},
      {"(", "x", ""},
      {"X", " ", "PS0005@1"},
  };
  const long before = peak_kilobytes();
  for (const auto& [head, pattern, expected] : cases) {
    ProgramReader reader(std::make_unique<EndlessLine>(head, pattern, kLength), Axes("XYZ"));
    Block block;
    if (!reader.next(block)) {
      EXPECT_EQ(expected, "") << head;
      continue;
    }
    ASSERT_TRUE(block.alarm) << head;
    EXPECT_EQ(toolcomp::test::usual_number(block.alarm->cause) + "@" + std::to_string(block.alarm->column), expected);
    EXPECT_FALSE(reader.next(block));
  }
  EXPECT_LT(peak_kilobytes() - before, 8 * 1024);
}

TEST(ProgramReader, BlocksAreWrittenAsTheyAreRead) {
  ProgramReader reader(text_source("N030G01X+10.Y-0Z0.50"), Axes("XYZ"));
  Block block;
  ASSERT_TRUE(reader.next(block));
  EXPECT_EQ(to_string(block), "N30 G1 X10. Y-0 Z.50");
}

}  // namespace

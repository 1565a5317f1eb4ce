// SPDX-License-Identifier: Apache-2.0
// M98 and M99: which block comes next, by hand from the clauses; and the text that a program with those it calls is.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <string_view>

#include "fuzz/targets/pieces.h"
#include "spec/language/fanuc/program_files.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/input_error.h"
#include "tests/support/usual_number.h"

namespace {

using namespace toolcomp::spec;
namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

ReaderOptions options(const Files& files = {}, bool block_skip = false) {
  return {.file = "p.nc",
          .block_skip = block_skip,
          .called_program = [files](std::string_view name, std::uint64_t /*line*/) -> std::optional<std::string> {
            const auto found = files.find(std::string(name));
            return found == files.end() ? std::nullopt : std::optional(found->second);
          }};
}

// The lines in the order in which they are read; an alarm, with ? where it is beyond this project, ends it.
std::string order(std::unique_ptr<ByteSource> text, ReaderOptions told) {
  ProgramReader reader(std::move(text), Axes("XYZ"), std::move(told));
  std::string shown;
  for (Block block; reader.next(block);) {
    shown += (shown.empty() ? "" : " ") + std::to_string(block.line);
    if (block.alarm)
      return shown + '!' + toolcomp::test::usual_number(block.alarm->cause) +
             (toolcomp::spec::beyond(block) != nullptr ? "?" : "") + '@' + std::to_string(block.alarm->column);
  }
  return shown;
}
std::string order(std::string_view text, const Files& files = {}) { return order(text_source(text), options(files)); }

TEST(ProgramCalls, ACalledProgramRunsBehindItsCall) {
  //         1      2   3        4   5    6   7   8    9
  EXPECT_EQ(order("O1\nX1\nM98 P2\nX2\nM30\nO2\nX3\nM99\nX4\n"), "1 2 3 6 7 8 4 5");
  EXPECT_EQ(order("X1 M98 P2\nX2\nM99\nO2\nX3\n"), "1 4 5 2 3") << "the end of its text ends a program";
  EXPECT_EQ(order("M98 P2\nM98 P2\nM30\nO2\nX1 M99\nX2\n"), "1 4 5 2 4 5 3");
  EXPECT_EQ(order("m98p2\nM30\n:0002(SUB)\nX1\n"), "1 3 4 2");
}

// Whatever it ended in: a % within it, a comment that is not closed, a name.
TEST(ProgramCalls, ARepeatedProgramBeginsAnew) {
  EXPECT_EQ(order("M98 P2 L2\nM98 P3 L2\nM30\nO2\n%\nX1\n%\nX2\nO3\n(\nX3 (\n"), "1 4 4 2 9 11 9 11 3");
  EXPECT_EQ(order("M98 P2 L2\nM30\nO2\nM98 <S> L2\nX1\n<S>\nX2\n"), "1 3 4 7 7 5 3 4 7 7 5 2");
}

TEST(ProgramCalls, HowOften) {
  const std::string sub = "M30\nO1002\nM99\nO51002\nX1\n";
  EXPECT_EQ(order("M98 P1002\n" + sub), "1 3 4 2");
  EXPECT_EQ(order("M98 P1002 L3\n" + sub), "1 3 4 3 4 3 4 2");
  EXPECT_EQ(order("M98 P31002\n" + sub), "1 3 4 3 4 3 4 2");
  EXPECT_EQ(order("M98 P0031002\n" + sub), "1 3 4 3 4 3 4 2");
  EXPECT_EQ(order("M98 P00001002\n" + sub), "1 3 4 2");
  // With L, P is the number of the program with all its digits.
  EXPECT_EQ(order("M98 P51002 L2\n" + sub), "1 5 6 5 6 2");
  EXPECT_EQ(order("M98 P31002 L2\n" + sub), "1!PS0076@1");
}

TEST(ProgramCalls, Names) {
  EXPECT_EQ(order("M98 <SUB A>\nM30\n<SUB A>\nX1\nM99\n"), "1 4 5 2") << "a name is no word";
  EXPECT_EQ(order("M98 <S> L2\nM30\n<S> (sub)\nX1\n"), "1 4 4 2");
  EXPECT_EQ(order("M98 <O0012>\nM30\nO12\nX1\n"), "1 3 4 2") << "a number by its name";
  EXPECT_EQ(order("M98 P12\nM30\n<O0012>\nX1\n"), "1 4 2");
  EXPECT_EQ(order("M98 <S>\nM30\n<T>\nX1\n"), "1!PS0076@1");
  EXPECT_EQ(order("M98 <>\n<S>\n"), "1!PS0076@1");
}

TEST(ProgramCalls, ABlockWithM99Returns) {
  // X5 of the block still runs; P is looked for behind the call, the first of two.
  EXPECT_EQ(order("N10 X0\nM98 P2\nX1\nN10 X2\nN10 X3\nM30\nO2\nX5 M99 P10\n"), "1 2 7 8 4 5 6");
  EXPECT_EQ(order("M98 P2 L3\nX1\nN10 X2\nM30\nO2\nM99 P10\n"), "1 5 6 3 4") << "and the repeats are over";
  EXPECT_EQ(order("M98 P2\nX1\nN0010\nX2\nM30\nO2\nM99 P10\n"), "1 6 7 4 5") << "a number that stands alone";
  EXPECT_EQ(order("M98 P2\nX1\nN10\nO2\nM99 P10\n"), "1 4 5") << "at the end of the program";
  EXPECT_EQ(order("M98 P2\nX1\nN10 X1.2.3\nM30\nO2\nM99 P10\n"), "1 5 6 3!PS0007@9");
  EXPECT_EQ(order("M98 P2\nX1\nN10 M98 P3\nM30\nO2\nM99 P10\nO3\nX1\n"), "1 5 6 3 7 8 4");
  // The program that has called is itself a called one.
  EXPECT_EQ(order("M98 P2\nN10 X1\nM30\nO2\nM98 P3\nX2\nN10 X3\nO3\nM99 P10\n"), "1 4 5 8 9 7 2 3");
}

TEST(ProgramCalls, AlarmsOfCalls) {
  EXPECT_EQ(order("X1\nN5 M98 P2\nM30\n"), "1 2!PS0076@4");
  EXPECT_EQ(order("M98\n"), "1!PS0076@1");
  EXPECT_EQ(order("M98 P0\nO0000\n"), "1!PS0076@1");
  EXPECT_EQ(order("M98 P10000\nO10000\n"), "1!PS0076@1") << "once program 0";
  EXPECT_EQ(order("M98 P-2\nO2\n"), "1!PS0076@1");
  EXPECT_EQ(order("M98 P2\nN10 X1\nN10\nO2\nX1 M99 P20\n"), "1 4 5!PS0078@8");
  EXPECT_EQ(order("N20 X1\nM98 P2\nO2\nN20 M99 P20\n"), "1 2 3 4!PS0078@9") << "neither before the call nor here";
  EXPECT_EQ(order("M98 P2\nN10 X1\nO2\nM99 P10.5\n"), "1 3 4!PS0078@5");
}

TEST(ProgramCalls, BeyondThisProject) {
  EXPECT_EQ(order("X1\nM99 P10\nN10 X2\n"), "1 2!NOT_SUPPORTED?@1");
  EXPECT_EQ(order("X1\nM99 L3\n"), "1 2!NOT_SUPPORTED?@1");
  EXPECT_EQ(order("M98 P2\nM30\nO2\nM99 L3\n"), "1 3 4!NOT_SUPPORTED?@1");
}

TEST(ProgramCalls, M99OfTheMainProgramEndsIt) {
  EXPECT_EQ(order("X1\nM99\nX2\n"), "1 2");
  EXPECT_EQ(order("M98 P2\nX1 M99\nX2\nO2\nX3\n"), "1 4 5 2");
}

TEST(ProgramCalls, TenLevels) {
  const auto chain = [](int levels) {
    std::string text = "M98 P1\n";
    for (int i = 1; i <= levels; ++i)
      text += 'O' + std::to_string(i) + '\n' + (i < levels ? "M98 P" + std::to_string(i + 1) : "X1") + '\n';
    return text;
  };
  EXPECT_EQ(order(chain(10)), "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21");
  EXPECT_EQ(order(chain(11)), "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21!PS0077@1");
  EXPECT_EQ(order("M98 P1\nM30\nO1\nM98 P1\n"), "1 3 4 3 4 3 4 3 4 3 4 3 4 3 4 3 4 3 4 3 4!PS0077@1");
}

TEST(ProgramCalls, OfTwoHeadsTheFirstCounts) {
  EXPECT_EQ(order("M98 P2\nM30\nO2\nX1\nO2\nX2\n"), "1 3 4 2");
  EXPECT_EQ(order("M98 P2\nM30\nO2\nX1\n", {{"O2", "O2\nX9\n"}}), "1 3 4 2") << "that of the text before a file";
}

TEST(ProgramCalls, HeadsBeginALine) {
  EXPECT_EQ(order("M98 P2\nM30\nN1 O2\nX1\n"), "1!PS0076@1");
  EXPECT_EQ(order("M98 P2\nM30\n(O2)\nX1\n"), "1!PS0076@1");
  EXPECT_EQ(order("M98 P2\nM30\n ( a comment ) O 0002\nX1\n"), "1 3 4 2");
  EXPECT_EQ(order("%\nO1\nM98 P2\nM30\n%\n%O2\nX1\n%\nX9\n"), "2 3 6 7 4") << "behind the end of the main program";
}

TEST(ProgramCalls, WhatIsSkippedCallsNothing) {
  const std::string_view text = "/M98 P2\nX1\nM98 P2\nX2\nN10 X3\nM30\nO2\n/M99 P10\nX4\n";
  EXPECT_EQ(order(text_source(text), options({}, true)), "2 3 7 9 4 5 6");
  EXPECT_EQ(order(text_source(text), options({}, false)), "1 7 8 5 6");
}

TEST(ProgramCalls, Files) {
  const std::string main = "%\nO1\nM98 P20\nM98 <B>\nM98 P20\nM30\n%";
  const Files files{{"O20", "%\r\nO0020 (SUB)\r\nM98 P30\r\nX20\r\nM99\r\n%\r\n"},
                    {"B", std::string(kByteOrderMark) + "<B>\nX1\nM99"},
                    {"O30", "O30\nX30\nM99\n\x1A"}};
  const std::string joined = joined_program(main, Axes("XYZ"), options(files));
  // 1 to 7; O20 8 to 13, what it calls 14 to 16, B 17 to 19.
  EXPECT_EQ(joined, main + "\n" + files.at("O20") + "O30\nX30\nM99\n<B>\nX1\nM99\n");
  const std::string expected = "2 3 9 10 14 15 16 11 12 4 18 19 5 9 10 14 15 16 11 12 6";
  EXPECT_EQ(order(main, files), expected);
  EXPECT_EQ(order(joined), expected);
  EXPECT_EQ(joined_program(joined, Axes("XYZ"), options(files)), joined);
}

// What is asked for by the name of a file is what the file holds; its head says so then.
TEST(ProgramCalls, FilesWithoutTheHeadOfTheirProgram) {
  const auto check = [](const std::string& call, const std::string& name, const std::string& text,
                        const std::string& joined, const std::string& lines) {
    const std::string main = call + "\nM30\n";
    const Files files{{name, text}};
    EXPECT_EQ(joined_program(main, Axes("XYZ"), options(files)), main + joined) << text;
    EXPECT_EQ(order(main, files), lines) << text;
    EXPECT_EQ(order(main + joined), lines) << text;
  };
  check("M98 P20", "O20", "X1\nM99\n", "O20;X1\nM99\n", "1 3 3 4 2");
  check("M98 P20", "O20", "%\n(NO HEAD)\n/N10 X1\nM99\n%\n", "%\n(NO HEAD)\nO20;/N10 X1\nM99\n%\n", "1 5 5 6 2");
  check("M98 P20", "O20", "%\nO0001\nX1\nO2\nX2\n", "%\nO20;O0001\nX1\nO2\nX2\n", "1 4 4 5 2");
  check("M98 <SUB>", "SUB", std::string(kByteOrderMark) + "% O0001\nX1", "% <SUB>;O0001\nX1\n", "1 3 4 2");
  check("M98 P20", "O20", "", "O20;\n", "1 3 2");
  check("M98 P20", "O20", "(NOTHING\n", "O20;(NOTHING\n", "1 3 2");
}

TEST(ProgramCalls, AProgramThatCallsNoneStaysAsItIs) {
  const Files files{{"O2", "O2\nX1\n"}};
  for (const std::string text : {"X1\n(M98 P2)", "G66 P2\n", "M99\n", "M98 P-\n"})
    EXPECT_EQ(joined_program(text, Axes("XYZ"), options(files)), text);
  EXPECT_EQ(joined_program("M98 P3", Axes("XYZ"), options(files)), "M98 P3");
}

TEST(ProgramCalls, SizesOfPiecesAndCarriageReturnsMatterNot) {
  const std::string text = "%\nO1\nX1\nM98 P2 L2; X2\nN7 X3\nM30\nO2\nX4\nM98 P3\nM99\nO3\nX5";
  const std::string expected = "2 3 4 7 8 9 11 12 10 7 8 9 11 12 10 4 5 6";
  EXPECT_EQ(order(text), expected);
  for (std::size_t size = 1; size < 9; ++size)
    EXPECT_EQ(order(std::make_unique<toolcomp::fuzz::Pieces>(text, size), options()), expected) << size;
  std::string returns;
  for (const char c : text) returns += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(order(returns), expected);
  EXPECT_EQ(order(std::string(kByteOrderMark) + returns), expected);
}

TEST(ProgramCalls, WhatMakesTooManyBlocksEnds) {
  ReaderOptions few = options();
  few.most_repeated = 1000;
  ProgramReader reader(text_source("X0\nM98 P2 L9999999\nM30\nO2\nX1\n"), Axes("XYZ"), few);
  std::size_t blocks = 0;
  Block block;
  while (reader.next(block) && !block.alarm) ++blocks;
  ASSERT_TRUE(block.alarm);
  EXPECT_EQ(block.alarm->cause, toolcomp::spec::AlarmCause::not_supported);
  EXPECT_EQ(blocks, 1002U) << "a thousand, and two of the main program";
  // Who reads on past the alarm comes to an end as well: repeats in repeats would have none.
  EXPECT_FALSE(reader.next(block));
  // Programs without blocks end at once.
  EXPECT_EQ(order("M98 <S> L999999999999999\nX1\nM30\n<S>\n"), "1 2 3");
}

// Blocks without end, made as they are read.
class ManyBlocks final : public ByteSource {
 public:
  explicit ManyBlocks(std::size_t bytes) : left_(bytes) {}
  std::size_t read(char* buffer, std::size_t size) override {
    constexpr std::string_view kBlock = "G01 X1 Y2\n";
    std::size_t count = 0;
    while (count + kBlock.size() <= std::min(size, left_)) count += kBlock.copy(buffer + count, kBlock.size());
    left_ -= count;
    return count;
  }

 private:
  std::size_t left_;
};

TEST(ProgramCalls, AProgramThatCallsNoneIsNotKept) {
  const auto peak_kilobytes = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
  };
  const long before = peak_kilobytes();
  ProgramReader reader(std::make_unique<ManyBlocks>(100'000'000), Axes("XYZ"), options());
  std::size_t blocks = 0;
  for (Block block; reader.next(block);) ++blocks;
  EXPECT_EQ(blocks, 10'000'000U);
  EXPECT_LT(peak_kilobytes() - before, 8 * 1024);
}

TEST(ProgramCalls, BytesOfCalledProgramsAreChecked) {
  EXPECT_THROW(order("M98 P2\nM30\n", {{"O2", "O2\nX1 \x01\n"}}), InputError);
  EXPECT_THROW(order("M98 P2\nM30\nO2\nX1 \x01\n"), InputError);
}

class ProgramsBeside : public testing::Test {
 protected:
  ProgramsBeside() { fs::create_directories(folder_); }
  ~ProgramsBeside() override { fs::remove_all(folder_); }
  void write(const std::string& name) const { std::ofstream(folder_ / name) << name; }
  [[nodiscard]] std::string beside(std::string_view name) const {
    return programs_beside(folder_)(name, 1).value_or("none");
  }
  fs::path folder_ = fs::temp_directory_path() / ("toolcomp-beside-" + std::to_string(std::random_device{}()));
};

TEST_F(ProgramsBeside, Spellings) {
  for (const char* name : {"O1000", "O1000.nc", "o1000.NC", "1000", "01000.txt", "O0001000.MIN"}) {
    write(name);
    EXPECT_EQ(beside("O1000"), name);
    fs::remove(folder_ / name);
  }
  for (const char* name : {"O1000A.nc", "P1000", "O100", "OO1000", "O1000.toml", "1000.json", "O1000.csv"}) write(name);
  fs::create_directories(folder_ / "O1000.dir");
  EXPECT_EQ(beside("O1000"), "none");
  write("sub-a.NC");
  EXPECT_EQ(beside("SUB-A"), "sub-a.NC");
  EXPECT_EQ(beside("Sub-A"), "sub-a.NC");
  EXPECT_EQ(beside("SUB-A.nc"), "sub-a.NC") << "a name may have a point";
  EXPECT_EQ(beside("SUB"), "none");
  EXPECT_EQ(beside("../SUB-A"), "none");
  EXPECT_EQ(programs_beside(folder_ / "none")("O1", 1), std::nullopt);
}

TEST_F(ProgramsBeside, TwoFilesOfOneProgramAreNamed) {
  write("O7.nc");
  write("0007.txt");
  try {
    ADD_FAILURE() << beside("O7");
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("O7.nc"), std::string::npos) << what;
    EXPECT_NE(what.find("0007.txt"), std::string::npos) << what;
  }
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// Programs in programs: which block comes next, by hand from the clauses; and the text that a program with those it
// calls is.
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/targets/pieces.h"
#include "spec/language/heidenhain/joined_program.h"
#include "spec/language/heidenhain/klartext_reader.h"
#include "spec/language/input_error.h"
#include "tests/support/usual_number.h"

namespace {

using namespace toolcomp::spec;
using namespace toolcomp::spec::klartext;
using klartext::Block;
using Files = std::map<std::string, std::string>;

Setup setup_with(bool block_skip = false) {
  Setup setup;
  setup.control = Control::heidenhain;
  setup.axes = Axes("XYZABC");
  setup.block_skip = block_skip;
  return setup;
}

CalledProgram from(const Files& files) {
  return [files](std::string_view name, std::uint64_t /*line*/) -> std::optional<std::string> {
    const auto found = files.find(std::string(name));
    return found == files.end() ? std::nullopt : std::optional(found->second);
  };
}

// The lines in the order in which they are read, "L", "LN" and M blocks as numbers, an alarm behind its line.
std::string order(std::unique_ptr<ByteSource> text, const ReaderOptions& options, bool block_skip = false) {
  Reader reader(std::move(text), setup_with(block_skip), options);
  std::string shown;
  for (Block block; reader.next(block);) {
    const bool call = block.statement == Statement::label || block.statement == Statement::call_label ||
                      block.statement == Statement::call_program || block.statement == Statement::program_return;
    if (call && !block.alarm) continue;
    shown += (shown.empty() ? "" : " ") + std::to_string(block.line);
    if (block.alarm)
      return shown + '!' + toolcomp::test::usual_number(block.alarm->cause) +
             (toolcomp::spec::beyond(block) != nullptr ? "?" : "") + '@' + std::to_string(block.alarm->line) + ':' +
             std::to_string(block.alarm->column);
  }
  return shown;
}
std::string order(std::string_view text, const Files& files = {}) {
  return order(text_source(text), {.file = "p.h", .called_program = from(files)});
}

TEST(KlartextCalls, SubprogramsRunFromTheirLabelToLabelZero) {
  EXPECT_EQ(order("CALL LBL 1\nL X1\nCALL LBL 1\nM30\nLBL 1\nL X2\nLBL 0\nL X3\n"), "6 2 6 4 6 8");
  // Called before and behind, one in another, by name.
  EXPECT_EQ(order("LBL \"a\"\nL X1\nLBL 0\nCALL LBL \"a\"\nCALL LBL 2\nM2\nLBL 2\nCALL LBL \"a\"\nL X4\nLBL 0\n"),
            "2 2 2 9 6 2 9");
  EXPECT_EQ(order("call lbl 07 ; LBL 0\n* LBL 7\nM2\n12 /lbl ~\n 7\nL X1\nLBL 0\n"), "6 3 6");
}

TEST(KlartextCalls, NamesOfLabelsKeepTheirCase) {
  EXPECT_EQ(order("CALL LBL \"a\"\nLBL \"A\"\n"), "1!E_LABEL_MISSING@1:1");
}

TEST(KlartextCalls, SectionsRunOnceMoreThanTheyAreRepeated) {
  EXPECT_EQ(order("LBL 1\nL X1\nCALL LBL 1 REP 2\nL X2\n"), "2 2 2 4");
  EXPECT_EQ(order("LBL 1\nL X1\nCALL LBL 1 REP2/2\nL X2\n"), "2 2 2 4");
  // In each other: the inner one counts anew.
  EXPECT_EQ(order("LBL 1\nLBL 2\nL X1\nCALL LBL 2 REP 1\nL X2\nCALL LBL 1 REP 1\n"), "3 3 5 3 3 5");
  // Two sections that overlap: the first runs again in the second.
  EXPECT_EQ(order("LBL 1\nL X1\nLBL 2\nL X2\nCALL LBL 1 REP 1\nL X3\nCALL LBL 2 REP 1\n"), "2 4 2 4 6 4 2 4 6");
  // In a subprogram, which is called twice.
  EXPECT_EQ(order("CALL LBL 1\nCALL LBL 1\nM2\nLBL 1\nLBL 2\nL X1\nCALL LBL 2 REP 1\nLBL 0\n"), "6 6 6 6 3 6 6");
}

TEST(KlartextCalls, WordsOfCalls) {
  EXPECT_EQ(order("CALL LBL 0\n"), "1!E_SYNTAX@1:10");
  EXPECT_EQ(order("CALL LBL 65536\n"), "1!E_SYNTAX@1:10");
  EXPECT_EQ(order("LBL 1\nCALL LBL 1 REP 0\n"), "2!E_SYNTAX@2:12");
  EXPECT_EQ(order("LBL 1\nCALL LBL 1 REP 65535\n"), "2!E_SYNTAX@2:12");
  EXPECT_EQ(order("LBL 1\nCALL LBL 1 M3\n"), "2!E_SYNTAX@2:12");
  EXPECT_EQ(order("CALL\n"), "1!E_SYNTAX@1:5");
  EXPECT_EQ(order("CALL PGM\n"), "1!E_SYNTAX@1:9");
  EXPECT_EQ(order("LBL\n"), "1!E_SYNTAX@1:4");
  EXPECT_EQ(order("LBL \"\"\n"), "1!E_SYNTAX@1:5");
  EXPECT_EQ(order("CALL LBL 1 REP\nM30\nLBL 1\nLBL 0\n"), order("CALL LBL 1\nM30\nLBL 1\nLBL 0\n"));
  EXPECT_EQ(order("LBL Q1\n"), "1!NOT_SUPPORTED?@1:5");
  EXPECT_EQ(order("CALL LBL QS1\n"), "1!NOT_SUPPORTED?@1:10");
  EXPECT_EQ(order("LBL 1\nCALL LBL 1 REPQ1\n"), "2!NOT_SUPPORTED?@2:15");
  EXPECT_EQ(order("CALL SELECTED PGM\n"), "1!NOT_SUPPORTED?@1:6");
}

TEST(KlartextCalls, AlarmsOfCalls) {
  EXPECT_EQ(order("L X1\n7 CALL LBL 3\n"), "1 2!E_LABEL_MISSING@2:3");
  EXPECT_EQ(order("LBL 3\nL X1\nCALL LBL 3 REP 1\nLBL 3\n"), "2 3!E_LABEL_TWICE@3:1");
  EXPECT_EQ(order("LBL 3\nLBL 3\nL X1\n"), "3") << "nobody calls it";
  EXPECT_EQ(order("CALL LBL 3 REP 1\nLBL 3\n"), "1!NOT_SUPPORTED?@1:1");
  EXPECT_EQ(order("CALL LBL 1\nLBL 1\nCALL LBL 1\n"), "3!E_LABEL_RECURSION@3:1");
  EXPECT_EQ(order("CALL PGM A/B.H\n"), "1!E_NO_PROGRAM@1:1");
  EXPECT_EQ(order("CALL PGM \"TNC:\\B.H\"\n"), "1!E_NO_PROGRAM@1:1");
}

TEST(KlartextCalls, NineteenLevels) {
  const auto chain = [](int levels, const std::string& last) {
    std::string text = "CALL LBL 1\n";
    for (int i = 1; i < levels; ++i) text += "LBL " + std::to_string(i) + "\nCALL LBL " + std::to_string(i + 1) + '\n';
    return text + "LBL " + std::to_string(levels) + '\n' + last;
  };
  EXPECT_EQ(order(chain(19, "L X1\n")), "39");
  EXPECT_EQ(order(chain(20, "L X1\n")), "39!E_NESTING@39:1");
  // Programs in programs; the main one is not counted.
  const auto program = [](int i, const std::string& body) {
    const std::string name = "PGM P" + std::to_string(i) + " MM\n";
    return "BEGIN " + name + body + "\nEND " + name;
  };
  Files files;
  for (int i = 1; i <= 20; ++i)
    files["P" + std::to_string(i)] = program(i, i < 19 ? "CALL PGM P" + std::to_string(i + 1) : "L X1");
  EXPECT_EQ(order("CALL PGM P1\n", files), "58 2");
  files["P19"] = program(19, "CALL PGM P20");
  EXPECT_EQ(order("CALL PGM P1\n", files), "58!E_NESTING@58:1");
}

TEST(KlartextCalls, ProgramsBehindTheMainOne) {
  constexpr std::string_view kText =
      "BEGIN PGM M MM\nCALL PGM sub\nCALL PGM \"SUB.H\"\nEND PGM M MM\n; between\nBEGIN PGM Sub MM\nL X1\nCALL LBL 1\n"
      "LBL 1\nL X2\nEND PGM Sub MM\nBEGIN PGM NEVER MM\nL X9\nEND PGM NEVER MM\n";
  // END PGM leaves the subprogram of the called program too.
  EXPECT_EQ(order(kText), "1 7 10 7 10 4");
}

TEST(KlartextCalls, UnitsAndNamesOfCalledPrograms) {
  EXPECT_EQ(order("BEGIN PGM M MM\nCALL PGM A\nEND PGM M MM\nBEGIN PGM A INCH\nEND PGM A INCH\n"),
            "1 2!NOT_SUPPORTED?@2:1");
  EXPECT_EQ(order("BEGIN PGM M INCH\nCALL PGM A\nEND PGM M INCH\nBEGIN PGM A INCH\nL X1\nEND PGM A INCH\n"), "1 5 3");
  EXPECT_EQ(order("CALL PGM A\n", {{"A", "BEGIN PGM OTHER MM\nEND PGM OTHER MM\n"}}), "1!E_NO_PROGRAM@1:1");
  EXPECT_EQ(order("CALL PGM A\n", {{"A", "BEGIN PGM A MM\nL X1\n"}}), "1!E_NO_PROGRAM@1:1");
  EXPECT_EQ(order("BEGIN PGM A MM\nCALL PGM A\nEND PGM A MM\n"), "1 2!E_PROGRAM_RECURSION@2:1");
}

TEST(KlartextCalls, FilesFollowInTheOrderOfTheirFirstCall) {
  const std::string main = "BEGIN PGM M MM\nL X1\nCALL PGM B\nCALL PGM A\nCALL PGM B\nEND PGM M MM\n";
  const Files files{{"A", "BEGIN PGM A MM\r\nL X2\r\nEND PGM A MM\r\n"},
                    {"B",
                     "\xEF\xBB\xBF"
                     "BEGIN PGM B MM\nCALL PGM C\nEND PGM B MM"},
                    {"C", "BEGIN PGM C MM\nL X3\nEND PGM C MM\n"}};
  const std::string joined = joined_klartext(main, from(files));
  EXPECT_EQ(joined, main + "BEGIN PGM B MM\nCALL PGM C\nEND PGM B MM\n" + files.at("A") + files.at("C"));
  // 1 to 6, B 7 to 9, A 10 to 12, C 13 to 15.
  EXPECT_EQ(order(main, files), "1 2 14 11 14 6");
  EXPECT_EQ(order(joined), "1 2 14 11 14 6");
  EXPECT_EQ(joined_klartext(joined, from(files)), joined);
}

TEST(KlartextCalls, AMainProgramWithoutItsEndGetsOne) {
  const Files files{{"A", "BEGIN PGM A MM\nL X2\nEND PGM A MM\n"}};
  EXPECT_EQ(joined_klartext("L X1\nCALL PGM A", from(files)),
            "L X1\nCALL PGM A\nEND PGM MAIN MM\nBEGIN PGM A MM\nL X2\nEND PGM A MM\n");
  EXPECT_EQ(order("L X1\nCALL PGM A", files), "1 5 3");
  EXPECT_EQ(joined_klartext("L X1\nCALL PGM NONE", from(files)), "L X1\nCALL PGM NONE");
  EXPECT_EQ(joined_klartext("L X1\nCALL PGM ../A", from(files)), "L X1\nCALL PGM ../A");
}

TEST(KlartextCalls, WhatIsSkippedCallsNothing) {
  constexpr std::string_view kText = "/CALL LBL 1\nL X1\n/LBL 1\nLBL 1\nL X2\n";
  EXPECT_EQ(order(text_source(kText), {}, true), "2 5");
  EXPECT_EQ(order(text_source(kText), {}, false), "1!E_LABEL_TWICE@1:2");
}

TEST(KlartextCalls, SizesOfPiecesAndCarriageReturnsMatterNot) {
  const std::string text = "L X1\nLBL 1\nL X2\nCALL ~\n LBL 1 ~\n REP 3\nCALL LBL 2\nM30\nLBL 2\nL X3\nLBL 0";
  const std::string expected = "1 3 3 3 3 10 8 10";
  EXPECT_EQ(order(text), expected);
  for (std::size_t size = 1; size < 9; ++size)
    EXPECT_EQ(order(std::make_unique<toolcomp::fuzz::Pieces>(text, size), {}), expected) << size;
  std::string returns;
  for (const char c : text) returns += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(order(returns), expected);
}

TEST(KlartextCalls, WhatMakesTooManyBlocksEnds) {
  const std::string text = "LBL 1\nL X1\nCALL LBL 1 REP 65534\n";
  Reader reader(text_source(text), setup_with(), {.most_repeated = 1000});
  std::size_t blocks = 0;
  Block block;
  while (reader.next(block) && !block.alarm) ++blocks;
  ASSERT_TRUE(block.alarm);
  EXPECT_EQ(block.alarm->cause, toolcomp::spec::AlarmCause::not_supported);
  EXPECT_EQ(blocks, 1004U) << "a thousand, three lines, and an empty one";
  EXPECT_FALSE(reader.next(block));
  // Repeats in repeats would never end.
  std::string nested;
  for (int i = 1; i < 20; ++i) nested += "LBL " + std::to_string(i) + '\n';
  for (int i = 19; i > 0; --i) nested += "CALL LBL " + std::to_string(i) + " REP 1000\n";
  Reader deep(text_source(nested), setup_with());
  for (blocks = 0; deep.next(block) && !block.alarm;) ++blocks;
  EXPECT_EQ(blocks, 1'000'000U + 39);
}

TEST(KlartextCalls, BytesOfCalledProgramsAreChecked) {
  EXPECT_THROW(order("CALL PGM A\n", {{"A", "BEGIN PGM A MM\nSTOP \x01\nEND PGM A MM\n"}}), InputError);
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// What this project does not follow says its name; what changes nothing is read; and reader, model and fast engine
// agree on which code is which.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "spec/language/fanuc/not_supported.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/fanuc/without_effect.h"
#include "tests/support/usual_number.h"
#include "tests/unit/fanuc/fast_run.h"
#include "tests/unit/model_run.h"

namespace {

using namespace toolcomp;

constexpr std::string_view kSetup = "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n";

// What is said of the last block of the text: "NUMBER@COLUMN message" of an alarm of reading, the message of a code
// with its column, or "read".
std::string said(std::string_view text) {
  spec::ProgramReader reader(spec::text_source(text), spec::Axes("XYZ"));
  spec::Block block;
  while (reader.next(block)) {
  }
  const char* const name = spec::not_supported(block);
  const std::string message = name == nullptr ? "" : name;
  if (block.alarm) {
    EXPECT_EQ(block.alarm->beyond, name != nullptr);
    return toolcomp::test::usual_number(block.alarm->cause) + '@' + std::to_string(block.alarm->column) + ' ' + message;
  }
  const spec::Word* const word = spec::word_not_supported(block);
  EXPECT_EQ(word == nullptr, name == nullptr);
  return word == nullptr ? "read" : std::to_string(word->column) + ' ' + message;
}

TEST(NotSupported, CodesSayTheirName) {
  EXPECT_EQ(said("G98 G81 Z-5 R2 F100"), "5 G81 (drilling, a canned cycle) is not supported");
  EXPECT_EQ(said("N10 g068.2X0Y0Z0I0J0K0"), "5 G68.2 (tilted working plane) is not supported");
  EXPECT_EQ(said("G68.20"), "1 G68.2 (tilted working plane) is not supported");
  EXPECT_EQ(said("G65 P9000"), "1 G65 (macro call) is not supported");
  EXPECT_EQ(said("G90 G16"), "5 G16 (polar coordinate command) is not supported");
  EXPECT_EQ(said("G68 G51"), "1 G68 (coordinate system rotation) is not supported") << "the first one";
  EXPECT_EQ(said("G05.4 Q1"), "1 G05.4 (hold of high precision control) is not supported");
  EXPECT_EQ(said("G81\nX1"), "read") << "of the last block alone";
  for (const char* code : {"G77.7", "G01", "G80", "G69", "G5.1", "G8.1", "G681", "G6.82", "G68.22", "G68000"})
    EXPECT_EQ(said(code), "read") << code;
}

TEST(NotSupported, MacrosSayTheirName) {
  const std::string variables = " custom macro variables and expressions are not supported";
  EXPECT_EQ(said("#1=5"), "PS0004@1" + variables);
  EXPECT_EQ(said("#100 = #101 + 1"), "PS0004@1" + variables);
  EXPECT_EQ(said("G01 X#1 Y5"), "PS0005@5" + variables);
  EXPECT_EQ(said("G01 X[1+2]"), "PS0005@5" + variables);
  EXPECT_EQ(said("G01 X-#1"), "PS0005@5" + variables);
  EXPECT_EQ(said("N#1"), "PS0005@1" + variables);
  const std::string statements = " custom macro statements (IF, WHILE, GOTO and the like) are not supported";
  for (const char* text : {"IF[#1EQ2]GOTO5", "IF [#1 EQ 2] THEN #2=1", "WHILE[#1LT5]DO1", "while [#1 lt 5] do1", "END1",
                           "GOTO 100", "GOTO100", "POPEN", "DPRNT[X#1]"})
    EXPECT_NE(said(text).find(statements), std::string::npos) << text << ": " << said(text);
  EXPECT_EQ(said("N10 GOTO 100"), "PS0005@5" + statements);
}

TEST(NotSupported, CornersByCommas) {
  const std::string corners = " ,R and ,C (corner rounding, chamfering) are not supported";
  EXPECT_EQ(said("G01 X10 Y10,R5"), "PS0004@12" + corners);
  EXPECT_EQ(said("G01 X10 , C2."), "PS0004@9" + corners);
  EXPECT_EQ(said("G01 X10 ,r 5"), "PS0004@9" + corners);
}

TEST(NotSupported, FaultsAreNotBeyond) {
  EXPECT_EQ(said("X1,A5"), "PS0004@3 ");
  EXPECT_EQ(said("X1!"), "PS0004@3 ");
  EXPECT_EQ(said("X"), "PS0005@1 ");
  EXPECT_EQ(said("X Y1"), "PS0005@1 ");
  EXPECT_EQ(said("G01 I"), "PS0005@5 ");
  EXPECT_EQ(said("X1.2.3 #1"), "PS0007@5 ");
  EXPECT_EQ(said("E5"), "PS0009@1 ");
}

std::string code_of(std::uint64_t tenths) {
  return 'G' + std::to_string(tenths / 10) + (tenths % 10 == 0 ? "" : '.' + std::to_string(tenths % 10));
}

// Those that do something (clause fanuc.program.unknown-code).
constexpr std::string_view kMeant =
    "G00 G01 G02 G03 G04 G10 G17 G18 G19 G20 G21 G28 G29 G30 G30.1 G37 G39 G40 G41 G41.2 G41.3 G41.6 G42 G42.2 G42.6 "
    "G43 G43.4 G43.5 G44 G45 G46 G47 G48 G49 G52 G53 G54 G55 G56 G57 G58 G59 G54.1 G90 G91 G92 G93 G94 G95";

TEST(NotSupported, EveryCodeIsTakenOrRefusedAlike) {
  std::set<std::uint64_t> refused_by_name;
  std::size_t taken = 0;
  for (std::uint64_t tenths = 0; tenths < 10000; ++tenths) {
    const std::string code = code_of(tenths);
    SCOPED_TRACE(code);
    const test::Run run = test::run(kSetup, code + "\n");
    const fast::ProgramRun fast(kSetup, code + "\n");
    const auto alarm = [](const auto& events) {
      const bool ends = !events.empty() && events.back().kind == spec::EventKind::alarm;
      return ends ? std::string(events.back().number.view()) : std::string();
    };
    EXPECT_EQ(alarm(fast.events), alarm(run.events()));
    const char* const name = spec::code_not_supported(tenths);
    const bool listed = spec::code_without_effect(tenths);
    EXPECT_FALSE(name != nullptr && listed) << "in both lists";
    const auto reached = [&run](spec::Clause clause) {
      return run.recorder.counts()[static_cast<std::size_t>(clause)].reached != 0;
    };
    EXPECT_EQ(reached(spec::Clause::fanuc_program_without_effect), listed);
    const bool unknown = reached(spec::Clause::fanuc_program_unknown_code);
    EXPECT_EQ(unknown, !listed && (' ' + std::string(kMeant) + ' ')
                                          .find(' ' + std::string(tenths < 100 ? "G0" : "G") + code.substr(1) + ' ') ==
                                      std::string::npos);
    if (unknown) {
      EXPECT_EQ(alarm(run.events()), "PS0010");
      EXPECT_STREQ(run.events().back().message, name != nullptr ? name : "there is no such G code");
      EXPECT_STREQ(fast.events.back().message, run.events().back().message);
    } else {
      EXPECT_EQ(name, nullptr) << "works here";
      ++taken;
    }
    if (name != nullptr) {
      refused_by_name.insert(tenths);
      EXPECT_TRUE(std::string_view(name).starts_with((tenths < 100 ? "G0" : "G") + code.substr(1))) << name;
    }
  }
  // As many as the clauses list: those that do something, and 29 that do nothing.
  EXPECT_EQ(taken, static_cast<std::size_t>(std::ranges::count(kMeant, 'G')) + 29);
  EXPECT_GT(refused_by_name.size(), 60U);
}

TEST(NotSupported, NumbersOfNoCodeAreRefusedAlike) {
  for (const char* code : {"G68.22", "G1.05", "G1000", "G10000", "G1234567890", "G99999999.9", "G100000.0"}) {
    SCOPED_TRACE(code);
    const auto run = test::run(kSetup, std::string("G90 ") + code + "\n");
    const fast::ProgramRun fast(kSetup, std::string("G90 ") + code + "\n");
    ASSERT_EQ(run.events().size(), 1U);
    ASSERT_EQ(fast.events.size(), 1U);
    EXPECT_EQ(run.events()[0].number, spec::Name("PS0010"));
    EXPECT_EQ(fast.events[0].number, spec::Name("PS0010"));
    EXPECT_STREQ(run.events()[0].message, "there is no such G code");
    EXPECT_STREQ(fast.events[0].message, "there is no such G code");
  }
}

// The first code of a block that is not taken, whatever stands around it.
TEST(NotSupported, TheFirstCodeIsNamed) {
  for (const char* block : {"G90 G81 G68 X1", "G80 G81 H9999", "X1 G81 M30", "G81 G77.7"}) {
    const auto run = test::run(kSetup, block);
    const fast::ProgramRun fast(kSetup, block);
    ASSERT_EQ(run.events().size(), 1U) << block;
    EXPECT_STREQ(run.events()[0].message, "G81 (drilling, a canned cycle) is not supported") << block;
    ASSERT_EQ(fast.events.size(), 1U) << block;
    EXPECT_STREQ(fast.events[0].message, run.events()[0].message) << block;
  }
}

TEST(NotSupported, WordsWithoutEffectAreListed) {
  std::set<std::string> words;
  spec::ProgramReader reader(spec::text_source("G05.1 Q1 G90 S500 M3\nT1 M06\nG8 P1 G080 M30 M98 P5 G40.1\n"),
                             spec::Axes("XYZ"));
  for (spec::Block block; reader.next(block);) spec::add_words_without_effect(block, words);
  EXPECT_EQ(words, (std::set<std::string>{"G05.1", "G08", "G40.1", "G80", "M03", "M06", "S", "T"}));
}

}  // namespace

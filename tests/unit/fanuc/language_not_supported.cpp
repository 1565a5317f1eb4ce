// SPDX-License-Identifier: Apache-2.0
// What this project does not follow says its name; what changes nothing is read; and reader, model and fast engine
// agree on which code is which.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "spec/language/alarm.h"
#include "spec/language/fanuc/not_supported.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/fanuc/without_effect.h"
#include "tests/support/usual_number.h"
#include "tests/unit/fanuc/fast_run.h"
#include "tests/unit/model_run.h"

namespace {

using namespace toolcomp;

constexpr std::string_view kSetup = "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n";

// What is said of the last block of the text: "COLUMN message" of what is not supported, "NUMBER@COLUMN" of another
// alarm of reading, or "read".
std::string said(std::string_view text) {
  spec::ProgramReader reader(spec::text_source(text), spec::Axes("XYZ"));
  spec::Block block;
  for (spec::Block next; reader.next(next);) block = next;
  if (!block.alarm) return "read";
  const std::string column = std::to_string(block.alarm->column);
  if (const char* const message = spec::beyond(block)) return column + ' ' + message;
  return toolcomp::test::usual_number(block.alarm->cause) + '@' + column;
}

TEST(NotSupported, CodesSayTheirName) {
  EXPECT_EQ(said("G98 G84.2 Z-5 R2 F100"), "5 G84.2 (rigid tapping, a canned cycle) is not supported");
  EXPECT_EQ(said("N10 g068.2X0Y0Z0I0J0K0"), "5 G68.2 (tilted working plane) is not supported");
  EXPECT_EQ(said("G68.20"), "1 G68.2 (tilted working plane) is not supported");
  EXPECT_EQ(said("N1 G65 P9000"), "4 G65 (macro call of a program that is missing) is not supported");
  EXPECT_EQ(said("G66 P9000"), "1 G66 (modal macro call) is not supported");
  EXPECT_EQ(said("G90 G16"), "5 G16 (polar coordinate command) is not supported");
  EXPECT_EQ(said("G68 G51"), "1 G68 (coordinate system rotation) is not supported") << "the first one";
  EXPECT_EQ(said("G05.4 Q1"), "1 G05.4 (hold of high precision control) is not supported");
  EXPECT_EQ(said("G90 G10 L50"), "9 G10 L (tool life and parameters) is not supported");
  EXPECT_EQ(said("G10 P1 L3"), "8 G10 L (tool life and parameters) is not supported");
  EXPECT_EQ(said("G10 L2 P1 X5\nM98 P1 L50"), "PS0076@1");
  EXPECT_EQ(said("M198 P1"), "1 M198 (call of a program in another memory) is not supported");
  EXPECT_EQ(said("G68\nX1"), "read") << "of the last block alone";
  for (const char* code : {"G77.7", "G01", "G80", "G69", "G5.1", "G8.1", "G681", "G6.82", "G68.22", "G68000"})
    EXPECT_EQ(said(code), "read") << code;
}

TEST(NotSupported, MacrosSayTheirName) {
  EXPECT_EQ(said("G01 X5 #1=5"), "8 # (a macro statement after other words) is not supported");
  EXPECT_EQ(
      said("#100 = SIN[#101]"),
      "1 # (a macro statement other than a variable set to an expression that toolcomp evaluates) is not supported");
  for (const char* text : {"#0=1", "#50=1", "#1000=1", "#3006=1", "#1=5/0", "#1 5", "#1=", "#1=#2", "#1=1 X5", "#1=[2"})
    EXPECT_NE(said(text).find(" is not supported"), std::string::npos) << text << ": " << said(text);
  const std::string none = " # (a macro variable without a known value) is not supported";
  EXPECT_EQ(said("G01 X#1 Y5"), "5" + none);
  EXPECT_EQ(said("N#1"), "1" + none);
  EXPECT_EQ(said("G01 X-#1"), "5" + none);
  EXPECT_EQ(said("G01 X[1/3]"), "5 # (a macro variable whose value this address does not accept) is not supported");
  EXPECT_EQ(said("G01 X[LN[2]]"), "5 [ (a macro expression that toolcomp does not evaluate) is not supported");
  for (const char* text : {"POPEN", "DPRNT[X#1]"})
    EXPECT_NE(said(text).find(" (a macro statement) is not supported"), std::string::npos)
        << text << ": " << said(text);
}

TEST(NotSupported, CornersByCommas) {
  EXPECT_EQ(said("G01 X10 Y10,R5"), "12 ,R (corner rounding) is not supported");
  EXPECT_EQ(said("G01 X10 , C2."), "9 ,C (chamfering) is not supported");
  EXPECT_EQ(said("G01 X10 ,r 5"), "9 ,R (corner rounding) is not supported");
}

TEST(NotSupported, FaultsAreNotBeyond) {
  EXPECT_EQ(said("X1,A5"), "PS0004@3");
  EXPECT_EQ(said("X1!"), "PS0004@3");
  EXPECT_EQ(said("X"), "PS0005@1");
  EXPECT_EQ(said("X Y1"), "PS0005@1");
  EXPECT_EQ(said("G01 I"), "PS0005@5");
  EXPECT_EQ(said("X1.2.3 #1"), "PS0007@5");
  EXPECT_EQ(said("E5"), "PS0009@1");
}

// What stands in the program, of what is said of it.
TEST(NotSupported, TheCodeIsWhatStandsInTheProgram) {
  EXPECT_EQ(spec::code_of("G84.2 (rigid tapping, a canned cycle) is not supported"), "G84.2");
  EXPECT_EQ(spec::code_of("# (a macro variable) is not supported"), "#");
  EXPECT_EQ(spec::code_of("CALL SELECTED PGM is not supported"), "CALL SELECTED PGM");
}

std::string code_of(std::uint64_t tenths) {
  return 'G' + std::to_string(tenths / 10) + (tenths % 10 == 0 ? "" : '.' + std::to_string(tenths % 10));
}

// Those that do something (clause fanuc.program.unknown-code).
constexpr std::string_view kMeant =
    "G00 G01 G02 G03 G04 G10 G17 G18 G19 G20 G21 G28 G29 G30 G30.1 G37 G39 G40 G41 G41.2 G41.3 G41.6 G42 G42.2 G42.6 "
    "G43 G43.4 G43.5 G44 G45 G46 G47 G48 G49 G52 G53 G54 G55 G56 G57 G58 G59 G54.1 G90 G91 G92 G93 G94 G95 "
    "G73 G74 G76 G80 G81 G82 G83 G84 G85 G86 G87 G88 G89 G98 G99";

TEST(NotSupported, EveryCodeIsTakenOrRefusedAlike) {
  std::set<std::uint64_t> refused_by_name;
  std::size_t taken = 0;
  for (std::uint64_t tenths = 0; tenths < 10000; ++tenths) {
    const std::string code = code_of(tenths);
    SCOPED_TRACE(code);
    const test::Run run = test::run(kSetup, code + "\n");
    const fast::ProgramRun fast(kSetup, code + "\n");
    const auto end = [](const auto& events) {
      const bool ends = !events.empty() && spec::ends_run(events.back().kind);
      return ends ? std::string(events.back().number.view()) : std::string();
    };
    EXPECT_EQ(end(fast.events), end(run.events()));
    const char* const name =
        spec::code_not_supported({.digits = tenths, .decimals = 1, .negative = false, .point = true});
    const bool listed = spec::code_without_effect(tenths);
    EXPECT_FALSE(name != nullptr && listed) << "in both lists";
    const auto reached = [&run](spec::Clause clause) {
      return run.recorder.counts()[static_cast<std::size_t>(clause)].reached != 0;
    };
    EXPECT_EQ(reached(spec::Clause::fanuc_program_without_effect), listed);
    EXPECT_EQ(reached(spec::Clause::fanuc_program_not_supported), name != nullptr);
    const bool meant =
        (' ' + std::string(kMeant) + ' ').find(' ' + std::string(tenths < 100 ? "G0" : "G") + code.substr(1) + ' ') !=
        std::string::npos;
    EXPECT_EQ(reached(spec::Clause::fanuc_program_unknown_code), !listed && !meant && name == nullptr);
    if (name != nullptr) {
      refused_by_name.insert(tenths);
      EXPECT_EQ(run.events().back().kind, spec::EventKind::not_supported);
      EXPECT_EQ(end(run.events()), (tenths < 100 ? "G0" : "G") + code.substr(1));
      EXPECT_STREQ(run.events().back().message, name);
      EXPECT_STREQ(fast.events.back().message, name);
    } else if (listed || meant) {
      ++taken;
    } else {
      EXPECT_EQ(run.events().back().kind, spec::EventKind::alarm);
      EXPECT_EQ(end(run.events()), "PS0010");
    }
  }
  // As many as the clauses list: those that do something, and 29 that do nothing.
  EXPECT_EQ(taken, static_cast<std::size_t>(std::ranges::count(kMeant, 'G')) + 26);
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
  for (const char* block : {"G90 G68 G16 X1", "G69 G68 H9999", "X1 G68 M30", "G68 G77.7", "G77.7 G68"}) {
    const auto run = test::run(kSetup, block);
    const fast::ProgramRun fast(kSetup, block);
    ASSERT_EQ(run.events().size(), 1U) << block;
    EXPECT_STREQ(run.events()[0].message, "G68 (coordinate system rotation) is not supported") << block;
    ASSERT_EQ(fast.events.size(), 1U) << block;
    EXPECT_STREQ(fast.events[0].message, run.events()[0].message) << block;
  }
}

TEST(NotSupported, WordsWithoutEffectAreListed) {
  std::set<std::string> words;
  spec::ProgramReader reader(spec::text_source("G05.1 Q1 G90 S500 M3\nT1 M06\nG8 P1 G080 M30 M98 P5 G40.1\n"),
                             spec::Axes("XYZ"));
  for (spec::Block block; reader.next(block);) spec::add_words_without_effect(block, words);
  EXPECT_EQ(words, (std::set<std::string>{"G05.1", "G08", "G40.1", "M03", "M06", "S", "T"}));
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// The clause files: what every clause must state, and that the model reaches every outcome a clause has.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "corpus/examples.h"
#include "judge/oracle/verdict.h"
#include "spec/language/setup_format.h"
#include "tests/support/setup_with_feed.h"

namespace {

using namespace toolcomp;

TEST(Clauses, StateTheirSource) {
  for (const spec::ClauseInfo& clause : spec::clauses()) {
    EXPECT_TRUE(clause.id.starts_with("fanuc.") || clause.id.starts_with("heidenhain.")) << clause.id;
    // Nobody may read our word, or our memory, as the manual's.
    const bool seen = clause.known == spec::Known::manual || clause.known == spec::Known::sister;
    const bool follows = clause.known == spec::Known::ours && clause.words.starts_with("geometry");
    EXPECT_TRUE(seen || follows || clause.kind == spec::ClauseKind::open) << clause.id;
    EXPECT_TRUE(clause.kind != spec::ClauseKind::open || !clause.alternatives.empty()) << clause.id;
    EXPECT_TRUE(!seen || (!clause.document.empty() && !clause.page.empty())) << clause.id;
    EXPECT_TRUE(clause.kind != spec::ClauseKind::parameter || !clause.parameters.empty()) << clause.id;
    EXPECT_TRUE(clause.testable || !clause.reason.empty()) << clause.id;
    EXPECT_TRUE(clause.unreachable.empty() || !clause.unreachable_reason.empty()) << clause.id;
    // Whoever reads an explanation must learn what an outcome means.
    const bool decides = clause.testable && clause.outcomes != spec::ClauseOutcomes::reach;
    EXPECT_TRUE(!decides || (!clause.positive.empty() && !clause.negative.empty())) << clause.id;
    EXPECT_TRUE(!decides || clause.outcomes != spec::ClauseOutcomes::sign || !clause.tie.empty()) << clause.id;
  }
}

TEST(Clauses, FitIntoAName) {
  for (const spec::ClauseInfo& clause : spec::clauses())
    EXPECT_LE(clause.id.size(), spec::Name::kCapacity) << clause.id;
}

const std::string kXyz = "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\"]\n";
const std::string kOffsets = "[offsets.H]\n1 = 10\n2 = 20\n5 = 1000\n[offsets.D]\n1 = 10\n2 = -5\n";
std::string setup(const std::string& parameters) { return kXyz + "[parameters]\n" + parameters + kOffsets; }

struct Program {
  std::string setup;
  std::string text;
};

// Reading, numbers, arcs, coordinates, memory, length offset, G45 to G48, G37.
std::vector<Program> programs_without_look_ahead() {
  const std::string plain = setup("");
  const auto measured = [](const std::string& parameters, const std::string& signal) {
    return setup(parameters) + "[position]\nZ = 300\n" + (signal.empty() ? "" : "[measurement]\nZ = " + signal + "\n");
  };
  const std::string memory_c =
      "control = \"fanuc\"\naxes = [\"Z\"]\n[parameters]\n6241 = 100\n[offsets]\nmemory = \"C\"\n[offsets.H]\n1 = 1\n"
      "[position]\nZ = 300\n[measurement]\nZ = 195\n";
  return {
      {plain, "G20 X1 Y1 F5\nG21 X1 X2 G91 G90\nG91 X1\nM30\n"},
      {setup("\"3401#0\" = 0\n"), "X1\nG04 X1\n"},
      {plain, "X1.2.3\n"},
      {plain, "G99\n"},
      {plain, "G03 X10 I-10\nZ5\n"},
      {setup("3410 = 3\n"), "G03 X8 Y0 I5\n"},
      {setup("\"5006#6\" = 1\n"), "G41 D1 X10\nX20\nG43 H1\n"},
      {setup("\"5003#2\" = 1\n"), "G01 G41 X0 D1\nX40\nG53 X0\nG92 X5\nX60\n"},
      {"control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n[parameters]\n19680 = 21\n19681 = 4\n19682 = "
       "2\n"
       "19686 = 5\n19687 = 3\n[offsets.D]\n1 = 1\n",
       "G01 G41.2 X10 D1\nX20\nG03 X30 Y10 R10\n"},
      {plain, "X10\nG03 X0 Y10 R10 I3\n"},
      {plain, "G55 X1\nG92 X5\nG53 X1\nG91 G53 X1\nG28\nG28 X1\nG29 X1 Y1\nG90 G29 X2\nG30 P3 X1\nG30 P7 X1\n"},
      {plain, "G10 L9\n"},
      {setup("\"5001#0\" = 1\n\"5001#3\" = 1\n"), "G43 X1 Y1 H1\n"},
      {plain, "G45 X100 B1 D1\nG48 X0\nG47\n"},
      {setup("\"5001#5\" = 1\n"), "G45 X1 H1\nG43 G45 X1\n"},
      {memory_c, "H1\nZ210\nG37 Z200\n"},
      {measured("", "230"), "H1\nG37 Z200\n"},
      {measured("", "190"), "H1\nG37 Z200\n"},
      {measured("6254 = 20\n", ""), "H1\nG37 Z300\n"},
  };
}

std::vector<Program> cutter_b_programs() {
  const std::string b = "cutter_compensation = \"B\"\n" + setup("");
  const std::string on = "G01 G41 X40 D1\n";
  return {
      {b, "G41 Z1 D1\nX40\nX40\nX50 I1\nX50 I0\nG41 X60\nG42 X70 D1\nX80 D2\nX90 D0\nG10 L11 P1 R1\nG40\n"},
      {b, on + "G03 X60 Y20 J20\nX40 Y20 I-10\nG02 X60 I10\nG03 J20\nX40 Y40 R-30\nG40\n"},
      {b, on + "G39 J1\nG39 J1\nG91 G39 X1\nG42\nG39 I-1\nG53 X1\nG90 G53 Z1\nG53 X1\nG40 X5\n"},
      {b, "G41 X5 D0\nG02 G40 X9 R2\nG40\n"},
      {b, on + "G40\nG41 X50\nG02 G40 X60 R5\n"},
      {b, "G41 D1\nG03 X50 I5\n"},
      {b, on + "G41.3\n"},
      {"control = \"fanuc\"\naxes = [\"X\"]\n", "G41\n"},
  };
}

// `on` starts along X with offset 10: the start-up and a block of the mode.
std::vector<Program> cutter_c_programs() {
  const auto c = [](const std::string& parameters) {
    return kXyz + "[parameters]\n" + parameters + "[offsets.D]\n1 = 10\n7 = 25\n[position]\nX = -20\n";
  };
  const std::string on = "G01 G41 X0 D1\nX40\n";
  // Behind an arc of radius 50 about (-40, -30) to the origin.
  const std::string nested = "G00 X10 Y-60\nG01 G41 Y-30 D7\nG03 X0 Y0 R50\nG02 X-40 Y-40 I-40\n";
  return {
      {c(""), on + "G03 X-40 Y20 I-40 J-30\n"},
      {c("\"5008#0\" = 1\n"), nested},
      {c("\"5003#1\" = 1\n"), "G41 D1\nX40\nX80\nG40\nX90\nG41 Z1\nX80\nG40 Z2\nG41\nG40\n"},
      {c(""), on + "X35.2 Y-6.4\nX80\n"},
      {c(""), "G00 X60\nG01 G41 X40 D1\nX0\nM05\nM09\nG02 J-5\n"},
  };
}

// What no example of the golden corpus reaches; programs end at their first alarm.
std::vector<Program> programs() {
  std::vector<Program> list = programs_without_look_ahead();
  for (const auto& more : {cutter_b_programs(), cutter_c_programs()}) list.insert(list.end(), more.begin(), more.end());
  return list;
}

model::Recorder decisions_of(std::string_view setup, std::string_view program, std::uint32_t samples = 0) {
  spec::Case c;
  c.setup = test::setup_with_feed(setup);
  c.program = program;
  c.samples = samples;
  return judge::run_model(c).recorder;
}

// By the examples of the golden corpus, whose figures are held by tests, and the programs above.
TEST(Clauses, EveryOutcomeIsReached) {
  std::vector<model::ClauseCount> total(spec::kClauseCount);
  const auto count = [&total](const model::Recorder& recorder) {
    for (std::size_t i = 0; i < total.size(); ++i) {
      const model::ClauseCount& one = recorder.counts()[i];
      total[i].reached += one.reached;
      total[i].positive += one.positive;
      total[i].negative += one.negative;
      total[i].tie += one.tie;
    }
  };
  for (const corpus::ExampleFile& file : corpus::example_files())
    for (const corpus::Example& example : file.examples)
      count(decisions_of(example.setup, example.program, example.samples));
  for (const Program& program : programs()) count(decisions_of(program.setup, program.text));
  for (std::size_t i = 0; i < total.size(); ++i) {
    const spec::ClauseInfo& clause = spec::clauses()[i];
    const auto expect = [&clause](const char* outcome, std::uint64_t times) {
      const bool unreachable = clause.unreachable.find(outcome) != std::string_view::npos;
      EXPECT_EQ(times == 0, unreachable) << clause.id << ": " << outcome;
    };
    if (!clause.testable || !clause.replaced_by.empty()) {
      EXPECT_EQ(total[i].reached, 0U) << clause.id;
    } else if (clause.outcomes == spec::ClauseOutcomes::reach) {
      EXPECT_GT(total[i].reached, 0U) << clause.id;
    } else if (clause.outcomes == spec::ClauseOutcomes::fact) {
      expect("true", total[i].positive);
      expect("false", total[i].negative);
    } else {
      expect("positive", total[i].positive);
      expect("negative", total[i].negative);
      expect("tie", total[i].tie);
    }
  }
}

}  // namespace

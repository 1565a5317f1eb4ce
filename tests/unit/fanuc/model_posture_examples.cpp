// SPDX-License-Identifier: Apache-2.0
// Tool posture control end to end: what the worked examples (golden/fanuc/corpus_examples_tool_posture.cpp) do not say:
// the flank at every moment, numbers that do not grow.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>

#include "model/fanuc/engine.h"
#include "spec/language/fanuc/program_reader.h"
#include "tests/unit/model_run.h"

namespace {

using namespace toolcomp;

// The machines of the worked examples (corpus/examples/fanuc/machines.h), on axes X1 Y2 Z3 A4 B5 C6.
const std::string kHC = "19680 = 2\n19681 = 6\n19682 = 3\n19686 = 5\n19687 = 2\n";
const std::string kTAC = "19680 = 12\n19681 = 4\n19682 = 1\n19684 = 1\n19686 = 6\n19687 = 3\n19689 = 1\n";
const std::string kN45 = "19680 = 2\n19681 = 6\n19682 = 3\n19686 = 5\n19687 = 5\n19688 = 45\n";

struct Done {
  spec::Setup setup;
  test::Collector sink;
};

// H1 is the length, D2 the radius 5.
Done run(const std::string& parameters, int length, const std::string& program, std::uint32_t samples) {
  const std::string text = "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"A\", \"B\", \"C\"]\n[parameters]\n" +
                           parameters + "[offsets.H]\n1 = " + std::to_string(length) + "\n[offsets.D]\n2 = 5\n";
  Done result{spec::read_setup_toml(text, "setup.toml"), {}};
  model::Recorder recorder;
  model::Engine engine(result.setup, recorder, result.sink, samples);
  spec::ProgramReader reader(spec::text_source(program), result.setup.axes);
  spec::Block block;
  while (!engine.stopped() && reader.next(block)) engine.block(block);
  engine.end();
  return result;
}

// O0010, the whole pyramid (worked example 8).
const std::string kO0010 =
    "N10 G90 G00 X30.0 Y-30.0 Z0.0\nN20 G43.5 H1 P1\nN30 G42.6 D2\nN40 G01 X20.0 Y-20.0 I-1 J1 K2 F500\n"
    "N50 X20.0 Y20.0 I-1 J-1 K2\nN60 X-20.0 Y20.0 I1 J-1 K2\nN70 X-20.0 Y-20.0 I1 J1 K2\nN80 X20.0 Y-20.0 I-1 J1 K2\n"
    "N90 G40\nM30\n";

// The distance of tip and control point from the face 2x + z = 40 of N50, times √5.
TEST(ModelPosture, FlankAndTipKeepTheRadiusFromTheFace) {
  const Done head = run(kHC, 100, kO0010, 16);
  std::size_t seen = 0;
  for (const model::Event& event : head.sink.events) {
    if (event.line != 5 || event.kind != spec::EventKind::sample) continue;
    ++seen;
    for (const auto* at : {&event.point, &event.axes}) {
      const exact::Real off = 2 * (*at)[0] + (*at)[2] - 40;
      const exact::Real error = off - 5 * sqrt(exact::Real(5));
      EXPECT_EQ(error.decimal(30), "0");
    }
  }
  EXPECT_EQ(seen, 15U);
}

// Every direction is taken as it was commanded, and only the branch and the whole turns from where the axes stand: the
// numbers of a block do not grow with the blocks before it.
TEST(ModelPosture, ExactNumbersDoNotChain) {
  struct Counter final : model::EventSink {
    void on(const model::Event& event) override { moves += event.kind == spec::EventKind::move ? 1 : 0; }
    int moves = 0;
  };
  for (const std::string& machine : {kHC, kTAC, kN45}) {
    const spec::Setup setup = spec::read_setup_toml(
        "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"A\", \"B\", \"C\"]\n[parameters]\n" + machine,
        "setup.toml");
    std::string program = "G90 G00 X0 A10 B10\nG43.5 H0 P1\nG01 F500\n";
    for (int i = 0; i < 300; ++i)
      program += "X" + std::to_string(i % 7) + " I" + std::to_string(i % 5 + 1) + " J" + std::to_string(i % 11 - 5) +
                 " K" + std::to_string(i % 3 + 1) + ".7\n";
    Counter counter;
    model::Recorder recorder;
    model::Engine engine(setup, recorder, counter);
    spec::ProgramReader reader(spec::text_source(program), setup.axes);
    spec::Block block;
    std::size_t early = 0;
    std::size_t late = 0;
    while (!engine.stopped() && reader.next(block)) {
      engine.block(block);
      std::size_t& most = block.line < 100 ? early : late;
      most = std::max(most, exact::live_nodes());
    }
    engine.end();
    EXPECT_GT(counter.moves, 300);
    EXPECT_LE(late, early + early / 4);
    EXPECT_LT(late, 400U);
  }
}

}  // namespace

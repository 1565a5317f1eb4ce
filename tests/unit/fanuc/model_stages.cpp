// SPDX-License-Identifier: Apache-2.0
// The stages of compensation as a pipeline: who is asked when, and how long a block is held.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "model/fanuc/program/pipeline.h"
#include "model/fanuc/stages.h"
#include "tests/support/setup_with_feed.h"
#include "tests/unit/model_run.h"

namespace {

using namespace toolcomp;
using test::Lines;

// What the stages below have been asked, in order.
Lines& asked() {
  static Lines lines;
  return lines;
}

struct Said final : model::StageWords {
  std::string by;
};

// Writes down what it is asked. Two of them: one in space, one in the plane.
template <char Name, model::Extent Where>
class Witness : public model::StageOf<Said> {
 public:
  using StageOf::StageOf;
  [[nodiscard]] model::Extent extent() const override { return Where; }
  [[nodiscard]] int look_ahead() const override { return 0; }
  [[nodiscard]] bool on() const override { return Name == 'a'; }
  [[nodiscard]] bool on_after(const model::Command& command) const override { return command.axes != 0; }
  std::shared_ptr<model::StageWords> read(const model::StageCommand& now) override {
    asked().push_back(std::string(1, Name) + " reads");
    if (!now.moves()) return nullptr;
    auto words = std::make_shared<Said>();
    words->by = Name;
    return words;
  }
  void add_way(model::StageWords& words, const model::BlockWay& /*way*/) const override {
    asked().push_back(Name + (" sees the way of " + own(words).by));
  }
  void complete(model::StageWords& words, const model::Step& /*step*/) const override {
    asked().push_back(Name + (" completes " + own(words).by));
  }
  void take(const model::Step& step) override {
    asked().push_back(Name + (" takes " + (has_words(step) ? said(step).by : "nothing")));
    hand_on(step);
  }
  void finish() override { asked().push_back(std::string(1, Name) + " finishes"); }
};

template <class Kind>
std::unique_ptr<model::Stage> make(const model::Stage::Place& place) {
  return std::make_unique<Kind>(place);
}

class ModelStages : public ::testing::Test {
 protected:
  ModelStages() { asked().clear(); }

  // The command of one block of a program.
  model::Command read(std::string_view line) {
    spec::ProgramReader reader(spec::text_source(line), setup.axes);
    EXPECT_TRUE(reader.next(block));
    return interpreter.read(block);
  }

  // A block through the pipeline as the engine leads it.
  void lead(std::string_view line) {
    const model::Command command = read(line);
    model::Pipeline::Words words;
    const model::StageCommand now{command, interpreter, false};
    pipeline.read(model::Extent::space, now, words);
    pipeline.read(model::Extent::plane, now, words);
    const std::vector<model::Leg> legs;
    pipeline.add_way(words, {{}, legs, [](const model::Position&) { return model::Direction(); }});
    model::Step step;
    pipeline.complete(words, step);
    step.words.assign(words.begin(), words.end());
    pipeline.take(step);
  }

  spec::Setup setup = test::setup_with_feed("control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n");
  spec::Block block;
  model::Recorder recorder;
  model::OffsetMemory memory{setup, recorder};
  model::Interpreter interpreter{setup, recorder};
  model::Pipeline pipeline{{make<Witness<'p', model::Extent::plane>>, make<Witness<'a', model::Extent::space>>},
                           setup,
                           memory,
                           recorder,
                           [](const model::Step&) { asked().emplace_back("out"); }};
};

// Stages in space read first, whatever their place; every stage finds its own words again.
TEST_F(ModelStages, AreAskedInOrder) {
  lead("G01 X1");
  EXPECT_EQ(asked(), (Lines{"a reads", "p reads", "p sees the way of p", "a sees the way of a", "p completes p",
                            "a completes a", "p takes p", "a takes a", "out"}));
}

TEST_F(ModelStages, WithoutWordsAreLeftInPeace) {
  lead("M08");
  EXPECT_EQ(asked(), (Lines{"a reads", "p reads", "p takes nothing", "a takes nothing", "out"}));
}

TEST_F(ModelStages, FinishInOrder) {
  pipeline.finish();
  EXPECT_EQ(asked(), (Lines{"p finishes", "a finishes"}));
}

TEST_F(ModelStages, SayWhatIsInForce) {
  const model::Pipeline::InForce before_stop = pipeline.in_force(model::Extent::space, read("M08"));
  EXPECT_TRUE(before_stop.before);
  EXPECT_FALSE(before_stop.after);
  EXPECT_FALSE(pipeline.in_force(model::Extent::plane, read("M08")).any());
  const model::Pipeline::InForce with_axis = pipeline.in_force(model::Extent::plane, read("X1"));
  EXPECT_FALSE(with_axis.before);
  EXPECT_TRUE(with_axis.after);
}

// How many blocks behind its own an event comes at the latest. Every line is a block.
std::uint64_t longest_hold(const spec::Setup& setup, std::string_view program) {
  model::Recorder recorder;
  test::Collector sink;
  model::Engine engine(setup, recorder, sink);
  spec::ProgramReader reader(spec::text_source(program), setup.axes);
  spec::Block block;
  std::uint64_t longest = 0;
  while (!engine.stopped() && reader.next(block)) {
    const std::size_t before = sink.events.size();
    engine.block(block);
    for (std::size_t i = before; i < sink.events.size(); ++i)
      longest = std::max(longest, block.line - sink.events[i].line);
  }
  EXPECT_FALSE(engine.stopped());
  return longest;
}

constexpr const char* kStart = "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n";
constexpr const char* kOffsets = "[offsets.D]\n1 = 10\n";

// The stage of the registry holds a block as long as it states, and no longer. The programs make it do so: a block that
// moves, and behind it what leaves its end open.
void expect_look_ahead(const std::string& keys, std::size_t place, std::uint64_t blocks, std::string_view program) {
  const spec::Setup setup = spec::read_setup_toml(kStart + keys + kOffsets, "setup.toml");
  model::Recorder recorder;
  const model::OffsetMemory memory(setup, recorder);
  const auto stage = model::stages(setup).at(place)({setup, memory, recorder, place, [](const model::Step&) {}});
  EXPECT_EQ(static_cast<std::uint64_t>(stage->look_ahead()), blocks);
  EXPECT_EQ(longest_hold(setup, program), blocks) << program;
}

TEST(ModelStagesLookAhead, LeadingEdgeOffset) {
  expect_look_ahead("", 0, 2, "G43.5 I3 J0 K4\nG41.3 D1\nG01 X100 F1\nM08\nX200\nM08\nM09\nX300\nX0\nG40\n");
}

TEST(ModelStagesLookAhead, CutterCompensation) {
  const std::string program = "G01 G41 D1 X10 F1\nX100\nM08\nY100\nM08\nM09\nX0\nY0\nG40 X-50\n";
  expect_look_ahead("cutter_compensation = \"B\"\n", 1, 0, program);
  expect_look_ahead("cutter_compensation = \"C\"\n", 1, 2, program);
}

// No. 19625: one block less than are read.
const std::string kFiveBlocks = "series = \"30i\"\n[parameters]\n19625 = 5\n";

TEST(ModelStagesLookAhead, CutterCompensationOfThe30i) {
  expect_look_ahead(kFiveBlocks, 1, 4, "G01 G41 D1 X10 F1\nX100\nM08\nM09\nM08\nM09\nX0\nY0\nG40 X-50\n");
}

// Behind an outer corner of two vectors (a turn to the left by 135 degrees, the tool at the right) a block waits for
// the next corner too.
TEST(ModelStagesLookAhead, ToolSideCompensation) {
  expect_look_ahead("", 2, 4, "G01 G42.2 D1 X10 F1\nX100\nM08\nX50 Y50\nM08\nX-100\nM08\nM09\nG40 X-200\n");
}

TEST(ModelStagesLookAhead, ToolSideCompensationOfThe30i) {
  expect_look_ahead(kFiveBlocks, 2, 8,
                    "G01 G42.2 D1 X10 F1\nX100\nM08\nM09\nM08\nX50 Y50\nM08\nM09\nM08\nX-100\nM08\nG40 X-200\n");
}

}  // namespace

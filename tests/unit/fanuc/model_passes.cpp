// SPDX-License-Identifier: Apache-2.0
// The passes of compensation one after the other: which is asked when, and how long a block waits.
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/fanuc/passes/passes.h"
#include "tests/support/setup_with_feed.h"
#include "tests/unit/model_run.h"

namespace {

using namespace toolcomp;
using test::Lines;

// What the passes below have been asked, in order.
Lines& asked() {
  static Lines lines;
  return lines;
}

// Writes down what it is asked. `Holds`: it gives nothing before the end.
template <char Name, model::Extent Where, bool Holds>
class Witness : public model::Pass {
 public:
  using Pass::Pass;
  [[nodiscard]] model::Extent extent() const override { return Where; }
  [[nodiscard]] int look_ahead() const override { return 0; }
  [[nodiscard]] bool on() const override { return Name == 'a'; }
  [[nodiscard]] bool on_after(const model::Command& command) const override { return command.axes != 0; }
  void read(const model::BlockWords& /*now*/, model::StepWords& /*words*/) override { note(" reads"); }
  void see(const model::BlockWay& /*way*/, model::StepWords& /*words*/) const override { note(" sees the way"); }
  [[nodiscard]] bool has(const model::StepWords& /*words*/) const override { return true; }
  void take(model::OwnedStep step) override {
    note(" takes");
    steps_.push_back(std::move(step));
  }
  void end() override {
    if (!ended_) note(" ends");
    ended_ = true;
  }
  model::OwnedStep next() override {
    if (steps_.empty() || (Holds && !ended_)) return nullptr;
    model::OwnedStep step = std::move(steps_.front());
    steps_.pop_front();
    return step;
  }

 private:
  static void note(const char* what) { asked().push_back(std::string(1, Name) + what); }
  std::deque<model::OwnedStep> steps_;
  bool ended_ = false;
};

template <class Kind>
std::unique_ptr<model::Pass> make(const model::Pass::Place& place) {
  return std::make_unique<Kind>(place);
}

class ModelPasses : public ::testing::Test {
 protected:
  ModelPasses() { asked().clear(); }

  // The command of one block of a program.
  model::Command read(std::string_view line) {
    spec::ProgramReader reader(spec::text_source(line), setup.axes);
    EXPECT_TRUE(reader.next(block));
    return interpreter.read(block);
  }

  // A block through the passes as the engine leads it.
  void lead(model::Passes& through, std::string_view line) {
    const model::Command command = read(line);
    auto step = std::make_unique<model::Step>();
    const model::BlockWords now{command, interpreter, false};
    through.read(model::Extent::space, now, step->words);
    through.read(model::Extent::plane, now, step->words);
    const std::vector<model::Leg> legs;
    through.see({{}, legs, [](const model::Position&) { return model::Direction(); }}, step->words);
    through.put(std::move(step));
    drain(through);
  }
  static void drain(model::Passes& through) {
    while (through.next()) asked().emplace_back("out");
  }

  spec::Setup setup = test::setup_with_feed("control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n");
  spec::Block block;
  model::Recorder recorder;
  model::OffsetMemory memory{setup, recorder};
  model::Interpreter interpreter{setup, recorder};
  model::Pass::Place place{setup, memory, recorder};
  model::Passes passes{
      {make<Witness<'p', model::Extent::plane, false>>, make<Witness<'a', model::Extent::space, false>>}, place};
};

// Passes in space read first, whatever their place.
TEST_F(ModelPasses, AreAskedInOrder) {
  lead(passes, "G01 X1");
  EXPECT_EQ(asked(), (Lines{"a reads", "p reads", "p sees the way", "a sees the way", "p takes", "a takes", "out"}));
}

// The second pass hears of the end after all that the first one had left.
TEST_F(ModelPasses, EndInOrder) {
  model::Passes holding{
      {make<Witness<'p', model::Extent::plane, true>>, make<Witness<'a', model::Extent::space, true>>}, place};
  lead(holding, "X1");
  lead(holding, "X2");
  asked().clear();
  holding.end();
  drain(holding);
  EXPECT_EQ(asked(), (Lines{"p ends", "a takes", "a takes", "a ends", "out", "out"}));
}

TEST_F(ModelPasses, SayWhatIsInForce) {
  const model::Passes::InForce before_stop = passes.in_force(model::Extent::space, read("M08"));
  EXPECT_TRUE(before_stop.before);
  EXPECT_FALSE(before_stop.after);
  EXPECT_FALSE(passes.in_force(model::Extent::plane, read("M08")).any());
  const model::Passes::InForce with_axis = passes.in_force(model::Extent::plane, read("X1"));
  EXPECT_FALSE(with_axis.before);
  EXPECT_TRUE(with_axis.after);
}

// How many blocks after its own an event comes at the latest. Every line is a block.
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

// A pass holds a block as long as it states, and no longer. The programs make it do so: a block that moves, and after
// it what leaves its end open.
void expect_look_ahead(const std::string& keys, std::size_t place, std::uint64_t blocks, std::string_view program) {
  const spec::Setup setup = spec::read_setup_toml(kStart + keys + kOffsets, "setup.toml");
  model::Recorder recorder;
  const model::OffsetMemory memory(setup, recorder);
  const auto pass = model::passes_of(setup).at(place)({setup, memory, recorder});
  EXPECT_EQ(static_cast<std::uint64_t>(pass->look_ahead()), blocks);
  EXPECT_EQ(longest_hold(setup, program), blocks) << program;
}

TEST(ModelPassesLookAhead, LeadingEdgeOffset) {
  expect_look_ahead("", 0, 2, "G43.5 I3 J0 K4\nG41.3 D1\nG01 X100 F1\nM08\nX200\nM08\nM09\nX300\nX0\nG40\n");
}

TEST(ModelPassesLookAhead, CutterCompensation) {
  const std::string program = "G01 G41 D1 X10 F1\nX100\nM08\nY100\nM08\nM09\nX0\nY0\nG40 X-50\n";
  expect_look_ahead("cutter_compensation = \"B\"\n", 1, 0, program);
  expect_look_ahead("cutter_compensation = \"C\"\n", 1, 2, program);
}

// No. 19625: one block less than are read.
const std::string kFiveBlocks = "series = \"30i\"\n[parameters]\n19625 = 5\n";

TEST(ModelPassesLookAhead, CutterCompensationOfThe30i) {
  expect_look_ahead(kFiveBlocks, 1, 4, "G01 G41 D1 X10 F1\nX100\nM08\nM09\nM08\nM09\nX0\nY0\nG40 X-50\n");
}

// After an outer corner of two vectors (a turn to the left by 135 degrees, the tool at the right) a block waits for
// the next corner too.
TEST(ModelPassesLookAhead, ToolSideCompensation) {
  expect_look_ahead("", 2, 4, "G01 G42.2 D1 X10 F1\nX100\nM08\nX50 Y50\nM08\nX-100\nM08\nM09\nG40 X-200\n");
}

TEST(ModelPassesLookAhead, ToolSideCompensationOfThe30i) {
  expect_look_ahead(kFiveBlocks, 2, 8,
                    "G01 G42.2 D1 X10 F1\nX100\nM08\nM09\nM08\nX50 Y50\nM08\nM09\nM08\nX-100\nM08\nG40 X-200\n");
}

}  // namespace

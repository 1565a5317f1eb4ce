// SPDX-License-Identifier: Apache-2.0
// What the model tells of moves beside their events: where positions count from, and what lies inside.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "model/fanuc/program/motion.h"
#include "tests/unit/model_run.h"

namespace toolcomp::test {
namespace {

constexpr std::string_view kTable =
    "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\",\"A\",\"C\"]\n[parameters]\n19680=12\n19681=4\n19682=1\n"
    "19684=1\n19686=5\n19687=3\n19689=1\n[offsets.H]\n1=100\n[workpiece.G54]\nX=5\n[workpiece.G55]\nX=7\nC=30\n";

// Writes down what it is told, in the order of the run.
struct Motions final : model::EventSink, model::MotionSink {
  void on(const model::Event& event) override {
    events.push_back(event);
    if (event.kind == spec::EventKind::move) told.push_back("move " + std::to_string(event.line));
  }
  void on(const model::MoveMotion& motion) override {
    told.push_back(std::string(motion.of_tip ? "tip" : "axes") + " from X" + (*motion.zero)[0].decimal(3));
    inside.push_back(motion.inside);
    // While the engine stands.
    if (motion.inside) middle = motion.inside->axes_at(exact::Rational(1, 2));
  }
  void stand(const model::SharedZero& zero, std::uint64_t line, const std::optional<std::uint64_t>&) override {
    told.push_back("stand " + std::to_string(line) + " X" + (*zero)[0].decimal(3) + " C" + (*zero)[4].decimal(3));
  }

  std::vector<model::Event> events;
  std::vector<std::string> told;
  std::vector<std::shared_ptr<const model::InsideMove>> inside;
  spec::AxisValues<exact::Real> middle;
};

Motions follow(std::string_view program) {
  const spec::Setup setup = spec::read_setup_toml(kTable, "setup.toml");
  model::Recorder recorder;
  Motions motions;
  model::Engine engine(setup, recorder, motions, 0, &motions);
  spec::ProgramReader reader(spec::text_source(program), setup.axes);
  spec::Block block;
  while (!engine.stopped() && reader.next(block)) engine.block(block);
  engine.end();
  motions.inside.clear();
  return motions;
}

TEST(ModelMotions, ZerosAreThoseOfTheBlock) {
  // G55 counts in its block, G92 behind it: X2 in G55 is called 0 then, 2 further.
  const Motions motions = follow("G90 G01 X1. F100\nG55 X2.\nG92 X0\nX1.\n");
  EXPECT_EQ(motions.told, (std::vector<std::string>{"stand 0 X5 C0", "axes from X5", "move 1", "stand 1 X5 C0",
                                                    "axes from X7", "move 2", "stand 2 X7 C30", "stand 3 X9 C30",
                                                    "axes from X9", "move 4", "stand 4 X9 C30"}));
}

// The tip at 10 from the centre of the table, which is at X-5 of the workpiece, runs to 20 while the table turns by 90
// degrees: in the middle 15 from it at 45 degrees, left-handed.
TEST(ModelMotions, TheInsideOfABlock) {
  const Motions motions = follow("G90 G00 X5.\nG43.4 H1\nG01 X15. C90. F100\n");
  EXPECT_EQ(motions.told,
            (std::vector<std::string>{"stand 0 X5 C0", "axes from X5", "move 1", "stand 1 X5 C0", "tip from X5",
                                      "move 2", "stand 2 X5 C0", "tip from X5", "move 3", "stand 3 X5 C0"}));
  const exact::Real along = 15 * exact::cos_degrees(45);
  EXPECT_TRUE(motions.middle[0] == along - 5);
  EXPECT_TRUE(motions.middle[1] == -along);
  EXPECT_EQ(motions.middle[2].decimal(3), "100");
  EXPECT_EQ(motions.middle[4].decimal(3), "45");
}

using ProgramRun = Run;

// Who asks changes nothing of the run.
TEST(ModelMotions, EventsStayAsTheyAre) {
  constexpr std::string_view program =
      "G90 G00 X5.\nG43.5 H1 P1\nG01 I1. K1. F100\nI-1. J2. K3. X3.\nG49\nG55 X1.\nG92 X0\nG53 X0\nG02 X4. I2.\n";
  const ProgramRun plain = run(kTable, program);
  ProgramRun asked{plain.setup, model::Recorder(), {}};
  asked.sink.events = follow(program).events;
  EXPECT_EQ(lines(asked), lines(plain));
  EXPECT_EQ(lines(asked, Show::machine), lines(plain, Show::machine));
}

}  // namespace
}  // namespace toolcomp::test

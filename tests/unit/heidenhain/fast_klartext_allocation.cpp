// SPDX-License-Identifier: Apache-2.0
// program: allocations
// Nothing allocates per block of a Klartext program, neither the reader nor the engine; and where its counters end.
#include <gtest/gtest.h>

#include "fast/heidenhain/engine.h"
#include "spec/language/heidenhain/klartext_reader.h"
#include "spec/language/setup_format.h"
#include "tests/unit/count_allocations.h"

namespace toolcomp::fast::klartext {
namespace {

class Counter final : public EventSink {
 public:
  void on(const Event& event) override {
    moves += event.kind == spec::EventKind::move ? 1 : 0;
    last = event.number;
  }
  std::size_t moves = 0;
  decltype(Event::number) last;
};

constexpr const char* kSetup = R"(
control = "heidenhain"
[[tool]]
number = 1
name = "TOROID"
R = 6
R2 = 1
L = 100
DR = "-0.1"
[[tool]]
number = 2
R = 3
R2 = 3
DR2TABLE = "BALL"
[[correction.tcs]]
number = 7
DR = "0.01"
[[dr2table]]
name = "BALL"
points = [[0, 0], [45, "0.01"], [90, "-0.02"]]
)";

// Every kind of block, whole and turned tools, numbers beyond 64 bits, warnings, near ties.
TEST(KlartextAllocation, NoneABlock) {
  const std::string body =
      "TOOL CALL \"TOROID\" Z S100 F500 DR-0.02\nFUNCTION CORRDATA TCS #7\nQ1 = 5.5\nCYCL DEF 7.0\nCYCL DEF 7.1 X1\n"
      "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT CNT-CNT\nL X+Q1 Y2 Z3 A10 C20 R0 FMAX\n"
      "LN X1 Y2 Z3 NX0.6 NY0 NZ0.8 TX0 TY0 TZ1\nLN X1 Y2 Z3 NX-0.6 NY0 NZ0.8 TX0 TY0 TZ1 M128\n"
      "LN X1 Y2 Z3 NX0.00000000000000001 NY0 NZ1 TX0 TY0 TZ1.0001\nLN X1 Y2 Z3 NX0 NY0.6 NZ0.8\n"
      "FUNCTION PROG PATH IS CONTOUR\nL X1 RL\nL X2 Z1 B5\nL Y5.123456789012\nL Z-5\nLN X0 Y9 Z9 TX0.1 TY0 TZ1\n"
      "LN X0 Y0 Z9 TX0.1 TY0 TZ1 RR\nLN X0 Y8 Z9.00001 TX0.1 TY0 TZ1\nL X0 Y-8 R0 M129\n"
      "FUNCTION PROG PATH OFF\nL X3 RL\nL X4 R0\nTOOL CALL 2 Z\nM128\nLN X0 Y0 Z0 NX1 NY0 NZ1 TX0 TY0 TZ1\n"
      "FUNCTION RESET TCPM\nTOOL CALL 0\n";
  std::string program;
  for (int i = 0; i < 500; ++i) program += body;
  const spec::Setup setup = spec::read_setup_toml(kSetup, "setup");
  Counter counter;
  klartext::Engine engine(setup, counter);
  spec::klartext::Reader reader(spec::text_source(program), setup);
  spec::klartext::Block block;
  const std::size_t before = allocations;
  while (reader.next(block)) engine.block(block);
  engine.end();
  EXPECT_EQ(allocations, before);
  EXPECT_GE(counter.moves, 500U * 14);
}

// A counter holds 2^125 / (127 * 10^18) = 3.349e17 to either side: three times the longest word, not four times.
TEST(Klartext, IncrementalWordsOutgrowTheCounter) {
  for (const char* const sign : {"", "-"})
    for (const int words : {3, 4}) {
      std::string program;
      for (int i = 0; i < words; ++i) program += std::string("L IX") + sign + "99999999999999999\n";
      const spec::Setup setup = spec::read_setup_toml(kSetup, "setup");
      Counter counter;
      klartext::Engine engine(setup, counter);
      spec::klartext::Reader reader(spec::text_source(program), setup);
      for (spec::klartext::Block block; reader.next(block);) engine.block(block);
      engine.end();
      EXPECT_EQ(counter.moves, 3U) << sign;
      EXPECT_EQ(counter.last.view() == "POSITION_RANGE", words == 4) << sign;
    }
}

}  // namespace
}  // namespace toolcomp::fast::klartext

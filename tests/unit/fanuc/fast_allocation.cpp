// SPDX-License-Identifier: Apache-2.0
// program: allocations
// Nothing allocates per block: neither the reader nor the engine, in any section.
#include <gtest/gtest.h>

#include "fast/arrays/line_road.h"
#include "fast/fanuc/engine.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/setup_format.h"
#include "tests/support/setup_with_feed.h"
#include "tests/unit/count_allocations.h"

namespace toolcomp::fast {
namespace {

class Counter final : public EventSink {
 public:
  void on(const Event& event) override {
    ++events;
    moves += event.kind == spec::EventKind::move ? 1 : 0;
  }
  std::size_t events = 0;
  std::size_t moves = 0;
};

constexpr const char* kSetup =
    "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\",\"B\",\"C\"]\n[parameters]\n\"19680\"=2\n\"19681\"=5\n"
    "\"19682\"=3\n\"19686\"=4\n\"19687\"=2\n[offsets.H]\n1=20\n2=30\n[offsets.D]\n1=10\n2=6\n";

// Tables with offsets, a mixed machine, inclined axes.
constexpr const char* kTable =
    "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\",\"A\",\"C\"]\n[parameters]\n\"19680\"=12\n\"19681\"=4\n"
    "\"19682\"=1\n\"19684\"=1\n\"19686\"=5\n\"19687\"=3\n\"19689\"=1\n\"19702\"=-100\n\"19704\"=30\n\"19738\"=5\n"
    "\"19739\"=90\n[offsets.H]\n1=20\n2=30\n[offsets.D]\n1=10\n2=6\n";
constexpr const char* kInclined =
    "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\",\"B\",\"C\"]\n[parameters]\n\"19680\"=21\n\"19681\"=4\n"
    "\"19682\"=5\n\"19683\"=45\n\"19686\"=5\n\"19687\"=3\n\"19689\"=1\n\"19711\"=40\n\"19696#5\"=1\n[offsets.H]\n1="
    "20\n2=30\n"
    "[offsets.D]\n1=10\n2=6\n";

// Runs `head` once and `body` until 10,000 blocks are done; the allocations after construction.
void expect_no_allocation(const std::string& head, const std::string& body, std::size_t events_a_block,
                          const char* toml = kSetup, std::uint32_t samples = 0) {
  std::string program = head;
  std::size_t blocks = 0;
  while (blocks < 10'000) {
    program += body;
    for (const char c : body) blocks += c == '\n' ? 1 : 0;
  }
  const spec::Setup setup = test::setup_with_feed(toml);
  Counter counter;
  Engine engine(setup, counter, samples);
  spec::ProgramReader reader(spec::text_source(program), setup.axes);
  spec::Block block;
  const std::size_t before = allocations;
  while (reader.next(block)) engine.block(block);
  engine.end();
  EXPECT_EQ(allocations, before);
  EXPECT_GE(counter.moves, events_a_block * 10'000 / 2);
}

// The same by the road of usual lines.
void expect_no_allocation_on_the_road(const std::string& head, const std::string& body) {
  std::string program = head;
  for (int i = 0; i < 1000; ++i) program += body;
  const spec::Setup setup = test::setup_with_feed(kSetup);
  Counter counter;
  Engine engine(setup, counter);
  spec::ProgramReader reader(spec::text_source(program), setup.axes);
  spec::Block block;
  LineRoad road;
  const std::size_t before = allocations;
  road.run(reader, engine, block);
  engine.end();
  EXPECT_EQ(allocations, before);
  EXPECT_GE(counter.moves, 10'000U);
}

TEST(Allocation, CounterCounts) {
  const std::size_t before = allocations;
  delete new int(3);  // NOLINT(cppcoreguidelines-owning-memory)
  EXPECT_EQ(allocations, before + 1);
}

TEST(Allocation, ToolLengthOffset) {
  expect_no_allocation("G90 G01 F100\n",
                       "G43 Z10 H1\nX1.5 Y2.25\nZ0.123456789012 H2\nG44\nG53 X0\nG28 Z5\nG10 L11 P2 R30.5\nG02 X5 Y5 "
                       "R40\nG03 X0 Y0 I-3 J2\nG20 G91 G01 X0.001\nG21 G90 G49\n",
                       1);
}

TEST(Allocation, UsualLines) {
  const std::string around =
      "X100 Y100\nX200\nX300 Y200\nX400\nX500 Y300\nX600\nX650\nY400\nX500 Y500\nX400\nX300\nX200 Y600\nX0\nX-100 Y0\n";
  expect_no_allocation_on_the_road("G90 G01 F100 X0 Y0\n", around);
  expect_no_allocation_on_the_road("G90 G01 F100 X-500 Y-500\nG42 D2 X-100 Y0\n", around);
  expect_no_allocation_on_the_road("G90 G01 F100 B10 X-500 Y-500\nG42.2 D2 X-100 Y0\n", around + "F200\n");
}

TEST(Allocation, LeadingEdgeOffset) {
  expect_no_allocation("G90 G01 F100 B30\n",
                       "G41.3 D1\nX100 B45\nX110 Z-10\nB20 C30\nY40 D2\nM08\nM09\nX0 Y0 Z0 B0 C0\nX1\nG40\n"
                       "G43.5 H1 I1 J2 K3\nG41.3 D1\nX3 Y6 Z9.000000001\nX5 I0 J0 K1\nX0 Y0 Z0\nG40\nG49\nB30\n",
                       1);
}

// Corners of every kind, rotations, blocks without movement, arcs in a plane of their own and in another, tool
// directions by I J K, numbers beyond 64 bits.
TEST(Allocation, ToolSideCompensation) {
  expect_no_allocation(
      "G90 G01 F100\n",
      "B0 C0\nG42.2 D1 X10 Y0 Z0\nX100 B30 C10\nX210 Z-10\nB20 C30\nX140 Y90 Z3\nM08\nX-60 Y10\n"
      "X-50.000000001 Y-99\nG41.2 X60 Y-140 Q1\nG41.2 X190 D2\nM08\nM09\nX200 Y-200 B45 C45\nY-300\nB0 C0\n"
      "Y-400\nG03 X250 Y-450 R50\nG01 X400\nB10\nG02 X500 Y-550 I0 J-100\nG01 Y-700\nG40 X0\nG43.5 H1 I1 J2 K3\n"
      "G41.6 D1 X30 Y6 Z9.000000001\nX500 I0 J0 K1\nX400 Y-300 I1 J0.5 K2\nI0.1\nX0 Y0 Z0 I0 J1 K1\nG40 X-50\n"
      "G49\n",
      1);
}

// Both types, both interpolations, singular starts and ends, passing, compensation, arcs, lean, every machine type.
TEST(Allocation, ToolCenterPointControl) {
  const std::string by_direction =
      "G90 G01 F100\nG43.5 H1 P1\nX10 Y0 Z0 I1 K5\nX30 Y-30 I-1 J0.1 K5\nK1\nG42.6 D2\nX20 Y-20 I-1 J1 K2\nY20 I-1 J-1 "
      "K2\n"
      "X-20 I1 J-1 K2\nM08\nY-20 I1 J1 K2\nG40 X-50\nH2\nX0 Y0 I0.123456789 K1\nG03 X0 Y10 R50 J1 K3\nG01 X0 Y0\nG49\n"
      "G43.5 H1 P0 Q3\nX5 I-1 J1 K2\nY9\nX0 Y0 K1\nG43.5 P1\nI1 K2\nG49 X0 Y0 Z0\n";
  const std::string by_position =
      "G90 G01 F100\nG43.4 H1 P1\nX10 C20\nX20 C200\nG02 X0 Y20 R20 C90\nG01 X0 Y0 C0\nG91 C10\nG90 C0.123456789\nG49 "
      "X0 Y0 Z0 C0\n";
  expect_no_allocation("", by_direction, 1);
  expect_no_allocation("", by_direction, 1, kSetup, 4);
  expect_no_allocation("", by_direction, 1, kTable, 4);
  expect_no_allocation("", by_position, 1, kTable);
  expect_no_allocation(
      "", "G90 G01 F100\nG43.4 H1 P1\nX10 C20\nX20 B30 C200\nB0 C90\nC0\nG91 C10\nG90 C0.123456789\nG49 X0 Y0 Z0 C0\n",
      1, kInclined, 4);
  expect_no_allocation("",
                       "G90 G01 F100\nG41.3 D1\nX10 B30\nX20 B31 C9\nY9\nG40\nG43.4 H2 P1\nG41.3 D1\nX30 B40\nC20\nY50 "
                       "B50\nG40\nG49 X0 Y0 Z0 B0 C0\n",
                       1, kSetup, 4);
}

TEST(Allocation, Alarms) {
  const spec::Setup setup = test::setup_with_feed(kSetup);
  Counter counter;
  Engine engine(setup, counter);
  spec::ProgramReader reader(spec::text_source("G01 B30\nG41.3 D1\nX1\nG41.3\n"), setup.axes);
  spec::Block block;
  const std::size_t before = allocations;
  while (reader.next(block)) engine.block(block);
  EXPECT_EQ(allocations, before);
  EXPECT_EQ(counter.events, 4U);
}

}  // namespace
}  // namespace toolcomp::fast

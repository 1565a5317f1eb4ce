// SPDX-License-Identifier: Apache-2.0
// program: c
// link: toolcomp_c

// The library of C (c/include/toolcomp.h). Expected values: the manual's, a hand derivation, and the engine that it
// hands on (the same numbers, bit for bit).
#include <gtest/gtest.h>
#include <toolcomp.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "fast/fanuc/engine.h"
#include "fast/heidenhain/engine.h"
#include "spec/language/byte_source.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/heidenhain/klartext_reader.h"
#include "spec/language/setup_format.h"

namespace {

constexpr std::string_view kSetup =
    "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\ncutter_compensation = \"C\"\n"
    "[offsets.H]\n1 = 20\n2 = 30\n[offsets.D]\n1 = 5\n";

struct Free {
  void operator()(toolcomp_setup* setup) const { toolcomp_setup_free(setup); }
  void operator()(toolcomp_engine* engine) const { toolcomp_engine_free(engine); }
  void operator()(toolcomp_batch* batch) const { toolcomp_batch_free(batch); }
};
template <class Handle>
using Owned = std::unique_ptr<Handle, Free>;

Owned<toolcomp_setup> setup(std::string_view text = kSetup) {
  toolcomp_setup* made = nullptr;
  toolcomp_error error;
  EXPECT_EQ(toolcomp_setup_from_text(text.data(), text.size(), &made, &error), TOOLCOMP_OK) << error.message;
  return Owned<toolcomp_setup>(made);
}

// An event with texts of its own.
struct Kept {
  toolcomp_event event;
  std::string number;
  std::string message;
};
using Events = std::vector<Kept>;
void keep(void* events, const toolcomp_event* event) {
  static_cast<Events*>(events)->push_back({*event, event->number, event->message});
}

Owned<toolcomp_engine> engine(const toolcomp_setup* of, Events& events, std::uint32_t samples = 0) {
  toolcomp_engine* made = nullptr;
  EXPECT_EQ(toolcomp_engine_new(of, samples, keep, &events, &made, nullptr), TOOLCOMP_OK);
  return Owned<toolcomp_engine>(made);
}

Events run(const toolcomp_setup* of, std::string_view program, std::uint32_t samples = 0) {
  Events events;
  const auto made = engine(of, events, samples);
  toolcomp_error error;
  EXPECT_EQ(toolcomp_engine_run(made.get(), program.data(), program.size(), &error), TOOLCOMP_OK) << error.message;
  EXPECT_EQ(toolcomp_engine_end(made.get(), &error), TOOLCOMP_OK);
  return events;
}

// The manual's replacement example: H1 = 20, H2 = 30 give Z120 and Z130.
TEST(CInterface, TheManualsExample) {
  const Events events = run(setup().get(), "G90 G43 Z100. H1\nG90 G43 Z100. H2\nM30\n");
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].event.axes[2], 120);
  EXPECT_EQ(events[1].event.axes[2], 130);
  EXPECT_EQ(events[0].event.programmed[2], 100);
  EXPECT_EQ(events[0].event.size, sizeof(toolcomp_event));
  EXPECT_EQ(events[0].event.kind, TOOLCOMP_MOVE);
  EXPECT_EQ(events[0].event.line, 1U);
  EXPECT_EQ(events[0].event.n, TOOLCOMP_NO_NUMBER);
}

// Every other field of an event; NaN where there is none. An arc about X10: from X0 to X20 clockwise, half a turn.
TEST(CInterface, NamesEveryNumberOfAnArc) {
  const Events events = run(setup().get(), "G90 G01 F200 X0 Y0\nN7 G02 X20 Y0 I10 J0\nM30\n");
  ASSERT_EQ(events.size(), 2U);
  const toolcomp_event& arc = events[1].event;
  EXPECT_EQ(arc.type, TOOLCOMP_ARC);
  EXPECT_EQ(arc.cause, TOOLCOMP_PROGRAMMED);
  EXPECT_EQ(arc.n, 7U);
  EXPECT_EQ(arc.center[0], 10);
  EXPECT_EQ(arc.center[1], 0);
  EXPECT_EQ(arc.direction, TOOLCOMP_CW);
  EXPECT_EQ(arc.plane, TOOLCOMP_XY);
  EXPECT_EQ(arc.sweep, 180);
  EXPECT_EQ(arc.feed, 200);
  EXPECT_TRUE(std::isnan(arc.radius[0]));
  EXPECT_TRUE(std::isnan(arc.machine[0]));
  EXPECT_TRUE(std::isnan(arc.axes[3]));
  EXPECT_TRUE(std::isnan(arc.tool_center[0]));
  EXPECT_TRUE(std::isnan(events[0].event.center[0]));
  EXPECT_TRUE(std::isnan(events[0].event.sweep));
}

TEST(CInterface, AnAlarmEndsTheRun) {
  Events events;
  const auto owner = setup();
  const auto made = engine(owner.get(), events);
  const std::string_view wrong = "G90 G00 X1\nG999\n";
  EXPECT_EQ(toolcomp_engine_run(made.get(), wrong.data(), wrong.size(), nullptr), TOOLCOMP_OK);
  EXPECT_EQ(toolcomp_engine_stopped(made.get()), 1);
  const std::string_view more = "X2\n";
  EXPECT_EQ(toolcomp_engine_run(made.get(), more.data(), more.size(), nullptr), TOOLCOMP_OK);
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[1].event.kind, TOOLCOMP_ALARM);
  EXPECT_EQ(events[1].number, "PS0010");
  EXPECT_FALSE(events[1].message.empty());
  EXPECT_EQ(events[1].event.line, 2U);
}

TEST(CInterface, FaultsOfInputHaveTheirPlace) {
  toolcomp_setup* made = nullptr;
  toolcomp_error error;
  const std::string_view wrong = "control = \"fanuc\"\nunits = \"cm\"\n";
  EXPECT_EQ(toolcomp_setup_from_text(wrong.data(), wrong.size(), &made, &error), TOOLCOMP_BAD_INPUT);
  EXPECT_EQ(made, nullptr);
  EXPECT_EQ(error.line, 2U);
  EXPECT_EQ(error.column, 9U);
  EXPECT_NE(std::strstr(error.message, "cm"), nullptr) << error.message;
  EXPECT_EQ(toolcomp_setup_from_file("/nowhere/setup.toml", &made, &error), TOOLCOMP_BAD_INPUT);
  EXPECT_EQ(error.line, 0U);

  // The lines of a program that comes in parts are counted through.
  Events events;
  const auto owner = setup();
  const auto part = engine(owner.get(), events);
  const std::string_view good = "G90 G00 X1\nX2\n";
  EXPECT_EQ(toolcomp_engine_run(part.get(), good.data(), good.size(), &error), TOOLCOMP_OK);
  EXPECT_EQ(error.message[0], '\0');
  const std::string_view bad = "X3\nX\xff\n";
  EXPECT_EQ(toolcomp_engine_run(part.get(), bad.data(), bad.size(), &error), TOOLCOMP_BAD_INPUT);
  EXPECT_EQ(error.line, 4U);
  EXPECT_EQ(error.column, 2U);
  EXPECT_EQ(events.size(), 3U);  // those before stand
}

TEST(CInterface, AnswersSenselessCalls) {
  toolcomp_error error;
  toolcomp_setup* none = nullptr;
  EXPECT_EQ(toolcomp_setup_from_text(nullptr, 0, &none, &error), TOOLCOMP_BAD_CALL);
  EXPECT_STREQ(error.message, "text is a null pointer");
  toolcomp_engine* no_engine = nullptr;
  EXPECT_EQ(toolcomp_engine_new(nullptr, 0, keep, nullptr, &no_engine, &error), TOOLCOMP_BAD_CALL);
  const auto owner = setup();
  EXPECT_EQ(toolcomp_engine_new(owner.get(), 0, nullptr, nullptr, &no_engine, &error), TOOLCOMP_BAD_CALL);
  EXPECT_EQ(toolcomp_engine_run(nullptr, "", 0, nullptr), TOOLCOMP_BAD_CALL);
  toolcomp_batch* made = nullptr;
  ASSERT_EQ(toolcomp_batch_new(owner.get(), nullptr, nullptr, &made, &error), TOOLCOMP_OK);
  const Owned<toolcomp_batch> batch(made);
  const double values[] = {1, std::nan("")};
  const toolcomp_column unknown{"B", values, 3};
  EXPECT_EQ(toolcomp_batch_lines(made, &unknown, 1, 1, &error), TOOLCOMP_BAD_CALL);
  EXPECT_NE(std::strstr(error.message, "B"), nullptr);
  const toolcomp_column no_number{"X", values, 3};
  EXPECT_EQ(toolcomp_batch_lines(made, &no_number, 1, 2, &error), TOOLCOMP_BAD_CALL);
  const toolcomp_column fine[] = {{"X", values, 10}};
  EXPECT_EQ(toolcomp_batch_lines(made, fine, 1, 1, &error), TOOLCOMP_BAD_CALL);
  const toolcomp_column twice[] = {{"X", values, 3}, {"X", values, 3}};
  EXPECT_EQ(toolcomp_batch_lines(made, twice, 2, 1, &error), TOOLCOMP_BAD_CALL);
  EXPECT_EQ(toolcomp_batch_lines(made, nullptr, 1, 1, &error), TOOLCOMP_BAD_CALL);
  EXPECT_EQ(toolcomp_batch_moves(made).count, 0U);
  toolcomp_setup_free(nullptr);
  toolcomp_engine_free(nullptr);
  toolcomp_batch_free(nullptr);
}

class MovesAndSamples final : public toolcomp::fast::EventSink {
 public:
  void on(const toolcomp::fast::Event& event) override {
    if (event.kind == toolcomp::spec::EventKind::move || event.kind == toolcomp::spec::EventKind::sample)
      events.push_back(event);
  }
  std::vector<toolcomp::fast::Event> events;
};

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

bool same(const double (&numbers)[TOOLCOMP_MOST_AXES], const toolcomp::spec::AxisValues<double>& expected) {
  for (std::size_t i = 0; i < TOOLCOMP_MOST_AXES; ++i)
    if (expected.has(i) ? !same_bits(numbers[i], expected.value[i]) : !std::isnan(numbers[i])) return false;
  return true;
}
template <class Vector>
bool same(const double (&numbers)[3], const Vector* expected) {
  for (std::size_t i = 0; i < 3; ++i)
    if (expected != nullptr ? !same_bits(numbers[i], (*expected)[i]) : !std::isnan(numbers[i])) return false;
  return true;
}

// Every number of a move or a sample.
bool same(const toolcomp_event& event, const toolcomp::fast::Event& expected) {
  const auto* const space = expected.space ? &*expected.space : nullptr;
  const auto* const contact = space != nullptr && space->contact ? &*space->contact : nullptr;
  return event.line == expected.line && event.cause == static_cast<toolcomp_cause>(expected.cause) &&
         event.type == static_cast<toolcomp_move_type>(expected.type) && same(event.programmed, expected.programmed) &&
         same(event.point, expected.point) && same(event.axes, expected.axes) &&
         same(event.machine, expected.machine) &&
         same(event.tool_axis, expected.tool_axis ? &*expected.tool_axis : nullptr) &&
         event.t_numerator == expected.t_numerator && event.t_denominator == expected.t_denominator &&
         same(event.center, expected.arc ? expected.arc->center : toolcomp::spec::AxisValues<double>{}) &&
         same(event.tool_center, space != nullptr ? &space->tool_center : nullptr) &&
         same(event.shift, space != nullptr ? &space->shift : nullptr) &&
         same(event.tool_shift, space != nullptr ? &space->tool_shift : nullptr) &&
         same(event.contact, contact != nullptr ? &contact->point : nullptr) &&
         same(event.normal, contact != nullptr ? &contact->normal : nullptr);
}

// The engine of C++ on the whole of a program.
std::vector<toolcomp::fast::Event> whole(const toolcomp::spec::Setup& by, const std::string& program,
                                         std::uint32_t samples) {
  MovesAndSamples sink;
  const auto feed = [](auto& to, auto& reader, auto&& block) {
    while (!to.stopped() && reader.next(block)) to.block(block);
    to.end();
  };
  if (by.control == toolcomp::spec::Control::heidenhain) {
    toolcomp::fast::klartext::Engine engine(by, sink);
    toolcomp::spec::klartext::Reader reader(toolcomp::spec::text_source(program), by);
    feed(engine, reader, toolcomp::spec::klartext::Block());
  } else {
    toolcomp::fast::Engine engine(by, sink, samples);
    toolcomp::spec::ProgramReader reader(toolcomp::spec::text_source(program), by.axes);
    feed(engine, reader, toolcomp::spec::Block());
  }
  return sink.events;
}

// Programs of the examples, a line at a time, give what the engine of C++ gives on the whole.
TEST(CInterface, ProgramsInParts) {
  namespace fs = std::filesystem;
  std::size_t fanuc = 0;
  std::size_t with_contact = 0;
  for (const auto& file : fs::recursive_directory_iterator(TOOLCOMP_SOURCE_DIR "/examples")) {
    const fs::path beside = file.path().parent_path() / "setup.toml";
    const bool klartext = file.path().extension() == ".h";
    if ((file.path().extension() != ".nc" && !klartext) || !fs::exists(beside)) continue;
    const std::string program = toolcomp::spec::read_file(file.path());
    const std::string text = toolcomp::spec::read_file(beside);
    for (const std::uint32_t samples : {0U, 4U}) {
      const auto expected = whole(toolcomp::spec::read_setup_toml(text, "setup"), program, samples);
      Events events;
      const auto owner = setup(text);
      const auto part = engine(owner.get(), events, samples);
      for (std::size_t from = 0; from < program.size();) {
        const std::size_t end = klartext ? program.size() : std::min(program.find('\n', from), program.size() - 1) + 1;
        ASSERT_EQ(toolcomp_engine_run(part.get(), program.data() + from, end - from, nullptr), TOOLCOMP_OK);
        from = end;
      }
      toolcomp_engine_end(part.get(), nullptr);
      std::erase_if(events, [](const Kept& k) { return k.event.kind > TOOLCOMP_SAMPLE; });
      ASSERT_EQ(events.size(), expected.size()) << file.path();
      for (std::size_t i = 0; i < events.size(); ++i)
        ASSERT_TRUE(same(events[i].event, expected[i])) << file.path() << ", line " << expected[i].line;
      fanuc += klartext ? 0 : events.size();
      with_contact += static_cast<std::size_t>(
          std::ranges::count_if(events, [](const Kept& k) { return !std::isnan(k.event.contact[0]); }));
    }
  }
  EXPECT_GT(fanuc, 1000U);
  EXPECT_GT(with_contact, 10U);
}

// A square by arrays and as text, the tool of radius 5 outside (right of a counterclockwise way).
TEST(CInterface, ArraysAreTheSameBlocks) {
  const auto owner = setup();
  const Events expected =
      run(owner.get(), "G90 G01 F100 X-20\nG42 D1 X0 Y0\nX40 Y0\nX40 Y40\nX0 Y40\nX0 Y0\nG40 X-20\n");
  Events others;
  toolcomp_batch* made = nullptr;
  ASSERT_EQ(toolcomp_batch_new(owner.get(), keep, &others, &made, nullptr), TOOLCOMP_OK);
  const Owned<toolcomp_batch> batch(made);
  const std::string_view before = "G90 G01 F100 X-20\nG42 D1 X0 Y0\n";
  const std::string_view behind = "G40 X-20\nG999\n";
  const double x[] = {40, 40, 0, 0};
  const double y[] = {0, 40, 40, 0};
  const toolcomp_column columns[] = {{"X", x, 3}, {"Y", y, 3}};
  EXPECT_EQ(toolcomp_batch_run(made, before.data(), before.size(), nullptr), TOOLCOMP_OK);
  EXPECT_EQ(toolcomp_batch_lines(made, columns, 2, 4, nullptr), TOOLCOMP_OK);
  EXPECT_EQ(toolcomp_batch_stopped(made), 0);
  EXPECT_EQ(toolcomp_batch_run(made, behind.data(), behind.size(), nullptr), TOOLCOMP_OK);
  EXPECT_EQ(toolcomp_batch_end(made, nullptr), TOOLCOMP_OK);
  EXPECT_EQ(toolcomp_batch_stopped(made), 1);
  const toolcomp_moves moves = toolcomp_batch_moves(made);
  ASSERT_EQ(moves.axes, 3U);
  ASSERT_EQ(moves.count, expected.size());
  for (std::size_t i = 0; i < moves.count; ++i) {
    EXPECT_EQ(moves.block[i], expected[i].event.line);
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_TRUE(same_bits(moves.axis[axis][i], expected[i].event.axes[axis])) << i;
  }
  // The corner at X40 Y0 by hand: both offset lines are 5 outside.
  EXPECT_EQ(moves.block[2], 3U);
  EXPECT_EQ(moves.axis[0][2], 45);
  EXPECT_EQ(moves.axis[1][2], -5);
  ASSERT_EQ(others.size(), 1U);
  EXPECT_EQ(others[0].number, "PS0010");
  toolcomp_batch_clear_moves(made);
  EXPECT_EQ(toolcomp_batch_moves(made).count, 0U);
}

TEST(CInterface, HandlesAreIndependent) {
  const auto owner = setup();
  const std::string_view program = "G90 G01 F100\nG41 D1 X0 Y10\nY100\nX100 Y200\nG40 X200\nM30\n";
  const Events alone = run(owner.get(), program);
  std::vector<std::thread> threads;
  std::vector<Events> each(8);
  for (Events& events : each) threads.emplace_back([&] { events = run(owner.get(), program); });
  for (std::thread& thread : threads) thread.join();
  for (const Events& events : each) {
    ASSERT_EQ(events.size(), alone.size());
    for (std::size_t i = 0; i < alone.size(); ++i)
      EXPECT_TRUE(same_bits(events[i].event.axes[1], alone[i].event.axes[1]));
  }
}

TEST(CInterface, VersionsAgree) {
  EXPECT_EQ(std::string(toolcomp_version()), std::to_string(TOOLCOMP_VERSION_MAJOR) + "." +
                                                 std::to_string(TOOLCOMP_VERSION_MINOR) + "." +
                                                 std::to_string(TOOLCOMP_VERSION_PATCH));
}

}  // namespace

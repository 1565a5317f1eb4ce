// SPDX-License-Identifier: Apache-2.0
// Rows of the benchmarks: one program under the fast engine and under the exact model, and from text to path.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "fast/arrays/line_moves.h"
#include "fast/arrays/line_road.h"
#include "fast/arrays/line_text.h"
#include "fast/basis/print.h"
#include "fast/fanuc/engine.h"
#include "model/fanuc/engine.h"
#include "spec/language/event_gcode.h"
#include "spec/language/event_json.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/setup_format.h"
#include "spec/language/text_buffer.h"
#include "tests/bench/latency.h"

namespace toolcomp::bench {

// Few enough to stay in the cache: a reader fills one block again and again.
constexpr int kBlocks = 100;
// Enough to hide the construction of an engine.
constexpr int kTextBlocks = 5000;

struct Program {
  std::string setup;          // TOML
  std::string head;           // run once
  std::string body;           // run again and again; with cutter compensation it ends where it starts
  std::uint32_t samples = 0;  // each counts as a block
};

// Touches what a controller would use.
template <class Number>
class Path final : public spec::EventSink<Number> {
 public:
  void on(const spec::Event<Number>& event) override {
    ++events_;
    benchmark::DoNotOptimize(event.axes[0]);
    if (event.kind == spec::EventKind::alarm) alarm_ = event.number.view();
  }
  [[nodiscard]] const std::string& alarm() const { return alarm_; }
  [[nodiscard]] std::int64_t events() const { return events_; }

 private:
  std::int64_t events_ = 0;
  std::string alarm_;
};

// Prints every event as `run` does.
class Printer final : public fast::EventSink {
 public:
  explicit Printer(const spec::Axes& axes) : axes_(axes) {}
  [[gnu::flatten]] void on(const fast::Event& event) override {
    text_.clear();
    spec::TextCursor out(text_);
    spec::append_event_json(out, event, axes_, [this](spec::TextCursor& text, double value) {
      text.write([&](char* to) { return numbers_.write(to, value); });
    });
  }
  [[nodiscard]] std::string_view text() const { return text_.view(); }

 private:
  const spec::Axes& axes_;
  fast::NumberWriter numbers_;
  spec::TextBuffer text_;
};

// `s/block` of the row; items per second are blocks per second.
inline void count_blocks(benchmark::State& state, std::size_t blocks) {
  state.counters["s/block"] = benchmark::Counter(
      static_cast<double>(blocks), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.SetItemsProcessed(static_cast<std::int64_t>(blocks) * state.iterations());
}

inline std::vector<spec::Block> read(std::string_view program, const spec::Axes& axes) {
  spec::ProgramReader reader(spec::text_source(program), axes);
  std::vector<spec::Block> blocks;
  for (spec::Block block; reader.next(block);) blocks.push_back(block);
  return blocks;
}

template <class Number, class Engine>
void go_round(benchmark::State& state, const Program& program, const spec::Setup& setup, Engine& engine,
              const Path<Number>& path) {
  for (const spec::Block& block : read(program.head, setup.axes)) engine.block(block);
  const auto blocks = read(program.body, setup.axes);
  for (auto _ : state)
    for (const spec::Block& block : blocks) engine.block(block);
  if (engine.stopped() || path.events() == 0) state.SkipWithError(("stopped: " + path.alarm()).c_str());
  count_blocks(state, blocks.size() * std::max(program.samples, 1U));
  if constexpr (std::is_same_v<Number, exact::Real>)
    show_latency(state, blocks.size(), program.samples, program.body, [&](std::size_t i) { engine.block(blocks[i]); });
}

inline void fast_engine(benchmark::State& state, const Program& program) {
  const spec::Setup setup = spec::read_setup_toml(program.setup, "setup");
  Path<double> path;
  fast::Engine engine(setup, path, program.samples);
  go_round(state, program, setup, engine, path);
}

inline void exact_model(benchmark::State& state, const Program& program) {
  const spec::Setup setup = spec::read_setup_toml(program.setup, "setup");
  Path<exact::Real> path;
  model::Recorder recorder;
  model::Engine engine(setup, recorder, path, program.samples);
  go_round(state, program, setup, engine, path);
}

// Prints a path as `run --format gcode` does.
class PathPrinter final : public fast::EventSink, public fast::LineSink {
 public:
  explicit PathPrinter(const spec::Axes& axes) : axes_(axes), lines_(axes) {}
  [[gnu::flatten]] void on(const fast::Event& event) override {
    if (text_.view().size() > kFlushAt) text_.clear();
    spec::TextCursor out(text_);
    const auto append = [this](spec::TextCursor& text, double value) {
      text.write([&](char* to) { return numbers_.write(to, value); });
    };
    spec::append_event_gcode(out, event, axes_, append, state_);
    if (event.kind == spec::EventKind::alarm) alarm_ = event.number.view();
  }
  void lines(fast::LineMoves& moves) override {
    if (text_.view().size() > kFlushAt) text_.clear();
    lines_.append(text_, moves, state_);
  }
  [[nodiscard]] std::string_view text() const { return text_.view(); }
  [[nodiscard]] const std::string& alarm() const { return alarm_; }

 private:
  static constexpr std::size_t kFlushAt = std::size_t{1} << 16U;
  const spec::Axes& axes_;
  fast::NumberWriter numbers_;
  fast::LineText lines_;
  spec::TextBuffer text_;
  spec::GcodeState<double> state_;
  std::string alarm_;
};

// The body of a program again and again, and how many blocks it then has.
struct LongText {
  LongText(const Program& program, std::size_t body_blocks) {
    const std::size_t rounds = std::max<std::size_t>(1, std::size_t{4} * kTextBlocks / body_blocks);
    text = program.head;
    for (std::size_t i = 0; i < rounds; ++i) text += program.body;
    blocks = rounds * body_blocks * std::max(program.samples, 1U);
  }
  std::string text;
  std::size_t blocks;
};

// The fast engine from the text of a program to that of its path.
inline void text_to_path(benchmark::State& state, const Program& program) {
  const spec::Setup setup = spec::read_setup_toml(program.setup, "setup");
  const LongText long_text(program, read(program.body, setup.axes).size());
  for (auto _ : state) {
    PathPrinter printer(setup.axes);
    fast::Engine engine(setup, printer, program.samples);
    spec::ProgramReader reader(spec::text_source(long_text.text), setup.axes);
    spec::Block block;
    fast::LineRoad(&printer).run(reader, engine, block);
    if (engine.stopped()) state.SkipWithError(("stopped: " + printer.alarm()).c_str());
    engine.end();
    benchmark::DoNotOptimize(printer.text());
  }
  count_blocks(state, long_text.blocks);
}

}  // namespace toolcomp::bench

// A row for each engine of the program that the function of this name makes, and one from its text to the text of the
// path.
// NOLINTBEGIN(cppcoreguidelines-macro-usage)
#define TOOLCOMP_ROW(program)                                                                       \
  void program##_fast(benchmark::State& state) { toolcomp::bench::fast_engine(state, program()); }  \
  BENCHMARK(program##_fast)->Name(#program);                                                        \
  void program##_text(benchmark::State& state) { toolcomp::bench::text_to_path(state, program()); } \
  BENCHMARK(program##_text)->Name("text/" #program);                                                \
  void program##_model(benchmark::State& state) { toolcomp::bench::exact_model(state, program()); } \
  BENCHMARK(program##_model)->Name("model/" #program)
// NOLINTEND(cppcoreguidelines-macro-usage)

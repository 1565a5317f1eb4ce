// SPDX-License-Identifier: Apache-2.0
// Rows of the benchmarks of Heidenhain programs.
#pragma once

#include "fast/heidenhain/engine.h"
#include "model/heidenhain/engine.h"
#include "spec/language/heidenhain/klartext_reader.h"
#include "tests/bench/rows.h"

namespace toolcomp::bench::klartext {

inline std::vector<spec::klartext::Block> read(std::string_view program, const spec::Setup& setup) {
  spec::klartext::Reader reader(spec::text_source(program), setup);
  std::vector<spec::klartext::Block> blocks;
  for (spec::klartext::Block block; reader.next(block);) blocks.push_back(block);
  return blocks;
}

template <class Number, class Engine>
void run_round(benchmark::State& state, const Program& program, const spec::Setup& setup, Engine& engine,
               const Path<Number>& path) {
  for (const spec::klartext::Block& block : read(program.head, setup)) engine.block(block);
  const auto blocks = read(program.body, setup);
  for (auto _ : state)
    for (const spec::klartext::Block& block : blocks) engine.block(block);
  if (engine.stopped() || path.events() == 0) state.SkipWithError(("stopped: " + path.alarm()).c_str());
  count_blocks(state, blocks.size());
  if constexpr (std::is_same_v<Number, exact::Real>)
    show_latency(state, blocks.size(), program.samples, program.body, [&](std::size_t i) { engine.block(blocks[i]); });
}

inline void fast_engine(benchmark::State& state, const Program& program) {
  const spec::Setup setup = spec::read_setup_toml(program.setup, "setup");
  Path<double> path;
  fast::klartext::Engine engine(setup, path);
  run_round(state, program, setup, engine, path);
}

inline void exact_model(benchmark::State& state, const Program& program) {
  const spec::Setup setup = spec::read_setup_toml(program.setup, "setup");
  Path<exact::Real> path;
  model::Recorder recorder;
  model::klartext::Engine engine(setup, recorder, path);
  run_round(state, program, setup, engine, path);
}

// The fast engine from the text of a program to a sink of its events, and to their text.
inline void from_text(benchmark::State& state, const Program& program, std::size_t blocks, fast::EventSink& sink) {
  const spec::Setup setup = spec::read_setup_toml(program.setup, "setup");
  const std::string text = program.head + program.body;
  for (auto _ : state) {
    fast::klartext::Engine engine(setup, sink);
    spec::klartext::Reader reader(spec::text_source(text), setup);
    for (spec::klartext::Block block; reader.next(block);) engine.block(block);
    if (engine.stopped()) state.SkipWithError("alarm");
    engine.end();
  }
  count_blocks(state, blocks);
  state.SetBytesProcessed(static_cast<std::int64_t>(text.size()) * state.iterations());
}

// The fast engine from the text of a program to that of its path.
inline void text_to_path(benchmark::State& state, const Program& program) {
  const spec::Setup setup = spec::read_setup_toml(program.setup, "setup");
  const LongText long_text(program, read(program.body, setup).size());
  for (auto _ : state) {
    PathPrinter printer(setup.axes);
    fast::klartext::Engine engine(setup, printer);
    spec::klartext::Reader reader(spec::text_source(long_text.text), setup);
    spec::klartext::Block block;
    fast::LineRoad(&printer).run(reader, engine, block);
    if (engine.stopped()) state.SkipWithError(("stopped: " + printer.alarm()).c_str());
    engine.end();
    benchmark::DoNotOptimize(printer.text());
  }
  count_blocks(state, long_text.blocks);
}

}  // namespace toolcomp::bench::klartext

// NOLINTBEGIN(cppcoreguidelines-macro-usage)
#define TOOLCOMP_KLARTEXT_ROW(program)                                                                        \
  void program##_fast(benchmark::State& state) { toolcomp::bench::klartext::fast_engine(state, program()); }  \
  BENCHMARK(program##_fast)->Name(#program);                                                                  \
  void program##_model(benchmark::State& state) { toolcomp::bench::klartext::exact_model(state, program()); } \
  BENCHMARK(program##_model)->Name("model/" #program);                                                        \
  void program##_text(benchmark::State& state) { toolcomp::bench::klartext::text_to_path(state, program()); } \
  BENCHMARK(program##_text)->Name("text/" #program)
// NOLINTEND(cppcoreguidelines-macro-usage)

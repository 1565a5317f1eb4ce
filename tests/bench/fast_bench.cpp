// The fast engine: nanoseconds a block, one thread, streaming. Blocks are read once beforehand, except in text_to_path.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fast/engine.h"
#include "fast/print.h"
#include "spec/language/event_json.h"
#include "spec/language/program_reader.h"
#include "spec/language/setup_format.h"

namespace {

using namespace toolcomp;

// Few enough to stay in the cache: a reader fills one block again and again.
constexpr int kBlocks = 100;
// Enough to hide the construction of an engine.
constexpr int kTextBlocks = 5000;

// C-B tool rotation head: C (about Z) carries B (about Y).
constexpr std::string_view kSetup = R"(
control = "fanuc"
units = "mm"
axes = ["X", "Y", "Z", "B", "C"]
[parameters]
"19680" = 2
"19681" = 5
"19682" = 3
"19686" = 4
"19687" = 2
[offsets.H]
1 = "100.25"
2 = "87.5"
[offsets.D]
1 = "4.95"
)";
constexpr std::string_view kThreeAxes = R"(
control = "fanuc"
units = "mm"
axes = ["X", "Y", "Z"]
[offsets.H]
1 = "100.25"
2 = "87.5"
[offsets.D]
1 = "4.95"
)";

// Counts events and touches what a controller would use.
class Path final : public fast::EventSink {
 public:
  void on(const fast::Event& event) override {
    ++events_;
    sum_ += event.axes[0] + event.axes[1] + event.axes[2];
  }
  [[nodiscard]] double sum() const { return sum_; }
  [[nodiscard]] std::int64_t events() const { return events_; }

 private:
  std::int64_t events_ = 0;
  double sum_ = 0;
};

class Printer final : public fast::EventSink {
 public:
  explicit Printer(const spec::Axes& axes) : axes_(axes) { text_.reserve(4096); }
  void on(const fast::Event& event) override {
    text_.clear();
    spec::append_event_json(text_, event, axes_, fast::append_number);
    bytes_ += text_.size();
  }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  const spec::Axes& axes_;
  std::string text_;
  std::size_t bytes_ = 0;
};

// A small generator, so that the numbers are the same everywhere.
class Numbers {
 public:
  // A number with three decimals in [-limit, limit).
  std::string next(int limit) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    const auto thousandths =
        static_cast<std::int64_t>((state_ >> 33U) % static_cast<std::uint64_t>(2000 * limit)) - 1000 * limit;
    std::string text = thousandths < 0 ? "-" : "";
    const std::int64_t magnitude = thousandths < 0 ? -thousandths : thousandths;
    text += std::to_string(magnitude / 1000) + ".";
    const std::string decimals = std::to_string(magnitude % 1000);
    return text + std::string(3 - decimals.size(), '0') + decimals;
  }

 private:
  std::uint64_t state_ = 1;
};

std::vector<spec::Block> read(std::string_view program, const spec::Axes& axes) {
  spec::ProgramReader reader(spec::text_source(program), axes);
  std::vector<spec::Block> blocks;
  for (spec::Block block; reader.next(block);) blocks.push_back(block);
  return blocks;
}

std::string xyz(Numbers& numbers) {
  return "X" + numbers.next(100) + " Y" + numbers.next(100) + " Z" + numbers.next(100);
}

void run(benchmark::State& state, std::string_view setup_text, const std::string& head, const std::string& body) {
  const spec::Setup setup = spec::read_setup_toml(setup_text, "setup");
  const auto start = read(head, setup.axes);
  const auto blocks = read(body, setup.axes);
  Path path;
  fast::Engine engine(setup, path);
  for (const spec::Block& block : start) engine.block(block);
  for (auto _ : state) {
    for (const spec::Block& block : blocks) engine.block(block);
    benchmark::DoNotOptimize(path.sum());
  }
  if (engine.stopped()) state.SkipWithError("alarm");
  const auto n = static_cast<double>(blocks.size());
  state.counters["s/block"] =
      benchmark::Counter(n, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void tool_length_offset(benchmark::State& state) {
  Numbers numbers;
  std::string body;
  for (int i = 0; i < kBlocks; ++i) body += xyz(numbers) + "\n";
  run(state, kThreeAxes, "G90 G01 F1000. G43 Z0 H1\n", body);
}
BENCHMARK(tool_length_offset);

void tool_length_offset_new_h(benchmark::State& state) {
  Numbers numbers;
  std::string body;
  for (int i = 0; i < kBlocks; ++i) body += xyz(numbers) + (i % 2 == 0 ? " H2\n" : " H1\n");
  run(state, kThreeAxes, "G90 G01 F1000. G43 Z0 H1\n", body);
}
BENCHMARK(tool_length_offset_new_h);

void leading_edge_fixed_tool(benchmark::State& state) {
  Numbers numbers;
  std::string body;
  for (int i = 0; i < kBlocks; ++i) body += xyz(numbers) + "\n";
  run(state, kSetup, "G90 G01 F1000. B30. C20.\nG41.3 D1\n", body);
}
BENCHMARK(leading_edge_fixed_tool);

void leading_edge_rotary_words(benchmark::State& state) {
  Numbers numbers;
  std::string body;
  for (int i = 0; i < kBlocks; ++i) body += xyz(numbers) + " B" + numbers.next(80) + " C" + numbers.next(180) + "\n";
  run(state, kSetup, "G90 G01 F1000.\nG41.3 D1\n", body);
}
BENCHMARK(leading_edge_rotary_words);

void leading_edge_ijk(benchmark::State& state) {
  Numbers numbers;
  std::string body;
  for (int i = 0; i < kBlocks; ++i) body += xyz(numbers) + " I" + numbers.next(1) + " J" + numbers.next(1) + " K1.\n";
  run(state, kThreeAxes, "G90 G01 F1000. G43.5 H1 I0 J0 K1.\nG41.3 D1\n", body);
}
BENCHMARK(leading_edge_ijk);

// Exact ties every block: the tool stands on Z, the movement in X Y.
void leading_edge_ties(benchmark::State& state) {
  Numbers numbers;
  std::string body;
  for (int i = 0; i < kBlocks; ++i) body += "X" + numbers.next(100) + " Y" + numbers.next(100) + "\n";
  run(state, kSetup, "G90 G01 F1000.\nG41.3 D1\n", body);
}
BENCHMARK(leading_edge_ties);

// Ties that double-double decides: B45 and movements along (1, 0, -1).
void leading_edge_fine_ties(benchmark::State& state) {
  std::string body;
  for (int i = 0; i < kBlocks; ++i) body += i % 2 == 0 ? "X10.5 Z-10.5\n" : "X0 Z0\n";
  run(state, kSetup, "G90 G01 F1000. B45.\nG41.3 D1\n", body);
}
BENCHMARK(leading_edge_fine_ties);

void text_to_path(benchmark::State& state) {
  const spec::Setup setup = spec::read_setup_toml(kSetup, "setup");
  Numbers numbers;
  std::string program = "G90 G01 F1000. B30.\nG41.3 D1\n";
  for (int i = 0; i < kTextBlocks; ++i)
    program += xyz(numbers) + " B" + numbers.next(80) + " C" + numbers.next(180) + "\n";
  Printer printer(setup.axes);
  for (auto _ : state) {
    fast::Engine engine(setup, printer);
    spec::ProgramReader reader(spec::text_source(program), setup.axes);
    for (spec::Block block; reader.next(block);) engine.block(block);
    engine.end();
    benchmark::DoNotOptimize(printer.bytes());
  }
  state.counters["s/block"] =
      benchmark::Counter(kTextBlocks, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(text_to_path);

void text_to_path_three_axes(benchmark::State& state) {
  const spec::Setup setup = spec::read_setup_toml(kThreeAxes, "setup");
  Numbers numbers;
  std::string program = "G90 G01 F1000. G43 Z0 H1\n";
  for (int i = 0; i < kTextBlocks; ++i) program += xyz(numbers) + "\n";
  Printer printer(setup.axes);
  for (auto _ : state) {
    fast::Engine engine(setup, printer);
    spec::ProgramReader reader(spec::text_source(program), setup.axes);
    for (spec::Block block; reader.next(block);) engine.block(block);
    engine.end();
    benchmark::DoNotOptimize(printer.bytes());
  }
  state.counters["s/block"] =
      benchmark::Counter(kTextBlocks, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(text_to_path_three_axes);

}  // namespace

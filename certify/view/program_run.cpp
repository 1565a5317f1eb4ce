// SPDX-License-Identifier: Apache-2.0
#include "certify/view/program_run.h"

#include <map>
#include <memory>

#include "judge/oracle/control.h"

namespace toolcomp::certify {
namespace {

// The latest block that begins in a line. Events of a line with none (the end of the program) belong to the last block.
class LatestBlock {
 public:
  void add(std::uint64_t line, std::size_t block) {
    by_line_[line] = block;
    last_ = block;
  }
  [[nodiscard]] std::size_t of(std::uint64_t line) const {
    const auto found = by_line_.find(line);
    return found == by_line_.end() ? last_ : found->second;
  }

 private:
  std::map<std::uint64_t, std::size_t> by_line_;
  std::size_t last_ = 0;
};

template <class Number>
class Placed final : public spec::EventSink<Number> {
 public:
  Placed(const LatestBlock& latest, std::vector<spec::Event<Number>>& events, std::vector<std::size_t>& block_of)
      : latest_(latest), events_(events), block_of_(block_of) {}
  void on(const spec::Event<Number>& event) override {
    events_.push_back(event);
    block_of_.push_back(latest_.of(event.line));
  }

 private:
  const LatestBlock& latest_;
  std::vector<spec::Event<Number>>& events_;
  std::vector<std::size_t>& block_of_;
};

// Where an alarm of a block points to: a fault of reading, or the block.
ProgramRun::Block read_block(const spec::Block& block) {
  const std::uint64_t column = block.alarm ? block.alarm->column : block.size > 0 ? block.word[0].column : 1;
  return {block.line, block.n, block.line, column};
}
ProgramRun::Block read_block(const spec::klartext::Block& block) {
  if (block.alarm) return {block.line, block.n, block.alarm->line, block.alarm->column};
  return {block.line, block.n, block.line, block.column};
}

template <class Control>
void run(const spec::Case& c, const std::string& file, const std::function<void()>& on_block, ProgramRun& result) {
  LatestBlock latest;
  Placed<exact::Real> exact_sink(latest, result.events, result.block_of);
  Placed<double> fast_sink(latest, result.fast, result.block_of_fast);
  model::Recorder recorder(true);
  auto model = Control::model(c.setup, recorder, exact_sink, c.samples);
  auto fast = Control::fast(c.setup, fast_sink, c.samples);
  auto reader = Control::reader(spec::text_source(c.program), c.setup, file);
  const auto place_decisions = [&] {
    const std::vector<model::Decision>& decisions = recorder.decisions();
    for (std::size_t i = result.block_of_decision.size(); i < decisions.size(); ++i)
      result.block_of_decision.push_back(latest.of(decisions[i].line));
  };
  const auto block = std::make_unique<typename Control::Block>();
  while (!model.stopped() && reader.next(*block)) {
    on_block();
    latest.add(block->line, result.blocks.size());
    result.blocks.push_back(read_block(*block));
    model.block(*block);
    fast.block(*block);
    place_decisions();
  }
  model.end();
  fast.end();
  place_decisions();
  result.decisions = recorder.decisions();
}

}  // namespace

ProgramRun run_program(const spec::Case& c, const std::string& file, const std::function<void()>& on_block) {
  ProgramRun result;
  judge::with_control(c.setup, [&]<class Control>(Control) { run<Control>(c, file, on_block, result); });
  for (const model::Event& event : result.events)
    result.undecided = result.undecided || event.kind == spec::EventKind::undecided ||
                       (event.kind != spec::EventKind::alarm && spec::ends_run(event.kind));
  return result;
}

}  // namespace toolcomp::certify

#include <memory>

#include "fuzz/oracle/verdict.h"

namespace toolcomp::fuzz {
namespace {

template <class Number>
class Collector final : public spec::EventSink<Number> {
 public:
  explicit Collector(std::vector<spec::Event<Number>>& events) : events_(events) {}
  void on(const spec::Event<Number>& event) override { events_.push_back(event); }

 private:
  std::vector<spec::Event<Number>>& events_;
};

// The whole program of a case through an engine.
template <class Engine>
void run(const spec::Case& c, Engine& engine) {
  spec::ProgramReader reader(spec::text_source(c.program), c.setup.axes, {"program", c.setup.block_skip});
  const auto block = std::make_unique<spec::Block>();
  while (!engine.stopped() && reader.next(*block)) engine.block(*block);
  engine.end();
}

}  // namespace

ModelRun run_model(const spec::Case& c, const Forced& forced) {
  ModelRun result;
  for (const auto& [index, sign] : forced) result.recorder.force(index, sign);
  Collector<model::Real> sink(result.events);
  model::Engine engine(c.setup, result.recorder, sink, c.samples);
  run(c, engine);
  return result;
}

std::vector<fast::Event> run_fast(const spec::Case& c) {
  std::vector<fast::Event> events;
  Collector<double> sink(events);
  fast::Engine engine(c.setup, sink, c.samples);
  run(c, engine);
  return events;
}

}  // namespace toolcomp::fuzz

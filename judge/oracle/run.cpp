// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "fast/arrays/line_road.h"
#include "judge/oracle/control.h"
#include "judge/oracle/verdict.h"

namespace toolcomp::judge {
namespace {

class ModelEvents final : public model::EventSink {
 public:
  explicit ModelEvents(ModelRun& run) : run_(run) {}
  void on(const model::Event& event) override {
    run_.events.push_back(event);
    run_.asked.push_back(run_.recorder.decision_count());
  }

 private:
  ModelRun& run_;
};

class FastEvents final : public fast::EventSink {
 public:
  explicit FastEvents(std::vector<fast::Event>& events) : events_(events) {}
  void on(const fast::Event& event) override { events_.push_back(event); }

 private:
  std::vector<fast::Event>& events_;
};

// The whole program of a case through an engine of its control.
template <class Control, class Engine, class OnBlock>
void run(const spec::Case& c, Engine& engine, const OnBlock& on_block) {
  auto reader = Control::reader(spec::text_source(c.program), c.setup, "program");
  const auto block = std::make_unique<typename Control::Block>();
  while (!engine.stopped() && reader.next(*block)) {
    on_block(*block);
    engine.block(*block);
  }
  engine.end();
}

}  // namespace

ModelRun run_model(const spec::Case& c, const Forced& forced) {
  ModelRun result;
  for (const auto& [index, sign] : forced) result.recorder.force(index, sign);
  ModelEvents sink(result);
  with_control(c.setup, [&]<class Control>(Control) {
    auto engine = Control::model(c.setup, result.recorder, sink, c.samples);
    run<Control>(c, engine, [&result](const typename Control::Block& block) {
      result.beyond = beyond_of(block, result.events.size());
    });
  });
  return result;
}

std::vector<fast::Event> run_fast(const spec::Case& c) {
  std::vector<fast::Event> events;
  FastEvents sink(events);
  with_control(c.setup, [&]<class Control>(Control) {
    auto engine = Control::fast(c.setup, sink, c.samples);
    auto reader = Control::reader(spec::text_source(c.program), c.setup, "program");
    const auto block = std::make_unique<typename Control::Block>();
    // Every usual line goes by the arrays: generated programs seldom have many in a row.
    fast::LineRoad(nullptr, 1).run(reader, engine, *block);
    engine.end();
  });
  return events;
}

}  // namespace toolcomp::judge

// The manual's replacement example through both installed engines: H1 = 20, H2 = 30 give Z120 and Z130.
#include <iostream>
#include <string>
#include <vector>

#include "fast/fanuc/engine.h"
#include "model/fanuc/engine.h"
#include "spec/language/fanuc/program_reader.h"

namespace {

constexpr const char* kProgram = "G90 G43 Z100. H1\nG90 G43 Z100. H2\nM30\n";

toolcomp::spec::Setup setup() {
  toolcomp::spec::Setup s;
  s.h[1].geometry = toolcomp::spec::decimal(20);
  s.h[2].geometry = toolcomp::spec::decimal(30);
  return s;
}

template <class Number>
struct Moves final : toolcomp::spec::EventSink<Number> {
  std::vector<Number> z;
  void on(const toolcomp::spec::Event<Number>& event) override { z.push_back(event.axes[2]); }
};

template <class Engine>
void run(Engine& engine, const toolcomp::spec::Setup& s) {
  toolcomp::spec::ProgramReader reader(toolcomp::spec::text_source(kProgram), s.axes);
  toolcomp::spec::Block block;
  while (reader.next(block)) engine.block(block);
  engine.end();
}

}  // namespace

int main() {
  const toolcomp::spec::Setup s = setup();
  Moves<toolcomp::exact::Real> exact;
  toolcomp::model::Recorder recorder;
  toolcomp::model::Engine model(s, recorder, exact);
  run(model, s);
  Moves<double> fast;
  toolcomp::fast::Engine engine(s, fast);
  run(engine, s);
  const bool right =
      exact.z.size() == 2 && exact.z[0] == 120 && exact.z[1] == 130 && fast.z == std::vector<double>{120, 130};
  std::cout << (right ? "the installed engines agree with the manual\n" : "the installed engines are wrong\n");
  return right ? 0 : 1;
}

// SPDX-License-Identifier: Apache-2.0
// The manual's replacement example through both installed engines: H1 = 20, H2 = 30 give Z120 and Z130.
#include <iostream>
#include <string>
#include <vector>

#include "fast/batch/batch.h"
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

// A thousand lines as arrays under the same offset: Z 30 above the words.
bool arrays_agree(const toolcomp::spec::Setup& s) {
  std::vector<double> words;
  for (int i = 0; i < 1000; ++i) words.push_back(i);
  toolcomp::fast::Batch batch(s);
  batch.run("G90 G43 H2 Z0\n");
  batch.moves().clear();
  const std::vector<toolcomp::fast::WordColumn> columns{{"Z", words}};
  batch.lines(columns);
  batch.end();
  const auto z = batch.moves().axis(2);
  bool right = z.size() == words.size();
  for (std::size_t i = 0; right && i < z.size(); ++i) right = z[i] == words[i] + 30;
  return right;
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
  const bool right = exact.z.size() == 2 && exact.z[0] == 120 && exact.z[1] == 130 &&
                     fast.z == std::vector<double>{120, 130} && arrays_agree(s);
  std::cout << (right ? "the installed engines agree with the manual\n" : "the installed engines are wrong\n");
  return right ? 0 : 1;
}

// SPDX-License-Identifier: Apache-2.0
#include "fast/heidenhain/engine.h"

#include "fast/heidenhain/interpreter/interpreter.h"

namespace toolcomp::fast::klartext {

struct Engine::State {
  State(const spec::Setup& setup, EventSink& sink) : interpreter(setup, sink), maker(setup.axes) {}
  Interpreter interpreter;
  LineMaker maker;
};

Engine::Engine(const spec::Setup& setup, EventSink& sink) : state_(std::make_unique<State>(setup, sink)) {}
Engine::~Engine() = default;

void Engine::block(const spec::klartext::Block& block) { state_->interpreter.block(block); }
std::size_t Engine::lines(const LineChunk& chunk) { return state_->interpreter.lines(chunk); }
std::size_t Engine::lines(const spec::LineColumns& lines, LineSink* to) {
  State& state = *state_;
  const LineChunk chunk = state.maker.begin(lines);
  const std::size_t taken = to == nullptr ? 0 : state.interpreter.lines(chunk);
  if (taken > 0) to->lines(state.maker.end(chunk, taken));
  return taken;
}
void Engine::end() { state_->interpreter.end(); }
bool Engine::stopped() const { return state_->interpreter.stopped(); }

}  // namespace toolcomp::fast::klartext

// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/engine.h"

#include "fast/fanuc/control/control.h"
#include "fast/fanuc/interpreter/interpreter.h"
#include "fast/fanuc/stages.h"

namespace toolcomp::fast {

// What the control knows, the stages of compensation that work on it, and the way of a block through both.
struct Engine::State {
  State(const spec::Setup& setup, EventSink& to, std::uint32_t samples)
      : control(setup, to, samples),
        stages(make_stages(setup, control, to)),
        interpreter(setup, control, stages, to),
        sink(to),
        maker(setup.axes) {}
  Control control;
  Stages stages;
  Interpreter interpreter;
  EventSink& sink;
  LineMaker maker;
};

Engine::Engine(const spec::Setup& setup, EventSink& sink, std::uint32_t samples)
    : state_(std::make_unique<State>(setup, sink, samples)) {}
Engine::~Engine() = default;

void Engine::block(const spec::Block& block) { state_->interpreter.block(block); }
std::size_t Engine::lines(const LineChunk& chunk) { return state_->interpreter.lines(chunk); }
std::size_t Engine::lines(const spec::LineColumns& lines, LineSink* to) {
  State& state = *state_;
  if (lines.code != spec::LineColumns::kNoCode && 10 * lines.code != state.control.modal.motion()) return 0;
  const LineChunk chunk = state.maker.begin(lines);
  const std::size_t taken = state.interpreter.lines(chunk);
  if (taken == 0) return 0;
  LineMoves& made = state.maker.end(chunk, taken);
  if (to != nullptr)
    to->lines(made);
  else
    for (std::size_t i = 0; i < taken; ++i) state.sink.on(made.at(i));
  return taken;
}

void Engine::end() { state_->interpreter.end(); }
bool Engine::stopped() const { return state_->control.stopped; }

}  // namespace toolcomp::fast

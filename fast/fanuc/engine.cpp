// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/engine.h"

#include "fast/fanuc/control/control.h"
#include "fast/fanuc/interpreter/interpreter.h"
#include "fast/fanuc/stages.h"

namespace toolcomp::fast {

// What the control knows, the stages of compensation that work on it, and the way of a block through both.
struct Engine::State {
  State(const spec::Setup& setup, EventSink& sink, std::uint32_t samples)
      : control(setup, sink, samples),
        stages(make_stages(setup, control, sink)),
        interpreter(setup, control, stages, sink) {}
  Control control;
  Stages stages;
  Interpreter interpreter;
};

Engine::Engine(const spec::Setup& setup, EventSink& sink, std::uint32_t samples)
    : state_(std::make_unique<State>(setup, sink, samples)) {}
Engine::~Engine() = default;

void Engine::block(const spec::Block& block) { state_->control.taker->block(block); }
std::size_t Engine::lines(const LineChunk& chunk) { return state_->control.taker->lines(chunk); }
void Engine::end() { state_->control.taker->end(); }
bool Engine::stopped() const { return state_->control.stopped; }

}  // namespace toolcomp::fast

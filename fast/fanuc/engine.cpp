#include "fast/fanuc/engine.h"

#include "fast/fanuc/interpreter/interpreter.h"

namespace toolcomp::fast {

// The stages own each other in the order a block passes them: interpretation with the length offset, then leading edge
// offset, which sends the events.
struct Engine::State {
  State(const spec::Setup& setup, EventSink& sink, std::uint32_t samples) : interpreter(setup, sink, samples) {}
  Interpreter interpreter;
};

Engine::Engine(const spec::Setup& setup, EventSink& sink, std::uint32_t samples)
    : state_(std::make_unique<State>(setup, sink, samples)) {}
Engine::~Engine() = default;

void Engine::block(const spec::Block& block) { state_->interpreter.block(block); }
void Engine::end() { state_->interpreter.end(); }
bool Engine::stopped() const { return state_->interpreter.stopped(); }

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/engine.h"

#include <array>
#include <cmath>

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
        moves(control.axes.count) {
    moves.reserve(LineChunk::kMost + 1);
  }
  // The events of the first `count` lines of a chunk, whose moves have been made.
  void send(const LineChunk& chunk, std::size_t count);

  Control control;
  Stages stages;
  Interpreter interpreter;
  EventSink& sink;
  Moves moves;
  LineEvents events;
  const Instructions instructions = best_instructions();
};

Engine::Engine(const spec::Setup& setup, EventSink& sink, std::uint32_t samples)
    : state_(std::make_unique<State>(setup, sink, samples)) {}
Engine::~Engine() = default;

void Engine::block(const spec::Block& block) { state_->interpreter.block(block); }
std::size_t Engine::lines(const LineChunk& chunk) { return state_->interpreter.lines(chunk); }
std::size_t Engine::lines(const spec::LineColumns& lines) {
  State& state = *state_;
  if (lines.code != spec::LineColumns::kNoCode && 10 * lines.code != state.control.modal.motion()) return 0;
  LineChunk chunk;
  chunk.size = lines.size;
  chunk.words = lines.words;
  chunk.columns = &lines.columns;
  chunk.line = lines.line;
  chunk.instructions = state.instructions;
  chunk.moves = &state.moves;
  if (lines.numbered) chunk.n = lines.n.data();
  chunk.events = &state.events;
  state.moves.clear();
  const std::size_t taken = state.interpreter.lines(chunk);
  if (taken != 0) state.send(chunk, taken);
  return taken;
}

void Engine::State::send(const LineChunk& chunk, std::size_t count) {
  struct Axis {
    std::size_t index;
    const double* word;  // nullptr: it stays
    const double* sent;
  };
  std::array<Axis, spec::kMaxAxes> moving;
  std::size_t size = 0;
  for (unsigned rest = events.moving; rest != 0; rest &= rest - 1) {
    const auto axis = static_cast<std::size_t>(__builtin_ctz(rest));
    moving[size++] = {axis, chunk.word(word_place(control.axes.names.letter(axis))), moves.axis(axis).data()};
  }
  Event& event = events.event;
  const std::array<const double*, 3> tool{chunk.word(word_place('I')), chunk.word(word_place('J')),
                                          chunk.word(word_place('K'))};
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0 || !events.of_held) {
      const std::size_t line = i - (events.of_held ? 1 : 0);
      event.line = chunk.line + line;
      event.n = chunk.number(line);
      for (std::size_t k = 0; k < size; ++k)
        if (const Axis& axis = moving[k]; axis.word != nullptr)
          event.programmed.value[axis.index] = axis.word[line] / static_cast<double>(Count::kSmallPerOne);
      if (tool[0] != nullptr && event.tool_axis) {
        const double x = tool[0][line];
        const double y = tool[1][line];
        const double z = tool[2][line];
        const double norm = std::sqrt(x * x + y * y + z * z);
        *event.tool_axis = {x / norm + 0.0, y / norm + 0.0, z / norm + 0.0};
      }
    }
    for (std::size_t k = 0; k < size; ++k) {
      const Axis& axis = moving[k];
      event.axes.value[axis.index] = axis.sent[i];
      event.point.value[axis.index] = events.by_vector ? axis.sent[i] : event.programmed.value[axis.index];
      event.machine.value[axis.index] = axis.sent[i];  // where it is present, nothing lies between
    }
    sink.on(event);
  }
}

void Engine::end() { state_->interpreter.end(); }
bool Engine::stopped() const { return state_->control.stopped; }

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
// The fast engine of Heidenhain controls: double precision, streaming, no allocation per block.
#pragma once

#include <cstddef>
#include <memory>

#include "fast/arrays/line_chunk.h"
#include "fast/arrays/line_moves.h"
#include "fast/basis/event.h"
#include "spec/language/heidenhain/klartext_block.h"
#include "spec/language/setup.h"

namespace toolcomp::fast::klartext {

// Runs one program, block by block, in memory of fixed size. After an alarm or the end of the program further blocks
// are ignored. Only the constructor allocates.
class Engine {
 public:
  // Throws spec::InputError for a setup the control could not have (message names the key).
  Engine(const spec::Setup& setup, EventSink& sink);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  void block(const spec::klartext::Block& block);
  // Blocks of lines as arrays (fast/batch): how many of them have been taken, their moves written to the chunk's. 0:
  // the first one is for block().
  [[nodiscard]] std::size_t lines(const LineChunk& chunk);
  // The same of blocks as they are read: only their axes and feed are known (LineMoves), no events.
  static constexpr bool kEventsOfLines = false;
  [[nodiscard]] std::size_t lines(const spec::LineColumns& lines, LineSink* to);
  // The end of the text: flushes the look-ahead.
  void end();
  [[nodiscard]] bool stopped() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace toolcomp::fast::klartext

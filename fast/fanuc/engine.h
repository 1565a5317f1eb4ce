// SPDX-License-Identifier: Apache-2.0
// The fast engine: what a controller would ship. Double precision, streaming, no allocation per block.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "fast/arrays/line_chunk.h"
#include "fast/arrays/line_moves.h"
#include "fast/basis/event.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// Runs one program, block by block, in memory of fixed size. After an alarm or the end of the program further blocks
// are ignored. Only the constructor allocates.
class Engine {
 public:
  // `samples`: into how many equal parts a block under tool center point control is divided; 0 or 1: no samples.
  // Throws spec::InputError for a setup the control could not have (message names the key).
  Engine(const spec::Setup& setup, EventSink& sink, std::uint32_t samples = 0);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  void block(const spec::Block& block);
  // Blocks of lines as arrays (fast/batch): how many of them have been taken, their moves and that of a block held
  // before them written to the chunk's. 0: the first one is for block().
  [[nodiscard]] std::size_t lines(const LineChunk& chunk);
  // lines() makes whole events of them.
  static constexpr bool kEventsOfLines = true;
  // The same of lines as they are read. Their moves go to `to`; where it is nullptr, as events to the sink.
  [[nodiscard]] std::size_t lines(const spec::LineColumns& lines, LineSink* to = nullptr);
  // The end of the text: flushes the look-ahead.
  void end();
  [[nodiscard]] bool stopped() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace toolcomp::fast

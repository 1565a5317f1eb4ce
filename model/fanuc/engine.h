// SPDX-License-Identifier: Apache-2.0
// The exact reference engine: blocks in, events out.
#pragma once

#include <cstdint>
#include <memory>

#include "model/basis/event.h"
#include "model/basis/recorder.h"
#include "model/fanuc/program/motion.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Runs one program, block by block, in memory bounded by the look-ahead. After an alarm or the end of the program
// (M02, M30) further blocks are ignored. A decision that cannot be certified ends the run with an `undecided` event.
class Engine {
 public:
  // `samples`: N for events at the fractions 1/N … (N-1)/N of blocks run under tool center point control; 0 for none.
  // `motions`: gets what lies inside the moves, if it is there.
  // Throws spec::InputError for a setup the control could not have (message names the key).
  Engine(const spec::Setup& setup, Recorder& recorder, EventSink& sink, std::uint32_t samples = 0,
         MotionSink* motions = nullptr);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  void block(const spec::Block& block);
  // The end of the text: flushes the look-ahead.
  void end();
  [[nodiscard]] bool stopped() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace toolcomp::model

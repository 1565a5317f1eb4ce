// SPDX-License-Identifier: Apache-2.0
// The exact reference engine of Heidenhain controls: Klartext blocks in, events out.
#pragma once

#include <memory>

#include "model/basis/event.h"
#include "model/basis/recorder.h"
#include "spec/language/heidenhain/klartext_block.h"
#include "spec/language/setup.h"

namespace toolcomp::model::klartext {

// Runs one program, block by block, in constant memory: one motion is held at most. After an alarm or the end of the
// program further blocks are ignored. A decision that cannot be certified ends the run with an `undecided` event.
class Engine {
 public:
  // Throws spec::InputError for a setup of another control.
  Engine(const spec::Setup& setup, Recorder& recorder, EventSink& sink);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  void block(const spec::klartext::Block& block);
  // The end of the text: what is held goes out.
  void end();
  [[nodiscard]] bool stopped() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace toolcomp::model::klartext

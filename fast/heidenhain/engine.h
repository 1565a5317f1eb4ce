// The fast engine of Heidenhain controls: double precision, streaming, no allocation per block.
#pragma once

#include <memory>

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
  // The end of the text: flushes the look-ahead.
  void end();
  [[nodiscard]] bool stopped() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace toolcomp::fast::klartext

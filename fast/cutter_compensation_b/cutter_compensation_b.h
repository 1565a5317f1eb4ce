// Cutter compensation B, G39 to G42 (chapter 14.4): every block ends with a vector of its own, at once.
#pragma once

#include "fast/engine.h"
#include "fast/program/cutter_block.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

class CutterCompensationB {
 public:
  CutterCompensationB(const spec::Setup& setup, EventSink& sink);

  // G41 or G42 is in force.
  [[nodiscard]] bool active() const { return active_; }
  // PS0035, then PS0034: the alarms that follow from the words and the state alone.
  [[nodiscard]] Alarm check(const CutterCommand& command) const;
  // The block to fill in next: every field.
  [[nodiscard]] CutterBlock& next() { return block_; }
  // Takes next() and sends its move.
  StageEnd block();
  // Nothing is ever held.
  [[nodiscard]] StageEnd release() const { return {}; }

 private:
  EventSink& sink_;
  CutterBlock block_;
  bool active_ = false;
};

}  // namespace toolcomp::fast

// Cutter compensation C, G40 G41 G42 G39 (chapter 14.5, 14.6): a stage that holds blocks until the vectors at both
// their ends are known.
#pragma once

#include <array>
#include <cstdint>

#include "fast/engine.h"
#include "fast/program/cutter_block.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// Look-ahead: a block that moves in the plane, one block after it that does not, and the next one. The slots are fixed:
// nothing is allocated per block, no event is copied.
class CutterCompensationC {
 public:
  // Throws spec::InputError for parameters no control could have.
  CutterCompensationC(const spec::Setup& setup, EventSink& sink);

  // From the block with G41 or G42 on, until the vector of a block with G40 is removed and nothing is held. While it is
  // not active and a block has no G41 or G42, blocks pass without this stage.
  [[nodiscard]] bool active() const { return active_; }
  // Compensation is wanted (G41 or G42 and a number other than 0), or its vector is not removed yet: PS0037, PS0042 and
  // the exclusion of other modes rest on it.
  [[nodiscard]] bool on() const { return active_; }
  // PS0035, then PS0034: the alarms that follow from the words and the state alone, before anything is changed (plane
  // change, G45 to G48, other modes and the range of the value are tested by the caller). Asked while active, and at a
  // block with G39, G41 or G42.
  [[nodiscard]] Alarm check(const CutterCommand& command) const;

  // The block to fill in next. It keeps what it held before: the caller writes every field.
  [[nodiscard]] CutterBlock& next() { return ring_[next_]; }
  // Takes next(). An answer with an alarm or a typed undecided ends the run; what goes before it has been sent.
  StageEnd block();
  // No further block is known: a block that raises an alarm of its own (absent from the path), or the end of the
  // program. Everything held goes out.
  StageEnd release();

 private:
  static constexpr std::size_t kSlots = 4;

  EventSink& sink_;
  std::array<CutterBlock, kSlots> ring_;
  std::uint8_t next_ = 0;
  bool active_ = false;
};

}  // namespace toolcomp::fast

// What cutter compensation B and C have in common as stages.
#pragma once

#include <functional>
#include <utility>

#include "model/basis/recorder.h"
#include "model/fanuc/program/step.h"

namespace toolcomp::model {

// Takes steps in order and emits them in order: every move with its compensation vector (Move::offset), the moves that
// belong to a block but are inserted before its own move (cause start-up, corner or cancel), arcs as the tool runs
// them.
class CutterCompensation {
 public:
  using Output = std::function<void(const Step& step)>;

  CutterCompensation(Recorder& recorder, Output output) : recorder_(recorder), output_(std::move(output)) {}
  virtual ~CutterCompensation() = default;
  CutterCompensation(const CutterCompensation&) = delete;
  CutterCompensation& operator=(const CutterCompensation&) = delete;

  // Cutter compensation is on before the next block that is read (fanuc.cutter.on).
  [[nodiscard]] virtual bool on() const = 0;
  // It is on after a block with these words, unless a vector holds it on anyway.
  [[nodiscard]] virtual bool wanted(const CutterBlock& words) const { return words.side != CutterSide::none; }
  // The alarms that the words of a block raise, before its movement and the value of its number are known: first
  // check(). Throws Alarm; the block is then not taken.
  virtual void read(const CutterBlock& words) = 0;
  // The step after read() of its block; its `cutter` may be absent. An Alarm without a line is one of this step: what
  // is held goes out by finish(). An Alarm with a line belongs to an earlier block; what may go out before it has gone.
  virtual void take(const Step& step) = 0;
  // No block follows: the end of the program, or a block that ends the run by an alarm.
  virtual void finish() = 0;

 protected:
  // The alarms that B and C share. Throws Alarm PS0028, PS0037, FORBIDDEN_IN_CUTTER_COMPENSATION or PS0042.
  void check(const CutterBlock& words) const;
  [[nodiscard]] Recorder& recorder() const { return recorder_; }
  void emit(const Step& step) const { output_(step); }

 private:
  Recorder& recorder_;
  Output output_;
};

}  // namespace toolcomp::model

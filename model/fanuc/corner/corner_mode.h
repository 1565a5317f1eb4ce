// SPDX-License-Identifier: Apache-2.0
// The mode of a compensation that makes vectors at corners: cutter compensation C and tool side compensation.
#pragma once

#include <cstdint>

#include "model/basis/alarm.h"
#include "model/basis/recorder.h"
#include "model/fanuc/corner/corner_block.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

class CornerMode {
 public:
  CornerMode(const spec::Setup& setup, Recorder& recorder) : setup_(setup), recorder_(recorder) {}

  // There is a vector, or a block that makes one.
  [[nodiscard]] bool is_on() const { return phase_ > Phase::pending; }
  // Or a code asks for one.
  [[nodiscard]] bool is_on_or_asked_for() const { return is_on() || asked_; }
  // A moving block has made the vector, or makes it.
  [[nodiscard]] bool made_by_move() const { return phase_ == Phase::started || phase_ == Phase::running; }
  // A block that asks for the mode, or no longer does, as its words say, starts or cancels it.
  [[nodiscard]] bool starts(bool wanted) const { return wanted && phase_ == Phase::off; }
  [[nodiscard]] bool cancels(bool wanted) const { return !wanted && is_on(); }

 protected:
  enum class Phase : std::uint8_t {
    off,
    pending,  // a lone start waits for the next block that moves
    started,  // no block has moved since the start-up block
    running,
    taken_away,  // the mode goes on without a vector: after G52, G92, G53 or a reference return
    ending       // after a lone cancel the vector waits for its removal
  };

  [[nodiscard]] bool is_pending() const { return phase_ == Phase::pending; }
  // fanuc.cutter-c.number-zero: Number 0 in force acts as G40 does. G41 or G42 stays in force, and a later number other
  // than 0 asks for the mode again. A number other than 0 whose value is 0 does not cancel: the mode starts and stays
  // on.
  [[nodiscard]] bool asks(const CornerBlock& block) const {
    return block.side != CutterSide::none && !recorder_.decide(Clause::fanuc_cutter_c_number_zero, block.number == 0);
  }
  // Whether the first block that moves after a start changes the side.
  [[nodiscard]] bool changes_side_at_start(const CutterOffset& offset) const {
    return (phase_ == Phase::started || is_pending()) && offset.side != last_.side;
  }

  const spec::Setup& setup_;
  Recorder& recorder_;
  Phase phase_ = Phase::off;
  bool asked_ = false;  // by the last block: a side and a number other than 0 in force
  CutterOffset last_;   // of the last block that moved, or of a lone start
};

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
// The programmed position: end points of blocks, travels, and the datum shift of cycle 7.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "model/basis/recorder.h"
#include "model/exact/real.h"
#include "model/geometry/vector.h"
#include "model/heidenhain/program/values.h"
#include "spec/language/heidenhain/klartext_block.h"
#include "spec/language/setup.h"

namespace toolcomp::model::klartext {

// One value for each letter of spec::klartext::kAxisLetters: units of the program, or degrees.
using BySlot = std::array<Real, spec::klartext::kAxisLetters.size()>;

// Slots of kAxisLetters.
inline constexpr std::size_t kFirstRotarySlot = 3;
inline constexpr std::size_t kFirstParallelSlot = 6;
constexpr bool is_rotary_slot(std::size_t slot) { return slot >= kFirstRotarySlot && slot < kFirstParallelSlot; }

// Of a hole, along the tool axis: workpiece coordinates, units of the program.
struct HoleLevels {
  Real r;       // where the cycle begins
  Real bottom;  // as deep as it goes
  Real level;   // to which the tool returns
};

// Workpiece coordinates. Clauses: heidenhain.program.incremental, .datum-shift, .machine-coordinates, .retraction.
class ProgrammedPosition {
 public:
  ProgrammedPosition(const Values& values, Recorder& recorder) : values_(values), recorder_(recorder) {}

  // The start of the run: linear axes from the setup, rotary axes at 0.
  void start(const spec::Setup& setup);
  // The axis words of L and LN. `machine_coordinates`: M91 or M92 in the block.
  void move(const spec::klartext::Block& block, bool machine_coordinates);
  // M140 MB n and MB MAX: along the tool.
  void retract(const Real& by, const Vector& tool);
  void retract_to_limit(const Vector& tool);
  // DEP without coordinates: somewhere in the plane at right angles to the tool, which is along its axis.
  void depart(const Vector& tool);
  // A call of the drilling cycle defined last, along the axis of this slot: the tool stands at the level of return
  // then. Nothing where the cycle does nothing. Clauses: heidenhain.program.cycle-call, .cycle-return.
  std::optional<HoleLevels> drill(std::size_t slot);
  // Cycle 7.
  void shift_datum(const spec::klartext::Block& block);

  [[nodiscard]] const Real& at(std::size_t slot) const { return at_.at(slot); }
  // Bit i: where X, Y or Z of slot i stands is not known; at() is then worth nothing.
  [[nodiscard]] unsigned unknown() const { return unknown_; }
  // The block moves by an increment of such an axis.
  [[nodiscard]] bool needs_unknown(const spec::klartext::Block& block) const {
    return (block.axes & block.incremental & unknown_) != 0;
  }
  [[nodiscard]] Vector point() const { return {at_[0], at_[1], at_[2]}; }

 private:
  const Values& values_;
  Recorder& recorder_;
  BySlot at_;
  unsigned unknown_ = 0;
  BySlot datum_;
};

}  // namespace toolcomp::model::klartext

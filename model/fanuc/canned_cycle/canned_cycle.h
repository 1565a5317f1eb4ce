// SPDX-License-Identifier: Apache-2.0
// Canned cycles: the drilling mode, what it keeps, and the holes of a block. Clauses: fanuc.canned-cycle.*.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "model/basis/number.h"
#include "model/basis/recorder.h"
#include "model/fanuc/passes/passes.h"
#include "model/fanuc/program/interpreter.h"
#include "model/fanuc/program/step.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

class CannedCycle {
 public:
  CannedCycle(const spec::Setup& setup, const Numbers& numbers, Recorder& recorder);

  // The mode behind the codes of the block, and the data that it gives. In the mode the command then names no axis.
  void read(Command& command);
  // The alarms of a block in the mode, in their order. Throws Alarm PS0044, FORBIDDEN_IN_3D_COMPENSATION,
  // FORBIDDEN_IN_CUTTER_COMPENSATION, PS0045; LeftOpen where the manual does not say what happens. `passes` tell which
  // compensation is on.
  void check(const Command& command, const Passes& passes) const;
  // The holes of a block that drills; their moves have an end alone. `from`: where it starts.
  std::vector<DrilledHole> drill(const Command& command, const Position& from);

  // The drilling axis of the mode.
  [[nodiscard]] std::size_t axis() const { return axis_; }

 private:
  // A word of the drilling axis, and whether G91 was in force in its block.
  struct Level {
    Rational value = 0;
    bool distance = true;
  };

  void change_mode(const Codes& codes);
  void keep(const Command& command);
  [[nodiscard]] Rational repeats(const Codes& codes, const Words& words) const;
  [[nodiscard]] std::size_t axis_of(spec::Plane plane) const;
  // Where the hole is, one travel behind `from` under G91.
  [[nodiscard]] Position place(const Command& command, const Position& from) const;

  const Numbers& numbers_;
  Recorder& recorder_;
  spec::Axes axes_;
  bool by_plane_;                 // 5101#0, FXY
  bool to_initial_level_ = true;  // G98
  std::optional<Cycle> cycle_;    // nothing: the mode is off
  std::size_t axis_ = spec::Axes::kNone;
  bool same_axis_ = true;  // the block has the drilling axis of the mode
  Level point_r_;
  Level bottom_;
  bool depth_of_cut_ = false;  // a Q other than 0
  // The initial level less where the drilling axis stands: what renames the position renames both.
  Coordinate rise_;
};

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
// Canned cycles G73 G74 G76 G80 to G89 with G98 and G99 (section 13.1): the drilling mode, the data it keeps, how deep
// a hole is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "fast/arithmetic/count.h"
#include "fast/basis/alarm.h"
#include "fast/fanuc/control/word_units.h"
#include "fast/fanuc/program/cycle_command.h"
#include "fast/fanuc/program/words.h"
#include "spec/language/axes.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// Along the drilling axis: programmed positions, setup units, exact.
struct HoleLevels {
  Count initial;
  Count point_r;
  Count bottom;
  Count level;  // to which the tool returns
  // As AxisPositions::rounded().
  bool initial_rounded = false;
  bool level_rounded = false;
};

// The drilling mode, which group 01 and G80 end, and the code of G98 and G99, which stays in force without it. Words
// count in setup units here (WordUnits), K and L as they are written.
class CannedCycle {
 public:
  // Reads 5101#0.
  explicit CannedCycle(const spec::Setup& setup);

  // The drilling mode is on: no block goes a short way.
  [[nodiscard]] bool on() const { return cycle_ != kNone; }
  // Of a block; `normal`: the axis at right angles to the plane in force after its codes, or spec::Axes::kNone. Clauses
  // fanuc.canned-cycle.mode, .cancel, .drills, .drilling-axis, .repeats.
  [[nodiscard]] CycleCommand read(const Words& words, std::size_t normal) const;
  // The clauses say what a block in the drilling mode does: but for what they leave to compensation (clause
  // fanuc.canned-cycle.not-said).
  [[nodiscard]] bool is_said(const Words& words, const CycleCommand& command) const;
  // It drills under G73 or G83 without Q, or with Q0: PS0045 (clause fanuc.canned-cycle.depth-of-cut).
  [[nodiscard]] bool lacks_depth_of_cut(const Words& words, const CycleCommand& command) const;

  // The codes of a block come into force, and the data of one that drills; units and `incremental`, G91, those after
  // its codes.
  void take(const Words& words, const CycleCommand& command, const WordUnits& units, bool incremental);
  // Of a hole, from where the drilling axis stands in the program; `rounded`: that position is. POSITION_RANGE. Clauses
  // fanuc.canned-cycle.initial-level, .point-r, .bottom, .return.
  [[nodiscard]] Alarm find_levels(const Count& position, bool rounded, HoleLevels& levels) const;
  // The drilling axis stands at the level of a hole.
  void stand_at(const HoleLevels& levels);

 private:
  // A word as it was given: a coordinate, or under G91 a distance.
  struct Given {
    Count value;
    bool distance = false;
  };
  [[nodiscard]] static Count along(const Count& from, const std::optional<Given>& given);

  bool by_plane_;  // 5101#0, FXY
  std::size_t z_;
  Code cycle_ = kNone;
  bool to_point_r_ = false;
  std::size_t axis_ = spec::Axes::kNone;
  std::optional<Given> point_r_;
  std::optional<Given> bottom_;
  bool has_depth_of_cut_ = false;  // Q, and not 0
  // The initial level less the position of the axis: nothing but holes moves it in the mode, and what renames its
  // position renames the level with it.
  Count rise_;
  bool rise_rounded_ = false;
};

}  // namespace toolcomp::fast

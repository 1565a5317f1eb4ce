// SPDX-License-Identifier: Apache-2.0
// A block whose vectors at its end wait for a block that follows.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "model/fanuc/corner/tool_arc.h"
#include "model/fanuc/corner/vector_group.h"
#include "model/fanuc/program/cutter_offset.h"
#include "model/fanuc/program/step.h"

namespace toolcomp::model {

// The path of a block of the mode, and how the section sees it between the vectors at its ends.
class HeldPath {
 public:
  HeldPath() = default;
  HeldPath(const HeldPath&) = default;
  HeldPath(HeldPath&&) = default;
  HeldPath& operator=(const HeldPath&) = default;
  HeldPath& operator=(HeldPath&&) = default;
  virtual ~HeldPath() = default;

  // Of an arc: as the tool runs it between two heads.
  [[nodiscard]] virtual std::optional<ToolArcRun> arc_run(Recorder& recorder, const SpaceVector& from,
                                                          const SpaceVector& to) const = 0;
  // Whether an arc interferes that the tool runs so. Clauses: fanuc.cutter-c.interference-radius, interference-sweep.
  [[nodiscard]] virtual bool arc_interferes(Recorder& recorder, ToolArcRun& run) const = 0;
  // Whether the block, as a line, interferes between two vectors. Clause: fanuc.cutter-c.interference-direction.
  [[nodiscard]] virtual bool line_interferes(Recorder& recorder, const Vector& from, const Vector& to) const = 0;
  // How far the tool goes against the block between two vectors that interfere so, setup units.
  [[nodiscard]] virtual Real backwards(const Vector& from, const Vector& to) const = 0;
  // By how much the offset of an arc that interferes is larger than its radius, setup units; 0 where its sweep does.
  [[nodiscard]] virtual Real excess() const = 0;
};

struct Held {
  enum class Kind : std::uint8_t {
    start_up,
    moving,      // a block of the mode
    lone_start,  // the code in a block that does not move, and makes the vector: SUV = 1
    corner_arc   // G39
  };
  Kind kind = Kind::moving;
  Step step;
  CutterOffset offset;                   // in force at its end; of G39 that of the moving block before
  std::shared_ptr<const HeldPath> path;  // of the first two kinds, and where the section needs one
  bool checked = true;                   // for interference

  // Behind it, as its own corner sees them.
  int without_movement = 0;   // what the blocks that do not move there count
  bool repeated = false;      // the code repeated in one of them, or in the block now taken
  std::vector<Step> between;  // of these blocks, those that make no vector of their own
  // Its group, where the block that it makes its corner with has come while one before it still waits for its own.
  std::function<SpaceGroup(Held& held)> met;
  bool leaves_corner = false;  // and that block, the last one between, makes no vector: there is no corner behind it

  [[nodiscard]] bool starts() const { return kind == Kind::start_up || kind == Kind::lone_start; }
  // It has one vector at its end, and makes a corner with no block.
  [[nodiscard]] bool stands() const { return kind == Kind::lone_start || kind == Kind::corner_arc; }
};

}  // namespace toolcomp::model

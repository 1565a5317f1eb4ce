// SPDX-License-Identifier: Apache-2.0
// What a block is to the mode of tool side compensation: by its own words and movement and by the blocks before it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/fanuc/corner/corner_block.h"
#include "model/fanuc/program/step.h"
#include "model/fanuc/tool_side_compensation/side_path.h"

namespace toolcomp::model {

// What a block says to tool side compensation.
struct ToolSideBlock : CornerBlock {
  std::optional<int> treatment;  // Q: 1, 2 or 3; 0 where it is none of them

  // The compensation is on after the block.
  [[nodiscard]] bool wanted() const { return side != CutterSide::none && number != 0; }
};

// What a block does to the vector.
enum class SidePart : std::uint8_t {
  free,        // the mode is off: another compensation may be on
  idle,        // makes no vector
  lone_start,  // of type C: makes the vector of the next block
  lone_cancel,
  start_up,
  moving,  // of the mode
  cancel
};

struct SidePlan {
  // How it leaves the corner at the end of a block before it.
  struct Start {
    std::uint64_t at = 0;  // the number of that block
    SideEnd end;
  };

  SidePart part = SidePart::free;
  std::uint64_t number = 0;    // of a block that makes a vector, counted from 1
  CutterOffset offset;         // at its end: of the last block that moved
  Rational offset_before;      // of a block of the mode: with the distance before it, on its own side, to the left
  Vector travel;               // from start to end
  std::optional<SideArc> arc;  // else a line
  CompensationPlane plane;     // at its end
  std::vector<Start> starts;   // where it moves in the plane of an earlier corner
  std::optional<SideEnd> end;  // how it reaches its own end, if it moves in the plane there
  bool at_corner = false;      // the block right before it makes a corner with it
  bool leaves_corner = false;  // no vector: the one at its end is one of no corner
  bool changes = false;        // lone_start, lone_cancel: the vector that is made or removed is not 0
  std::optional<Warning> warning;

  [[nodiscard]] const SideEnd* start_at(std::uint64_t block) const;
  [[nodiscard]] bool moves_behind() const { return !starts.empty(); }
};

// Follows the mode through the program. Clauses: fanuc.tool-side.*.
class SideMode : public CornerMode {
 public:
  SideMode(const spec::Setup& setup, Recorder& recorder)
      : CornerMode(setup, recorder), shortest_(parameter(setup, 19630)) {}

  // The next block. Throws Alarm PS0038 or DIR_CHANGE_AT_STARTUP, or LeftOpen.
  // `waiting`: the blocks before it whose corners are not known.
  SidePlan next(const ToolSideBlock& block, const Step& step, std::vector<const SidePlan*> waiting);

 private:
  void while_off(const ToolSideBlock& block, SidePlan& plan);
  void in_mode(const ToolSideBlock& block, const Step& step, SidePlan& plan);
  void cancel(SidePlan& plan);
  // How the block moves at the corners before it and at its own end.
  void find_movement(const ToolSideBlock& block, const Step& step, SidePlan& plan);
  [[nodiscard]] bool crosses_tool(const CompensationPlane& plane, const Vector& travel) const;
  void look_at_arc(SidePlan& plan);
  [[nodiscard]] CutterOffset next_offset(const ToolSideBlock& block, const SidePlan& plan) const;
  [[nodiscard]] const SidePlan& waiting(std::uint64_t number) const;

  Rational shortest_;  // 19630, setup units

  bool has_vector_ = false;               // the vector made last is not 0
  std::vector<const SidePlan*> waiting_;  // while a block is planned
  std::uint64_t made_ = 0;                // blocks that make a vector
  Direction before_;                      // tool at the end of the block before
};

}  // namespace toolcomp::model

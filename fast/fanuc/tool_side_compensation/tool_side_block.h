// SPDX-License-Identifier: Apache-2.0
// What the interpreter hands to tool side compensation: one block, complete but for the vectors.
#pragma once

#include <array>
#include <cstddef>

#include "fast/basis/event.h"
#include "fast/fanuc/tool_side_compensation/travel.h"
#include "fast/geometry/path.h"
#include "fast/kinematics/direction.h"

namespace toolcomp::fast {

// Q: how the vectors at the end of the block are made.
enum class Treatment : std::uint8_t { none, perpendicular, first_only, keep };

// Frame: the programmed path, without length offset or vector; the event carries the former, so the stage adds its
// vector to event.point, event.axes and (where present) event.machine.
struct ToolSideBlock {
  // The block's own move, filled also where the block has none, for a stage that makes one.
  Event event;
  bool own = false;       // the block makes that move (docs/events.md, rule 1)
  bool wanted = false;    // a code of the section is in force, with a number other than 0
  bool repeated = false;  // the code in the block is the one in force before it
  int side = 1;           // +1 left: by code and sign of the value
  Treatment treatment = Treatment::none;
  // Where it starts, as that is called behind its change of the workpiece system; nullptr: it changes none.
  const Event* renamed = nullptr;

  const Direction* tool = nullptr;         // at the end of the block
  std::uint64_t tool_number = 0;           // another one for every direction of the program
  const Direction* tool_before = nullptr;  // where the block before ended

  // Arcs. event.arc has the nearest doubles of the centre.
  bool arc = false;
  bool mismatches = false;  // of its path, set by the stage: the tool does not stand along the normal of its plane
  bool clockwise = false;
  bool by_radius = false;
  std::array<std::size_t, 2> in{};    // which of X Y Z the plane has
  std::array<std::size_t, 2> axis{};  // their indices in the events; spec::Axes::kNone: no such axis
  std::array<Count, 2> start{};       // in the plane
  std::array<Count, 2> end{};
  std::array<Count, 2> to_center{};  // from start; only where !by_radius
  Count radius;                      // R; only where by_radius
};

}  // namespace toolcomp::fast

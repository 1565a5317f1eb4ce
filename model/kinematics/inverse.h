// SPDX-License-Identifier: Apache-2.0
// Rotary positions from a direction: every solution, and what a branch is followed by.
#pragma once

#include <array>
#include <cstddef>

#include "model/basis/recorder.h"
#include "model/kinematics/machine.h"
#include "model/kinematics/tool_direction.h"

namespace toolcomp::model {

// One pair of computed angles, both principal.
struct Solution {
  Pose pose;
  // The side of the extreme heights on which the tool-side axis stands: 1 where its turn, counted from that of the
  // greatest height, is in (0, 180); -1 where it is in (-180, 0); 0 at the edge of reach.
  int branch = 0;
};

struct Solutions {
  std::array<Solution, 2> at;  // branch 1, branch -1
  std::size_t count = 0;       // 1: edge of reach or singular; else 2
  bool work_free = false;      // singular: the work-side position is arbitrary (0 stands in the solution)

  [[nodiscard]] const Solution* begin() const { return at.data(); }
  [[nodiscard]] const Solution* end() const { return at.data() + count; }
};

// All pairs of a direction, of any length; whole turns can be added to each angle. The direction is in the table frame,
// turned back about the work-side axis from a position of that. Throws the alarm PS5459 where there is none. The
// machine is_invertible(). Clauses: fanuc.tool-center-point.inverse, .parallel-to-the-work-side,
// .reach-toward-the-axis, .reach-away-from-the-axis, .unreachable.
Solutions inverse(const Machine& machine, Recorder& recorder, const Direction& direction,
                  const Angle& work_position = Angle());

// Cosine and sine of the positions for a unit direction in the table frame on one branch, and nothing decided: for
// directions inside a block, which are known to be reachable and not parallel to the work-side axis. `along`: its
// component along that axis.
struct PoseCosines {
  Real tool_cosine;
  Real tool_sine;
  Real work_cosine;
  Real work_sine;
};
PoseCosines on_branch(const Machine& machine, const Vector& unit, const Real& along, int branch);

// On which side of the extreme heights a tool-side position is: the sine of its turn, counted from that of the greatest
// height, times rho: positive on branch 1, negative on branch -1, zero at an edge of reach.
Real branch_quantity(const Machine& machine, const Angle& tool);
// That branch, as of Solution.
int branch_of(const Machine& machine, const Angle& tool);

// The azimuth about the work-side axis from one direction to another, principal; neither is parallel to that axis.
Angle azimuth(const Machine& machine, const Vector& from, const Vector& to);

// `end`, a position of one of the axes, with the whole turns that bring it to where a continuous motion takes the axis:
// the tool-side axis within its branch,
Angle lifted_tool(const Angle& start, const Angle& end, int branch, const Machine& machine);
// the work-side axis to start + sense * (swing of the direction - swing of the tilted direction), of which `end`
// differs by whole turns only.
Angle lifted_work(const Angle& start, const Angle& end, const Angle& direction_swing, const Angle& tilt_swing,
                  const Machine& machine);

}  // namespace toolcomp::model

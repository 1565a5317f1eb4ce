// Rotary positions from a direction: every solution, and the quantities by which a branch is followed.
#pragma once

#include <array>
#include <cstddef>

#include "model/kinematics/machine.h"
#include "model/kinematics/tool_direction.h"
#include "model/recorder.h"

namespace toolcomp::model {

// One pair of basic computed angles, each in [0, 360).
struct Solution {
  Pose pose;
  int branch = 0;  // side of the extreme height on which the tool-side axis stands: 1, -1, or 0 at the edge of reach
};

struct Solutions {
  std::array<Solution, 2> at;
  std::size_t count = 0;   // 0: unreachable; 1: edge of reach; else 2
  bool work_free = false;  // singular: the work-side position is arbitrary; the one given is 0

  [[nodiscard]] const Solution* begin() const { return at.data(); }
  [[nodiscard]] const Solution* end() const { return at.data() + count; }
};

// All pairs of a direction in the table frame, of any length. A hypothetical axis admits only pairs at its fixed angle.
// Clauses: fanuc.tool-center-point.*.
Solutions inverse(const Machine& machine, Recorder& recorder, const Direction& direction);

// Which side of the extreme height a tool-side position is on: positive, negative, or zero at an edge of reach; as a
// number of magnitude at most 1 for a decision.
Real branch(const Machine& machine, const Angle& tool);
// How far a direction lies inside the reach: positive inside, zero at its edge, negative outside; with its scale.
struct Margin {
  Real quantity;
  Real scale;
};
Margin reach(const Machine& machine, const Direction& direction);
// The pair of one branch (1 or -1; any at an edge of reach) of a direction that is reachable and not singular; both
// angles principal.
Pose on_branch(const Machine& machine, const Direction& direction, int branch);

// The azimuth about the work-side axis from one direction to another, principal; neither is parallel to that axis.
Angle azimuth(const Machine& machine, const Vector& from, const Vector& to);
// The work-side position where a motion that starts at `start` and keeps clear of the work-side axis ends: from the
// azimuth that the direction has swung and that the tool-side axis has swung the tilted direction, each less than 180
// degrees.
Angle lifted_work(const Machine& machine, const Pose& start, const Vector& from, const Vector& to, const Angle& tool);

}  // namespace toolcomp::model

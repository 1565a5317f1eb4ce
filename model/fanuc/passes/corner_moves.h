// SPDX-License-Identifier: Apache-2.0
// The moves between the heads of the vectors of a corner, and the alarms that name a block of a pass.
#pragma once

#include "model/basis/alarm.h"
#include "model/fanuc/corner/corner_block.h"
#include "model/fanuc/corner/interference.h"
#include "model/fanuc/program/step.h"

namespace toolcomp::model {

// Where the tool stands: at the first of these heads. It takes the others before the next block moves.
struct Standing {
  SpaceGroup heads{SpaceVector{}};
  Move place;  // where the last block ended, for corner moves

  void stand(SpaceVector vector) { heads = {std::move(vector)}; }
};

// All moves of a block that makes no vector end at this head.
void at_head(Step& step, const SpaceVector& head);

// Before the block's own move, with its feed. Clause: fanuc.cutter-c.corner-movement.
void insert_corner_moves(Step& step, const CornerBlock& block, Standing& tool);

// After the block's own move, up to the stop point. Clause: fanuc.tool-side.stop-point.
void append_corner_moves(Step& step, Standing& tool);

// The own move of a block that makes a vector ends at this head. `run`: of an arc.
void end_at(Move& own, const SpaceVector& head, ToolArcRun* run, Passage passage);

// A code that makes or removes the vector in a block that does not move: with the block's own move, or, if the vector
// changes, with one made for it.
void change_alone(Step& step, spec::Cause cause, bool changes);

// An alarm of geometry: it names this block. The blocks before it are given as computed with it.
Alarm geometry_alarm(const Step& step, const spec::Axes& axes, AlarmCause cause, Real crossing);

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
// Interference check: what becomes of a block between the vectors at its start and at its end.
#pragma once

#include <cstdint>
#include <functional>

#include "model/fanuc/corner/tool_arc.h"
#include "model/fanuc/corner/vector_group.h"

namespace toolcomp::model {

enum class Passage : std::uint8_t {
  free,       // the block runs as it is
  shortened,  // vectors were dropped: an arc becomes a line
  blocked     // the last pair interferes too: PS0041
};

// What parameters say of the check.
struct InterferenceRules {
  bool by_parameters = false;  // they concern the section
  bool keeps_vectors = false;  // the first pair that interferes is the last one
  bool no_alarm = false;       // where the tool goes against the programmed direction
};

// How far the tool goes along a block, times the length of the block as it is seen, and against what that is measured.
struct WayAlong {
  Real product;
  Real scale;
  Real length2;
};

// How a section sees its block.
struct CheckedPath {
  PathEnd start;  // of an arc
  PathEnd end;
  // As a line, between two vectors.
  std::function<WayAlong(const Vector& from, const Vector& to)> along;
};
// In a plane, between the vectors there.
WayAlong way_along(const OffsetPath& path, const PlanePoint& from, const PlanePoint& to);

// Drops vectors, the last ones at the start and the first ones at the end of a block, until it does not interfere; at
// each end one vector stays. `run`: of an arc, between the inner vectors. `crossing`: of a blocked one, by how much its
// paths cross, setup units; 0 where the sweep of an arc interferes. Clauses: fanuc.cutter-c.interference-*.
struct Checked {
  Passage passage = Passage::free;
  Real crossing;
};
Checked check_interference(Recorder& recorder, const InterferenceRules& rules, const CheckedPath& path,
                           SpaceGroup& at_start, SpaceGroup& at_end, ToolArcRun* run);

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
// The rules of cutter compensation B: the vector at the end of a block, and the arc on which the tool goes there. Plane
// coordinates, setup units.
#pragma once

#include <cstdint>
#include <optional>

#include "model/fanuc/cutter_compensation/cutter_compensation.h"

namespace toolcomp::model {

// What G39 does.
struct CornerArcOfB {
  PlanePoint vector;    // from there on
  spec::Arc<Real> arc;  // but for its plane and centre
  bool moves = true;
};

// How G40 takes the vector away.
enum class Removal : std::uint8_t {
  none,
  in_own_move,
  alone  // without an axis word: in the move of the length offset, or one of its own
};

// What each kind of block makes of the vector in force. Clauses: fanuc.cutter-b.*, fanuc.cutter.side.

// At the end of a straight block; nothing where the vector in force is kept.
std::optional<PlanePoint> vector_of_line(Recorder& recorder, const CutterBlock& block);
// At the end of an arc. Throws Alarm PS0038.
PlanePoint vector_of_arc(Recorder& recorder, const CutterBlock& block);
// Sweep and radii of the tool's own arc, from head to head, each counted from the centre. Whether the heads are one.
bool head_to_head(Recorder& recorder, spec::Arc<Real>& arc, const PlanePoint& from, const PlanePoint& to);
// `started`: the start-up is made.
Removal removal(Recorder& recorder, const CutterBlock& block, bool started, const PlanePoint& vector);
CornerArcOfB corner_arc_of_b(Recorder& recorder, const CutterBlock& block, const PlanePoint& before);

}  // namespace toolcomp::model

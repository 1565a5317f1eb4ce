// SPDX-License-Identifier: Apache-2.0
// A corner of the programmed path: its class, and the vectors that stand at it. Vectors are seen from the corner, setup
// units. "former" is the block that ends there, "latter" the one that starts there.
#pragma once

#include <cstdint>
#include <optional>

#include "model/fanuc/corner/offset_path.h"

namespace toolcomp::model {

// By the angle α between the two programmed paths on the side of the workpiece; of an arc its tangent counts.
enum class CornerClass : std::uint8_t {
  inner,     // α over 180°
  straight,  // 180°: one direction
  obtuse,    // 90° up to 180°
  acute      // under 90°, the exact reversal included
};

// Without trigonometry: by the signs of cross and scalar product. The offset of `former` is not 0. Clauses:
// fanuc.cutter-c.corner-side, straight-or-reversal, obtuse-or-acute.
CornerClass classify(Recorder& recorder, const PathEnd& former, const PathEnd& latter);

// Whether α of an acute corner is under 1°. Clause: fanuc.cutter-c.under-one-degree.
bool is_under_one_degree(Recorder& recorder, const PathEnd& former, const PathEnd& latter);
// The same by the squares of cross and scalar product, times one positive factor.
bool is_under_one_degree(Recorder& recorder, const Real& cross2, const Real& dot2);

// P: at right angles to the path, of the length of the offset.
PlanePoint perpendicular(const PathEnd& end);
// M: where the offset tangent lines of both blocks meet; not at a reversal.
PlanePoint tangents_meet(const PathEnd& former, const PathEnd& latter);
// Q1 and Q2: the offset lines prolonged beyond the corner by the length of the offset.
PlanePoint prolonged(const PathEnd& former);
PlanePoint begun_before(const PathEnd& latter);

// Whether both ends have an offset path, which an arc has not where the offset is larger than its radius. Clause:
// fanuc.cutter-c.offset-radius-at-a-corner.
bool have_offset_paths(Recorder& recorder, const PathEnd& former, const PathEnd& latter);

// I: where the offset paths meet, each with its own offset: the meeting point that goes to the corner as the offset
// goes to 0. The tangents are not parallel, and there are offset paths. Nothing where they do not meet. Clauses:
// fanuc.cutter-c.line-meets-arc, line-arc-point, circles-apart, circles-nested, arc-arc-point.
std::optional<PlanePoint> paths_meet(Recorder& recorder, const PathEnd& former, const PathEnd& latter);

}  // namespace toolcomp::model

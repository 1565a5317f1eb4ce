// SPDX-License-Identifier: Apache-2.0
// Laws of the direction at the end of blocks under G43.5. Exempt as those of tool center point control
// (tool_center_point.h).
#pragma once

#include <cstdint>

#include "judge/laws/fanuc/scene.h"

namespace toolcomp::judge::laws {

// The tool direction at the end of a G43.5 block is that of its I J K, without them the one before; with Q it is in the
// plane of them (the latest) and the travel, Q degrees toward the travel, which is the tangent at the end of arcs and
// helices. fanuc.tool-center-point.direction-words, -lean, -lean-in-an-arc. Not where P1 changed the end, or with Q may
// have changed the vector kept (19738 > 0), for Q on arcs under compensation, nor without travel across the direction.
void commanded_direction(const FanucScene& scene, Holding& holding);

// The end of a P1 block under G43.5 is the commanded one, or with 19738 > 0 one changed so that the tool goes through a
// singular posture: then the work-side axis stays where it was, the tool leans as far against the singular posture as
// commanded, to its other side, and the arc from start to command comes nearer to it than 19738. On machines whose axes
// are orthogonal the changed direction is within 19739 (azimuth) of the commanded one; and an arc that comes near to
// one singular posture, not through it, has its end changed if that is within 19739 (no ranges 19741 to 19744).
// fanuc.tool-posture.near, -veto, -changed. Only blocks whose direction is known as above.
void changed_end(const FanucScene& scene, Holding& holding);

// Whether a move ends in the commanded direction: a P1 block with 19738 > 0 may not. Unknown where the command is, and
// where an inclined tool-side axis may have reached the commanded direction by a changed end.
enum class End : std::uint8_t { commanded, changed, unknown };
End end_of(const FanucScene& scene, const Run& run, const Pose& end);

}  // namespace toolcomp::judge::laws

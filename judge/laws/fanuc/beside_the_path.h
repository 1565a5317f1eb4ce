// SPDX-License-Identifier: Apache-2.0
// Laws of compensation beside a path: tool side compensation, cutter compensation B and C. One geometry: V is the
// vector from the programmed point to the tool, T the tool (or the normal of the selected plane), U the displacement of
// a block, and T × U points to its left.
//
// Common exemptions: blocks whose start is unknown (the first of the program or behind a hole, or coordinates were
// renamed) or that are not displaced across T (arcs always are); programs with G37 or G45 to G48, which move the point
// by other vectors; for distances programs with G10, G92, G53, G28, G29, G30, whose vectors follow rules of their own;
// cutter compensation with 5001#2 = 1 (H may be its number) where the radius counts. Blocks shorter in the plane than
// 19630 are no movement.
#pragma once

#include "judge/laws/fanuc/scene.h"

namespace toolcomp::judge::laws {

// V · T = 0 for every head at the end of a block displaced across its own tool, T being its tool axis there; at the end
// of every arc, unless T sees its centre there. fanuc.tool-side.plane and fanuc.tool-side.projection (no component
// along the tool).
void perpendicular_to_the_tool(const FanucScene& scene, Holding& holding);

// |V| >= r for every head at the end of a compensated block: no head is nearer to the programmed corner than the
// radius. Follows from fanuc.tool-side.inner and fanuc.tool-side.outer-acute (|V|² = 2r²/(1+c), |V1| = |V2| = r√2); for
// arcs, points of the offset circle are r from the programmed one.
void not_nearer_than_the_radius(const FanucScene& scene, Holding& holding);

// The first head at the end of a compensated line lies at the signed distance r left of it: V · (T × U) = ρ |T × U|.
// fanuc.tool-side.inner (V · n1 = r); chapter 14, 14.6.2 to 14.6.4. Not for a start-up block, nor where the side
// changes up to the next movement across T; with the interference check on, only at inner corners of two lines (a
// removed vector is another).
void beside_the_line_before(const FanucScene& scene, Holding& holding);

// The last head before a compensated line lies at the same distance of that line: V · (T × U) = ρ |T × U|, T and ρ of
// the block that ends there. fanuc.tool-side.inner (V · n2 = r), fanuc.tool-side.start-up. Only where both blocks are
// plain and follow each other directly, the latter says no code of group 07, no corner limit (5010) drops heads, R' > 0
// on an arc before it, and as above.
void beside_the_line_after(const FanucScene& scene, Holding& holding);

// The path of the tool on a compensated arc is the circle parallel to the programmed one: |P + V - O| = R - σρ at its
// end, and at its start where the corner before it is free of exemptions. Chapter 14, notation (R' = R - σρ) and
// 14.6.3. Tool side compensation: all lengths as T sees them where the corner is, R at each end by itself, σ the sense
// that T sees. fanuc.tool-side.arc-corners and fanuc.tool-side.arc-in-the-plane. Cutter compensation B: at the end
// alone. Not where R' <= 0 or T stands in the plane of the arc, nor where the side changes up to the next movement
// across T. An arc that lost a head to the interference check runs straight and is not asked.
void beside_the_arc(const FanucScene& scene, Holding& holding);

// Cutter compensation B: the vector of a line is ρ times the left normal of (I, J), or of the block itself without
// them. Chapter 14.4.
void normal_of_the_block(const FanucScene& scene, Holding& holding);

// Start and cancel leave from and return to the programmed path: without a mode in force no vector appears where there
// was none, and the move that cancels ends on the programmed point. fanuc.tool-side.start-up and -cancel,
// fanuc.leading-edge.start and -cancel; chapter 14.6.2, 14.6.4.
void on_the_path_without_a_mode(const FanucScene& scene, Holding& holding);

// G92 names the place where the tool is: in an axis that it names nothing stands between the programmed point before it
// and the tool, so the last vector before it has no component there. Cutter compensation C; where blocks with movements
// come after it (what ends the run has none), no hole before it since that vector, and no other code of group 00 stands
// beside it.
void where_the_tool_is_said_to_be(const FanucScene& scene, Holding& holding);

}  // namespace toolcomp::judge::laws

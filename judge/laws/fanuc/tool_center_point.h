// SPDX-License-Identifier: Apache-2.0
// Laws of tool center point control and tool posture control (G43.4, G43.5).
//
// Rotary positions are the reported machine coordinates, or those of the workpiece system where a setup can say so and
// does (`rotary_angles`). Exempt: machines this reading of the parameters does not cover
// (machine.h); what follows a second G43.4 or G43.5, or a hole of a canned cycle, without G49 between, or comes with
// G10, G37, G92, G53, G28 to G30 or a change of the workpiece system anywhere in the program (frames and lengths are
// then others).
#pragma once

#include "judge/laws/fanuc/scene.h"

namespace toolcomp::judge::laws {

// The tool axis reported is that of the rotary positions reported, in the programming frame: M° V, M° the table where
// the mode began (WKP = 0) or where it stands (WKP = 1). fanuc.tool-direction.of-pose,
// fanuc.tool-center-point.frozen-pose; docs/events.md, rule 6.
void axis_of_the_positions(const FanucScene& scene, Holding& holding);

// The tip that belongs to the axes reported is the point reported: axes less holder and length, seen from the table.
// fanuc.tool-center-point.control-point-*. Only with H in the block of G43.4 or G43.5 and none after it.
void tip_of_the_axes(const FanucScene& scene, Holding& holding);

// Between the ends of a block the tip seen from the table is on the straight line, in proportion; on an arc it keeps
// its distance from the centre and goes by equal chords. fanuc.tool-center-point.tip-path. Arcs with two radii and
// under WKP = 1 are exempt.
void tip_on_the_path(const FanucScene& scene, Holding& holding);

// With tip_control_cancel = moves a G49 alone takes the offset back: the axes go to where the tip was in the workpiece
// system, with the table as it stands. Exempt as tip_of_the_axes.
void offset_taken_back(const FanucScene& scene, Holding& holding);

// Under P1 the tool stays in the plane of its directions at both ends, and turns by equal angles.
// fanuc.tool-posture.great-circle. Not in a block with a warning (posture-branch), with parallel ends, on machines that
// cannot lean the tool any way, or where its end was changed, or may have been.
void great_circle(const FanucScene& scene, Holding& holding);

// Under P0, and where P1 changed the end, both rotary axes go in proportion. fanuc.tool-center-point.conventional,
// fanuc.tool-posture.passing.
void positions_in_proportion(const FanucScene& scene, Holding& holding);

// Rotary words of absolute blocks with a decimal point are where the axes end under G43.4.
// fanuc.tool-center-point.commands.
void positions_as_programmed(const FanucScene& scene, Holding& holding);

}  // namespace toolcomp::judge::laws

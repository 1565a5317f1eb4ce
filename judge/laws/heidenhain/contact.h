// SPDX-License-Identifier: Apache-2.0
// Laws of 3D tool compensation (Klartext): the effective tool touches the surface it is to cut. q is the contact point,
// n the normal, t the tool axis; all of the event.
//
// Exempt where sizes count: tools that cannot be known from the text (Q parameters, tool 0, CORRDATA rows that do not
// exist).
#pragma once

#include "judge/laws/heidenhain/scene.h"

namespace toolcomp::judge::laws {

// The effective tool touches the plane (q, n) in q: its centre lies R2' along n and ρ' across the tool, toward n, from
// q; so sphere, torus and cylinder touch the plane and do not cut it. heidenhain.face.ring-direction, -contact-point,
// -effective-tip. ρ' is checked where the table of deviations does not decide R2'.
void touches_the_contact_plane(const KlartextScene& scene, Holding& holding);

// The nominal tool, its tip (or its centre, CNT-CNT) on the programmed point, touches the same plane in the same point;
// under PROG PATH IS CONTOUR the contact point is the programmed point. heidenhain.face.contact-point,
// heidenhain.contour.face.
void nominal_tool_touches(const KlartextScene& scene, Holding& holding);

// n has the direction of N; t that of T, of N without T, and that of the tool axis without TCPM.
// heidenhain.face.tool-vector, -without-tcpm. LN blocks.
void direction_of_the_tool(const KlartextScene& scene, Holding& holding);

// Under TCPM the tool stands as its rotary axes stand, whenever they were positioned and TCPM was switched on: along
// the tool axis where A, B and C are 0, and where one of them is not, turned by it right-handed about X, Y or Z. L
// blocks; not where several have turned, or where the words of the program do not say it.
void tool_as_the_axes_stand(const KlartextScene& scene, Holding& holding);

// Lengths act along the tool: axes = tip + dL t, carrier = axes + L t, tool shift = shift + dL t.
// heidenhain.program.length-along-the-tool.
void length_along_the_tool(const KlartextScene& scene, Holding& holding);

// The shift leads from the tip of the nominal tool to that of the effective one. heidenhain.face.effective-tip. Not for
// IS CONTOUR.
void shift_of_the_tip(const KlartextScene& scene, Holding& holding);

// A block under RL or RR ends with the cylinder beside its line: the shift of the tip is perpendicular to the tool and
// lies δ = dR (R' under IS CONTOUR) to the side of the line. heidenhain.peripheral.direction, -side, -mitre. Not for
// the first block under RL or RR, whose offset is that of the next one (checked there), nor where a line leads along
// the tool or its start is unknown.
void cylinder_beside_the_line(const KlartextScene& scene, Holding& holding);

}  // namespace toolcomp::judge::laws

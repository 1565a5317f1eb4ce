// SPDX-License-Identifier: Apache-2.0
// Laws of Klartext drilling cycles: where holes are, how deep, and where the axes stand behind them. What an operator's
// manual says: a call drills one hole where the tool stands, by Q200 (set-up clearance), Q201 (depth), Q203 (surface)
// and Q204 (second set-up clearance). Words are read anew (holes_by_words.h).
#pragma once

#include "judge/laws/heidenhain/scene.h"

namespace toolcomp::judge::laws {

// A call drills one hole, none with a depth of 0, and no other block drills. It lies at the programmed position of the
// axes across the tool, whatever contour, normal or datum shift came before. A move behind it starts from there, and
// along the tool from the level of return. Not in axes whose place is unknown; not how many where the depth is, and not
// how few where the run may have ended before.
void hole_where_programmed(const KlartextScene& scene, Holding& holding);

// A hole is along the tool axis, begins at the set-up clearance over the surface, from the shifted datum, and ends at
// the depth below it; the tool returns as far up as the greater clearance. Not where a parameter was given no value by
// the words, nor from the datum where its shift is unknown.
void hole_by_its_parameters(const KlartextScene& scene, Holding& holding);

// Behind a hole the axes stand at its position and its level of return, along the tool with the deltas of the length in
// force: those of the words, where the tool is known, and those of the last move without TCPM, if no tool and no
// correction was called since. All linear axes are known there. Rotary axes, where the event has them, stand at their
// words.
void hole_with_length(const KlartextScene& scene, Holding& holding);

}  // namespace toolcomp::judge::laws

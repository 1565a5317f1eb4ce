// SPDX-License-Identifier: Apache-2.0
// Laws of canned cycles: where holes are, how deep, and where the axes stand behind them. What an operator's manual
// says: in the drilling mode (DrillingMode) every block with a word of an axis or R drills, as often as K or L says.
// Words are read anew (holes_by_words.h); the three laws say nothing of programs with G43.4 or G43.5, nor while it is
// doubtful whether the mode is on (DrillingMode::clear).
#pragma once

#include "judge/laws/fanuc/scene.h"

namespace toolcomp::judge::laws {

// A block drills as many holes as it says, K before L, at the commanded positions: absolute ones, or one travel (G91)
// from where the axes stood, each repeat one travel from the one before; less the shift of G45 to G48 as it stood
// before the mode. Rotary axes stand where they are commanded. A move behind a hole starts from it, the drilling axis
// from the level of return. K0 drills nothing and moves nothing. Not in axes whose place is unknown (holes_by_words.h),
// whose word stands twice, or has degrees in least increments; not how many where K or L is no whole number up to 9999
// or has a point, and not how few where the run may have ended before.
void hole_where_commanded(const FanucScene& scene, Holding& holding);

// The drilling axis is Z, or with 5101#0 = 1 that at right angles to the plane. Point R is the R given last in the
// mode: itself if given under G90, from the initial level under G91; so is the bottom, from point R. The tool returns
// to the initial level under G98, to point R under G99; the initial level is where the drilling axis stood when the
// mode began, whatever came since. Not what the mode was not given, or was given absolute before coordinates were
// renamed in it, or where a shift of G45 to G48 may stand along the axis; not the level of G87 under G99, which no
// manual allows. Where it is unknown where the axis stood, or a shift stood along it, the initial level is that of the
// first return under G98.
void hole_levels(const FanucScene& scene, Holding& holding);

// Behind a hole the axes stand at its position and level, plus the length offset: nothing under G49; the offset of a
// move or hole before or behind it where no block between says otherwise (G43, G44, G49, H); the value of H in the axis
// of the offset where G43 or G44 and H stand in the block (types A and B); nothing in other axes (type A: than Z; type
// B: than those at right angles to a plane of the program). Up to the first G10 or G37 (the memory changes); not in
// programs with G28, G29, G30 or G53, nor from one to the other where coordinates may be renamed.
void hole_axes(const FanucScene& scene, Holding& holding);

}  // namespace toolcomp::judge::laws

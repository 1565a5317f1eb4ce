// SPDX-License-Identifier: Apache-2.0
// Metamorphic laws: a program is changed in a way whose effect is known from geometry. The model must run once more, so
// only a share of the trials is checked. The text of the program alone decides whether it is checked, and by which law.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "judge/laws/laws.h"

namespace toolcomp::judge::laws {

// The events of a case.
using Runner = std::function<std::vector<model::Event>(const spec::Case&)>;

// One of these, for FANUC programs up to the first block that cannot be read, without two blocks in one line:
//
// value-zero: with every offset zero (H, D, 19666; Klartext: every delta), points are the programmed points, and axes
// are the points if there is no tool center point control. After a hole the axes are at its position and level (FANUC:
// programs without G43.4 and G43.5). Chapter 14; heidenhain.face.effective-tip. Not with G10 or G37, nor under PROG
// PATH IS CONTOUR or with deltas in tool calls.
//
// mirrored: X mirrored, G41 with G42 and G02 with G03 exchanged, the events are mirrored. Not in G18 and G19, for
// length offset type C, with G37, with a tool direction or 3D compensation, nor for a control without X or Y.
//
// quarter-turn: turned about Z by 90 degrees, the events are turned. Exempt as above.
//
// a-tenth: with all lengths of program and setup a tenth as long, the events are a tenth as large. In the drilling mode
// Q is a length, K a count. Not with G10 or G37 (ranges and distances of the control), not with numbers in least
// increments (3401#0 = 0), not if numbers get too long, and not with K or Q if the mode is doubtful
// (DrillingMode::clear) or a code of group 01 cancels the cycle of the block.
//
// reversed: a contour of lines under cutter compensation C, run from its end with G41 and G42 exchanged, has the heads
// of every corner in reverse order (14.6.2 and 14.6.4 are mirror images). Only contours of plain blocks from the
// start-up to the cancelling move without a block between, with 5008#0 = 1 and without 5010; not type C (5003#1).
//
// moved-origins: the origin of every workpiece system is moved, each by its own distance, and the absolute words of its
// blocks are moved back, including R of a hole. The machine then does the same: machine positions stay, and other
// positions of an event are moved back by the distance of the system of its block. The machine uses nothing of a
// coordinate system except its origin. Not if G29 goes through a point of another system (it keeps coordinates), nor
// with G37 in two systems (so does the setup), P of G54.1 next to another code with P, or numbers that get too long;
// nor with canned cycles if the system changes in the drilling mode (point R and levels are kept), if no block of the
// mode gave R or the bottom of a hole, if coordinates were renamed since then, or if the mode is doubtful. Also asked
// of every program that selects a system.
//
// cut-at-a-stop: up to a block with M00 or M01, the events are those of the program that ends there, because a control
// that waits for its operator has not read further. For the first two such blocks; not if programs are called, nor with
// two blocks in one line. Also asked of every program with a compensation and such a block.
//
// The clauses use no other length, side or direction than those of program and setup, so their results are equivariant.
std::span<const std::string_view> changes();

// Checks the law of this name, whatever the share.
LawResult hold_changed(std::string_view law, const spec::Case& c, std::span<const model::Event> events,
                       const Runner& run);
// Checks one law for every sixteenth program, and the laws that are checked for every program of its kind.
LawResult hold_changed(const spec::Case& c, std::span<const model::Event> events, const Runner& run);

}  // namespace toolcomp::judge::laws

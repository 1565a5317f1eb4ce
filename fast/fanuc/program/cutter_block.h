// SPDX-License-Identifier: Apache-2.0
// What the interpreter hands to cutter compensation, B or C alike: one block, complete but for the vectors.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "fast/arithmetic/count.h"
#include "fast/basis/event.h"
#include "fast/fanuc/program/stage_end.h"
#include "spec/language/name.h"

namespace toolcomp::fast {

// What a block does in the compensation plane.
enum class CutterMotion : std::uint8_t {
  still,              // no axis word of the plane: M, S, T, G04, G10, other axes, codes or numbers alone
  zero,               // an axis word of the plane and no travel in it
  line,               // G00, G01
  arc,                // G02, G03; a full circle too
  corner_arc,         // G39; the programmed position stays
  to_machine,         // G53 (one event)
  to_intermediate,    // G28 G30 G30.1, first move
  to_reference,       // second move; always right after to_intermediate
  from_intermediate,  // G29, first move
  from_reference,     // second move; always right after from_intermediate
  shift,              // G92; the position of the named axes is called otherwise, nothing moves
};

// G40 G41 G42: the code of a block, or the side in force.
enum class CutterSide : std::uint8_t { unchanged, off, left, right };

// One block. Positions and lengths are exact, setup units, in the plane: [0] X of XY, Z of ZX, Y of YZ; [1] the axis
// that follows cyclically. Frame: the programmed path, without the shift of G45 to G48, length offset or vector; the
// event carries those two, so a stage adds its vector to event.point, event.axes and (where present) event.machine.
struct CutterBlock {
  // The block's own move: line, n, type, feed, tool_axis, arc (the programmed arc, its centre in the frame of `point`),
  // programmed, point and axes without vector. Filled also where the block has no own move, for a stage that makes one.
  Event event;
  bool own = false;            // the block makes that move (docs/events.md, rule 1)
  bool axis_word = false;      // any axis word that is a position; asked where the block ends the compensation
  std::optional<double> feed;  // F in force, for G39's arc: also under G00
  // G10: a setting, to be sent after the move of its block (event.line, event.n).
  bool sets = false;
  spec::Name setting;
  double setting_value = 0;

  CutterMotion motion = CutterMotion::still;
  CutterSide word = CutterSide::unchanged;  // the code in the block
  CutterSide side = CutterSide::off;        // in force after it; never unchanged
  bool d_word = false;                      // an offset number is commanded in the block
  std::uint32_t d = 0;                      // the number in force in the block
  Count offset;                             // its value, signed

  std::array<Count, 2> start{};
  std::array<Count, 2> end{};
  std::uint8_t named = 0;  // bit i: the axis word of plane axis i is there

  // I J (K I, J K) of the plane, a missing one 0, of a block that is no arc: the direction of B, G39 or G40; and for a
  // G39 with axis words the way from the current point to them. They are increments.
  bool has_direction = false;
  std::array<Count, 2> direction{};

  bool path_made = false;  // motion == line or arc only: the stage has made the path already

  // motion == arc only. Given by centre or by radius; event.arc has the nearest doubles of the centre and, where the
  // stage makes no arc of the tool's own, of sweep and radii.
  bool clockwise = false;
  bool by_radius = false;
  std::array<Count, 2> to_center{};  // from start; only where !by_radius
  Count radius;                      // R, negative for the arc above 180 degrees; only where by_radius

  spec::Plane plane = spec::Plane::xy;
  std::array<std::size_t, 2> axis{};  // indices of the plane axes in the events; spec::Axes::kNone: no such axis

  // motion == shift only, of a block with a code or with number 0: the own move in the coordinates after the renaming,
  // for a block that makes or removes a vector; `event` has those from before.
  Event renamed;
};

// What the words of a block command, before anything is changed: for the alarms that follow from words and state alone.
struct CutterCommand {
  CutterSide word = CutterSide::unchanged;
  bool arc = false;           // G02 or G03 in force, and an axis word of the plane or I J K or R
  bool corner_arc = false;    // G39
  bool axis_word = false;     // any axis word
  bool plane_word = false;    // one of the plane
  bool outside_word = false;  // one outside the plane
  bool letters = false;       // a letter I J K of the plane
  bool letters_zero = false;  // there are such letters, and all are 0
  bool no_direction = false;  // of G39: neither letters nor axis words of the plane, or what they give is zero
  bool d_word = false;        // an offset number is commanded
  std::uint32_t d = 0;        // the number in force in the block
};

}  // namespace toolcomp::fast

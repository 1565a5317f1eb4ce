// SPDX-License-Identifier: Apache-2.0
// One block on its way through the passes: where it goes and with what tool.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "model/basis/alarm.h"
#include "model/fanuc/program/motion.h"
#include "model/fanuc/program/offset_memory.h"
#include "model/geometry/vector.h"
#include "model/kinematics/coordinate.h"
#include "model/kinematics/tool_direction.h"
#include "model/kinematics/tool_pose.h"
#include "spec/language/event.h"

namespace toolcomp::model {

// Where a move goes, before compensation; a pass of compensation may change type, cause and arc.
struct Leg {
  spec::MoveType type = spec::MoveType::linear;
  spec::Cause cause = spec::Cause::programmed;
  Position end;   // programmed, workpiece coordinates
  Vector travel;  // X Y Z, from where the block starts, tool offset included
  // Arcs: centre in actual coordinates (programmed + shift), sweep and radii of the tool's own arc.
  std::optional<spec::Arc<Real>> arc;
  // By axis, actual minus programmed position at the end: tool offset G45–G48, or where a measuring move stopped.
  std::optional<std::array<Rational, spec::kMaxAxes>> shift;

  [[nodiscard]] Rational shift_of(std::size_t axis) const { return shift ? shift->at(axis) : 0; }
  // Where the tool is at the end, before compensation and length offset.
  [[nodiscard]] Coordinate actual(std::size_t axis) const {
    return shift ? end.at(axis) + Coordinate(shift->at(axis)) : end.at(axis);
  }
};

// A leg with everything that length offset, tool direction and compensation say about its end.
struct Move {
  Leg leg;
  Vector offset;                            // compensation vector at the end, X Y Z
  std::array<Real, spec::kMaxAxes> length;  // length offset, by axis
  Direction tool;                           // at the end
  SharedZero zero;                          // of the workpiece, where it is asked for
  bool machine = false;                     // machine coordinates are reported
  std::optional<Real> feed;
  std::optional<ToolPose> tip;              // under tool center point control, which then makes the axes of it
  std::shared_ptr<const OwnMotion> inside;  // of the own move of a block run under it
};

// What a pass of compensation says before the moves of a block.
struct Warning {
  spec::Name number;
  const char* message = "";  // static text
  spec::ClauseList clauses;
};

// A hole of a canned cycle. `move`: its position, the drilling axis at the level of return, with the offsets in force.
struct DrilledHole {
  Move move;
  std::size_t axis = 0;  // the drilling axis
  Coordinate point_r;    // workpiece coordinates, as programmed
  Coordinate bottom;
};

// What a block says to each pass of compensation; nothing if it does not concern the pass. Only the pass looks inside.
struct EdgeBlock;
struct CutterBlock;
struct ToolSideBlock;
struct StepWords {
  std::shared_ptr<EdgeBlock> edge;
  std::shared_ptr<CutterBlock> cutter;
  std::shared_ptr<ToolSideBlock> side;

  [[nodiscard]] bool any() const { return edge || cutter || side; }
};

// A block ready to be compensated.
struct Step {
  std::uint64_t line = 0;
  std::optional<std::uint64_t> n;
  // In order: none, one, or the two of a reference return or of a measurement. After a pass of compensation also the
  // moves it inserts.
  std::vector<Move> moves;
  std::vector<DrilledHole> holes;  // in their place: no compensation is on
  // The place where the block ends, for a move inserted there; its type is that of group 01. Present if some pass
  // has words.
  Move rest;
  bool has_word = false;  // a word other than N and O
  bool stops_look_ahead = false;
  bool ends_program = false;
  StepWords words;
  std::optional<Warning> warning;
  SharedZero zero;                       // behind the block, where motions are asked for
  std::optional<OffsetSetting> setting;  // written at the end of the block
  std::optional<Alarm> alarm;            // that shows by its motion, once its moves are made
  spec::ClauseList clauses;
};
// From pass to pass: a step is large.
using OwnedStep = std::unique_ptr<Step>;

}  // namespace toolcomp::model

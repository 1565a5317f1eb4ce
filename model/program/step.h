// One block on its way through the stages: where it goes and with what tool.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/geometry/arc.h"
#include "model/geometry/vector.h"
#include "model/kinematics/tool_direction.h"
#include "model/program/coordinate.h"
#include "spec/language/event.h"

namespace toolcomp::model {

// Where a move goes, before compensation.
struct Leg {
  spec::MoveType type = spec::MoveType::linear;
  spec::Cause cause = spec::Cause::programmed;
  Position end;   // programmed, workpiece coordinates
  Vector travel;  // X Y Z, from where the block starts
  std::optional<spec::Arc<Real>> arc;
};

// A leg with everything the length offset and the tool direction say about its end.
struct Move {
  Leg leg;
  std::array<Real, spec::kMaxAxes> length;  // length offset, by axis
  Direction tool;                           // at the end
  std::optional<std::array<Real, spec::kMaxAxes>>
      zero;  // machine coordinate of the workpiece zero, where it is reported
  std::optional<Real> feed;
};

// What a block says to the leading edge offset.
enum class EdgeCommand : std::uint8_t { none, start, cancel };

// A block ready to be compensated.
struct Step {
  std::uint64_t line = 0;
  std::optional<std::uint64_t> n;
  std::vector<Move> moves;  // in order: none, one, or the two of a reference return
  Move rest;                // the place where the block ends, for a move inserted there; its type is that of group 01
  bool has_word = false;    // a word other than N and O
  bool travels = false;     // a linear movement, X Y Z
  bool stops_look_ahead = false;
  EdgeCommand edge = EdgeCommand::none;
  Rational radius;  // offset of the D number in force at the end of the block, where the leading edge offset is active
  spec::ClauseList clauses;
};

}  // namespace toolcomp::model

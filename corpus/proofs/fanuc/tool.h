// Tool directions as the proofs read them, from programs and setups.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "corpus/proofs/fanuc/program.h"

namespace toolcomp::corpus {

using Vector3 = std::array<double, 3>;

double dot(const Vector3& a, const Vector3& b);
Vector3 cross(const Vector3& a, const Vector3& b);
Vector3 approximate(const Exact3& v);

// A tool direction as Coq reads it, to double precision, and exactly where it is rational.
struct Tool {
  std::string text;
  Vector3 about{};
  std::optional<Exact3> exactly;
};

// Positions of rotary axes are not the angles that turn the tool: they have zeros, or G92 may give them some.
bool has_rotary_zeros(const spec::Case& c, const Blocks& blocks);

// The direction in force at the end of an event's block: I J K under G43.5, Z of a setup that turns no tool, or a plain
// tool rotation head (19680 = 2, axes along X Y Z, no tilt, no reversed sense), exactly where it turns by right angles.
// Nothing for other kinematics.
std::optional<Tool> tool_of(const spec::Case& c, const Blocks& blocks, const spec::TextEvent& event);

// Is the clause with this id in the event's list?
bool rests_on(const spec::TextEvent& event, std::string_view clause);

}  // namespace toolcomp::corpus

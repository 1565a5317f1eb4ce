// SPDX-License-Identifier: Apache-2.0
// The rotary axes of a machine in double, for scales and conditions. They are read from the setup here, independently
// of both engines.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "judge/oracle/corner.h"
#include "spec/language/setup.h"

namespace toolcomp::judge {

// Parameters 19680 to 19714. The tool-side axis tilts the tool against the work, the work-side axis carries it, or the
// work, around; both turn right-handed by their sense times their position.
struct RotaryMachine {
  enum class Type : std::uint8_t { head, table, mixed };

  Type type = Type::head;
  std::size_t tool = spec::Axes::kNone;  // the tool-side axis; kNone: hypothetical
  std::size_t work = spec::Axes::kNone;
  double tool_angle = 0;  // at the position 0, degrees: of a hypothetical axis, or if positions have a zero
  double work_angle = 0;
  double tool_sense = 1;
  double work_sense = 1;
  Space tool_line{};   // unit, with both axes at 0
  Space work_line{};   // unit
  Space reference{};   // tool direction with both axes at 0, unit
  Space table{};       // 19700–19702
  Space table_step{};  // 19703–19705
  Space head{};        // 19709–19711
  Space head_step{};   // 19712–19714
  double length = 0;   // the longest tool: largest H value and holder offset (19666)

  // std::nullopt if 19680 is 0 or has no valid value: then a direction is I J K itself.
  static std::optional<RotaryMachine> of(const spec::Setup& setup);

  // The tool direction seen from the table at its zero pose; positions in degrees.
  [[nodiscard]] Space direction(double tool_position, double work_position) const;
};

// The largest H value plus the holder offset (19666). No tool is longer.
double longest_tool(const spec::Setup& setup);

// v rotated about a unit vector by an angle in degrees, right-handed.
Space rotated(const Space& v, const Space& about, double degrees);

// The errors of a position of the tool-side axis, and of the azimuth that is left to the work-side axis, for a small
// error of the direction from which they are computed. All in radians.
struct Posture {
  double polar_sine = 0;   // of the angle between the tool and the work-side axis
  double height_rate = 0;  // |d cos(polar)/d tool| and its own rate: 0 at a pole and at an edge of reach
  double height_bend = 0;
  double azimuth_rate = 0;  // d azimuth/d tool
  bool singular = false;    // no azimuth at all, within double precision
  bool at_a_pole = true;    // the edge of reach nearest to it is a singular posture

  Posture(const RotaryMachine& machine, double tool_position);
  // The root of rate δ + bend δ²/2 = sine e + e²/2: δ is e at a pole of an orthogonal machine and √(2e) at an edge. If
  // the edge is not a pole, the height itself is compared with it, and its rounding, e, is on the right side.
  [[nodiscard]] double tool_error(double direction_error) const;
  [[nodiscard]] double work_error(double direction_error) const;
};

}  // namespace toolcomp::judge

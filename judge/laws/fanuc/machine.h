// SPDX-License-Identifier: Apache-2.0
// A five-axis machine out of its parameters: where tool and table stand at given rotary positions. Forward kinematics
// written anew from the clauses fanuc.tool-direction.* and fanuc.tool-center-point.control-point-*.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "judge/laws/certainty.h"
#include "spec/language/setup.h"

namespace toolcomp::judge::laws {

// Columns of an orthogonal matrix: the images of X, Y and Z.
using Turn = std::array<Vector, 3>;
Vector operator*(const Turn& turn, const Vector& v);
Turn operator*(const Turn& first, const Turn& second);
Turn inverse(const Turn& turn);

// Of 19680: head, table, head and table.
enum class MachineType : std::uint8_t { tool = 2, table = 12, mixed = 21 };

class Machine {
 public:
  // Nothing for a setup without 19680, with an axis that is hypothetical or missing, or with codes that no clause has.
  static std::optional<Machine> of(const spec::Setup& setup);

  [[nodiscard]] MachineType type() const { return type_; }
  // Indices of the first and the second rotary axis among the axes of the setup.
  [[nodiscard]] const std::array<std::size_t, 2>& axes() const { return axis_; }

  // R(u1, s1 θ1) and R(u2, s2 θ2) at mechanical positions in degrees.
  [[nodiscard]] std::array<Turn, 2> turns(const std::array<Real, 2>& degrees) const;
  // What turns the table: M, the identity for a head.
  [[nodiscard]] Turn table(const std::array<Turn, 2>& turns) const;
  // Direction from tip to holder in the machine.
  [[nodiscard]] Vector tool(const std::array<Turn, 2>& turns) const;
  // From the tip to the control point, in the machine.
  [[nodiscard]] Vector holder(const std::array<Turn, 2>& turns, const Real& length) const;
  // A point of the machine as the table at its zero pose has it; and back.
  [[nodiscard]] Vector on_table(const std::array<Turn, 2>& turns, const Vector& p) const;
  [[nodiscard]] Vector in_machine(const std::array<Turn, 2>& turns, const Vector& q) const;
  // Whether the tool can lean any way: not where the axis that tilts it is parallel to it, or to the other axis.
  [[nodiscard]] bool leans_any_way() const;
  // The axis that leans the tool against the work, and the other: indices into axes().
  [[nodiscard]] std::size_t tool_side() const { return type_ == MachineType::tool ? 1 : 0; }
  [[nodiscard]] std::size_t work_side() const { return 1 - tool_side(); }
  // Direction of the work-side axis at the zero pose: along it and against it postures are singular, where the tool
  // reaches them.
  [[nodiscard]] const Vector& singular() const { return direction_.at(work_side()); }
  // Tool-side axis across the tool and across the work-side axis.
  [[nodiscard]] bool is_orthogonal() const;
  // Zero where the tool-side axis at this position leans the tool least or most against the work-side axis; the sign
  // tells on which side of that it stands.
  [[nodiscard]] Real side(const Real& degrees) const;
  // 19666.
  [[nodiscard]] const Real& holder_offset() const { return holder_offset_; }

 private:
  MachineType type_{};
  std::array<std::size_t, 2> axis_{};
  std::array<Vector, 2> direction_;
  std::array<int, 2> sense_{};
  Vector reference_;      // t0
  Vector table_;          // 19700 to 19702
  Vector between_;        // 19703 to 19705
  Vector tool_to_axis_;   // 19709 to 19711
  Vector axis_to_first_;  // 19712 to 19714
  Real holder_offset_;
};

// Turn about a unit axis by an angle in degrees, right hand.
Turn turn_about(const Vector& axis, const Real& degrees);

}  // namespace toolcomp::judge::laws

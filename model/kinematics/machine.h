// SPDX-License-Identifier: Apache-2.0
// A machine with two rotary axes: tool direction and control point from the positions of its axes.
#pragma once

#include <cstddef>
#include <vector>

#include "model/geometry/vector.h"
#include "model/kinematics/angle.h"
#include "model/kinematics/coordinate.h"
#include "model/kinematics/mechanism.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Angles of the two rotary axes, those that turn tool and table: machine coordinates, or programmed ones
// (fanuc.tool-direction.rotary-angles). The tool-side axis tilts the tool against the work: the slave of a tool
// rotation head, the master of a rotary table, the head's axis of a mixed machine.
struct Pose {
  Angle tool;
  Angle work;
};
// Certified; throws exact::Undecided.
inline bool operator==(const Pose& a, const Pose& b) { return a.tool == b.tool && a.work == b.work; }

// A posture at which the work-side position is arbitrary.
struct SingularPosture {
  int side = 1;      // 1: along the work-side axis, -1: against it
  Vector direction;  // that axis or its opposite, in the table frame; unit
  Angle tool;        // the tool-side position, principal
};

// Directions are from the tip to the holder, in the table frame, that is as seen from the table at its zero pose.
// Clauses: fanuc.tool-direction.*, fanuc.tool-center-point.*.
class Machine {
 public:
  // Parameters 19680-19690 and 19697-19714. Throws spec::InputError naming the parameter that makes no sense; 19680
  // must not be 0.
  explicit Machine(const spec::Setup& setup);

  [[nodiscard]] MachineType type() const { return mechanism_.type; }
  [[nodiscard]] const Turn& tool_side() const { return mechanism_.turns.front(); }
  [[nodiscard]] const Turn& work_side() const { return mechanism_.turns.back(); }

  // Setup units, parallel to the machine axes with both rotary axes at 0.
  struct Arms {
    Vector table;       // 19700-19702: machine origin to the first table axis
    Vector table_step;  // 19703-19705: first to second table axis
    Vector head;        // 19709-19711: tool axis to its rotary axis
    Vector head_step;   // 19712-19714: second to first rotary axis of a head
  };
  [[nodiscard]] const Arms& arms() const { return arms_; }
  // Tip to holder with both axes at 0; unit.
  [[nodiscard]] const Vector& reference() const { return mechanism_.reference; }
  // Parameter 19696#5: points are programmed in the workpiece coordinate system, which does not turn with the table.
  [[nodiscard]] bool programs_workpiece() const { return programs_workpiece_; }

  // A hypothetical axis stands at 0: its fixed angle is in the offset of its turn.
  [[nodiscard]] Pose pose(const Position& angles) const;
  // Into the programmed positions of the axes; `zero`: their angles where those are 0.
  void place(const Pose& pose, const Pose& zero, Position& position) const;

  // Of a pose; unit.
  [[nodiscard]] Vector direction(const Pose& pose) const;
  // The same with the table turned back about the work-side axis from a position: as if that were its 0.
  [[nodiscard]] Vector direction_beside(const Pose& pose, const Angle& work) const;
  // The same seen from the machine, that is in the workpiece coordinate system.
  [[nodiscard]] Vector direction_in_machine(const Pose& pose) const;
  // The direction that the tool-side axis gives the tool before the work-side axis turns it; unit.
  [[nodiscard]] Vector tilted(const Angle& tool) const { return tool_side().apply(mechanism_.reference, tool); }

  // The constants of the inverse kinematics: with the reference direction split along and across the tool-side axis,
  // the height of a tilted direction over the plane across the work-side axis is
  //   mean + a cos(turn) + b sin(turn), turn = sense * (position + offset) of the tool-side axis.
  struct Heights {
    Vector along;   // the part of the reference direction along the tool-side axis
    Vector across;  // the rest
    Vector ahead;   // that rest a quarter turn on
    Real mean;
    Real a;
    Real b;
    Real swing2;  // a^2 + b^2
  };
  [[nodiscard]] const Heights& heights() const { return heights_; }
  // Both rotary axes can move, and the tool-side axis changes the height at all: directions have computed angles.
  [[nodiscard]] bool is_invertible() const { return tilts_ && tool_side().axis && work_side().axis; }
  // The axes are at right angles, and the reference direction is to the tool-side one. Along every great circle through
  // a singular posture the work-side axis stands and the tool-side axis turns evenly.
  [[nodiscard]] bool is_orthogonal() const { return orthogonal_; }
  // Those that exist, along the work-side axis first. The existence is decided exactly.
  [[nodiscard]] const std::vector<SingularPosture>& singular_postures() const { return singular_; }
  // The one of a side, null if it does not exist.
  [[nodiscard]] const SingularPosture* singular(int side) const;

 private:
  friend class ProgrammingFrame;

  void find_heights();
  void find_singular_postures();
  // Where the table carries a point, machine coordinates, from one pose to another.
  [[nodiscard]] Vector carried(const Vector& point, const Pose& from, const Pose& to) const;
  // From the tip of a tool of this length to the control point, parallel to the machine axes.
  [[nodiscard]] Vector tool_vector(const Pose& pose, const Real& length) const;

  Mechanism mechanism_;
  Arms arms_;
  bool programs_workpiece_ = false;
  Heights heights_;
  bool tilts_ = false;
  bool orthogonal_ = false;
  std::vector<SingularPosture> singular_;
};

// The programming coordinate system of tool center point control: the copy of the workpiece coordinate system attached
// to the table at the pose where the G43.4 or G43.5 block ends. Points and directions "in the frame" are of that copy;
// under 19696#5 = 1 programmed points are converted into it first.
class ProgrammingFrame {
 public:
  // `frozen`: that pose. `origin`: machine coordinates X Y Z of the workpiece zero.
  ProgrammingFrame(const Machine& machine, Pose frozen, Vector origin);

  // A direction of the frame as the table frame sees it, and back.
  [[nodiscard]] Vector to_table(const Vector& direction) const;
  [[nodiscard]] Vector from_table(const Vector& direction) const;
  // The same but for the turn about the work-side axis by its frozen position: as if that were its 0.
  [[nodiscard]] Vector to_table_beside(const Vector& direction) const;
  [[nodiscard]] const Pose& frozen() const { return frozen_; }
  // Machine coordinates of the workpiece zero.
  [[nodiscard]] const Vector& origin() const { return origin_; }
  // Of a pose, in the frame; unit.
  [[nodiscard]] Vector direction(const Pose& pose) const;
  // u_w, unit, in the frame.
  [[nodiscard]] Vector work_axis() const;

  // Control point minus workpiece zero, parallel to the machine axes. `tip` in the frame; `length`: tool length offset
  // and holder offset.
  [[nodiscard]] Vector control_point(const Vector& tip, const Pose& pose, const Real& length) const;
  // Where a point of the frame stands in the workpiece coordinate system, and back (19696#5 = 1).
  [[nodiscard]] Vector in_workpiece(const Vector& tip, const Pose& pose) const;
  [[nodiscard]] Vector of_workpiece(const Vector& point, const Pose& pose) const;

 private:
  const Machine* machine_;
  Pose frozen_;
  Vector origin_;
};

}  // namespace toolcomp::model

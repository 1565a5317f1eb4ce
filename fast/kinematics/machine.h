// SPDX-License-Identifier: Apache-2.0
// The machine as tool center point control sees it: types 2, 12 and 21 of No. 19680
// (fanuc.tool-center-point.inverse, choice, control-point-*).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "fast/kinematics/kinematics.h"
#include "fast/kinematics/polar_frame.h"
#include "fast/kinematics/pose.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// Sine and cosine of both rotary positions, 1st and 2nd.
template <class T>
using Turns = std::array<SineCosine<T>, 2>;

inline Turns<double> turns(const Pose& pose) { return {pose.axis[0].turn, pose.axis[1].turn}; }

// Forward, inverse, the choice of a pair of rotary positions, and the way from the tip to the control point.
// Vectors are in the directions of the machine axes; lengths in setup units, angles in degrees.
class Machine {
 public:
  // Reads 19608#5, 19666, 19680, 19696#5, 19700 to 19705, 19709 to 19714, 19741 to 19744; the rotary axes are those of
  // `kinematics`, which also keeps the frame of the mode: it is what refines directions.
  Machine(const spec::Setup& setup, Kinematics& kinematics);

  [[nodiscard]] bool defined() const { return type_ != 0; }  // 19680 is not 0
  [[nodiscard]] int type() const { return type_; }
  // The axis of the setup that is the 1st, 2nd rotary axis; spec::kMaxAxes for a hypothetical one.
  [[nodiscard]] std::size_t rotary_axis(std::size_t i) const { return axis_[i].index; }
  // Which of the two, 0 or 1, is the tool-side and the work-side axis.
  [[nodiscard]] std::size_t tool_side() const { return tool_side_; }
  [[nodiscard]] std::size_t work_side() const { return 1 - tool_side_; }
  [[nodiscard]] double sense(std::size_t i) const { return axis_[i].sense; }  // sigma: +1 or -1
  [[nodiscard]] bool hypothetical() const { return rotary_axis(0) == kNone || rotary_axis(1) == kNone; }
  // A head without offsets: the control point lies on the axis of the tool.
  [[nodiscard]] bool along_tool() const { return along_tool_; }
  [[nodiscard]] bool has_table() const { return type_ == 12 || type_ == 21; }
  [[nodiscard]] bool workpiece_frame() const { return workpiece_frame_; }      // WKP, 19696#5
  [[nodiscard]] const Count& holder_offset() const { return holder_offset_; }  // 19666
  [[nodiscard]] bool ranges_valid() const { return ranges_valid_; }            // no lower limit above the upper one
  // Axis i of the pose is inside 19741 to 19744; the limits belong to the range.
  [[nodiscard]] bool in_range(const Pose& pose, std::size_t i) const { return !axis_[i].limited || in_limits(pose, i); }
  // A direction can be reached by both axes: both turn (are not hypothetical), and rho is not 0.
  [[nodiscard]] bool invertible() const { return !hypothetical() && polar_.invertible(); }

  // --- poses -------------------------------------------------------------------------------------------------------
  // Machine positions of the zeros of commanded positions, by axis index, those of `kinematics`; at first 0. They do
  // not change in the mode.
  void set_zeros(const std::array<Count, spec::kMaxAxes>& zero);
  // The pose at commanded positions (by axis index of the setup). Bit i of `rounded`: position[i] was computed.
  void pose(const std::array<Count, spec::kMaxAxes>& position, std::uint16_t rounded, Pose& pose);
  // The same without `seen`, `psi` and `branch`, which inverse kinematics and tool posture control alone look at.
  void attitude(const std::array<Count, spec::kMaxAxes>& position, std::uint16_t rounded, Pose& pose);
  // The position of axis i of a pose as a count; within 2^-63 rad unless it is exact.
  [[nodiscard]] Count count(const Pose& pose, std::size_t i) const;
  // The same as it is commanded; and rounded.
  [[nodiscard]] Count programmed(const Pose& pose, std::size_t i) const { return count(pose, i) - axis_[i].zero; }
  [[nodiscard]] double programmed_degrees(const Pose& pose, std::size_t i) const {
    const RotaryPosition& rotary = pose.axis[i];
    if (axis_[i].zero_degrees == 0) [[likely]]
      return rotary.degrees;
    if (rotary.kind == RotaryPosition::Kind::inverse) return programmed_degrees(rotary.degrees, i);
    return (rotary.count - axis_[i].zero).nearest();
  }
  [[nodiscard]] double programmed_degrees(double degrees, std::size_t i) const {
    return degrees - axis_[i].zero_degrees;
  }
  // Sines and cosines of a pose in double-double.
  [[nodiscard]] Turns<DoubleDouble> fine_turns(const Pose& pose) const;

  // --- the programming coordinate system ---------------------------------------------------------------------------
  // Fixes the programming coordinate system to the table at this pose (WKP = 0), or to the workpiece (WKP = 1). The
  // direction of `pose` is written in it.
  void freeze(Pose& pose);
  // Ends it: directions are seen from the table at its zero pose again. Poses made before are to be made anew.
  void release();

  // --- inverse -----------------------------------------------------------------------------------------------------
  // The pair for `tool` (programming coordinate system) by fanuc.tool-center-point.choice from the present pose,
  // inside the movement ranges. False: PS5459. `end` may not be `present`.
  [[nodiscard]] bool choose(const Direction& tool, const Pose& present, Pose& end) const;

  // --- tip and control point ---------------------------------------------------------------------------------------
  // All in workpiece coordinates parallel to the machine axes: machine coordinates minus `origin`, the machine position
  // of the workpiece origin. T is double or DoubleDouble. Heads: the table stands still.
  // The control point (fanuc.tool-center-point.control-point-*) of a tip that is given on the table: under WKP = 0 in
  // the programming coordinate system, under WKP = 1 as to_table() makes it.
  template <class T>
  [[nodiscard]] Vector3<T> control_point(const Vector3<T>& table_tip, const Turns<T>& turns, const T& length,
                                         const Vector3<T>& origin) const;
  // The point of the table that at this pose stands at `tip` of the workpiece system, and back.
  template <class T>
  [[nodiscard]] Vector3<T> to_table(const Vector3<T>& tip, const Turns<T>& turns, const Vector3<T>& origin) const;
  template <class T>
  [[nodiscard]] Vector3<T> from_table(const Vector3<T>& table_tip, const Turns<T>& turns,
                                      const Vector3<T>& origin) const;
  // A direction seen from the table at its zero pose, as it stands in the machine at this pose.
  template <class T>
  [[nodiscard]] Vector3<T> in_machine(const Vector3<T>& on_table, const Turns<T>& turns) const;

  // The tool direction that events report at a pose: in the programming coordinate system.
  [[nodiscard]] Vector3<double> tool_at(const Turns<double>& turns) const;

  // --- for tool posture control ------------------------------------------------------------------------------------
  [[nodiscard]] const PolarFrame& polar() const { return polar_; }
  [[nodiscard]] const Kinematics& kinematics() const { return kinematics_; }
  // Tool directions of events are those of the machine: WKP = 1 on a table.
  [[nodiscard]] bool reports_machine_directions() const { return frozen_ && workpiece_frame_ && has_table(); }
  // From the table at its zero pose into the programming coordinate system that is frozen.
  [[nodiscard]] Vector3<double> in_frame(const Vector3<double>& on_table) const {
    return kinematics_.frame().turned ? in_turned_frame(on_table) : on_table;
  }
  [[nodiscard]] FineVector fine_in_frame(const Vector3<DoubleDouble>& on_table) const;
  // A direction as the system of the work-side axis has it; `relative` as in Pose.
  [[nodiscard]] Vector3<double> seen(const Direction& tool, bool& relative) const;
  [[nodiscard]] Vector3<DoubleDouble> fine_seen(const Direction& tool) const;
  // Sines and cosines of both positions from those of psi and of the mechanical angle of the work-side axis.
  template <class T>
  [[nodiscard]] Turns<T> turns_of(const SineCosine<T>& psi, const SineCosine<T>& work) const;

  // The same into the turns of the tool-side and the work-side axis.
  void set_turns(const SineCosine<double>& psi, const SineCosine<double>& work, SineCosine<double>& tool_turn,
                 SineCosine<double>& work_turn) const {
    const SineCosine<double>& phase = polar_.constants().phase;
    tool_turn.sine = (psi.sine * phase.cosine + psi.cosine * phase.sine) * axis_[tool_side_].sense;
    tool_turn.cosine = psi.cosine * phase.cosine - psi.sine * phase.sine;
    work_turn.sine = work.sine * axis_[work_side()].sense;
    work_turn.cosine = work.cosine;
  }

  // The pose of the pair on a branch (+1, -1), at the whole turns nearest to `near`: the tool-side position, the
  // work-side one. The way from there.
  DoublePair set_pair(const PolarPairs& pairs, int branch, DoublePair near, Pose& pose) const;
  // Sine and cosine of psi.
  [[nodiscard]] SineCosine<double> psi_of(const Pose& pose) const {
    const SineCosine<double>& phase = polar_.constants().phase;
    const SineCosine<double>& turn = pose.axis[tool_side_].turn;
    const double sine = axis_[tool_side_].sense * turn.sine;
    return {sine * phase.cosine - turn.cosine * phase.sine, turn.cosine * phase.cosine + sine * phase.sine};
  }
  // A computed position.
  void set_rounded(Pose& pose, std::size_t i, const Count& count) const;
  // The principal positions of the pair on a branch.
  [[nodiscard]] std::array<Count, 2> fine_pair(const PolarRoots& roots, int branch) const;
  // psi and branch from the tool-side position.
  void set_branch(Pose& pose) const;
  // The same of a pose on this branch, not singular: a position may be too near a singular posture to tell.
  void set_branch(Pose& pose, int branch) const;
  // Everything of a pose but its axes.
  void set_direction(const Direction& tool, Pose& pose) const;
  // The same where it is known in double-double: near a singular posture the azimuth needs it.
  static void set_direction(const Direction& tool, const Vector3<DoubleDouble>& seen, Pose& pose);

 private:
  static constexpr std::size_t kNone = spec::kMaxAxes;
  struct Axis {
    std::size_t index = kNone;
    double sense = 1;       // sigma: of the direction seen from the work
    double mechanical = 1;  // s: of the mechanical rotation
    Vector3<DoubleDouble> fine_line;
    Vector3<double> line;
    std::size_t along = kNone;  // 0, 1, 2: the line is X, Y, Z
    Count fixed;                // hypothetical
    Count zero;                 // of commanded positions
    double zero_degrees = 0;
    bool limited = false;
    Count lower, upper;
    double least = 0;  // the same rounded
    double most = 0;
  };
  struct Vectors {  // of the control point, constant
    Vector3<DoubleDouble> fine;
    Vector3<double> rough;
    template <class T>
    [[nodiscard]] const Vector3<T>& get() const {
      if constexpr (std::is_same_v<T, double>)
        return rough;
      else
        return fine;
    }
  };
  [[nodiscard]] Vector3<double> in_turned_frame(const Vector3<double>& on_table) const;
  DoublePair set_pair_here(const PolarPairs& pairs, int branch, DoublePair near, Pose& pose) const;
  [[nodiscard]] bool in_limits(const Pose& pose, std::size_t i) const;
  // The branch of the pair that moves the axis judged first by less; 0 where doubles cannot tell.
  [[nodiscard]] int nearer(const PolarPairs& pairs, const Pose& present) const;
  // pair_in_doubles.cpp: what choose_fine() would choose. False where doubles cannot tell.
  [[nodiscard]] bool choose_in_doubles(const Direction& tool, const Pose& present, Pose& end) const;
  // Pairs of positions inside the movement ranges, in units of counts, and their branches.
  struct FinePair {
    std::array<Int128, 2> value{};
    int branch = 1;
  };
  struct FinePairs {
    std::array<FinePair, 8> pair;
    std::size_t size = 0;
  };
  // Those that a direction allows, each at the whole turns next to where the axes stand.
  [[nodiscard]] FinePairs fine_pairs(const PolarRoots& roots, Reach reach, const std::array<Int128, 2>& from) const;
  [[nodiscard]] bool choose_fine(const Direction& tool, const Pose& present, Pose& end) const;
  template <class T>
  [[nodiscard]] Vector3<T> turn(std::size_t i, const Vector3<T>& v, const SineCosine<T>& by, bool back = false) const;
  template <class T>
  [[nodiscard]] const Turns<T>& frozen_turns() const;
  template <class T>
  [[nodiscard]] Vector3<T> on_machine(const Vector3<T>& table_tip, const Turns<T>& turns,
                                      const Vector3<T>& origin) const;

  Kinematics& kinematics_;
  PolarFrame polar_;
  int type_ = 0;
  std::size_t tool_side_ = 0;
  std::array<Axis, 2> axis_;
  std::size_t judged_first_ = 0;  // by PRI, 19608#5
  bool workpiece_frame_ = false;
  bool ranges_valid_ = true;
  Count holder_offset_;
  Vectors table_;         // 19700 to 19702: from the machine origin to A
  Vectors second_table_;  // 19703 to 19705: from A to B
  Vectors tool_offset_;   // 19709 to 19711: from D to E
  Vectors head_offset_;   // 19712 to 19714: from E to F
  Vectors zero_;          // t0
  bool along_tool_ = false;
  bool frozen_ = false;
  bool frozen_at_zero_ = true;  // the table stood at 0
  Turns<double> frozen_rough_{};
  Turns<DoubleDouble> frozen_fine_{};
};

template <class T>
[[gnu::always_inline]] inline Turns<T> Machine::turns_of(const SineCosine<T>& psi, const SineCosine<T>& work) const {
  const auto& c = [this]() -> const PolarFrame::Constants<T>& {
    if constexpr (std::is_same_v<T, double>)
      return polar_.constants();
    else
      return polar_.fine_constants();
  }();
  const SineCosine<T> tool{(psi.sine * c.phase.cosine + psi.cosine * c.phase.sine) * axis_[tool_side_].sense,
                           psi.cosine * c.phase.cosine - psi.sine * c.phase.sine};
  const SineCosine<T> turned_work{work.sine * axis_[work_side()].sense, work.cosine};
  // Not by index: a processor that reads back what it has just written to an address it had to compute waits.
  return tool_side_ == 0 ? Turns<T>{tool, turned_work} : Turns<T>{turned_work, tool};
}

}  // namespace toolcomp::fast

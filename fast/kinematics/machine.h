// The machine as tool center point control sees it: types 2, 12 and 21 of No. 19680 (posture sheet 3 to 5 and 17).
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
// Vectors are in the directions of the machine axes; lengths in setup units.
class Machine {
 public:
  // Reads 19666, 19680 to 19690, 19697 to 19714, 19741 to 19744, 19608#5, 19696#5. Throws spec::InputError naming the
  // parameter. `kinematics` keeps the frame of the mode: it is what refines directions.
  Machine(const spec::Setup& setup, Kinematics& kinematics);

  [[nodiscard]] bool defined() const { return type_ != 0; }  // 19680 is not 0
  [[nodiscard]] int type() const { return type_; }
  // The axis of the setup that is the 1st, 2nd rotary axis; spec::kMaxAxes for a hypothetical one.
  [[nodiscard]] std::size_t rotary_axis(std::size_t i) const { return index_[i]; }
  [[nodiscard]] bool hypothetical() const { return index_[0] == spec::kMaxAxes || index_[1] == spec::kMaxAxes; }
  [[nodiscard]] bool has_table() const { return type_ == 12 || type_ == 21; }
  [[nodiscard]] bool workpiece_frame() const { return workpiece_frame_; }      // WKP, 19696#5
  [[nodiscard]] const Count& holder_offset() const { return holder_offset_; }  // 19666
  [[nodiscard]] bool ranges_valid() const { return ranges_valid_; }            // no lower limit above the upper one
  [[nodiscard]] bool in_range(std::size_t i, const RotaryPosition& p) const;   // 19741 to 19744, inclusive
  // An I J K direction can be reached at all: both axes are real, and rho is not 0.
  [[nodiscard]] bool invertible() const { return !hypothetical() && polar_.invertible(); }

  // --- poses -------------------------------------------------------------------------------------------------------
  // The pose at commanded positions (degrees, by axis index of the setup). `rounded`: those that are not exact.
  void pose(const std::array<Count, spec::kMaxAxes>& position, std::uint16_t rounded, Pose& pose);
  // The position of axis i of a pose as a count; rounded where it is computed (kind is not exact).
  [[nodiscard]] Count count(const Pose& pose, std::size_t i) const;

  // --- the programming coordinate system -----------------------------------------------------------------------------
  // Fixes the programming coordinate system to the table at this pose (WKP = 0), or to the workpiece (WKP = 1: no
  // turn). The direction of `pose` is written in the new system.
  void freeze(Pose& pose);
  // Ends it: directions are seen from the table at its zero pose again. Poses made before are to be made anew.
  void release();

  // --- inverse -------------------------------------------------------------------------------------------------------
  // The pair for `tool` (programming coordinate system) by the rules of sheet 4 from the present pose, inside the
  // movement ranges. False: PS5459. `end` may not be `present`.
  [[nodiscard]] bool choose(const Direction& tool, const Pose& present, Pose& end) const;

  // --- tip and control point -----------------------------------------------------------------------------------------
  // All in workpiece coordinates parallel to the machine axes (machine coordinates minus origin W); `origin` is W, the
  // machine position of the workpiece origin. `tip` is in the programming coordinate system: for WKP = 0 the copy
  // attached to the table at the frozen pose, for WKP = 1 and heads the workpiece system itself.
  // T over double or DoubleDouble.
  // Control point (F, D or E of sheet 5) of a tip given on the table (table_point for WKP = 1).
  template <class T>
  [[nodiscard]] Vector3<T> control_point(const Vector3<T>& table_tip, const Turns<T>& turns, const T& length,
                                         const Vector3<T>& origin) const;
  // The tip fixed to the table (as at the frozen pose under WKP = 0, at the zero pose under WKP = 1) that at this pose
  // stands at `tip` of the workpiece system, and back. Heads: the tip itself. Under WKP = 0 programmed points are on
  // the table already.
  template <class T>
  [[nodiscard]] Vector3<T> to_table(const Vector3<T>& tip, const Turns<T>& turns, const Vector3<T>& origin) const;
  template <class T>
  [[nodiscard]] Vector3<T> from_table(const Vector3<T>& table_tip, const Turns<T>& turns,
                                      const Vector3<T>& origin) const;
  // Sines and cosines of a pose in double-double.
  [[nodiscard]] Turns<DoubleDouble> fine_turns(const Pose& pose) const;

  [[nodiscard]] const PolarFrame& polar() const { return polar_; }
  [[nodiscard]] const Kinematics& kinematics() const { return kinematics_; }

 private:
  Kinematics& kinematics_;
  int type_ = 0;
  std::array<std::size_t, 2> index_{spec::kMaxAxes, spec::kMaxAxes};
  bool workpiece_frame_ = false;
  bool ranges_valid_ = true;
  Count holder_offset_;
  PolarFrame polar_;
};

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
// How the axes go from the end of one move to that of the next, for who follows them: beyond what events say.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "model/geometry/point_path.h"
#include "model/kinematics/control_frame.h"
#include "model/kinematics/posture_motion.h"
#include "spec/language/axes.h"

namespace toolcomp::model {

// Machine coordinates of the workpiece zero, by axis.
using Zero = std::array<Real, spec::kMaxAxes>;
using SharedZero = std::shared_ptr<const Zero>;

// The inside of a move in which the rotary axes may turn at a tip that runs along its own path, so that the linear axes
// bend: the own move of a block run under tool center point control, and a turn before or behind it. It must not
// outlive its engine.
class InsideMove {
 public:
  InsideMove() = default;
  InsideMove(const InsideMove&) = delete;
  InsideMove& operator=(const InsideMove&) = delete;
  virtual ~InsideMove() = default;

  // All axes at the fraction t, 0 < t < 1, workpiece coordinates, exact.
  [[nodiscard]] virtual spec::AxisValues<Real> axes_at(const Rational& t) const = 0;

  // What they are made of. X Y Z are the control point that the frame makes of tip, posture and length (without a
  // frame: the tip, and along the tool the length); all other axes run evenly.
  struct Form {
    PointPath tip;  // in the system fixed to the table
    MotionForm posture;
    Rational length_before;  // it goes evenly
    Rational length_after;
    SharedFrame frame;  // none: no rotary axes
  };
  [[nodiscard]] virtual Form form() const = 0;
};

struct MoveMotion {
  SharedZero zero;                           // of the coordinates in which the move is reported
  std::shared_ptr<const InsideMove> inside;  // none: all axes evenly, or along the arc of the event
  bool of_tip = false;                       // under tool center point control
};

// Takes them in the order of the run. Coordinates that jump have another zero.
class MotionSink {
 public:
  virtual ~MotionSink() = default;
  // Before the event of the move.
  virtual void on(const MoveMotion& motion) = 0;
  // Behind a block, and at the beginning of the run (line 0): what positions are counted from.
  virtual void stand(const SharedZero& zero, std::uint64_t line, const std::optional<std::uint64_t>& n) = 0;
};

}  // namespace toolcomp::model

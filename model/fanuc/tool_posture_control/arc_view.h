// SPDX-License-Identifier: Apache-2.0
// The coordinates in which the great circle of a block is looked at, so that what is zero is proven to be.
#pragma once

#include <optional>

#include "model/kinematics/control_frame.h"
#include "model/kinematics/tool_direction.h"

namespace toolcomp::model {

// Directions that the program says are looked at in the programming frame. Directions of commanded positions (type 1)
// are looked at as the table sees them with its work-side axis turned back by the position at the start: neither that
// position nor the frame's pose, which may be angles of any kind, enters the questions then.
class ArcView {
 public:
  // Of the programming frame.
  explicit ArcView(SharedFrame frame);
  // Of this position of the work-side axis.
  ArcView(SharedFrame frame, const Angle& work);

  [[nodiscard]] const SharedFrame& frame() const { return frame_; }
  // u_w, unit.
  [[nodiscard]] const Vector& work_axis() const { return work_axis_; }
  // Of a pose, in a view of a position.
  [[nodiscard]] Direction direction(const Pose& pose) const;

  // A direction of the view as it is in the table frame, and in the programming frame.
  [[nodiscard]] Vector in_table(const Vector& direction) const;
  [[nodiscard]] Vector in_frame(const Vector& direction) const;
  // As it is in the table frame, but for a turn about the work-side axis that is the same for all directions.
  [[nodiscard]] Vector about_axis(const Vector& direction) const;

 private:
  SharedFrame frame_;
  std::optional<Angle> work_;
  Vector work_axis_;
};

}  // namespace toolcomp::model

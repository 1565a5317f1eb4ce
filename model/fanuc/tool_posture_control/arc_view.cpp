// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_posture_control/arc_view.h"

#include <utility>

namespace toolcomp::model {

ArcView::ArcView(SharedFrame frame) : frame_(std::move(frame)), work_axis_(frame_->work_axis) {}

ArcView::ArcView(SharedFrame frame, const Angle& work)
    : frame_(std::move(frame)), work_(work), work_axis_(frame_->machine.work_side().line) {}

Direction ArcView::direction(const Pose& pose) const {
  const Vector unit = frame_->machine.direction_beside(pose, *work_);
  return {unit, 1, unit, true};
}

Vector ArcView::in_table(const Vector& direction) const {
  return work_ ? frame_->machine.work_side().apply(direction, *work_) : frame_->frame.to_table(direction);
}

Vector ArcView::in_frame(const Vector& direction) const {
  return work_ ? frame_->frame.from_table(in_table(direction)) : direction;
}

Vector ArcView::about_axis(const Vector& direction) const {
  return work_ ? direction : frame_->frame.to_table_beside(direction);
}

}  // namespace toolcomp::model

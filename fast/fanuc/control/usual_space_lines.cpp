// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/control/usual_space_lines.h"

namespace toolcomp::fast {
namespace {

constexpr Mask kLinearXyz = 0b111;

bool is_within(const Count& count, std::int64_t most) {
  return count.is_small() && count.small() <= most && count.small() >= -most;
}

}  // namespace

// The offsets of length are far below what the sum with a position could take.
bool UsualSpaceLines::may_come() const {
  constexpr std::int64_t kMostPosition = std::int64_t{1} << 52U;
  constexpr std::int64_t kMostOffset = std::int64_t{1} << 48U;
  const AxisPositions& positions = control_.positions;
  const ToolCenterPointControl& tip = control_.attitude.tip();
  if (!control_.axes.letters.xyz_first || !usual_lines_may_come(control_)) return false;
  if (tip.active() || (positions.along_tool() && tip.samples())) return false;
  for (std::size_t i = 0; i < 3; ++i)
    if (!is_within(positions.programmed()[i], kMostPosition)) return false;
  for (std::size_t axis = 0; axis < control_.axes.count; ++axis)
    if (!is_within(positions.length()[axis], kMostOffset)) return false;
  return true;
}

UsualSpaceLines::Sent UsualSpaceLines::sent() const {
  const AxisPositions& positions = control_.positions;
  const bool along = positions.along_tool();
  const bool offset = positions.length().live() != 0;
  if (control_.axes.linear != kLinearXyz || (along && (offset || positions.displaced() != 0))) return Sent::otherwise;
  if (along && control_.attitude.along_length() != 0) return Sent::along_tool;
  return offset ? Sent::with_offset : Sent::as_programmed;
}

bool UsualSpaceLines::await(BlockTaker& taker) {
  if (!may_come()) return false;
  const AxisPositions& positions = control_.positions;
  std::uint32_t letters = kXyzF;
  if (positions.along_tool()) {
    if (control_.modal.by_vector()) letters |= kDirection;
  } else {
    letters |= letters_of_further_axes(control_);
  }
  words_.permit(letters);
  const auto of_xyz = [](const auto& counts) {
    return Vector3<double>{static_cast<double>(counts[0].small()), static_cast<double>(counts[1].small()),
                           static_cast<double>(counts[2].small())};
  };
  set_at(of_xyz(positions.programmed()));
  offset_ = of_xyz(positions.length());
  sent_ = sent();
  handover_.take(taker);
  return true;
}

BlockTaker& UsualSpaceLines::leave() {
  place(at_.x, at_.y, at_.z);
  return handover_.back();
}

void UsualSpaceLines::set_at(const Vector3<double>& at) {
  at_ = at;
  for (std::size_t i = 0; i < 3; ++i) words_[kX + i] = static_cast<std::int64_t>(at[i]);
}

void UsualSpaceLines::place(double x, double y, double z) {
  const std::array<double, 3> at{x, y, z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    control_.positions.place_small(axis, static_cast<std::int64_t>(at[axis]));
    if ((control_.positions.length().live() & bit(axis)) != 0) control_.positions.add_offset(axis);
  }
}

void UsualSpaceLines::fill_all(Event& event, std::uint64_t line, const std::optional<std::uint64_t>& n, double x,
                               double y, double z) {
  place(x, y, z);
  control_.line = line;
  control_.n = n;
  control_.fill(event, control_.modal.straight(), spec::Cause::programmed);
}

}  // namespace toolcomp::fast

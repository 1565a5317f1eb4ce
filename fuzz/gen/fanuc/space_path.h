// SPDX-License-Identifier: Apache-2.0
// Straight movements in space that meet at corners of every kind, as a tilted tool sees them.
#pragma once

#include "fuzz/gen/choices.h"
#include "fuzz/gen/fanuc/tool_pose.h"

namespace toolcomp::fuzz {

// Makes movements one after the other, in counts of the least increment. Corners are aimed at in the plane at right
// angles to the tool, where the compensation is made: exactly where the tool's direction is whole numbers.
class SpacePath {
 public:
  // `one`: counts of a millimetre, inch or degree.
  SpacePath(Choices& choose, std::int64_t one) : choose_(choose), one_(one) {}

  // Magnitude of the offset; movements are mostly longer.
  void offset(std::int64_t counts) { offset_ = counts < 0 ? -counts : counts; }
  // The movement made last, also by others.
  void follow(const SpaceCounts& movement);

  SpaceCounts movement(const ToolAim& tool);
  // Along the tool, or a unit beside it.
  SpaceCounts parallel(const ToolAim& tool);
  // Of this length in the plane, to within a unit, and any length along the tool.
  SpaceCounts of_length(const ToolAim& tool, std::int64_t length);
  // A movement that goes back in the plane of the tool `first` after `before`, though the side of either movement by
  // its own tool is the same: what the check at a change of the compensation plane looks for. 100 `percent` are the end
  // of that range, more lie inside.
  SpaceCounts overcut(const Direction& first, const SpaceCounts& before, const Direction& second, std::int64_t percent);

 private:
  // At an angle to the last movement, in the plane.
  SpaceCounts in_plane(const ToolAim& tool);
  SpaceCounts turned_exactly(const SpaceCounts& tool);
  SpaceCounts turned_roughly(const Direction& tool);
  SpaceCounts coplanar(const ToolAim& tool);
  void tilt(const ToolAim& tool, SpaceCounts& movement);
  std::int64_t length();
  [[nodiscard]] SpaceCounts scaled(const Direction& d, double length) const;
  // A whole multiple of the shortest vector along v, about `length` long.
  [[nodiscard]] SpaceCounts multiple(SpaceCounts v, std::int64_t length) const;

  Choices& choose_;
  std::int64_t one_;
  std::int64_t offset_ = 0;
  SpaceCounts last_{1, 0, 0};
};

}  // namespace toolcomp::fuzz

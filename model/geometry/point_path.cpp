// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/point_path.h"

#include <utility>

namespace toolcomp::model {

PointPath path_along(Vector from, Vector to, const spec::Arc<Real>& arc, const spec::Axes& axes) {
  PointPath path{std::move(from), std::move(to), {}};
  if (!arc.sweep) return path;
  const PlaneLetters in_plane = letters(arc.plane);
  const auto center = [&](char letter) { return axes.has(letter) ? arc.center[axes.index(letter)] : Real(0); };
  PointPath::Turn turn;
  turn.plane = arc.plane;
  turn.center = {center(in_plane.first), center(in_plane.second)};
  turn.sweep = arc.direction == spec::ArcDirection::ccw ? *arc.sweep : -*arc.sweep;
  if (arc.radius) turn.growth = (arc.radius->second - arc.radius->first) / arc.radius->first;
  path.turn = turn;
  return path;
}

}  // namespace toolcomp::model

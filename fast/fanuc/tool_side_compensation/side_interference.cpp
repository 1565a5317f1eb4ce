// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_side_compensation/side_interference.h"

#include <algorithm>
#include <cmath>

namespace toolcomp::fast {
namespace {

double extent(const Vector3<double>& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

// As line_interferes, by doubles that cannot tell; `length` in the plane, `size` of the vectors.
bool line_interferes_by_little(const SideGroups& groups, const SidePath& path, const SideGroup& start, std::size_t v,
                               const SideGroup& end, std::size_t w, double length, double size) {
  const FineTurn fine = groups.geometry().plane(*path.tool).fine_turn(path.travel, path.travel);
  const DoubleDouble refined = fine.length1 + dot(fine.ahead1, groups.fine(end, w) - groups.fine(start, v));
  const double steep = std::max(1.0, std::sqrt(path.travel.square) / path.travel.unit / length);
  return refined.hi < -0x1p-88 * steep * (length + size);
}

// Whether the tool goes against the projected travel, of which exactly 90 degrees is no case. `turn` has its length and
// direction.
[[gnu::always_inline]] inline bool goes_against(const SideGroups& groups, const SidePath& path, const SideGroup& start,
                                                std::size_t v, const SideGroup& end, std::size_t w,
                                                const SpaceTurn& turn) {
  const Vector3<double>& from = start.head[v].vector;
  const Vector3<double>& to = end.head[w].vector;
  const double size = extent(to) + extent(from);
  const double product = turn.length1 + dot(turn.ahead1, to - from);
  if (std::abs(product) > 0x1p-42 * (turn.length1 + size)) [[likely]]
    return product < 0;
  return line_interferes_by_little(groups, path, start, v, end, w, turn.length1, size);
}

bool chord_interferes(const SideGroups& groups, const SidePath& path, const SideGroup& start, std::size_t v,
                      const SideGroup& end, std::size_t w) {
  const ToolPlane plane = groups.geometry().plane(*path.tool);
  // An arc may end where it starts, or above it along the tool.
  if (!plane.moves({path.travel, plane.see(path.travel)}, Amount())) return false;
  return goes_against(groups, path, start, v, end, w, plane.straight(path.travel));
}

[[gnu::always_inline]] inline bool line_interferes(const SideGroups& groups, const SidePath& path,
                                                   const SideGroup& start, std::size_t v, const SideGroup& end,
                                                   std::size_t w) {
  if (end.corner.first == &path && !end.corner.flat) [[likely]]
    return goes_against(groups, path, start, v, end, w, end.corner.turn);
  return chord_interferes(groups, path, start, v, end, w);
}

bool arc_interferes(const SideGeometry& geometry, const SidePath& path, const PathStart& at_start,
                    const std::optional<double>& sweep) {
  const int start = geometry.offset_radius_sign(path, false, *at_start.tool, at_start.side, *at_start.offset);
  const int end = geometry.offset_radius_sign(path, true, *path.tool, path.side, path.offset);
  return fast::arc_interferes(path.flat, start, end, sweep);
}

Vector2<double> seen(const SidePath& path, const Vector3<double>& v) { return {v[path.in[0]], v[path.in[1]]}; }

// How the distances of the heads from the centre compare, by what the vectors are, where the tool stands along the
// normal of the arc at both ends.
Radii compare_radii(const SidePath& path, const SideGroup& start, const SideGroup& end) {
  const bool cornered = start.corner.second == &path && !start.back().kept && start.corner.flat &&
                        start.corner.aligned && end.corner.first == &path && end.corner.flat && end.corner.aligned &&
                        start.corner.facing == end.corner.facing;
  if (!cornered || !(start.corner.offset->exact == path.offset.exact) || start.corner.second_side != path.side)
    return Radii::unknown;
  const HeadKind first = start.back().kind;
  const HeadKind last = end.front().kind;
  const auto meets = [](HeadKind kind) { return kind == HeadKind::paths_meet || kind == HeadKind::paths_cross; };
  const Turn& turn = start.corner.plane.turn;
  const bool tangent = first == HeadKind::first_normal && turn.c == 0 &&
                       (turn.k > 0) == (start.corner.first_side == start.corner.second_side);
  const bool on_start = meets(first) || first == HeadKind::second_normal || tangent;
  const bool on_end = meets(last) || last == HeadKind::first_normal;
  if (!on_start || !on_end || path.flat.spiral) return Radii::unknown;
  return Radii::agree;
}

// The same to about 80 bits, where doubles cannot tell.
bool radii_agree(const SideGroups& groups, const SidePath& path, const SideGroup& start, const SideGroup& end) {
  const auto square = [&](bool at_end, const Vector3<DoubleDouble>& vector) {
    const Heading& heading = at_end ? path.flat.end() : path.flat.start;
    const Vector2<DoubleDouble> outward = left_of(fine_unit(heading));
    const DoubleDouble radius = fine_radius(path.flat, at_end);
    const DoubleDouble toward = path.flat.sigma > 0 ? -radius : radius;
    const Vector2<DoubleDouble> head{outward.x * toward + vector[path.in[0]], outward.y * toward + vector[path.in[1]]};
    return dot(head, head);
  };
  const DoubleDouble a = square(false, groups.fine(start, start.size - 1U));
  const DoubleDouble b = square(true, groups.fine(end, 0));
  const double size = path.flat.radius_start + path.flat.radius_end + path.offset.nearest;
  return std::abs((a - b).hi) <= 0x1p-80 * size * size;
}

}  // namespace

Interference check_interference(const SideGroups& groups, const SidePath& path, const PathStart& at_start,
                                const std::optional<double>& sweep, SideGroup& start, SideGroup& end) {
  return check_pairs(
      path.arc, start, end, [&] { return arc_interferes(groups.geometry(), path, at_start, sweep); },
      [&](std::size_t v, std::size_t w) { return line_interferes(groups, path, start, v, end, w); });
}

void set_tool_arc(spec::Arc<double>& arc, const SideGroups& groups, const SidePath& path, const SideGroup& start,
                  const SideGroup& end) {
  Radii radii = compare_radii(path, start, end);
  const Vector2<double> v = seen(path, start.back().vector);
  Vector2<double> w = seen(path, end.front().vector);
  // A whole circle from a head back to itself: the two are made apart, and near the centre a rounding turns far.
  const PlanePath& flat = path.flat;
  const bool whole =
      flat.from_center_start.x == flat.from_center_end.x && flat.from_center_start.y == flat.from_center_end.y;
  if (whole && length(v - w) <= 0x1p-46 * length(v)) w = v;
  if (radii == Radii::unknown) {
    const double difference = length(path.flat.from_center_start + v) - length(path.flat.from_center_end + w);
    const double size = path.flat.radius_start + path.flat.radius_end + path.offset.nearest;
    if (std::abs(difference) <= 0x1p-36 * size)
      radii = radii_agree(groups, path, start, end) ? Radii::agree : Radii::differ;
    else
      radii = Radii::differ;
  }
  set_tool_arc(arc, path.flat, v, w, radii);
}

}  // namespace toolcomp::fast

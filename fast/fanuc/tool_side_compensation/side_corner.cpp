// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_side_compensation/side_corner.h"

#include <cmath>

namespace toolcomp::fast {
namespace {

using Fine = Vector3<DoubleDouble>;

DoubleDouble fine_value(const Count& count) {
  return to_double_double(count.units()) / to_double_double(Count::kRestPerOne);
}

DoubleDouble signed_by(int sign, const DoubleDouble& value) { return sign < 0 ? -value : value; }

double of(int sign, double value) { return sign < 0 ? -value : value; }

Vector3<double> axis_vector(std::size_t axis) {
  return {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
}

// What the vectors of a corner of lines are made of.
template <class T>
struct Numbers {
  Vector3<T> left1, ahead1, left2, ahead2;
  T c{};
  T k{};
  T r{};
  T rho1{};  // r, positive to the left
  T rho2{};
};

// How far the offset lines meet behind the perpendicular; `crossing`: the latter line is offset to the other side,
// which is the same line run backward.
template <class T>
T meeting(const Numbers<T>& n, bool crossing) {
  const T c = crossing ? number<T>(0) - n.c : n.c;
  const T k = crossing ? number<T>(0) - n.k : n.k;
  return leading(k) >= 0 ? c / (number<T>(1) + k) : (number<T>(1) - k) / c;
}

bool is_of_second(HeadKind kind) { return kind == HeadKind::second_normal || kind == HeadKind::second_extended; }

template <class T>
Vector3<T> second_vector(const Numbers<T>& n, HeadKind kind) {
  const Vector3<T> normal = n.left2 * n.rho2;
  return kind == HeadKind::second_normal ? normal : normal - n.ahead2 * n.r;
}

// Of any other kind.
template <class T>
Vector3<T> first_vector(const Numbers<T>& n, HeadKind kind) {
  switch (kind) {
    [[likely]] case HeadKind::tangents_meet:
    case HeadKind::paths_meet:
      return (n.left1 - n.ahead1 * meeting(n, false)) * n.rho1;
    case HeadKind::paths_cross:
      return (n.left1 - n.ahead1 * meeting(n, true)) * n.rho1;
    case HeadKind::first_normal:
      return n.left1 * n.rho1;
    case HeadKind::first_extended:
      return n.left1 * n.rho1 + n.ahead1 * n.r;
    default:
      return {};
  }
}

// Whether doubles are too few for a vector: near a reversal the sine of the turn is the divisor.
bool is_ill(const SideCorner& corner, HeadKind kind) {
  if (corner.turn.ill) return true;
  const bool back = kind == HeadKind::paths_cross ? corner.turn.k > 0 : corner.turn.k < 0;
  const bool meets = kind == HeadKind::tangents_meet || kind == HeadKind::paths_meet || kind == HeadKind::paths_cross;
  return meets && back && std::abs(corner.turn.c) < 0x1p-3;
}

// A line seen along an axis.
void set_line_path(PlanePath& path, const Travel& travel, const std::array<std::size_t, 2>& in) {
  path.arc = false;
  path.by_radius = false;
  path.ends_in_center = false;
  path.seen = false;
  path.fine_units = travel.fine_units;
  const std::array<Int128, 3> whole = travel.whole();
  path.start = whole_heading({whole[in[0]], whole[in[1]]});
}

// A vector of the plane of a corner with an arc.
Vector3<double> in_space(const SideCorner& corner, const Vector2<double>& v) {
  return corner.across * v.x + corner.up * v.y;
}

}  // namespace

bool SideGeometry::set_turn(SideCorner& corner) const {
  const SidePath& first = *corner.first;
  const SidePath* second = corner.second;
  const ToolPlane plane(kinematics_, *corner.tool);
  corner.flat = first.arc || (second != nullptr && second->arc);
  if (!corner.flat) [[likely]] {
    if (second == nullptr)
      corner.turn = plane.straight(first.travel);
    else
      set_turn_of_lines(corner, plane);
    return true;
  }
  const SidePath& arc = first.arc ? first : *second;
  corner.facing = plane.facing(arc.normal);
  if (corner.facing == 0) return false;
  corner.aligned = plane.along(arc.normal);
  Corner& flat = corner.plane;
  flat.offset = corner.offset;
  if (corner.aligned) {
    set_aligned(corner, arc);
  } else {
    corner.facing = 1;
    set_tilted(corner, plane);
  }
  flat.first_side = corner.facing * corner.first_side;
  flat.second_side = corner.facing * corner.second_side;
  return true;
}

[[gnu::always_inline]] inline void SideGeometry::set_turn_of_lines(SideCorner& corner, const ToolPlane& plane) {
  const SidePath& first = *corner.first;
  const SidePath& second = *corner.second;
  if (first.tool == corner.tool && second.tool == corner.tool) [[likely]] {
    plane.set_turn({first.travel, first.seen}, {second.travel, second.seen}, corner.turn);
    return;
  }
  const auto seen = [&](const SidePath& path) { return path.tool == corner.tool ? path.seen : plane.see(path.travel); };
  plane.set_turn({first.travel, seen(first)}, {second.travel, seen(second)}, corner.turn);
}

void SideGeometry::set_aligned(SideCorner& corner, const SidePath& arc) {
  Corner& flat = corner.plane;
  corner.across = axis_vector(arc.in[0]);
  corner.up = axis_vector(arc.in[1]);
  const auto path = [&](const SidePath* of_block, std::size_t i) -> const PlanePath* {
    if (of_block == nullptr) return nullptr;
    if (of_block->arc) return &of_block->flat;
    set_line_path(corner.path[i], of_block->travel, arc.in);
    return &corner.path[i];
  };
  flat.first = path(corner.first, 0);
  flat.second = path(corner.second, 1);
  flat.last = &flat.first->end();
  flat.next = flat.second == nullptr ? flat.last : &flat.second->start;
  flat.turn = turn(*flat.last, *flat.next);
}

SideGeometry::FineLeg SideGeometry::fine_leg(const SidePath& path, bool at_end, const ToolPlane& plane) const {
  FineLeg leg;
  const Fine v = plane.fine_unit();
  if (!path.arc) {
    const FineTurn numbers = plane.fine_turn(path.travel, path.travel);
    leg.ahead = numbers.ahead1;
    leg.left = numbers.left1;
    return leg;
  }
  const Heading& heading = at_end ? path.flat.end() : path.flat.start;
  const Vector2<DoubleDouble> tangent = fast::fine_unit(heading);
  const Vector2<DoubleDouble> outward = left_of(tangent);  // from the centre for a clockwise arc
  const DoubleDouble radius = fine_radius(path.flat, at_end);
  std::array<DoubleDouble, 3> from_center{};
  from_center[path.in[0]] = signed_by(-path.flat.sigma, outward.x) * radius;
  from_center[path.in[1]] = signed_by(-path.flat.sigma, outward.y) * radius;
  const Fine turned = fast::cross(v, Fine{from_center[0], from_center[1], from_center[2]});
  leg.radius = sqrt(dot(turned, turned));
  leg.sigma = path.flat.sigma * plane.facing(path.normal);
  const DoubleDouble scale = signed_by(leg.sigma, DoubleDouble{1, 0} / leg.radius);
  leg.ahead = turned * scale;
  leg.left = fast::cross(v, leg.ahead);
  return leg;
}

void SideGeometry::set_tilted(SideCorner& corner, const ToolPlane& plane) const {
  const FineLeg first = fine_leg(*corner.first, true, plane);
  const FineLeg second = corner.second == nullptr ? first : fine_leg(*corner.second, false, plane);
  corner.across = nearest(first.ahead);
  corner.up = nearest(first.left);
  DoubleDouble c = dot(second.ahead, first.left);
  DoubleDouble k = dot(second.ahead, first.ahead);
  constexpr double kTurnTie = 0x1p-90;
  if (corner.second == nullptr || std::abs(c.hi) <= kTurnTie) c = {};
  if (std::abs(k.hi) <= kTurnTie) k = {};
  Corner& flat = corner.plane;
  flat.turn = {c.hi, k.hi, 1};
  const auto set_heading = [](Heading& heading, const DoubleDouble& x, const DoubleDouble& y) {
    heading.exact = false;
    heading.seen = true;
    heading.fine = {x, y};
    heading.unit = {x.hi, y.hi};
  };
  set_heading(corner.heading[0], {1, 0}, {});
  set_heading(corner.heading[1], k, c);
  const auto set_path = [&](const SidePath* block, const FineLeg& leg, std::size_t i) -> const PlanePath* {
    if (block == nullptr) return nullptr;
    PlanePath& path = corner.path[i];
    path.arc = block->arc;
    path.by_radius = false;
    path.seen = true;
    path.sigma = leg.sigma;
    path.fine_radius = {leg.radius, leg.radius};
    path.radius_start = path.radius_end = leg.radius.hi;
    path.semicircle = block->arc && block->flat.semicircle;
    return &path;
  };
  flat.first = set_path(corner.first, first, 0);
  flat.second = set_path(corner.second, second, 1);
  flat.last = corner.heading.data();
  flat.next = &corner.heading[1];
}

bool SideGeometry::paths_meet(const SideCorner& corner, HeadKind kind, Vector3<double>& vector) {
  Vector2<double> meeting;
  if (!offset_paths_meet(corner.plane, kind, meeting)) return false;
  vector = in_space(corner, meeting);
  return true;
}

void SideGeometry::set_vector(const SideCorner& corner, HeadKind kind, Vector3<double>& vector) const {
  if (kind == HeadKind::zero || corner.flat || is_ill(corner, kind)) [[unlikely]] {
    vector = corner.flat && kind != HeadKind::zero ? in_space(corner, head_vector(corner.plane, kind))
                                                   : nearest(fine_vector(corner, kind));
    return;
  }
  const SpaceTurn& turn = corner.turn;
  Numbers<double> n;
  n.r = corner.offset->nearest;
  if (is_of_second(kind)) {
    plane(*corner.tool).set_leg(corner.second->travel, n.left2, n.ahead2);
    n.rho2 = of(corner.second_side, n.r);
    vector = second_vector(n, kind);
    return;
  }
  n.left1 = turn.left1;
  n.ahead1 = turn.ahead1;
  n.c = turn.c;
  n.k = turn.k;
  n.rho1 = of(corner.first_side, n.r);
  vector = first_vector(n, kind);
}

Vector3<DoubleDouble> SideGeometry::fine_vector(const SideCorner& corner, HeadKind kind) const {
  if (kind == HeadKind::zero) return {};
  const ToolPlane plane(kinematics_, *corner.tool);
  if (corner.flat) {
    const Vector2<DoubleDouble> v = fine_head_vector(corner.plane, kind);
    if (corner.aligned) {
      const Fine across{{corner.across.x, 0}, {corner.across.y, 0}, {corner.across.z, 0}};
      const Fine up{{corner.up.x, 0}, {corner.up.y, 0}, {corner.up.z, 0}};
      return across * v.x + up * v.y;
    }
    const FineLeg leg = fine_leg(*corner.first, true, plane);
    return leg.ahead * v.x + leg.left * v.y;
  }
  const FineTurn turn =
      plane.fine_turn(corner.first->travel, corner.second == nullptr ? corner.first->travel : corner.second->travel);
  Numbers<DoubleDouble> n;
  n.left1 = turn.left1;
  n.ahead1 = turn.ahead1;
  n.left2 = turn.left2;
  n.ahead2 = turn.ahead2;
  n.c = corner.turn.cross == 0 ? DoubleDouble{} : turn.c;
  n.k = corner.turn.dot == 0 ? DoubleDouble{} : turn.k;
  n.r = fine_value(corner.offset->exact);
  n.rho1 = signed_by(corner.first_side, n.r);
  n.rho2 = signed_by(corner.second_side, n.r);
  return is_of_second(kind) ? second_vector(n, kind) : first_vector(n, kind);
}

int SideGeometry::offset_radius_sign(const SidePath& path, bool at_end, const Direction& tool, int side,
                                     const Amount& offset) const {
  if (!path.arc) return 1;
  const ToolPlane plane(kinematics_, tool);
  if (plane.along(path.normal))
    return fast::offset_radius_sign(path.flat, at_end, side * plane.facing(path.normal), offset);
  const FineLeg leg = fine_leg(path, at_end, plane);
  PlanePath seen;
  seen.arc = true;
  seen.seen = true;
  seen.sigma = leg.sigma;
  seen.fine_radius = {leg.radius, leg.radius};
  seen.radius_start = seen.radius_end = leg.radius.hi;
  return fast::offset_radius_sign(seen, at_end, side, offset);
}

bool SideGeometry::is_under_one_degree(const SideCorner& corner) const {
  const double left = kTangentOfOneDegree.hi * corner.turn.k;
  const double difference = left * left - corner.turn.c * corner.turn.c;
  if (std::abs(difference) > 0x1p-46 * left * left) return difference > 0;
  const FineTurn turn = plane(*corner.tool).fine_turn(corner.first->travel, corner.second->travel);
  const DoubleDouble tangent = kTangentOfOneDegree * turn.k;
  return (tangent * tangent - turn.c * turn.c).hi > 0;
}

}  // namespace toolcomp::fast

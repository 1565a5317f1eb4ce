// SPDX-License-Identifier: Apache-2.0
#include "fast/geometry/corner.h"

#include <cmath>

#include "fast/geometry/offset_meeting.h"

namespace toolcomp::fast {
namespace {

OffsetMeeting<double> numbers(const Corner& corner) {
  OffsetMeeting<double> n;
  n.t1 = corner.last->unit;
  n.t2 = corner.next->unit;
  set_turn(n, corner.turn);
  n.r = corner.offset->nearest;
  n.rho = corner.first_side * n.r;
  n.rho2 = corner.second_side * n.r;
  if (corner.first->arc) n.p1 = corner.first->sigma / corner.first->radius_end;
  if (corner.second != nullptr && corner.second->arc) n.p2 = corner.second->sigma / corner.second->radius_start;
  return n;
}

OffsetMeeting<DoubleDouble> fine_numbers(const Corner& corner) {
  const auto signed_by = [](int sign, const DoubleDouble& value) { return sign < 0 ? -value : value; };
  OffsetMeeting<DoubleDouble> n;
  n.t1 = fine_unit(*corner.last);
  n.t2 = fine_unit(*corner.next);
  n.turned = sign_of(corner.turn.c);
  n.c = n.turned == 0 ? DoubleDouble{} : cross(n.t1, n.t2);
  n.k = corner.turn.k == 0 ? DoubleDouble{} : dot(n.t1, n.t2);
  complete(n);
  n.r = to_double_double(corner.offset->exact.units()) / to_double_double(Count::kRestPerOne);
  n.rho = signed_by(corner.first_side, n.r);
  n.rho2 = signed_by(corner.second_side, n.r);
  const auto curvature = [&](const PlanePath* path, bool at_end) {
    if (path == nullptr || !path->arc) return DoubleDouble{};
    return signed_by(path->sigma, DoubleDouble{1, 0} / fine_radius(*path, at_end));
  };
  n.p1 = curvature(corner.first, true);
  n.p2 = curvature(corner.second, false);
  return n;
}

// The latter path run backward.
template <class T>
void reverse_second(OffsetMeeting<T>& n) {
  n.c = -n.c;
  n.k = -n.k;
  n.p2 = -n.p2;
  n.turned = -n.turned;
  const T plus = n.plus;
  n.plus = n.minus;
  n.minus = plus;
}

constexpr double kBound = 0x1p-48;
constexpr double kFineBound = 0x1p-92;

template <class T>
Vector2<T> tangents_meet(const OffsetMeeting<T>& n) {
  const T along = leading(n.k) >= 0 ? n.c / n.plus : n.minus / n.c;
  return (left_of(n.t1) - n.t1 * along) * n.rho;
}

template <class T>
bool has_arcs(const OffsetMeeting<T>& n) {
  return leading(n.p1) != 0 || leading(n.p2) != 0;
}

Vector2<DoubleDouble> fine_paths_meet(const OffsetMeeting<DoubleDouble>& n) {
  if (!has_arcs(n)) return tangents_meet(n);
  const DoubleDouble e = curvature_term(n);
  DoubleDouble discriminant = n.plus - e * 2.0;
  if (discriminant.hi < kFineBound * discriminant_scale(n)) discriminant = {};
  return paths_meet(n, e, discriminant);
}

Vector2<double> nearest(const Vector2<DoubleDouble>& v) { return {to_double(v.x), to_double(v.y)}; }

}  // namespace

Vector2<DoubleDouble> fine_head_vector(const Corner& corner, HeadKind kind) {
  if (kind == HeadKind::zero) return {};
  OffsetMeeting<DoubleDouble> n = fine_numbers(corner);
  switch (kind) {
    case HeadKind::zero:
      break;
    case HeadKind::first_normal:
      return left_of(n.t1) * n.rho;
    case HeadKind::second_normal:
      return left_of(n.t2) * n.rho2;
    case HeadKind::first_extended:
      return left_of(n.t1) * n.rho + n.t1 * n.r;
    case HeadKind::second_extended:
      return left_of(n.t2) * n.rho - n.t2 * n.r;
    case HeadKind::tangents_meet:
      return tangents_meet(n);
    case HeadKind::paths_cross:
      reverse_second(n);
      return fine_paths_meet(n);
    case HeadKind::paths_meet:
      return fine_paths_meet(n);
  }
  return {};
}

bool offset_paths_meet(const Corner& corner, HeadKind kind, Vector2<double>& vector) {
  const bool crossing = kind == HeadKind::paths_cross;
  OffsetMeeting<double> n = numbers(corner);
  if (crossing) reverse_second(n);
  if (!has_arcs(n)) {
    if (n.turned == 0 && n.k <= 0) return false;
    vector = tangents_meet(n);
    return true;
  }
  const double e = curvature_term(n);
  const double discriminant = n.plus - 2 * e;
  if (doubles_suffice(n, discriminant, corner.turn.error)) [[likely]] {
    vector = paths_meet(n, e, discriminant);
    return true;
  }
  const double scale = discriminant_scale(n);
  if (discriminant < -kBound * scale) return false;
  // Near tangent contact a root, near equal circles the distance of the centres lose what doubles have.
  OffsetMeeting<DoubleDouble> fine = fine_numbers(corner);
  if (crossing) reverse_second(fine);
  if (discriminant <= kBound * scale &&
      (fine.plus - curvature_term(fine) * 2.0).hi <= -kFineBound * discriminant_scale(fine))
    return false;
  vector = nearest(fine_paths_meet(fine));
  return true;
}

}  // namespace toolcomp::fast

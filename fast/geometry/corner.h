// SPDX-License-Identifier: Apache-2.0
// Vectors at a corner of two offset paths: perpendiculars, intersections, prolongations (chapter 14.6.1 and 14.6.3).
#pragma once

#include <cstdint>

#include "fast/arithmetic/count.h"
#include "fast/geometry/heading.h"
#include "fast/geometry/path.h"
#include "fast/geometry/vector2.h"

namespace toolcomp::fast {

// 0.0174550649282175857651288952197, to 31 digits.
constexpr DoubleDouble kTangentOfOneDegree{0x1.1dfbd9410a422p-6, 0x1.8c721220dd4afp-62};

// What a vector at a corner is. rho is the offset, positive to the left; N the left normal, t the tangent of the former
// (1) and the latter (2) path, r = |rho|.
enum class HeadKind : std::uint8_t {
  zero,
  first_normal,     // rho1 N1
  second_normal,    // rho2 N2
  tangents_meet,    // where the two offset tangents meet
  first_extended,   // rho N1 + r t1
  second_extended,  // rho N2 - r t2
  paths_meet,       // where the two offset paths meet: of two points the one that tends to the corner with rho
  paths_cross,      // the same where the latter path is offset to the other side
};

// A corner, with everything its vectors are made of. The paths must outlive it.
struct Corner {
  const PlanePath* first = nullptr;
  const PlanePath* second = nullptr;  // nullptr: a line along `next`
  const Heading* last = nullptr;      // the tangent of the former path at the corner
  const Heading* next = nullptr;      // the tangent of the latter path
  int first_side = 1;                 // +1: the tool is left of the path
  int second_side = 1;
  const Amount* offset = nullptr;  // r
  Turn turn;
};

// The vector of tangents_meet from a former tangent offset by rho.
inline Vector2<double> where_tangents_meet(const Heading& former, const Turn& turned, double rho) {
  return (left_of(former.unit) - former.unit * half_tangent(turned)) * rho;
}

// The vector, from the corner, setup units; of kinds other than paths_meet and paths_cross.
inline Vector2<double> head_vector(const Corner& corner, HeadKind kind) {
  if (kind == HeadKind::zero) return {};
  const Vector2<double>& t1 = corner.last->unit;
  const Vector2<double>& t2 = corner.next->unit;
  const double r = corner.offset->nearest;
  const double rho = corner.first_side * r;
  switch (kind) {
    case HeadKind::zero:
      break;
    case HeadKind::first_normal:
      return left_of(t1) * rho;
    case HeadKind::second_normal:
      return left_of(t2) * (corner.second_side * r);
    case HeadKind::first_extended:
      return left_of(t1) * rho + t1 * r;
    case HeadKind::second_extended:
      return left_of(t2) * rho - t2 * r;
    case HeadKind::tangents_meet:
      return where_tangents_meet(*corner.last, corner.turn, rho);
    case HeadKind::paths_meet:
    case HeadKind::paths_cross:
      break;
  }
  return {};
}
// The same to about 90 bits, of any kind.
Vector2<DoubleDouble> fine_head_vector(const Corner& corner, HeadKind kind);

// The vector of paths_meet or paths_cross. False where the offset paths have no common point (tangent contact is one),
// the circles taken whole and with radii that are not negative. Lines that are parallel have none.
bool offset_paths_meet(const Corner& corner, HeadKind kind, Vector2<double>& vector);
// The sign of the radius of the offset circle of a path at one end; 1 for a line.
inline int offset_radius_sign(const PlanePath& path, bool at_end, int side, const Amount& offset) {
  if (!path.arc || path.sigma != side) return 1;
  return compare_radius(path, at_end, offset);
}

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
// Lines and arcs of few digits, and the corners between them: what the general path makes, bit for bit, in 64 bits.
// Where such a path or corner is unusual, or doubles cannot tell, the answer is false.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "fast/arithmetic/count.h"
#include "fast/arithmetic/trigonometry.h"
#include "fast/geometry/corner.h"
#include "fast/geometry/heading.h"
#include "fast/geometry/offset_meeting.h"
#include "fast/geometry/whole_pair.h"

namespace toolcomp::fast {

// The tangent of a path at one of its ends.
struct UsualTangent {
  // Along it, of the length of the line, or of the radius of the arc there; of an arc by radius the chord, from which
  // the tangent is turned by an angle of this cosine and sine.
  WholePair whole{};
  DoublePair from_whole{1, 0};
  DoublePair unit{};
  double norm = 1;       // |whole|
  double curvature = 0;  // of the path there, positive to the left
};

struct UsualPath {
  int sigma = 0;               // of an arc: +1 counterclockwise, -1 clockwise; 0: a line
  std::int64_t by_radius = 0;  // the R of an arc, 10^-6; 0: it is about a centre
  UsualTangent start;
  UsualTangent arc_end;
  // Of an arc, seen from its centre.
  DoublePair from_start{};
  DoublePair from_end{};
  DoublePair radius{};  // at the start, at the end
  bool spiral = false;  // they differ
  bool over_half = false;

  [[nodiscard]] bool is_arc() const { return sigma != 0; }
  [[nodiscard]] const UsualTangent& end() const { return is_arc() ? arc_end : start; }
  // From the centre of an arc that is about one.
  [[nodiscard]] WholePair whole_start() const { return {sigma * start.whole[1], -sigma * start.whole[0]}; }
  [[nodiscard]] WholePair whole_end() const { return {sigma * arc_end.whole[1], -sigma * arc_end.whole[0]}; }
  [[nodiscard]] WholePair way() const {
    if (!is_arc() || by_radius != 0) return start.whole;
    const WholePair from = whole_start();
    const WholePair to = whole_end();
    return {to[0] - from[0], to[1] - from[1]};
  }
};

// The offset of both paths at a corner.
struct UsualOffset {
  double radius = 0;  // without sign
  double left = 0;    // the same, negative to the right
  double limit = 0;   // No. 5010
  bool keeps_all = false;
};

// Its vectors, in their order.
struct UsualCorner {
  std::array<HeadKind, 4> kind{};
  std::array<DoublePair, 4> vector{};
  std::uint8_t size = 0;

  void add(HeadKind head, DoublePair v) {
    kind[size] = head;
    vector[size++] = v;
  }
  [[nodiscard]] DoublePair front() const { return vector[0]; }
  [[nodiscard]] DoublePair back() const { return vector[size - 1U]; }
};

inline void set_usual_line(UsualPath& path, const WholePair& way) {
  UsualTangent& tangent = path.start;
  const DoublePair whole = to_doubles(way);
  const DoublePair squares = whole * whole;
  path.sigma = 0;
  path.by_radius = 0;
  tangent.whole = way;
  tangent.from_whole = DoublePair{1, 0};
  tangent.norm = std::sqrt(squares[0] + squares[1]);
  tangent.unit = whole / tangent.norm;
  tangent.curvature = 0;
}

// From `from` to `to`, seen from the centre. False: an end in the centre, or just a half or a whole turn.
[[nodiscard]] inline bool set_usual_arc(UsualPath& path, const WholePair& from, const WholePair& to, int sigma) {
  const std::int64_t from_square = from[0] * from[0] + from[1] * from[1];
  const std::int64_t to_square = to[0] * to[0] + to[1] * to[1];
  const std::int64_t sine = sigma * (from[0] * to[1] - from[1] * to[0]);
  if (from_square == 0 || to_square == 0 || sine == 0) [[unlikely]]
    return false;
  path.sigma = sigma;
  path.by_radius = 0;
  path.start.from_whole = DoublePair{1, 0};
  path.arc_end.from_whole = DoublePair{1, 0};
  path.spiral = from_square != to_square;
  path.over_half = sine < 0;
  path.start.whole = {-sigma * from[1], sigma * from[0]};
  path.arc_end.whole = {-sigma * to[1], sigma * to[0]};
  const DoublePair from_center = to_doubles(from);
  const DoublePair to_center = to_doubles(to);
  const auto sense = static_cast<double>(sigma);
  // As whole numbers are: never -0.
  const DoublePair start = left_of(from_center) * sense + 0.0;
  const DoublePair end = left_of(to_center) * sense + 0.0;
  const DoublePair start_squares = start * start;
  const DoublePair end_squares = end * end;
  const double norm = std::sqrt(start_squares[0] + start_squares[1]);
  const double end_norm = path.spiral ? std::sqrt(end_squares[0] + end_squares[1]) : norm;
  path.start.norm = norm;
  path.arc_end.norm = end_norm;
  path.start.unit = start / norm;
  path.arc_end.unit = end / end_norm;
  path.from_start = from_center / kWholePerOne;
  path.from_end = to_center / kWholePerOne;
  path.radius = DoublePair{norm, end_norm} / kWholePerOne;
  const DoublePair curvature = DoublePair{sense, sense} / path.radius;
  path.start.curvature = curvature[0];
  path.arc_end.curvature = curvature[1];
  return true;
}

// Over a chord; above 180 degrees where radius < 0. False: there is none, or it is half a circle.
[[nodiscard]] inline bool set_usual_arc_by_radius(UsualPath& path, const WholePair& chord, std::int64_t radius,
                                                  int sigma) {
  const std::int64_t square = 4 * radius * radius - (chord[0] * chord[0] + chord[1] * chord[1]);
  if (square <= 0 || (chord[0] == 0 && chord[1] == 0)) [[unlikely]]
    return false;
  path.sigma = sigma;
  path.by_radius = radius;
  path.spiral = false;
  path.over_half = radius < 0;
  const DoublePair whole = to_doubles(chord);
  const DoublePair squares = whole * whole;
  const double norm = std::sqrt(squares[0] + squares[1]);
  const DoublePair along = whole / norm;
  const double height = std::sqrt(static_cast<double>(square));
  const double magnitude = std::abs(static_cast<double>(radius));
  const DoublePair angle = DoublePair{radius < 0 ? -height : height, norm} / (2 * magnitude);
  const double sine = sigma * angle[1];
  path.radius = DoublePair{magnitude, magnitude} / kWholePerOne;
  const double curvature = sigma / path.radius[0];
  const auto set_tangent = [&](UsualTangent& tangent, double turned_sine) {
    tangent.whole = chord;
    tangent.norm = norm;
    tangent.from_whole = DoublePair{angle[0], turned_sine};
    tangent.unit = along * angle[0] + left_of(along) * turned_sine;
    tangent.curvature = curvature;
  };
  set_tangent(path.start, -sine);
  set_tangent(path.arc_end, sine);
  path.from_start = left_of(path.start.unit) * (-sigma * path.radius[0]);
  path.from_end = left_of(path.arc_end.unit) * (-sigma * path.radius[1]);
  return true;
}

// The offset circle of an arc has a radius for certain, at both ends.
inline bool has_offset_path(const UsualPath& path, const UsualOffset& offset) {
  if (path.sigma * offset.left <= 0) return true;
  const DoublePair rest = path.radius - offset.radius;
  return rest[0] > 0x1p-48 * path.radius[0] && rest[1] > 0x1p-48 * path.radius[1];
}

// Whether no vector is dropped for certain: each is beyond No. 5010 in one of the axes.
inline bool keeps_all(const UsualCorner& corner, const UsualOffset& offset) {
  const double bound = offset.limit + 0x1p-46 * (4 * offset.radius + std::abs(offset.limit));
  for (std::size_t i = 1; i < corner.size; ++i) {
    const DoublePair change = corner.vector[i] - corner.vector[i - 1];
    if (std::max(std::abs(change[0]), std::abs(change[1])) <= bound) return false;
  }
  return true;
}

// The vectors of an outer corner from tangent t1 to t2, with those perpendicular to its arcs.
[[nodiscard]] inline bool make_outer_corner(const UsualPath& former, const UsualPath& latter, DoublePair t1,
                                            DoublePair t2, const Turn& turn, const UsualOffset& offset,
                                            UsualCorner& corner) {
  const DoublePair n1 = left_of(t1) * offset.left;
  const DoublePair n2 = left_of(t2) * offset.left;
  if (former.is_arc()) corner.add(HeadKind::first_normal, n1);
  if (turn.k >= 0) {
    corner.add(HeadKind::tangents_meet, (left_of(t1) - t1 * half_tangent(turn)) * offset.left);
  } else {
    corner.add(HeadKind::first_extended, n1 + t1 * offset.radius);
    corner.add(HeadKind::second_extended, n2 - t2 * offset.radius);
  }
  if (latter.is_arc()) corner.add(HeadKind::second_normal, n2);
  const bool none_dropped = offset.keeps_all || (latter.is_arc() && latter.over_half);
  return none_dropped || keeps_all(corner, offset);
}

[[nodiscard, gnu::always_inline]] inline bool make_inner_corner(const UsualPath& former, const UsualPath& latter,
                                                                const Turn& turn, const UsualOffset& offset,
                                                                UsualCorner& corner) {
  const UsualTangent& last = former.end();
  const UsualTangent& next = latter.start;
  if (!former.is_arc() && !latter.is_arc()) {
    corner.add(HeadKind::tangents_meet, (left_of(last.unit) - last.unit * half_tangent(turn)) * offset.left);
    return true;
  }
  OffsetMeeting<double> n;
  n.t1 = to_vector(last.unit);
  n.rho = offset.left;
  n.p1 = last.curvature;
  n.p2 = next.curvature;
  set_turn(n, turn);
  const double e = curvature_term(n);
  const double discriminant = n.plus - 2 * e;
  if (!doubles_suffice(n, discriminant, turn.error)) [[unlikely]]
    return false;
  const Vector2<double> vector = paths_meet(n, e, discriminant);
  corner.add(HeadKind::paths_meet, DoublePair{vector.x, vector.y});
  return true;
}

[[nodiscard, gnu::always_inline]] inline bool make_usual_corner(const UsualPath& former, const UsualPath& latter,
                                                                const UsualOffset& offset, UsualCorner& corner) {
  const UsualTangent& last = former.end();
  const UsualTangent& next = latter.start;
  const std::int64_t c = last.whole[0] * next.whole[1] - last.whole[1] * next.whole[0];
  const std::int64_t k = last.whole[0] * next.whole[0] + last.whole[1] * next.whole[1];
  corner.size = 0;
  const bool by_radius = former.by_radius != 0 || latter.by_radius != 0;
  if (c == 0 && !by_radius) {
    // No way at all, or straight back.
    if (k <= 0) [[unlikely]]
      return false;
    corner.add(HeadKind::first_normal, left_of(last.unit) * offset.left);
    return true;
  }
  Turn turn{static_cast<double>(c), static_cast<double>(k), last.norm * next.norm};
  if (by_radius) [[unlikely]] {
    turn = turn_from_whole(turn, to_vector(last.from_whole), to_vector(next.from_whole));
    if (!doubles_suffice(turn)) return false;
  }
  return (turn.c > 0) == (offset.left > 0)
             ? make_inner_corner(former, latter, turn, offset, corner)
             : make_outer_corner(former, latter, last.unit, next.unit, turn, offset, corner);
}

// A corner of two lines as ToolPlane::set_turn() of tool side compensation sees it, with the tool along the normal of
// the plane: by the reciprocals of their lengths, and the cosine by products of doubles.
[[nodiscard]] inline bool make_corner_of_seen_lines(const UsualPath& former, const UsualPath& latter,
                                                    const UsualOffset& offset, UsualCorner& corner) {
  const WholePair& way1 = former.start.whole;
  const WholePair& way2 = latter.start.whole;
  const std::int64_t c = way1[0] * way2[1] - way1[1] * way2[0];
  const DoublePair first = to_doubles(way1);
  const DoublePair second = to_doubles(way2);
  const DoublePair products = first * second;
  const double k = products[0] + products[1];
  // Nearer to a right angle the products are summed up as whole numbers there.
  const bool right = way1[0] * way2[0] + way1[1] * way2[1] == 0;
  if (!right && std::abs(k) <= 0x1p-40 * (former.start.norm * latter.start.norm)) [[unlikely]]
    return false;
  const double inverse1 = 1 / former.start.norm;
  const double inverse2 = 1 / latter.start.norm;
  const double inverses = inverse1 * inverse2;
  const DoublePair t1 = first * inverse1;
  const DoublePair t2 = second * inverse2;
  corner.size = 0;
  if (c == 0) {
    // Straight back.
    if (k <= 0) [[unlikely]]
      return false;
    corner.add(HeadKind::first_normal, left_of(t1) * offset.left);
    return true;
  }
  const Turn turn{static_cast<double>(c) * inverses, right ? 0 : k * inverses, 1};
  if ((turn.c > 0) != (offset.left > 0)) return make_outer_corner(former, latter, t1, t2, turn, offset, corner);
  // Near a reversal it takes more than doubles.
  if (turn.k < 0 && std::abs(turn.c) < 0x1p-3) [[unlikely]]
    return false;
  corner.add(HeadKind::tangents_meet, (left_of(t1) - t1 * half_tangent(turn)) * offset.left);
  return true;
}

// What the interference check asks of a line, from a vector to another: the tool goes forward for certain. Where the
// vector changes by less than the way, at once.
inline bool goes_forward(DoublePair unit, double norm, DoublePair from, DoublePair to) {
  const DoublePair change = to - from;
  if (extent(change) < (1 - 0x1p-30) / kWholePerOne * norm) [[likely]]
    return true;
  const double length = norm / kWholePerOne;
  const double product = length + (unit[0] * change[0] + unit[1] * change[1]);
  return product > 0x1p-46 * (length + extent(to) + extent(from));
}

}  // namespace toolcomp::fast

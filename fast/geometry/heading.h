// SPDX-License-Identifier: Apache-2.0
// Directions of travel at a corner, exactly, and the turn from one to the next.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "fast/arithmetic/int128.h"
#include "fast/geometry/vector2.h"

namespace toolcomp::fast {

// The direction of a line, or of the tangent of an arc at one of its ends.
//  - Lines and arcs given by their centre: parallel to `whole`, a vector of whole numbers. The length of `whole` is
//  that
//    of the line, or the radius at that end.
//  - Arcs given by their radius: the chord, `whole`, turned by half the sweep; cosine of it height / 2R, sine
//    |chord| / 2R, with height = (+-) sqrt(4 R^2 - chord^2). Not rational, so `exact` is false.
struct Heading {
  std::array<Int128, 2> whole{};
  bool exact = true;
  bool narrow = false;               // |whole| below 2^31, and exact: products fit into 64 bits
  bool small = false;                // |whole| below 2^62: products fit into 128 bits
  int turned = 0;                    // not exact: -1 the chord is turned right, +1 left
  bool larger = false;               // not exact: the height is negative
  Int128 radius = 0;                 // not exact: |R|
  Vector2<double> from_whole{1, 0};  // not exact: cosine and sine of the angle from `whole` to the heading
  Vector2<double> unit{1, 0};
  double norm = 1;  // |whole|
  // Seen in a plane that no axis spans: the unit vector itself is all there is.
  bool seen = false;
  Vector2<DoubleDouble> fine;
};

// The heading along `whole`, not zero.
Heading whole_heading(const std::array<Int128, 2>& whole);
// The same, made in place, for numbers below 2^31.
inline double narrow_norm(std::int64_t x, std::int64_t y) {
  const auto dx = static_cast<double>(x);
  const auto dy = static_cast<double>(y);
  return std::sqrt(dx * dx + dy * dy);  // exact where one of them is 0
}
inline void set_narrow_heading(Heading& heading, std::int64_t x, std::int64_t y, double norm) {
  heading.whole = {x, y};
  heading.exact = heading.narrow = heading.small = true;
  heading.norm = norm;
  heading.unit = {static_cast<double>(x) / norm, static_cast<double>(y) / norm};
}
inline void set_narrow_heading(Heading& heading, std::int64_t x, std::int64_t y) {
  set_narrow_heading(heading, x, y, narrow_norm(x, y));
}

// The tangents of an arc of radius `radius` over `chord` at its start and end; 4 R^2 >= chord^2.
struct ChordHeadings {
  Heading start;
  Heading end;
  double height = 0;  // 2 h, negative for the larger arc; in the unit of the chord
  double radius = 0;  // |R|, the same
  double chord = 0;   // its length, the same
  bool half = false;  // h = 0
};
ChordHeadings chord_headings(const std::array<Int128, 2>& chord, const Int128& radius, bool clockwise);

// The unit vector along a heading, relative error about 2^-100.
Vector2<DoubleDouble> fine_unit(const Heading& heading);

// How a path turns from heading t1 to t2, vectors of some length: c = t1 x t2, k = t1 . t2, of exact signs and zeros.
struct Turn {
  double c = 0;
  double k = 1;
  double norms = 1;  // |t1| |t2|
  double error = 0;  // not exact: c is within a few roundings of this number
};
// The tangent of half the angle.
inline double half_tangent(const Turn& turn) {
  return turn.k >= 0 ? turn.c / (turn.norms + turn.k) : (turn.norms - turn.k) / turn.c;
}

// The same where a heading is not exact: from that between their `whole`, turned from there by angles of these cosines
// and sines, short arcs by little.
inline Turn turn_from_whole(const Turn& whole, const Vector2<double>& from, const Vector2<double>& to) {
  const double c = whole.c / whole.norms;
  const double k = whole.k / whole.norms;
  const double sine = cross(from, to);
  const double cosine = dot(from, to);
  return {c * cosine + k * sine, k * cosine - c * sine, 1, std::abs(c) + std::abs(from.y) + std::abs(to.y)};
}
// Near a tangent join or a right angle doubles are not enough for it, straight back not for the value either: below
// this sine the vectors of a sharp corner are so long that the relative error of the sine counts.
inline bool doubles_suffice(const Turn& turn) {
  constexpr double kBound = 0x1p-48;
  constexpr double kSharp = 0x1p-10;
  return std::abs(turn.c) >= (turn.k < 0 ? kSharp : kBound * turn.error) && std::abs(turn.k) >= kBound;
}

// Signs are exact for exact headings. Otherwise doubles decide outside 2^-48, double-double outside 2^-94, and what is
// left is taken for zero: tangent joins with an arc given by R are zero, and nothing else made of 15 digits comes near.
Turn turn_of_any(const Heading& first, const Heading& second);

// The same of the usual headings, in 64 bits.
inline Turn turn_of_narrow(const Heading& first, const Heading& second) {
  const auto x1 = static_cast<std::int64_t>(first.whole[0]);
  const auto y1 = static_cast<std::int64_t>(first.whole[1]);
  const auto x2 = static_cast<std::int64_t>(second.whole[0]);
  const auto y2 = static_cast<std::int64_t>(second.whole[1]);
  const std::int64_t c = x1 * y2 - y1 * x2;
  const std::int64_t k = x1 * x2 + y1 * y2;
  return {static_cast<double>(c), static_cast<double>(k), first.norm * second.norm};
}
inline Turn turn(const Heading& first, const Heading& second) {
  if (!(first.narrow && second.narrow)) [[unlikely]]
    return turn_of_any(first, second);
  return turn_of_narrow(first, second);
}

}  // namespace toolcomp::fast

// Directions of travel at a corner, exactly, and the turn from one to the next.
#pragma once

#include <array>
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
  bool narrow = false;  // |whole| below 2^31, and exact: products fit into 64 bits
  bool small = false;   // |whole| below 2^62: products fit into 128 bits
  int turned = 0;       // not exact: -1 the chord is turned right, +1 left
  bool larger = false;  // not exact: the height is negative
  Int128 radius = 0;    // not exact: |R|
  Vector2<double> unit{1, 0};
  double norm = 1;  // |whole|
};

// The heading along `whole`, not zero.
Heading whole_heading(const std::array<Int128, 2>& whole);
// The same, made in place, for numbers below 2^31.
inline void set_narrow_heading(Heading& heading, std::int64_t x, std::int64_t y) {
  heading.whole = {x, y};
  heading.exact = heading.narrow = heading.small = true;
  const auto dx = static_cast<double>(x);
  const auto dy = static_cast<double>(y);
  const double square = dx * dx + dy * dy;
  heading.norm = std::sqrt(square);  // exact where one of them is 0
  heading.unit = {dx / heading.norm, dy / heading.norm};
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

// How a path turns from heading t1 to t2: c = t1 x t2, k = t1 . t2; their signs, and zeros, are exact.
struct Turn {
  double c = 0;
  double k = 1;
};

// Signs are exact for exact headings. Otherwise doubles decide outside 2^-48, double-double outside 2^-94, and what is
// left is taken for zero: tangent joins with an arc given by R are zero, and nothing else made of 15 digits comes near.
Turn turn_of_any(const Heading& first, const Heading& second);

// The same; the usual headings at once, in 64 bits.
inline Turn turn(const Heading& first, const Heading& second) {
  if (!(first.narrow && second.narrow)) [[unlikely]]
    return turn_of_any(first, second);
  const auto x1 = static_cast<std::int64_t>(first.whole[0]);
  const auto y1 = static_cast<std::int64_t>(first.whole[1]);
  const auto x2 = static_cast<std::int64_t>(second.whole[0]);
  const auto y2 = static_cast<std::int64_t>(second.whole[1]);
  const std::int64_t c = x1 * y2 - y1 * x2;
  const std::int64_t k = x1 * x2 + y1 * y2;
  const double norms = 1 / (first.norm * second.norm);
  return {static_cast<double>(c) * norms, static_cast<double>(k) * norms};
}

}  // namespace toolcomp::fast

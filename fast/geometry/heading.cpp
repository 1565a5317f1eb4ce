// SPDX-License-Identifier: Apache-2.0
#include "fast/geometry/heading.h"

#include "fast/arithmetic/wide.h"

namespace toolcomp::fast {
namespace {

constexpr Int128 kNarrow = Int128{1} << 31;
constexpr Int128 kSmall = Int128{1} << 62;
constexpr double kFineTurnBound = 0x1p-94;

bool within(const std::array<Int128, 2>& v, const Int128& limit) {
  return v[0] < limit && v[0] > -limit && v[1] < limit && v[1] > -limit;
}

Wide cross_of(const std::array<Int128, 2>& a, const std::array<Int128, 2>& b) {
  return Wide(a[0]) * Wide(b[1]) - Wide(a[1]) * Wide(b[0]);
}
Wide dot_of(const std::array<Int128, 2>& a, const std::array<Int128, 2>& b) {
  return Wide(a[0]) * Wide(b[0]) + Wide(a[1]) * Wide(b[1]);
}

DoubleDouble squared_length(const Heading& heading) {
  const auto& [x, y] = heading.whole;
  return heading.narrow ? to_double_double(x * x + y * y) : dot_of(heading.whole, heading.whole).to_double_double();
}

// sqrt(4 R^2 - chord^2) without cancellation.
DoubleDouble height_of(const std::array<Int128, 2>& chord, const Int128& radius) {
  return sqrt((Wide(4) * Wide(radius) * Wide(radius) - dot_of(chord, chord)).to_double_double());
}

Vector2<double> from_whole(const Heading& heading) {
  return heading.exact ? Vector2<double>{1, 0} : heading.from_whole;
}

}  // namespace

Heading whole_heading(const std::array<Int128, 2>& whole) {
  Heading heading;
  heading.whole = whole;
  heading.narrow = within(whole, kNarrow);
  heading.small = heading.narrow || within(whole, kSmall);
  if (heading.narrow) {
    set_narrow_heading(heading, static_cast<std::int64_t>(whole[0]), static_cast<std::int64_t>(whole[1]));
    return heading;
  }
  const auto x = static_cast<double>(whole[0]);
  const auto y = static_cast<double>(whole[1]);
  heading.norm = y == 0 ? std::abs(x) : (x == 0 ? std::abs(y) : std::sqrt(x * x + y * y));
  heading.unit = {x / heading.norm, y / heading.norm};
  return heading;
}

ChordHeadings chord_headings(const std::array<Int128, 2>& chord, const Int128& radius, bool clockwise) {
  ChordHeadings arc;
  const bool larger = radius < 0;
  const Int128 magnitude = larger ? -radius : radius;
  const Heading along = whole_heading(chord);
  double height = 0;
  if (along.small && magnitude < kSmall / 2) {
    const Int128 square = 4 * magnitude * magnitude - (chord[0] * chord[0] + chord[1] * chord[1]);
    arc.half = square == 0;
    height = std::sqrt(static_cast<double>(square));
  } else {
    const DoubleDouble fine = height_of(chord, magnitude);
    arc.half = fine.hi == 0;
    height = fine.hi;
  }
  arc.height = larger ? -height : height;
  arc.radius = static_cast<double>(magnitude);
  arc.chord = along.norm;
  const double cosine = arc.height / (2 * arc.radius);
  const double sine = along.norm / (2 * arc.radius);
  const int left = clockwise ? -1 : 1;
  for (const int turned : {-left, left}) {
    Heading& heading = turned == -left ? arc.start : arc.end;
    if (arc.half) {
      // The tangents of a half circle are at right angles to its chord.
      heading = turned > 0 ? whole_heading({-chord[1], chord[0]}) : whole_heading({chord[1], -chord[0]});
      continue;
    }
    heading.whole = chord;
    heading.exact = false;
    heading.turned = turned;
    heading.larger = larger;
    heading.radius = magnitude;
    heading.small = along.small;
    heading.norm = along.norm;
    heading.from_whole = {cosine, turned * sine};
    heading.unit = along.unit * cosine + left_of(along.unit) * (turned * sine);
  }
  return arc;
}

Vector2<DoubleDouble> fine_unit(const Heading& heading) {
  if (heading.seen) return heading.fine;
  const Vector2<DoubleDouble> whole{to_double_double(heading.whole[0]), to_double_double(heading.whole[1])};
  const DoubleDouble norm = sqrt(squared_length(heading));
  const Vector2<DoubleDouble> unit{whole.x / norm, whole.y / norm};
  if (heading.exact) return unit;
  const DoubleDouble twice = to_double_double(heading.radius) * 2.0;
  const DoubleDouble height = height_of(heading.whole, heading.radius) / twice;
  const DoubleDouble sine = norm / twice;
  return unit * (heading.larger ? -height : height) + left_of(unit) * (heading.turned > 0 ? sine : -sine);
}

Turn turn_of_any(const Heading& first, const Heading& second) {
  Turn result;
  result.norms = first.norm * second.norm;
  if (first.small && second.small) {
    const Int128 exact_c = first.whole[0] * second.whole[1] - first.whole[1] * second.whole[0];
    const Int128 exact_k = first.whole[0] * second.whole[0] + first.whole[1] * second.whole[1];
    result.c = static_cast<double>(exact_c);
    result.k = static_cast<double>(exact_k);
  } else {
    result.c = cross_of(first.whole, second.whole).to_double();
    result.k = dot_of(first.whole, second.whole).to_double();
  }
  if (first.exact && second.exact) return result;
  // So far from chord to chord; from there each arc by radius turns by half its sweep.
  result = turn_from_whole(result, from_whole(first), from_whole(second));
  if (!doubles_suffice(result)) {
    const Vector2<DoubleDouble> t1 = fine_unit(first);
    const Vector2<DoubleDouble> t2 = fine_unit(second);
    result.c = cross(t1, t2).hi;
    result.k = dot(t1, t2).hi;
    if (std::abs(result.c) < kFineTurnBound) result.c = 0;
    if (std::abs(result.k) < kFineTurnBound) result.k = 0;
  }
  return result;
}

}  // namespace toolcomp::fast

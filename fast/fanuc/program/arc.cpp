// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/program/arc.h"

#include <cmath>

#include "fast/arithmetic/double_double.h"
#include "fast/arithmetic/trigonometry.h"
#include "fast/arithmetic/wide.h"

namespace toolcomp::fast {
namespace {

const DoubleDouble kUnitsPerOne = to_double_double(Count::kRestPerOne);

DoubleDouble length_of(const DoubleDouble& squared_units) { return sqrt(squared_units) / kUnitsPerOne; }

// An arc by radius.
struct ByRadius {
  std::array<DoubleDouble, 2> from_middle;  // the centre, from the middle of the chord
  DoubleDouble chord_length;
  DoubleDouble height;  // twice the distance of the centre from the chord
};

ByRadius by_radius(const std::array<Int128, 2>& chord, const Wide& chord_square, const Wide& height_square,
                   bool clockwise, bool larger) {
  ByRadius arc;
  arc.chord_length = sqrt(chord_square.to_double_double());
  arc.height = sqrt(height_square.to_double_double());
  // The centre lies left of the chord for a smaller arc counterclockwise or a larger one clockwise.
  const DoubleDouble side = arc.height / arc.chord_length * (clockwise == larger ? 0.5 : -0.5);
  arc.from_middle = {-to_double_double(chord[1]) * side, to_double_double(chord[0]) * side};
  return arc;
}

}  // namespace

std::array<DoubleDouble, 2> fine_center(const std::array<Count, 2>& start, const std::array<Count, 2>& end,
                                        const ArcWords& words) {
  if (!words.by_radius)
    return {to_double_double(words.to_center[0].units()), to_double_double(words.to_center[1].units())};
  const std::array<Int128, 2> chord{(end[0] - start[0]).units(), (end[1] - start[1]).units()};
  const Wide chord_square = Wide(chord[0]) * Wide(chord[0]) + Wide(chord[1]) * Wide(chord[1]);
  const Wide radius(words.radius.units());
  const Wide height_square = Wide(4) * radius * radius - chord_square;
  const ByRadius arc = by_radius(chord, chord_square, height_square, words.clockwise, words.radius < Count());
  std::array<DoubleDouble, 2> center;
  for (std::size_t i = 0; i < 2; ++i) center[i] = to_double_double(chord[i]) * 0.5 + arc.from_middle[i];
  return center;
}

// atan2 gives a start; one step of the angle addition formula in double-double gives the rest. NaN for NaN.
double positive_angle(const DoubleDouble& x, const DoubleDouble& y) {
  if (y.hi == 0) return x.hi > 0 ? 360 : 180;
  if (x.hi == 0) return y.hi > 0 ? 90 : 270;
  constexpr DoubleDouble kDegrees{0x1.ca5dc1a63c1f8p+5, -0x1.1e7ab456405f9p-49};  // 180 / pi
  double first = std::atan2(y.hi, x.hi) * kDegrees.hi;
  if (std::isnan(first)) return first;
  if (first < 0) first += 360;
  const Count start = Count::of_units(static_cast<Int128>(first * kUnitsPerOne.hi));
  const auto t = fine_sine_cosine(start);
  const DoubleDouble rest = (y * t.cosine - x * t.sine) / (x * t.cosine + y * t.sine);
  return to_double(to_double_double(start.units()) / kUnitsPerOne + rest * kDegrees);
}

Alarm center_by_any_center(const std::array<Count, 2>& start, const std::array<Count, 2>& to_center,
                           std::array<double, 2>& center) {
  if (to_center[0].is_zero() && to_center[1].is_zero()) return AlarmCause::arc_without_center;
  for (std::size_t i = 0; i < 2; ++i) {
    const Count sum = start[i] + to_center[i];
    if (!sum.in_range()) return AlarmCause::position_range;
    center[i] = sum.nearest();
  }
  return AlarmCause::none;
}

Alarm center_by_radius(const std::array<Count, 2>& start, const std::array<Count, 2>& end, const Count& radius,
                       bool clockwise, std::array<double, 2>& center) {
  const std::array<Count, 2> chord{end[0] - start[0], end[1] - start[1]};
  if (!(chord[0].is_small() && chord[1].is_small() && radius.is_small())) {
    ArcGeometry arc;
    const Alarm a = arc_by_radius(start, end, radius, clockwise, arc);
    center = arc.center;
    return a;
  }
  // The one difference that can cancel is exact; the rest is within a few ulp of the longest of its terms.
  const auto square = [](const Count& value) { return static_cast<Int128>(value.small()) * value.small(); };
  const Int128 chord_square = square(chord[0]) + square(chord[1]);
  const Int128 height_square = 4 * square(radius) - chord_square;
  if (height_square < 0) return AlarmCause::arc_radius_too_short;
  const double ratio = std::sqrt(static_cast<double>(height_square) / static_cast<double>(chord_square));
  const double side = clockwise == (radius.small() < 0) ? 0.5 * ratio : -0.5 * ratio;
  center[0] = start[0].nearest() + (0.5 * chord[0].nearest() - chord[1].nearest() * side);
  center[1] = start[1].nearest() + (0.5 * chord[1].nearest() + chord[0].nearest() * side);
  return AlarmCause::none;
}

Alarm check_radii(const std::array<Count, 2>& start, const std::array<Count, 2>& end,
                  const std::array<Count, 2>& to_center, const Count& most) {
  Wide squares[2];
  for (std::size_t i = 0; i < 2; ++i) {
    const Wide from((-to_center[i]).units());
    const Wide to((end[i] - start[i] - to_center[i]).units());
    squares[0] = squares[0] + from * from;
    squares[1] = squares[1] + to * to;
  }
  // A full circle has one radius.
  if (start == end) return AlarmCause::none;
  // With A >= B: sqrt A - sqrt B > L where A - B - L^2 > 0 and (A - B - L^2)^2 > 4 L^2 B.
  if ((squares[0] - squares[1]).sign() < 0) std::swap(squares[0], squares[1]);
  const Wide limit = Wide(most.units()) * Wide(most.units());
  const Wide excess = squares[0] - squares[1] - limit;
  if (excess.sign() <= 0) return AlarmCause::none;
  return (excess * excess - Wide(4) * limit * squares[1]).sign() > 0 ? AlarmCause::arc_radii_differ : AlarmCause::none;
}

Alarm arc_by_center(const std::array<Count, 2>& start, const std::array<Count, 2>& end,
                    const std::array<Count, 2>& to_center, bool clockwise, ArcGeometry& arc) {
  if (to_center[0].is_zero() && to_center[1].is_zero()) return AlarmCause::arc_without_center;
  std::array<Wide, 2> from;
  std::array<Wide, 2> to;
  for (std::size_t i = 0; i < 2; ++i) {
    const Count center = start[i] + to_center[i];
    if (!center.in_range()) return AlarmCause::position_range;
    arc.center[i] = center.nearest();
    from[i] = Wide((-to_center[i]).units());
    to[i] = Wide((end[i] - center).units());
  }
  const Wide start_square = from[0] * from[0] + from[1] * from[1];
  const Wide end_square = to[0] * to[0] + to[1] * to[1];
  arc.radius.reset();
  if ((start_square - end_square).sign() != 0)
    arc.radius = {to_double(length_of(start_square.to_double_double())),
                  to_double(length_of(end_square.to_double_double()))};
  arc.sweep.reset();
  if (end_square.sign() != 0) {
    const Wide turn = from[0] * to[1] - from[1] * to[0];
    arc.sweep = positive_angle((from[0] * to[0] + from[1] * to[1]).to_double_double(),
                               (clockwise ? -turn : turn).to_double_double());
  }
  return AlarmCause::none;
}

Alarm arc_by_radius(const std::array<Count, 2>& start, const std::array<Count, 2>& end, const Count& radius,
                    bool clockwise, ArcGeometry& arc) {
  const std::array<Int128, 2> chord{(end[0] - start[0]).units(), (end[1] - start[1]).units()};
  const Wide chord_square = Wide(chord[0]) * Wide(chord[0]) + Wide(chord[1]) * Wide(chord[1]);
  // 4 h^2 = 4 R^2 - chord^2, h the distance of the centre from the chord.
  const Wide height_square = Wide(4) * Wide(radius.units()) * Wide(radius.units()) - chord_square;
  if (height_square.sign() < 0) return AlarmCause::arc_radius_too_short;
  const bool larger = radius < Count();
  const ByRadius made = by_radius(chord, chord_square, height_square, clockwise, larger);
  for (std::size_t i = 0; i < 2; ++i) {
    const DoubleDouble middle = to_double_double(start[i].units() + end[i].units()) * 0.5;
    arc.center[i] = to_double((middle + made.from_middle[i]) / kUnitsPerOne);
  }
  arc.radius.reset();
  if (made.height.hi == 0) {
    arc.sweep = 180;
  } else {
    const double minor = 2 * positive_angle(made.height, made.chord_length);
    arc.sweep = larger ? 2 * positive_angle(-made.height, made.chord_length) : minor;
  }
  return AlarmCause::none;
}

}  // namespace toolcomp::fast

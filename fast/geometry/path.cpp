// SPDX-License-Identifier: Apache-2.0
#include "fast/geometry/path.h"

#include "fast/arithmetic/wide.h"
#include "fast/geometry/angle.h"

namespace toolcomp::fast {
namespace {

// Differences as whole numbers: of 10^-6 where all terms are, else of 1 / (127 * 10^18).
struct Whole {
  bool fine = false;
  [[nodiscard]] Int128 operator()(const Count& value) const { return fine ? value.units() : Int128{value.small()}; }
  [[nodiscard]] Int128 difference(const Count& to, const Count& from) const {
    return fine ? to.units() - from.units() : Int128{to.small() - from.small()};
  }
};

bool is_small(const std::array<Count, 2>& v) { return v[0].is_small() && v[1].is_small(); }

}  // namespace

void set_any_line(PlanePath& path, const std::array<Count, 2>& start, const std::array<Count, 2>& end) {
  const Whole whole{!(is_small(start) && is_small(end))};
  path.arc = false;
  path.fine_units = whole.fine;
  path.start = whole_heading({whole.difference(end[0], start[0]), whole.difference(end[1], start[1])});
}

// Without 128 bits.
void set_narrow_arc(PlanePath& path, const std::array<std::int64_t, 2>& from, const std::array<std::int64_t, 2>& to) {
  constexpr auto kOne = static_cast<double>(Count::kSmallPerOne);
  const std::int64_t sigma = path.sigma;
  const auto vector = [](const std::array<std::int64_t, 2>& v) {
    return Vector2<double>{static_cast<double>(v[0]) / kOne, static_cast<double>(v[1]) / kOne};
  };
  path.spiral = from[0] * from[0] + from[1] * from[1] != to[0] * to[0] + to[1] * to[1];
  const double norm = narrow_norm(from[0], from[1]);
  const double end_norm = path.spiral ? narrow_norm(to[0], to[1]) : norm;
  set_narrow_heading(path.start, -sigma * from[1], sigma * from[0], norm);
  set_narrow_heading(path.arc_end, -sigma * to[1], sigma * to[0], end_norm);
  path.from_center_start = vector(from);
  path.from_center_end = vector(to);
  const std::array<std::int64_t, 2> travel{to[0] - from[0], to[1] - from[1]};
  path.whole = {travel[0], travel[1]};
  const std::int64_t sine = sigma * (from[0] * to[1] - from[1] * to[0]);
  path.turned = sine > 0 ? 1 : (sine < 0 ? -1 : 0);
  path.sine = static_cast<double>(sine);
  path.cosine = static_cast<double>(from[0] * to[0] + from[1] * to[1]);
  path.radius_start = norm / kOne;
  path.radius_end = end_norm / kOne;
  path.semicircle = path.turned <= 0;
  path.over_half = path.turned < 0 || (path.turned == 0 && path.cosine > 0);
}

namespace {

void set_any_arc(PlanePath& path, const std::array<Count, 2>& start, const std::array<Count, 2>& end,
                 const std::array<Count, 2>& to_center) {
  const Whole whole{!(is_small(start) && is_small(end) && is_small(to_center))};
  path.fine_units = whole.fine;
  const std::array<Int128, 2> travel{whole.difference(end[0], start[0]), whole.difference(end[1], start[1])};
  path.whole = travel;
  const double unit = per_one(path);
  // From the centre; the tangent is that turned left (counterclockwise) or right.
  const std::array<Int128, 2> from{-whole(to_center[0]), -whole(to_center[1])};
  const std::array<Int128, 2> to{from[0] + travel[0], from[1] + travel[1]};
  const bool starts_in_center = from[0] == 0 && from[1] == 0;
  path.ends_in_center = starts_in_center || (to[0] == 0 && to[1] == 0);
  if (starts_in_center) return;
  const Int128 sigma = path.sigma;
  path.start = whole_heading({-sigma * from[1], sigma * from[0]});
  path.radius_start = path.start.norm / unit;
  path.from_center_start = {static_cast<double>(from[0]) / unit, static_cast<double>(from[1]) / unit};
  path.from_center_end = {static_cast<double>(to[0]) / unit, static_cast<double>(to[1]) / unit};
  path.spiral = true;
  path.semicircle = false;
  path.over_half = false;
  if (path.ends_in_center) {
    path.arc_end = path.start;
    path.radius_end = 0;
    return;
  }
  path.arc_end = whole_heading({-sigma * to[1], sigma * to[0]});
  path.radius_end = path.arc_end.norm / unit;
  if (path.start.small && path.arc_end.small) {
    const Int128 c = sigma * (from[0] * to[1] - from[1] * to[0]);
    path.turned = c > 0 ? 1 : (c < 0 ? -1 : 0);
    path.sine = static_cast<double>(c);
    path.cosine = static_cast<double>(from[0] * to[0] + from[1] * to[1]);
    path.spiral = from[0] * from[0] + from[1] * from[1] != to[0] * to[0] + to[1] * to[1];
  } else {
    const std::array<Wide, 4> w{Wide(from[0]), Wide(from[1]), Wide(to[0]), Wide(to[1])};
    const Wide c = Wide(sigma) * (w[0] * w[3] - w[1] * w[2]);
    path.turned = c.sign();
    path.sine = c.to_double();
    path.cosine = (w[0] * w[2] + w[1] * w[3]).to_double();
    path.spiral = (w[0] * w[0] + w[1] * w[1] - w[2] * w[2] - w[3] * w[3]).sign() != 0;
  }
  if (!path.spiral) path.radius_end = path.radius_start;
  path.semicircle = path.turned <= 0;
  path.over_half = path.turned < 0 || (path.turned == 0 && path.cosine > 0);
}

}  // namespace

void set_arc(PlanePath& path, const std::array<Count, 2>& start, const std::array<Count, 2>& end,
             const std::array<Count, 2>& to_center, bool clockwise) {
  path.arc = true;
  path.sigma = clockwise ? -1 : 1;
  path.by_radius = false;
  const std::array<std::int64_t, 2> from{-to_center[0].small(), -to_center[1].small()};
  const std::array<std::int64_t, 2> to{end[0].small() - start[0].small() + from[0],
                                       end[1].small() - start[1].small() + from[1]};
  const bool narrow = is_narrow(from[0]) && is_narrow(from[1]) && is_narrow(to[0]) && is_narrow(to[1]);
  if (!narrow || !(is_small(start) && is_small(end) && is_small(to_center)) || (from[0] == 0 && from[1] == 0) ||
      (to[0] == 0 && to[1] == 0)) [[unlikely]]
    return set_any_arc(path, start, end, to_center);
  path.fine_units = false;
  path.ends_in_center = false;
  set_narrow_arc(path, from, to);
}

void set_arc_by_radius(PlanePath& path, const std::array<Count, 2>& start, const std::array<Count, 2>& end,
                       const Count& radius, bool clockwise) {
  const Whole whole{!(is_small(start) && is_small(end) && radius.is_small())};
  path.arc = true;
  path.sigma = clockwise ? -1 : 1;
  path.by_radius = true;
  path.spiral = false;
  path.ends_in_center = false;
  path.fine_units = whole.fine;
  const Int128 r = whole(radius);
  path.radius_whole = r < 0 ? -r : r;
  const std::array<Int128, 2> chord{whole.difference(end[0], start[0]), whole.difference(end[1], start[1])};
  path.whole = chord;
  const ChordHeadings arc = chord_headings(chord, r, clockwise);
  path.start = arc.start;
  path.arc_end = arc.end;
  path.radius_start = path.radius_end = arc.radius / per_one(path);
  const double sigma = path.sigma;
  path.from_center_start = left_of(path.start.unit) * (-sigma * path.radius_start);
  path.from_center_end = left_of(path.arc_end.unit) * (-sigma * path.radius_end);
  path.semicircle = r < 0 || arc.half;
  path.over_half = r < 0 && !arc.half;
  path.turned = arc.half ? 0 : 1;
  path.sine = arc.chord;
  path.cosine = arc.height;
}

namespace {

DoubleDouble fine_unit_of(const PlanePath& path) {
  return path.fine_units ? to_double_double(Count::kRestPerOne)
                         : DoubleDouble{static_cast<double>(Count::kSmallPerOne), 0};
}

}  // namespace

double programmed_sweep(const PlanePath& path) {
  if (path.by_radius) return path.turned == 0 ? 180 : 2 * polar_angle(path.cosine, path.sine);
  if (path.turned == 0) return path.cosine > 0 ? 360 : 180;
  const double angle = polar_angle(path.cosine, path.sine);
  return path.turned < 0 ? angle + 360 : angle;
}

Vector2<DoubleDouble> fine_travel(const PlanePath& path) {
  const DoubleDouble unit = fine_unit_of(path);
  const std::array<Int128, 2>& whole = path.arc ? path.whole : path.start.whole;
  return {to_double_double(whole[0]) / unit, to_double_double(whole[1]) / unit};
}

DoubleDouble fine_radius(const PlanePath& path, bool at_end) {
  if (path.seen) return path.fine_radius[at_end ? 1 : 0];
  const DoubleDouble unit = fine_unit_of(path);
  if (path.by_radius) return to_double_double(path.radius_whole) / unit;
  const Heading& tangent = at_end ? path.arc_end : path.start;
  const auto& v = tangent.whole;
  if (tangent.narrow) return sqrt(to_double_double(v[0] * v[0] + v[1] * v[1])) / unit;
  return sqrt((Wide(v[0]) * Wide(v[0]) + Wide(v[1]) * Wide(v[1])).to_double_double()) / unit;
}

int compare_whole_radius(const PlanePath& path, bool at_end, const Amount& offset) {
  if (path.seen) {
    const double radius = at_end ? path.radius_end : path.radius_start;
    const DoubleDouble length = to_double_double(offset.exact.units()) / to_double_double(Count::kRestPerOne);
    const double difference = (fine_radius(path, at_end) - length).hi;
    // What double-double cannot tell is a tie.
    return std::abs(difference) <= 0x1p-90 * radius ? 0 : (difference > 0 ? 1 : -1);
  }
  const auto in_units = [&](const Int128& whole) { return path.fine_units ? whole : whole * Count::kRestPerSmall; };
  if (path.by_radius) {
    const Int128 difference = in_units(path.radius_whole) - offset.exact.units();
    return difference > 0 ? 1 : (difference < 0 ? -1 : 0);
  }
  const auto& v = at_end ? path.arc_end.whole : path.start.whole;
  const Wide x(in_units(v[0]));
  const Wide y(in_units(v[1]));
  const Wide d(offset.exact.units());
  return (x * x + y * y - d * d).sign();
}

}  // namespace toolcomp::fast

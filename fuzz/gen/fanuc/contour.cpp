// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/fanuc/contour.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace toolcomp::fuzz {
namespace {

// x² + y² = 325², one of each eight alike.
constexpr std::int64_t kHypotenuse = 325;
constexpr PlaneCounts kLattice[] = {{325, 0},   {323, 36},  {315, 80},  {312, 91},
                                    {300, 125}, {280, 165}, {260, 195}, {253, 204}};

constexpr double kTangentOfOneDegree = 0.01745506492821759;

double length_of(PlaneCounts v) { return std::hypot(static_cast<double>(v.x), static_cast<double>(v.y)); }

std::int64_t magnitude(std::int64_t x) { return x < 0 ? -x : x; }

// The shortest whole vector along v.
PlaneCounts primitive(PlaneCounts v) {
  const std::int64_t divisor = std::gcd(magnitude(v.x), magnitude(v.y));
  return divisor == 0 ? PlaneCounts{1, 0} : PlaneCounts{v.x / divisor, v.y / divisor};
}

// |v| where it is whole.
std::optional<std::int64_t> whole_length(PlaneCounts v) {
  const auto length = static_cast<std::int64_t>(std::llround(length_of(v)));
  constexpr std::int64_t most = 2'000'000'000;  // its square is a 64-bit number
  if (length > most || length * length != v.x * v.x + v.y * v.y) return std::nullopt;
  return length;
}

// The whole vectors as long as v that mirroring at the axes and the diagonals makes of it.
std::vector<PlaneCounts> images(PlaneCounts v) {
  std::vector<PlaneCounts> all;
  for (const PlaneCounts p : {v, PlaneCounts{v.y, v.x}})
    for (const int sign : {0, 1, 2, 3}) all.push_back({(sign & 1) != 0 ? -p.x : p.x, (sign & 2) != 0 ? -p.y : p.y});
  return all;
}

// The points of the circle about zero through `on` that lie on the lattice.
std::vector<PlaneCounts> lattice_points(PlaneCounts on) {
  const auto radius = whole_length(on);
  if (!radius) return images(on);
  std::vector<PlaneCounts> points;
  for (const PlaneCounts& heading : kLattice)
    if (heading.x * *radius % kHypotenuse == 0 && heading.y * *radius % kHypotenuse == 0)
      for (const PlaneCounts& p : images({heading.x * *radius / kHypotenuse, heading.y * *radius / kHypotenuse}))
        points.push_back(p);
  return points.empty() ? images(on) : points;
}

}  // namespace

PlaneCounts Contour::parallel(PlaneCounts v, std::int64_t length) const {
  const PlaneCounts p = primitive(v);
  const double shortest = length_of(p);
  // Directions of irrational arcs have no short vector: rounded, they are a hair off.
  if (shortest > 400 * static_cast<double>(one_)) {
    const double factor = static_cast<double>(length) / shortest;
    return {std::llround(static_cast<double>(p.x) * factor), std::llround(static_cast<double>(p.y) * factor)};
  }
  return std::max<std::int64_t>(1, std::llround(static_cast<double>(length) / shortest)) * p;
}

PlaneCounts Contour::any_direction(std::int64_t length) {
  PlaneCounts p = choose_.chance(40) ? kLattice[choose_.one_of<std::size_t>({0, 0, 6})] : choose_.one_of(kLattice);
  if (choose_.chance(50)) std::swap(p.x, p.y);
  if (choose_.chance(50)) p.x = -p.x;
  if (choose_.chance(50)) p.y = -p.y;
  return parallel(p, length);
}

PlaneCounts Contour::axis_direction() {
  PlaneCounts p{1, 0};
  for (std::size_t turns = choose_.below(4); turns > 0; --turns) p = left_of(p);
  return p;
}

void Contour::nudge(PlaneCounts& v, std::int64_t counts) { (choose_.chance(50) ? v.x : v.y) += counts; }

std::int64_t Contour::length() {
  switch (choose_.weighted({60, 20, 14, 4, 2})) {
    case 0:
      return choose_.between(2, 16) * 5 * one_;
    case 1:
      return choose_.between(one_, 100 * one_);
    case 2:
      return choose_.between(1, 3 * reach() + 2);
    case 3:
      return choose_.between(1, 5);
    default:
      return choose_.between(100, 5'000) * one_;
  }
}

// Back along the path, turned by one degree to within a unit or so.
PlaneCounts Contour::one_degree_back() {
  const auto long_way = static_cast<double>(choose_.between(20, 200) * one_);
  const double scale = long_way / length_of(direction_);
  const double x = static_cast<double>(direction_.x) * scale;
  const double y = static_cast<double>(direction_.y) * scale;
  const double turn = choose_.chance(50) ? kTangentOfOneDegree : -kTangentOfOneDegree;
  PlaneCounts v{std::llround(-x - turn * y), std::llround(-y + turn * x)};
  if (choose_.chance(60)) v.x += choose_.between(-2, 2);
  if (choose_.chance(60)) v.y += choose_.between(-2, 2);
  return v;
}

PlaneCounts Contour::line_travel() {
  const std::int64_t long_way = length();
  switch (choose_.weighted({34, 20, 14, 8, 4, 6, 6, 8})) {
    case 0:
      return any_direction(long_way);
    case 1: {
      const std::int64_t unit = choose_.chance(60) ? one_ : 1;
      const std::int64_t most = 80 * one_ / unit;
      const std::int64_t x = choose_.between(-most, most);
      const std::int64_t y = choose_.between(-most, most);
      return unit * PlaneCounts{x, y};
    }
    case 2:
      return parallel(choose_.chance(50) ? left_of(direction_) : right_of(direction_), long_way);
    case 3:
      return parallel(direction_, long_way);
    case 4:
      return parallel(-direction_, long_way);
    case 5:
      return one_degree_back();
    case 6: {  // a unit off straight on, or off straight back
      PlaneCounts v = parallel(choose_.chance(50) ? direction_ : -direction_, long_way);
      nudge(v, choose_.one_of<std::int64_t>({-1, 1}));
      return v;
    }
    default: {
      const std::int64_t way = choose_.between(1, 60) * one_;
      const std::int64_t x = choose_.chance(50) ? way : -way;
      const std::int64_t y = choose_.chance(50) ? way : -way;
      return {x, y};
    }
  }
}

void Contour::follow(const Segment& segment) {
  PlaneCounts end = segment.travel;
  if (segment.kind == Segment::Kind::arc) {
    const PlaneCounts out = segment.travel - segment.to_center;
    end = segment.clockwise ? right_of(out) : left_of(out);
  } else if (segment.kind == Segment::Kind::radius_arc) {
    const double chord = length_of(segment.travel);
    const auto r = static_cast<double>(magnitude(segment.radius));
    // The end tangent is the chord turned by half the sweep.
    double half = chord > 0 ? std::asin(std::min(1.0, chord / (2 * r))) : 0;
    if (segment.radius < 0) half = std::acos(-1.0) - half;
    if (segment.clockwise) half = -half;
    const double x =
        static_cast<double>(segment.travel.x) * std::cos(half) - static_cast<double>(segment.travel.y) * std::sin(half);
    const double y =
        static_cast<double>(segment.travel.x) * std::sin(half) + static_cast<double>(segment.travel.y) * std::cos(half);
    constexpr double fine = 1e7;
    if (chord > 0) end = {std::llround(x / chord * fine), std::llround(y / chord * fine)};
  }
  if (end != PlaneCounts{}) direction_ = end;
}

Segment Contour::line() { return line_along(line_travel()); }

Segment Contour::line_along(PlaneCounts v) {
  Segment s;
  s.travel = v;
  follow(s);
  return s;
}

Segment Contour::arc_about(PlaneCounts to_center, PlaneCounts end, bool clockwise) {
  Segment s;
  s.kind = Segment::Kind::arc;
  s.clockwise = clockwise;
  s.to_center = to_center;
  s.travel = to_center + end;
  follow(s);
  return s;
}

// About the offset in a quarter of the cases: there the offset arc shrinks to a point or turns over.
std::int64_t Contour::radius() {
  if (reach() != 0 && choose_.chance(25)) {
    const std::int64_t about = reach() * choose_.one_of<std::int64_t>({1, 1, 1, 2});
    return std::max<std::int64_t>(1, about + choose_.between(-1, 1));
  }
  if (choose_.chance(60)) return choose_.between(1, 12) * 5 * one_;
  return choose_.between(1, 60 * one_);
}

PlaneCounts Contour::to_center(bool clockwise) {
  const std::int64_t r = radius();
  const PlaneCounts inwards = clockwise ? right_of(direction_) : left_of(direction_);
  switch (choose_.weighted({36, 4, 5, 40, 15})) {
    case 0:
      return parallel(inwards, r);
    case 1:  // a cusp
      return parallel(-inwards, r);
    case 2: {
      PlaneCounts v = parallel(inwards, r);
      nudge(v, choose_.one_of<std::int64_t>({-1, 1}));
      return v == PlaneCounts{} ? inwards : v;
    }
    case 3:
      return any_direction(r);
    default: {
      const std::int64_t x = choose_.between(-r, r);
      const std::int64_t y = choose_.between(-r, r);
      return x == 0 && y == 0 ? PlaneCounts{r, 0} : PlaneCounts{x, y};
    }
  }
}

// The end as seen from the centre, `start` likewise: on the circle, a whole turn, or off it.
PlaneCounts Contour::arc_end(PlaneCounts start) {
  switch (choose_.weighted({40, 34, 10, 8, 4, 4})) {
    case 0: {
      const std::vector<PlaneCounts> points = lattice_points(start);
      return points[choose_.below(points.size())];
    }
    case 1:
      return choose_.one_of({left_of(start), -start, right_of(start)});
    case 2:
      return start;
    case 3: {  // a little off the circle
      PlaneCounts end = choose_.one_of({left_of(start), -start, right_of(start)});
      nudge(end, choose_.one_of<std::int64_t>({-1, 1, 1, 5}));
      return end;
    }
    case 4: {  // far off it, seldom in the centre
      if (choose_.chance(10)) return {};
      const PlaneCounts turned = choose_.one_of({start, left_of(start), -start, right_of(start)});
      return choose_.chance(50) ? 2 * turned : PlaneCounts{turned.x / 2, turned.y / 2};
    }
    default: {  // a short one
      PlaneCounts end = start;
      nudge(end, choose_.between(-3, 3));
      return end;
    }
  }
}

// A short piece of an arc of 1,000 to 100,000 millimetres: start and end lie alike to the centre, so that both radii
// are the same number whatever it is.
Segment Contour::huge_arc(PlaneCounts along, std::int64_t length) {
  constexpr std::int64_t largest = 1'000'000'000;  // products of two are 64-bit numbers
  const auto size = choose_.one_of<std::int64_t>({1'000, 1'000, 10'000, 10'000, 100'000});
  const std::int64_t radius = std::min(largest, choose_.between(size / 10 * 11, size * 10) * one_ / 10);
  const PlaneCounts half = parallel(along, std::max<std::int64_t>(1, length / 2));
  const bool clockwise = choose_.chance(50);
  const PlaneCounts across = primitive(clockwise ? right_of(half) : left_of(half));
  const auto times = static_cast<std::int64_t>(static_cast<double>(radius) / length_of(across));
  Segment s;
  s.kind = Segment::Kind::arc;
  s.clockwise = clockwise;
  s.travel = 2 * half;
  s.to_center = half + times * across;
  if (choose_.chance(35)) {
    s.kind = Segment::Kind::radius_arc;
    s.radius = static_cast<std::int64_t>(std::ceil(length_of(s.to_center)));
  }
  follow(s);
  return s;
}

Segment Contour::arc() {
  if (choose_.chance(12)) return any_radius_arc();
  if (choose_.chance(4)) return huge_arc(choose_.chance(60) ? direction_ : any_direction(10 * one_), length());
  const bool clockwise = choose_.chance(50);
  const PlaneCounts center = to_center(clockwise);
  const PlaneCounts end = arc_end(-center);
  const Segment s = arc_about(center, end, clockwise);
  return choose_.chance(20) ? by_radius(s) : s;
}

// The same arc by R where that is whole; else as it is.
Segment Contour::by_radius(const Segment& arc) const {
  const PlaneCounts end = arc.travel - arc.to_center;
  const auto r = whole_length(arc.to_center);
  if (!r || whole_length(end) != r || arc.travel == PlaneCounts{}) return arc;
  const std::int64_t turn = arc.to_center.y * end.x - arc.to_center.x * end.y;  // of start and end about the centre
  const bool more_than_half = arc.clockwise ? turn > 0 : turn < 0;
  Segment s = arc;
  s.kind = Segment::Kind::radius_arc;
  s.radius = more_than_half ? -*r : *r;
  return s;
}

// An arc by R whose centre is irrational, or about half a circle.
Segment Contour::any_radius_arc() {
  Segment s;
  s.kind = Segment::Kind::radius_arc;
  s.clockwise = choose_.chance(50);
  const std::int64_t most = 40 * one_;
  s.travel.x = choose_.between(-most, most);
  s.travel.y = choose_.between(-most, most);
  if (choose_.chance(40)) s.travel = any_direction(choose_.between(1, 20) * 2 * one_);
  if (s.travel == PlaneCounts{}) s.travel.x = one_;
  const auto half = static_cast<std::int64_t>(std::ceil(length_of(s.travel) / 2));
  switch (choose_.weighted({50, 45, 5})) {
    case 0:
      s.radius = half + choose_.between(1, 60 * one_);
      break;
    case 1:
      s.radius = half + choose_.between(0, 1);
      break;
    default:
      s.radius = half - 1;  // seldom an arc
      break;
  }
  s.radius = std::max<std::int64_t>(1, s.radius);
  if (choose_.chance(35)) s.radius = -s.radius;
  follow(s);
  return s;
}

Segment Contour::movement() { return choose_.chance(64) ? line() : arc(); }

Segments Contour::shape() {
  switch (choose_.weighted({16, 10, 14, 20, 14, 12, 8, 8, 10, 6})) {
    case 0:
      return groove();
    case 1:
      return step();
    case 2:
      return notch();
    case 3:
      return tight_arc();
    case 4:
      return tangent_line_arc();
    case 5:
      return tangent_arcs();
    case 6:
      return concentric();
    case 7:
      return radial_arc();
    case 8:
      return huge_arcs();
    default:
      return circle();
  }
}

// In, across and back on the side of the tool, which fits in, or not by a unit.
Segments Contour::groove() {
  const PlaneCounts in = axis_direction();
  const PlaneCounts across = left() ? left_of(in) : right_of(in);
  const std::int64_t about = choose_.chance(70) ? 2 * reach() : choose_.between(1, 4 * reach() + 1);
  const std::int64_t width = std::max<std::int64_t>(1, about + choose_.between(-1, 1));
  const std::int64_t depth = choose_.between(1, 12) * 5 * one_;
  Segments s;
  s.push_back(line_along(depth * in));
  s.push_back(line_along(width * across));
  s.push_back(line_along(choose_.between(1, 12) * 5 * one_ * -in));
  return s;
}

// A step lower or higher than the tool's radius, towards the tool or away from it, by a line or by an arc.
Segments Contour::step() {
  const PlaneCounts on = axis_direction();
  const PlaneCounts up = choose_.chance(50) ? left_of(on) : right_of(on);
  const std::int64_t height = choose_.between(1, 2 * reach() + 1);
  Segments s;
  s.push_back(line_along(choose_.between(1, 12) * 5 * one_ * on));
  if (choose_.chance(60))
    s.push_back(line_along(height * up));
  else
    s.push_back(arc_about(height * up, choose_.chance(50) ? height * on : height * up, up == right_of(on)));
  s.push_back(line_along(choose_.between(1, 12) * 5 * one_ * on));
  return s;
}

// Three vectors and more at a short movement: those next to it interfere.
Segments Contour::notch() {
  const PlaneCounts on = axis_direction();
  const PlaneCounts away = left() ? right_of(on) : left_of(on);
  const std::int64_t n = choose_.between(1, reach() + 1);
  const auto forward = choose_.one_of<std::int64_t>({-3, -4, -1, 0, 1, 3});
  const auto sideways = choose_.one_of<std::int64_t>({4, 3, 1});
  Segments s;
  s.push_back(line_along(choose_.between(1, 12) * 5 * one_ * on));
  if (choose_.chance(30)) {
    const bool clockwise = choose_.chance(50);
    const PlaneCounts center = n * choose_.one_of({on, -on, away, -away});
    const PlaneCounts end = choose_.one_of({center, left_of(center), right_of(center)});
    s.push_back(arc_about(center, end, clockwise));
  } else {
    s.push_back(line_along(n * (forward * on + sideways * away)));
  }
  const PlaneCounts leaving = choose_.one_of({on, on, away, -on});
  s.push_back(line_along(choose_.between(1, 12) * 5 * one_ * leaving));
  return s;
}

// A tangent arc on the side of the tool whose radius is about the offset.
Segments Contour::tight_arc() {
  const PlaneCounts on = axis_direction();
  const bool inside = choose_.chance(75);
  const bool clockwise = left() != inside;
  const std::int64_t r =
      std::max<std::int64_t>(1, reach() + choose_.one_of<std::int64_t>({-1, 0, 1, 1, -reach() / 2, reach() / 3, one_}));
  const PlaneCounts center = r * (clockwise ? right_of(on) : left_of(on));
  Segments s;
  s.push_back(line_along(choose_.between(1, 12) * 5 * one_ * on));
  s.push_back(arc_about(center, choose_.one_of({r * on, r * on, center}), clockwise));
  s.push_back(line_along(parallel(direction_, choose_.between(1, 12) * 5 * one_)));
  return s;
}

// An inner corner of a line and an arc whose offset curves touch, or miss each other by a unit: with r = a²·s and
// R = (a² + b²)·s the centre (-2ab, a² - b²)·s lies as far from the offset line as the offset radius.
Segments Contour::tangent_line_arc() {
  const std::int64_t a = choose_.between(1, 3);
  const std::int64_t b = choose_.between(1, 3);
  const std::int64_t s = std::max<std::int64_t>(1, reach() / (a * a));
  const PlaneCounts on = axis_direction();
  const PlaneCounts side = left() ? left_of(on) : right_of(on);
  PlaneCounts center = (-2 * a * b * s) * on + ((a * a - b * b) * s) * side;
  if (choose_.chance(40)) nudge(center, choose_.one_of<std::int64_t>({-1, 1}));
  if (center == PlaneCounts{}) center = side;
  const PlaneCounts end = choose_.one_of({left_of(-center), center, right_of(-center)});
  Segments all;
  if (choose_.chance(50)) {
    all.push_back(line_along(choose_.between(4, 20) * 5 * one_ * on));
    all.push_back(arc_about(center, end, !left()));
  } else {  // the same run backwards: the arc first, the tool on the other side of the path
    const bool clockwise = left();
    const PlaneCounts back = left() ? right_of(on) : left_of(on);
    PlaneCounts mirrored = (-2 * a * b * s) * on + ((a * a - b * b) * s) * back;
    if (mirrored == PlaneCounts{}) mirrored = back;
    const PlaneCounts from = clockwise ? left_of(-mirrored) : right_of(-mirrored);
    all.push_back(arc_about(-from, -mirrored, !clockwise));
    all.push_back(line_along(choose_.between(4, 20) * 5 * one_ * -on));
  }
  return all;
}

// Two arcs whose offset circles touch at an inner corner: centres (a, -b)·s and (a, b)·s, radius c·s; from outside with
// two arcs of one sense and the offset (c - b)·s, from inside with arcs of both senses and the offset b·s.
Segments Contour::tangent_arcs() {
  constexpr std::int64_t triples[][3] = {{4, 3, 5}, {3, 4, 5}, {12, 5, 13}, {8, 15, 17}, {5, 12, 13}};
  const auto& t = choose_.one_of(triples);
  const bool outside = choose_.chance(60);
  const std::int64_t s = std::max<std::int64_t>(1, reach() / (outside ? t[2] - t[1] : t[1]));
  const PlaneCounts u = axis_direction();
  const PlaneCounts v = left() == outside ? left_of(u) : right_of(u);
  const PlaneCounts first = (t[0] * s) * u - (t[1] * s) * v;
  PlaneCounts second = (t[0] * s) * u + (t[1] * s) * v;
  if (choose_.chance(40)) nudge(second, choose_.one_of<std::int64_t>({-1, 1}));
  const bool clockwise = !left();
  // The first arc: a quarter that ends at the corner, which is -first as seen from its centre.
  const PlaneCounts from = clockwise ? left_of(-first) : right_of(-first);
  Segments all;
  all.push_back(arc_about(-from, -first, clockwise));
  all.push_back(arc_about(second, choose_.one_of({left_of(-second), second, right_of(-second)}), clockwise == outside));
  return all;
}

// Out along a radius, an arc of twice the offset on the inside, back along a radius: each end of the tool's arc lies a
// quarter turn on, so that its sweep is half a turn less.
Segments Contour::radial_arc() {
  const PlaneCounts out = axis_direction();
  const std::int64_t r = std::max<std::int64_t>(1, 2 * reach() + choose_.one_of<std::int64_t>({-1, 0, 0, 0, 1}));
  const bool clockwise = !left();
  const PlaneCounts end = r * choose_.one_of({out, -out, left_of(out), right_of(out)});
  Segments s;
  s.push_back(line_along(choose_.between(4, 12) * 5 * one_ * out));
  s.push_back(arc_about(-r * out, end, clockwise));
  s.push_back(line_along(parallel(-end, choose_.between(4, 12) * 5 * one_)));
  return s;
}

// Two arcs about one centre: on, or back.
Segments Contour::concentric() {
  const bool clockwise = choose_.chance(50);
  const PlaneCounts center = to_center(clockwise);
  const PlaneCounts middle = arc_end(-center);
  Segments s;
  s.push_back(arc_about(center, middle, clockwise));
  const PlaneCounts again = middle == PlaneCounts{} ? center : -middle;
  const PlaneCounts end = arc_end(-again);
  s.push_back(arc_about(again, end, choose_.chance(70) == clockwise));
  return s;
}

// A whole circle between lines, joined tangentially or not.
Segments Contour::circle() {
  Segments s;
  s.push_back(line());
  const bool clockwise = choose_.chance(50);
  const PlaneCounts center = to_center(clockwise);
  s.push_back(arc_about(center, -center, clockwise));
  s.push_back(choose_.chance(50) ? line() : line_along(parallel(direction_, length())));
  return s;
}

// Where the tool does not fit, or just does: a groove whose bottom or whose sides are pieces of huge arcs; and such
// pieces after one another, which meet almost straight on.
Segments Contour::huge_arcs() {
  const PlaneCounts in = axis_direction();
  const PlaneCounts across = left() ? left_of(in) : right_of(in);
  const std::int64_t about = choose_.chance(70) ? 2 * reach() : choose_.between(1, 4 * reach() + 1);
  const std::int64_t width = std::max<std::int64_t>(2, about + choose_.between(-2, 2));
  const auto piece = [this](PlaneCounts along, std::int64_t length, std::uint64_t arcs) {
    return choose_.chance(arcs) ? huge_arc(along, length) : line_along(parallel(along, length));
  };
  Segments s;
  s.push_back(piece(in, choose_.between(1, 12) * 5 * one_, 40));
  s.push_back(piece(choose_.chance(70) ? across : in, width, 60));
  s.push_back(piece(choose_.chance(70) ? -in : in, choose_.between(1, 12) * 5 * one_, 60));
  return s;
}

Contour::OmissionCorner Contour::omission_corner() {
  constexpr PlaneCounts acute[] = {{-3, 4}, {-4, 3}, {-7, 24}, {-24, 7}, {-44, 117}, {-117, 44}};
  const PlaneCounts on = axis_direction();
  const PlaneCounts away = left() ? right_of(on) : left_of(on);
  const PlaneCounts p = choose_.one_of(acute);
  OmissionCorner corner;
  corner.segments.push_back(line_along(choose_.between(4, 12) * 5 * one_ * on));
  const PlaneCounts next = p.x * on + p.y * away;
  if (choose_.chance(60)) {
    corner.segments.push_back(line_along(parallel(next, choose_.between(4, 12) * 5 * one_)));
  } else {
    const bool clockwise = choose_.chance(50);
    const PlaneCounts center = parallel(clockwise ? right_of(next) : left_of(next), choose_.between(4, 12) * 5 * one_);
    const PlaneCounts end = choose_.one_of({left_of(-center), center, right_of(-center), -center});
    corner.segments.push_back(arc_about(center, end, clockwise));
  }
  // From Q1 = r(N1 + t1) to Q2 = r(N2 - t2), with t1 = (1, 0), N1 = (0, 1) and t2 = (x, -y) / |p|.
  const double r = static_cast<double>(reach()) / length_of(p);
  const double whole = length_of(p);
  const double dx = r * (static_cast<double>(p.y - p.x) - whole);
  const double dy = r * (static_cast<double>(p.x + p.y) - whole);
  corner.distance = std::llround(std::max(std::fabs(dx), std::fabs(dy)));
  return corner;
}

}  // namespace toolcomp::fuzz

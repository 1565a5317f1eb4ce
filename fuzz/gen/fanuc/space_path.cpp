// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/fanuc/space_path.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace toolcomp::fuzz {
namespace {

// Products of three factors of this size are 64-bit numbers.
constexpr std::int64_t kSmall = 1'000'000;

double length_of(const SpaceCounts& v) {
  return std::hypot(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
}

SpaceCounts primitive(SpaceCounts v) {
  const std::int64_t divisor = std::gcd(std::gcd(v[0], v[1]), v[2]);
  if (divisor > 1)
    for (std::int64_t& x : v) x /= divisor;
  return v;
}

bool small(const SpaceCounts& v) {
  return std::ranges::all_of(v, [](std::int64_t x) { return x > -kSmall && x < kSmall; });
}

SpaceCounts times(std::int64_t k, SpaceCounts v) {
  for (std::int64_t& x : v) x *= k;
  return v;
}

SpaceCounts sum(const SpaceCounts& a, const SpaceCounts& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

std::int64_t product(const SpaceCounts& a, const SpaceCounts& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

SpaceCounts across(const SpaceCounts& a, const SpaceCounts& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

void SpacePath::follow(const SpaceCounts& movement) {
  if (movement != SpaceCounts{}) last_ = movement;
}

std::int64_t SpacePath::length() {
  switch (choose_.weighted({66, 18, 10, 4, 2})) {
    case 0:
      return choose_.between(2, 16) * 5 * one_;
    case 1:
      return choose_.between(one_, 100 * one_);
    case 2:
      return choose_.between(1, 3 * offset_ + 2);
    case 3:
      return choose_.between(1, 5);
    default:
      return choose_.between(100, 5'000) * one_;
  }
}

SpaceCounts SpacePath::scaled(const Direction& d, double length) const {
  return {std::llround(d[0] * length), std::llround(d[1] * length), std::llround(d[2] * length)};
}

SpaceCounts SpacePath::multiple(SpaceCounts v, std::int64_t length) const {
  if (v == SpaceCounts{}) return v;
  v = primitive(v);
  const double shortest = length_of(v);
  // Directions without a short vector: rounded, they are a hair off.
  if (shortest > 400 * static_cast<double>(one_)) return scaled(as_direction(v), static_cast<double>(length));
  return times(std::max<std::int64_t>(1, std::llround(static_cast<double>(length) / shortest)), v);
}

SpaceCounts SpacePath::movement(const ToolAim& tool) {
  SpaceCounts move{};
  switch (choose_.weighted({48, 20, 12, 6, 4, 4, 3, 3})) {
    case 0:
      move = in_plane(tool);
      break;
    case 1:
      for (std::int64_t& x : move)
        x = choose_.chance(25)   ? 0
            : choose_.chance(60) ? choose_.between(-16, 16) * 5 * one_
                                 : choose_.between(-80 * one_, 80 * one_);
      break;
    case 2:
      move = coplanar(tool);
      break;
    case 3:
      move = parallel(tool);
      break;
    case 4: {  // straight back, or on
      const std::int64_t way = length();
      move = multiple(last_, way);
      if (choose_.chance(60)) move = times(-1, move);
      break;
    }
    case 5:
      for (std::int64_t& x : move) x = choose_.between(-2, 2);
      break;
    case 6:
      for (std::int64_t& x : move) x = choose_.between(-3'000 * one_, 3'000 * one_);
      break;
    default:  // the same travel again, or back
      move = choose_.chance(50) ? last_ : times(-1, last_);
      break;
  }
  if (move == SpaceCounts{}) move[choose_.below(3)] = 10 * one_;
  follow(move);
  return move;
}

SpaceCounts SpacePath::in_plane(const ToolAim& tool) {
  SpaceCounts move{};
  if (tool.whole && small(*tool.whole) && choose_.chance(90)) move = turned_exactly(*tool.whole);
  if (move == SpaceCounts{}) move = turned_roughly(tool.direction);
  // A unit off.
  if (choose_.chance(10)) move[choose_.below(3)] += choose_.one_of<std::int64_t>({-1, 1});
  if (choose_.chance(35)) tilt(tool, move);
  return move;
}

// Something along the tool, which changes nothing in the plane.
void SpacePath::tilt(const ToolAim& tool, SpaceCounts& movement) {
  const std::int64_t way = length();
  SpaceCounts along = tool.whole ? multiple(*tool.whole, way) : scaled(tool.direction, static_cast<double>(way));
  if (choose_.chance(50)) along = times(-1, along);
  movement = sum(movement, along);
}

// u, the last movement in the plane but for length, and T × u make a right angle; T × u is |T| times as long.
SpaceCounts SpacePath::turned_exactly(const SpaceCounts& tool) {
  const SpaceCounts t = primitive(tool);
  if (!small(t) || !small(last_)) return {};
  const SpaceCounts u = primitive(sum(times(product(t, t), last_), times(-product(last_, t), t)));
  if (u == SpaceCounts{} || !small(u)) return {};
  const SpaceCounts side = across(t, u);
  const auto size = static_cast<std::int64_t>(std::llround(length_of(t)));
  const SpaceCounts on = times(size, u);
  constexpr std::int64_t turns[][2] = {{1, 0},  {-1, 0}, {-1, 0}, {0, 1},   {0, -1}, {0, 1},  {0, -1},   {1, 1},
                                       {1, -1}, {-1, 1}, {3, 4},  {-3, -4}, {-4, 3}, {4, -3}, {-12, -5}, {-24, 7}};
  const auto& turn = choose_.one_of(turns);
  SpaceCounts v = sum(times(turn[0], on), times(turn[1], side));
  const std::int64_t way = length();
  v = multiple(v, way);
  return v;
}

SpaceCounts SpacePath::turned_roughly(const Direction& tool) {
  const Direction d = as_direction(last_);
  Direction u{};
  const double along = dot(d, tool);
  for (std::size_t i = 0; i < 3; ++i) u[i] = d[i] - along * tool[i];
  u = billionths(dot(u, u)) > 0 ? unit(u) : beside(tool);
  double angle = 0;
  switch (choose_.weighted({20, 12, 30, 25, 8})) {
    case 0:
      angle = choose_.one_of({0.0, 90.0, -90.0, 180.0});
      break;
    case 1:
      angle = 180;
      break;
    case 2:
      angle = static_cast<double>(choose_.between(-11, 11) * 15);
      break;
    case 3:
      angle = static_cast<double>(choose_.between(-180'000, 180'000)) / 1000;
      break;
    default:  // about a degree from straight back
      angle = (choose_.chance(50) ? 179.0 : -179.0) + static_cast<double>(choose_.between(-2, 2)) / 1000;
      break;
  }
  const auto way = static_cast<double>(length());
  return scaled(turned(u, tool, angle), way);
}

// P, Q, R and the tool in one plane: the last movement and the tool alone, or a coordinate plane.
SpaceCounts SpacePath::coplanar(const ToolAim& tool) {
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < 3; ++i)
    if (billionths(tool.direction[i]) == 0 && last_[i] == 0) free.push_back(i);
  if (!free.empty() && choose_.chance(60)) {
    SpaceCounts move{};
    for (std::int64_t& x : move) x = choose_.between(-60, 60) * one_;
    move[free[choose_.below(free.size())]] = 0;
    return move;
  }
  const std::int64_t way = length();
  SpaceCounts move = multiple(last_, way);
  if (choose_.chance(75)) move = times(-1, move);
  tilt(tool, move);
  return move;
}

SpaceCounts SpacePath::parallel(const ToolAim& tool) {
  const std::int64_t way = length();
  SpaceCounts move =
      tool.whole && choose_.chance(80) ? multiple(*tool.whole, way) : scaled(tool.direction, static_cast<double>(way));
  if (choose_.chance(50)) move = times(-1, move);
  if (choose_.chance(35)) move[choose_.below(3)] += choose_.one_of<std::int64_t>({-1, 1});
  return move;
}

SpaceCounts SpacePath::of_length(const ToolAim& tool, std::int64_t length) {
  SpaceCounts move{};
  // Along a coordinate axis at right angles to the tool the length is exact.
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < 3; ++i)
    if (billionths(tool.direction[i]) == 0) free.push_back(i);
  if (!free.empty() && choose_.chance(80)) {
    move[free[choose_.below(free.size())]] = choose_.chance(50) ? length : -length;
  } else {
    const auto angle = static_cast<double>(choose_.between(0, 359));
    move = scaled(turned(beside(tool.direction), tool.direction, angle), static_cast<double>(length));
  }
  if (choose_.chance(50)) tilt(tool, move);
  return move;
}

// r: the first movement in its plane. The second, u, goes back in it where u·r < 0. The sides Va × r and Vb × u agree
// where u·q >= 0 with q = (Va × r) × Vb. u = s (q - (q·r) r) - r has u·q = s (1 - (q·r)²) - q·r.
SpaceCounts SpacePath::overcut(const Direction& first, const SpaceCounts& before, const Direction& second,
                               std::int64_t percent) {
  const Direction d = as_direction(before);
  Direction r{};
  for (std::size_t i = 0; i < 3; ++i) r[i] = d[i] - dot(d, first) * first[i];
  if (billionths(dot(r, r)) == 0) return movement({second, {}});
  r = unit(r);
  const Direction q = cross(cross(first, r), second);
  const double on = dot(q, r);
  const double aside = dot(q, q) - on * on;
  if (billionths(aside) < 1000) return movement({second, {}});
  const double s = std::max(on, 0.0) / aside * static_cast<double>(percent) / 100;
  Direction u{};
  for (std::size_t i = 0; i < 3; ++i) u[i] = s * (q[i] - on * r[i]) - r[i];
  const auto way = static_cast<double>(choose_.between(4, 20) * 5 * one_);
  const SpaceCounts move = scaled(unit(u), way);
  follow(move);
  return move;
}

}  // namespace toolcomp::fuzz

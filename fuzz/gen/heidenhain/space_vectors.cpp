// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/heidenhain/space_vectors.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace toolcomp::fuzz {
namespace {

constexpr int kMostDecimals = 8;
constexpr std::int64_t kLargest = 999'999'999;  // 9.99999999

std::int64_t power(int n) {
  std::int64_t p = 1;
  for (int i = 0; i < n; ++i) p *= 10;
  return p;
}

// Components in any order with any signs; mostly up.
VectorWords shuffled(Choices& choose, VectorWords v) {
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t other = i + choose.below(3 - i);
    std::swap(v.count[i], v.count[other]);
  }
  for (std::size_t i = 0; i < 3; ++i)
    if (choose.chance(i == 2 ? 15 : 50)) v.count[i] = -v.count[i];
  return v;
}

// IEEE arithmetic gives the same digits everywhere.
VectorWords rounded(Choices& choose) {
  constexpr int precisions[] = {4, 7, 7, 7, 8};
  VectorWords v;
  v.decimals = choose.one_of(precisions);
  const auto one = static_cast<double>(power(v.decimals));
  const auto x = static_cast<double>(choose.between(-1000, 1000));
  const auto y = static_cast<double>(choose.between(-1000, 1000));
  const auto z = static_cast<double>(choose.between(choose.chance(80) ? 1 : -1000, 1000));
  const double length = std::sqrt(x * x + y * y + z * z);
  if (length == 0) return {{0, 0, 1}, 0};
  v.count = {std::llround(x / length * one), std::llround(y / length * one), std::llround(z / length * one)};
  return v;
}

bool is_zero(const VectorWords& v) { return v.count == std::array<std::int64_t, 3>{}; }

// The same vector with 8 decimals, where it can be written so.
VectorWords fine(VectorWords v) {
  const std::int64_t factor = power(kMostDecimals - v.decimals);
  if (std::ranges::any_of(v.count, [&](std::int64_t c) { return std::abs(c) > kLargest / factor; })) return v;
  for (std::int64_t& c : v.count) c *= factor;
  v.decimals = kMostDecimals;
  return v;
}

VectorWords opposite(VectorWords v) {
  for (std::int64_t& c : v.count) c = -c;
  return v;
}

// Along v, of another length where that can be written.
VectorWords along(Choices& choose, VectorWords v) {
  const std::int64_t factor = choose.one_of({1, 1, 1, 2, 3, 5});
  const std::int64_t most = kLargest / power(kMostDecimals - v.decimals);
  if (std::ranges::all_of(v.count, [&](std::int64_t c) { return std::abs(c) <= most / factor; }))
    for (std::int64_t& c : v.count) c *= factor;
  return v;
}

// A few units of the eighth decimal beside it.
VectorWords nudged(Choices& choose, VectorWords v) {
  v = fine(v);
  const std::size_t at = choose.below(3);
  const std::int64_t size = choose.one_of({1, 1, 10, 100, 10'000});
  const std::int64_t by = choose.chance(50) ? size : -size;
  if (std::abs(v.count[at] + by) <= kLargest) v.count[at] += by;
  return is_zero(v) ? VectorWords{{0, 0, 1}, 0} : v;
}

}  // namespace

VectorWords any_vector(Choices& choose) {
  static constexpr VectorWords pythagorean[] = {{{6, 0, 8}, 1},   {{48, 64, 60}, 2},  {{36, 48, 80}, 2},
                                                {{28, 96, 0}, 2}, {{352, 936, 0}, 3}, {{3, 0, 4}, 0},
                                                {{2, 3, 6}, 0},   {{1, 4, 8}, 0},     {{6, 6, 7}, 0}};
  // v.v is 1.0002 exactly, 0.9998 exactly, then on either side.
  static constexpr VectorWords bounds[] = {{{10'000, 100, 100}, 4},  {{9'900, 1'400, 100}, 4}, {{10'001, 0, 0}, 4},
                                           {{9'999, 0, 0}, 4},       {{9'998, 0, 0}, 4},       {{10'000, 100, 101}, 4},
                                           {{100'009'999, 0, 0}, 8}, {{10'000, 141, 0}, 4}};
  switch (choose.weighted({20, 38, 14, 10, 8, 10})) {
    case 0:
      return shuffled(choose, choose.one_of(pythagorean));
    case 1: {
      const VectorWords v = rounded(choose);
      return is_zero(v) ? VectorWords{{0, 0, 1}, 0} : v;
    }
    case 2:
      return choose.chance(75) ? VectorWords{{0, 0, 1}, 0} : shuffled(choose, {{0, 0, 1}, 0});
    case 3: {
      VectorWords v;
      for (std::int64_t& c : v.count) c = choose.between(-9, 9);
      return is_zero(v) ? VectorWords{{0, 0, 1}, 0} : v;
    }
    case 4: {
      VectorWords v;
      v.decimals = static_cast<int>(choose.between(1, kMostDecimals));
      const std::int64_t most = power(v.decimals + 1) - 1;
      for (std::int64_t& c : v.count) c = choose.between(-most, most);
      return is_zero(v) ? VectorWords{{0, 0, 1}, 0} : v;
    }
    default:
      return shuffled(choose, choose.one_of(bounds));
  }
}

VectorWords perpendicular_to(Choices& choose, const VectorWords& v) {
  const std::size_t out = choose.below(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t zero = (out + i) % 3;
    const std::size_t a = (zero + 1) % 3;
    const std::size_t b = (zero + 2) % 3;
    if (v.count[a] == 0 && v.count[b] == 0) continue;
    VectorWords p;
    p.decimals = v.decimals;
    p.count[a] = v.count[b];
    p.count[b] = -v.count[a];
    return choose.chance(50) ? p : opposite(p);
  }
  return {{1, 0, 0}, 0};
}

VectorWords normal_for(Choices& choose, const VectorWords& tool) {
  switch (choose.weighted({46, 8, 4, 12, 8, 6, 6, 10})) {
    case 0: {
      VectorWords v = any_vector(choose);
      const double side = static_cast<double>(v.count[0]) * static_cast<double>(tool.count[0]) +
                          static_cast<double>(v.count[1]) * static_cast<double>(tool.count[1]) +
                          static_cast<double>(v.count[2]) * static_cast<double>(tool.count[2]);
      return side < 0 ? opposite(v) : v;
    }
    case 1:
      return along(choose, tool);
    case 2:
      return along(choose, opposite(tool));
    case 3:
      return perpendicular_to(choose, tool);
    case 4:
      return nudged(choose, tool);
    case 5:
      return nudged(choose, perpendicular_to(choose, tool));
    case 6: {
      // n.t near -0.0002, for a tool along an axis.
      VectorWords v{{100'000'000, 0, 0}, kMostDecimals};
      if (choose.chance(40)) v.count = {60'000'000, 80'000'000, 0};
      v.count[2] = -20'000 + choose.between(-3, 3);
      return v;
    }
    default:
      return opposite(any_vector(choose));
  }
}

NormalAndTool whole_angle(Choices& choose) {
  static constexpr NormalAndTool pairs[] = {{{{1, 0, 1}, 0}, {{0, 0, 1}, 0}},  {{{0, -1, 1}, 0}, {{0, 0, 1}, 0}},
                                            {{{1, 0, 1}, 0}, {{1, 1, 0}, 0}},  {{{0, 1, 1}, 0}, {{1, 0, 1}, 0}},
                                            {{{1, 0, 0}, 0}, {{0, 0, 1}, 0}},  {{{1, 0, -1}, 0}, {{0, 0, 1}, 0}},
                                            {{{-1, 0, 1}, 0}, {{1, 1, 0}, 0}}, {{{0, 0, 1}, 0}, {{0, 0, 1}, 0}}};
  return choose.one_of(pairs);
}

}  // namespace toolcomp::fuzz

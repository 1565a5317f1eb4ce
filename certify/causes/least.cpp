// SPDX-License-Identifier: Apache-2.0
#include "certify/causes/least.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace toolcomp::certify {
namespace {

constexpr int kHalvings = 10;
constexpr int kSteps = 20;  // to a ten thousandth of what is between two of them

}  // namespace

std::optional<double> least_of(const std::function<double(double)>& f, double reach) {
  // Numbers and values, by number.
  std::vector<std::pair<double, double>> seen{{0, f(0)}};
  const double at_zero = seen.front().second;
  for (int halving = kHalvings; halving >= 0; --halving) {
    const double x = std::ldexp(reach, -halving);
    for (const double sign : {1.0, -1.0}) seen.emplace_back(sign * x, f(sign * x));
  }
  std::ranges::sort(seen);
  const auto best = std::ranges::min_element(seen, {}, &std::pair<double, double>::second);
  // A number between two that were tried, one of them twice the other, is a third off the nearer one at most.
  if (!std::isfinite(best->second) || best->second > 0.75 * at_zero) return std::nullopt;
  // Golden section between its neighbours.
  double low = best == seen.begin() ? best->first : (best - 1)->first;
  double high = best + 1 == seen.end() ? best->first : (best + 1)->first;
  const double ratio = (std::sqrt(5) - 1) / 2;
  double a = high - ratio * (high - low);
  double b = low + ratio * (high - low);
  double at_a = f(a);
  double at_b = f(b);
  for (int step = 0; step < kSteps; ++step) {
    if (at_a <= at_b) {
      high = std::exchange(b, a);
      at_b = at_a;
      a = high - ratio * (high - low);
      at_a = f(a);
    } else {
      low = std::exchange(a, b);
      at_a = at_b;
      b = low + ratio * (high - low);
      at_b = f(b);
    }
  }
  const auto [least, x] = std::min(std::pair(at_a, a), std::pair(at_b, b));
  // At 0 it may be out of what is looked at.
  if (!(least < at_zero / 2)) return std::nullopt;
  return x;
}

}  // namespace toolcomp::certify

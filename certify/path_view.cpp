// SPDX-License-Identifier: Apache-2.0
#include "certify/path_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace toolcomp::certify {

void Box::add(const Point2& p) {
  left = std::min(left, p.first);
  right = std::max(right, p.first);
  bottom = std::min(bottom, p.second);
  top = std::max(top, p.second);
}

double round_down(double x) {
  const double power = std::pow(10.0, std::floor(std::log10(x)));
  const double mantissa = x / power;
  return power * (mantissa >= 5 ? 5 : mantissa >= 2 ? 2 : 1);
}

double grid_step(double size) { return round_down(size / 5); }

std::string grid_lines(const Point2& middle, double step, double scale, double side) {
  std::string lines;
  const double half = side / 2 / scale;
  const auto first_line = [&](double at) { return static_cast<std::int64_t>(std::ceil((at - half) / step)); };
  const auto last_line = [&](double at) { return static_cast<std::int64_t>(std::floor((at + half) / step)); };
  const auto place = [&](std::int64_t line, double at) { return (static_cast<double>(line) * step - at) * scale; };
  for (std::int64_t line = first_line(middle.first); line <= last_line(middle.first); ++line)
    lines += fmt::format("M{0:.2f} 0V{1}", side / 2 + place(line, middle.first), side);
  for (std::int64_t line = first_line(middle.second); line <= last_line(middle.second); ++line)
    lines += fmt::format("M0 {0:.2f}H{1}", side / 2 - place(line, middle.second), side);
  return lines;
}

}  // namespace toolcomp::certify

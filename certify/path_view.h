// SPDX-License-Identifier: Apache-2.0
// Views of a path: projections onto the paper, scales and grids.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "certify/path.h"

namespace toolcomp::certify {

// x to the right and y up.
using Point2 = std::pair<double, double>;

// A projection onto the paper.
struct View {
  std::string_view title;
  std::string_view right;
  std::string_view up;
  Point3 x;
  Point3 y;
  bool solid = false;  // shows tool directions
};

inline double dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
// a + k b.
inline Point3 plus(const Point3& a, double k, const Point3& b) {
  return {a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]};
}

inline Point2 project(const View& view, const Point3& p) { return {dot(view.x, p), dot(view.y, p)}; }

struct Box {
  double left = std::numeric_limits<double>::infinity();
  double right = -std::numeric_limits<double>::infinity();
  double bottom = std::numeric_limits<double>::infinity();
  double top = -std::numeric_limits<double>::infinity();
  void add(const Point2& p);
};

// The largest of 1, 2, 5 · 10^n that is not above x.
double round_down(double x);

// The largest of 1, 2, 5 · 10^n that fits about five times into `size`.
double grid_step(double size);

// The path data of grid lines `step` apart on a square paper of `side`, whose middle shows `middle`, with the scale
// `scale`.
std::string grid_lines(const Point2& middle, double step, double scale, double side);

}  // namespace toolcomp::certify

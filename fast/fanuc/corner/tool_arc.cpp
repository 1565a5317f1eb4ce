// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/corner/tool_arc.h"

#include <algorithm>
#include <cmath>

#include "fast/fanuc/corner/interference.h"
#include "fast/geometry/angle.h"

namespace toolcomp::fast {
namespace {

constexpr double kDegrees = 57.29577951308232;

// The angle in degrees, -180 to 180, by which v turns a seen from the centre; exactly 0 where v is radial.
double turned_by(const Vector2<double>& a, const Vector2<double>& v) {
  const double sine = cross(a, v);
  const double cosine = dot(a, a + v);
  if (std::abs(sine) <= 0x1p-49 * extent(a) * extent(v)) return cosine >= 0 ? 0 : 180;
  return polar_angle(cosine, sine);
}

// Heads on one ray from the centre are a whole turn.
double tool_sweep(const PlanePath& path, const Vector2<double>& v, const Vector2<double>& w) {
  const Vector2<double> a = path.from_center_start + v;
  const Vector2<double> b = path.from_center_end + w;
  double clear = 0;
  if (set_clear_sweep(path.sigma, path.from_center_start, path.from_center_end, a, b, clear)) return clear;
  const double programmed = programmed_sweep(path);
  const double at_start = turned_by(path.from_center_start, v);
  const double at_end = turned_by(path.from_center_end, w);
  double sweep = programmed + path.sigma * (at_end - at_start);
  // A short piece of a huge circle is as exact as its terms; a radial vector adds no error.
  double terms = programmed;
  if (at_start != 0) terms += kDegrees * extent(v) / extent(a);
  if (at_end != 0) terms += kDegrees * extent(w) / extent(b);
  const double equal = std::min(kEqualAngle, 0x1p-44 * terms);
  if (sweep < -equal) sweep += 360;
  if (sweep > 360 + kEqualAngle) sweep -= 360;
  return sweep <= equal || sweep > 360 ? 360 : sweep;
}

}  // namespace

void set_programmed_arc(spec::Arc<double>& arc, const PlanePath& path) {
  arc.sweep.reset();
  if (!path.ends_in_center) arc.sweep = programmed_sweep(path);
  arc.radius.reset();
  if (path.spiral) arc.radius = {path.radius_start, path.radius_end};
}

void set_tool_arc(spec::Arc<double>& arc, const PlanePath& path, const Vector2<double>& v, const Vector2<double>& w,
                  Radii radii) {
  const Vector2<double> a = path.from_center_start + v;
  const Vector2<double> b = path.from_center_end + w;
  arc.sweep.reset();
  if (is_off_center(path.radius_start, v, a) && is_off_center(path.radius_end, w, b))
    arc.sweep = tool_sweep(path, v, w);
  arc.radius.reset();
  if (radii == Radii::agree) return;
  const double start = length(a);
  const double end = length(b);
  const double sizes = path.radius_start + extent(v) + (path.radius_end + extent(w));
  if (radii == Radii::differ || std::abs(start - end) > kEqualLength * sizes) arc.radius = {start, end};
}

}  // namespace toolcomp::fast

#include "fast/cutter_compensation_c/interference.h"

#include <algorithm>
#include <cmath>

#include "fast/fault.h"

namespace toolcomp::fast {
namespace {

constexpr double kDegrees = 57.29577951308232;
// Lengths that are equal in truth differ by a few roundings; angles of the tool's arc by as many.
constexpr double kEqual = 0x1p-46;
constexpr double kEqualAngle = 0x1p-40;

// At least the length, at most twice of it.
double extent(const Vector2<double>& v) { return std::abs(v.x) + std::abs(v.y); }

// The angle in degrees, -180 to 180, by which v turns a seen from the centre; exactly 0 where v is radial.
double turned_by(const Vector2<double>& a, const Vector2<double>& v) {
  const double sine = cross(a, v);
  const double cosine = dot(a, a + v);
  if (std::abs(sine) <= 0x1p-49 * extent(a) * extent(v)) return cosine >= 0 ? 0 : 180;
  return std::atan2(sine, cosine) * kDegrees;
}

// Heads on one ray from the centre are a whole turn.
double tool_sweep(const PlanePath& path, const Vector2<double>& v, const Vector2<double>& w) {
  const Vector2<double> a = path.from_center_start + v;
  const Vector2<double> b = path.from_center_end + w;
  const double sine = path.sigma * cross(a, b);
  const double size = extent(a) * extent(b);
  // Away from a half and a whole turn, and from the centre: at once.
  if (std::abs(sine) > 0x1p-10 * size && 16 * size > extent(path.from_center_start) * extent(path.from_center_end)) {
    const double angle = std::atan2(sine, dot(a, b)) * kDegrees;
    return angle < 0 ? angle + 360 : angle;
  }
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

bool arc_interferes(const CheckedBlock& block, const std::optional<double>& sweep) {
  const PlanePath& path = *block.path;
  if (!fault(Fault::c_negative_radius_unnoticed)) {
    const int start = offset_radius_sign(path, false, block.start_side, *block.start_offset);
    const int end = offset_radius_sign(path, true, block.end_side, *block.end_offset);
    if (start < 0 || end < 0) return true;
    if (start == 0 || end == 0) return false;
  }
  if (!sweep || fault(Fault::c_sweep_unchecked)) return false;
  // Both up to 180 degrees, or both over it, never differ by more.
  if ((*sweep > 180) == path.over_half) return false;
  return std::abs(*sweep - programmed_sweep(path)) > 180 + kEqualAngle;
}

// Whether the tool goes against the programmed direction, of which exactly 90 degrees is no case.
bool line_interferes(const PlanePath& path, const CornerGroup& start, std::size_t v, const CornerGroup& end,
                     std::size_t w) {
  const Vector2<double> shift = end.head[w].vector - start.head[v].vector;
  const Vector2<double> way = travel(path);
  const double product = dot(way, way + shift);
  const double size = extent(way);
  const double bound = 0x1p-46 * size * (size + extent(end.head[w].vector) + extent(start.head[v].vector));
  if (std::abs(product) > bound) [[likely]]
    return product < 0;
  const Vector2<DoubleDouble> fine_way = fine_travel(path);
  const DoubleDouble fine = dot(fine_way, fine_way + end.fine(w) - start.fine(v));
  if (fault(Fault::c_right_angle_interferes)) return fine.hi <= 0x1p-42 * bound;
  return fine.hi < -0x1p-42 * bound;
}

}  // namespace

Interference check_interference(const CheckedBlock& block, const std::optional<double>& sweep, CornerGroup& start,
                                CornerGroup& end) {
  if (start.size == 1 && end.size == 1 && !block.path->arc) [[likely]]
    return line_interferes(*block.path, start, 0, end, 0) ? Interference::alarm : Interference::none;
  const std::size_t m = start.size;
  const std::size_t n = end.size;
  const std::size_t pairs = std::max(m, n);
  bool arc = block.path->arc;
  Interference result = Interference::none;
  std::size_t dropped = 0;  // of `end`
  for (std::size_t q = 0; q < pairs; ++q) {
    const std::size_t v = m > q ? m - q - 1 : 0;
    const std::size_t w = std::min(q, n - 1) - dropped;
    // Only the first pair is tested as an arc.
    const bool interferes =
        arc ? q == 0 && arc_interferes(block, sweep) : line_interferes(*block.path, start, v, end, w);
    if (!interferes) break;
    if (q + 1 == pairs) return Interference::alarm;
    if (arc) {
      arc = fault(Fault::c_arc_after_removal);
      result = Interference::straightened;
    }
    if (v > 0) start.drop_last();
    if (q + 1 < n) {
      end.drop_first();
      ++dropped;
    }
  }
  return result == Interference::straightened && arc ? Interference::none : result;
}

void set_programmed_arc(spec::Arc<double>& arc, const PlanePath& path) {
  arc.sweep.reset();
  if (!path.center_in_end) arc.sweep = programmed_sweep(path);
  arc.radius.reset();
  if (path.spiral) arc.radius = {path.radius_start, path.radius_end};
}

void set_tool_arc(spec::Arc<double>& arc, const PlanePath& path, const Vector2<double>& v, const Vector2<double>& w,
                  Radii radii) {
  const Vector2<double> a = path.from_center_start + v;
  const Vector2<double> b = path.from_center_end + w;
  // Each end by its own size: a programmed spiral may grow from next to nothing.
  const double size_start = path.radius_start + extent(v);
  const double size_end = path.radius_end + extent(w);
  arc.sweep.reset();
  if (extent(a) > kEqual * size_start && extent(b) > kEqual * size_end) arc.sweep = tool_sweep(path, v, w);
  arc.radius.reset();
  if (radii == Radii::agree || fault(Fault::c_spiral_as_circle)) return;
  const double start = length(a);
  const double end = length(b);
  if (radii == Radii::differ || std::abs(start - end) > kEqual * (size_start + size_end)) arc.radius = {start, end};
}

}  // namespace toolcomp::fast

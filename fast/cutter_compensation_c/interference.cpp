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

// The angle in degrees, -180 to 180, by which v turns a seen from the centre; exactly 0 where v is radial.
double turned_by(const Vector2<double>& a, const Vector2<double>& v) {
  const double sine = cross(a, v);
  const double cosine = dot(a, a + v);
  if (std::abs(sine) <= 0x1p-48 * length(a) * length(v)) return cosine >= 0 ? 0 : 180;
  return std::atan2(sine, cosine) * kDegrees;
}

bool in_center(const Vector2<double>& a, const Vector2<double>& v) {
  return length(a + v) <= kEqual * (length(a) + length(v));
}

// Heads on one ray from the centre are a whole turn.
double tool_sweep(const PlanePath& path, const Vector2<double>& v, const Vector2<double>& w) {
  double sweep = path.sweep + path.sigma * (turned_by(path.from_center_end, w) - turned_by(path.from_center_start, v));
  if (sweep < -kEqualAngle) sweep += 360;
  if (sweep > 360 + kEqualAngle) sweep -= 360;
  return sweep <= kEqualAngle || sweep > 360 ? 360 : sweep;
}

bool arc_interferes(const CheckedBlock& block, const Vector2<double>& v, const Vector2<double>& w) {
  const PlanePath& path = *block.path;
  if (!fault(Fault::c_negative_radius_unnoticed)) {
    const int start = offset_radius_sign(path, false, block.start_side, *block.start_offset);
    if (start <= 0) return start < 0;
    const int end = offset_radius_sign(path, true, block.end_side, *block.end_offset);
    if (end <= 0) return end < 0;
  }
  if (in_center(path.from_center_start, v) || in_center(path.from_center_end, w)) return false;
  if (fault(Fault::c_sweep_unchecked)) return false;
  return std::abs(tool_sweep(path, v, w) - path.sweep) > 180 + kEqualAngle;
}

// At least the length.
double extent(const Vector2<double>& v) { return std::abs(v.x) + std::abs(v.y); }

// Whether the tool goes against the programmed direction, of which exactly 90 degrees is no case.
bool line_interferes(const PlanePath& path, const CornerGroup& start, std::size_t v, const CornerGroup& end,
                     std::size_t w) {
  const Vector2<double> shift = end.head[w].vector - start.head[v].vector;
  const double square = path.length * path.length;
  const double product = square + dot(path.travel, shift);
  const double bound = 0x1p-46 * (square + path.length * (extent(end.head[w].vector) + extent(start.head[v].vector)));
  if (std::abs(product) > bound) [[likely]]
    return product < 0;
  const Vector2<DoubleDouble> travel = fine_travel(path);
  const DoubleDouble fine = dot(travel, travel + end.fine(w) - start.fine(v));
  if (fault(Fault::c_right_angle_interferes)) return fine.hi <= 0x1p-42 * bound;
  return fine.hi < -0x1p-42 * bound;
}

}  // namespace

Interference check_interference(const CheckedBlock& block, CornerGroup& start, CornerGroup& end) {
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
    const bool interferes = arc ? arc_interferes(block, start.head[v].vector, end.head[w].vector)
                                : line_interferes(*block.path, start, v, end, w);
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

ToolArc programmed_arc(const PlanePath& path) {
  ToolArc arc;
  if (!path.center_in_end) arc.sweep = path.sweep;
  if (path.spiral) arc.radius = {path.radius_start, path.radius_end};
  return arc;
}

ToolArc tool_arc(const PlanePath& path, const Vector2<double>& v, const Vector2<double>& w) {
  ToolArc arc;
  if (!in_center(path.from_center_start, v) && !in_center(path.from_center_end, w)) arc.sweep = tool_sweep(path, v, w);
  const double start = length(path.from_center_start + v);
  const double end = length(path.from_center_end + w);
  if (!fault(Fault::c_spiral_as_circle) &&
      std::abs(start - end) > kEqual * (path.radius_start + path.radius_end + length(v) + length(w)))
    arc.radius = {start, end};
  return arc;
}

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/cutter_compensation_c/cutter_interference.h"

#include <cmath>

namespace toolcomp::fast {
namespace {

// Whether the tool goes against the programmed direction, of which exactly 90 degrees is no case, on its way from one
// vector of `start` to one of `end`.
bool line_interferes(const PlanePath& path, const CutterGroup& start, std::size_t last, const CutterGroup& end,
                     std::size_t first) {
  const Vector2<double>& v = start.head[last].vector;
  const Vector2<double>& w = end.head[first].vector;
  const Vector2<double> way = travel(path);
  const double product = dot(way, way + w - v);
  const double size = extent(way);
  const double bound = 0x1p-46 * size * (size + extent(w) + extent(v));
  if (std::abs(product) > bound) [[likely]]
    return product < 0;
  const Vector2<DoubleDouble> fine_way = fine_travel(path);
  const DoubleDouble fine = dot(fine_way, fine_way + end.fine(first) - start.fine(last));
  return fine.hi < -0x1p-42 * bound;
}

bool arc_interferes(const CheckedBlock& block, const std::optional<double>& sweep) {
  const PlanePath& path = *block.path;
  const int start = offset_radius_sign(path, false, block.start_side, *block.start_offset);
  const int end = offset_radius_sign(path, true, block.end_side, *block.end_offset);
  return fast::arc_interferes(path, start, end, sweep);
}

// How the distances of the heads from the centre of an arc compare, by what the vectors are: exactly, where it can be
// told so.
Radii compare_radii(const CheckedBlock& block, const CutterGroup& start_group, const CutterGroup& end_group) {
  const PlanePath& path = *block.path;
  const Amount& offset = *block.end_offset;
  if (!(block.start_offset->exact == offset.exact) || block.start_side != block.end_side) return Radii::unknown;
  enum class Place : std::uint8_t { on_circle, off_circle, unknown };
  const auto radial = [](bool on) { return on ? Place::on_circle : Place::off_circle; };
  // The perpendicular to another heading, or on another side: it is of this circle where it is the same vector.
  const auto same = [&](const Corner& corner) {
    const Turn turned = turn(*corner.last, path.start);
    return turned.c == 0 && (turned.k > 0) == (corner.first_side == block.start_side);
  };
  const auto meets = [](HeadKind kind) { return kind == HeadKind::paths_meet || kind == HeadKind::paths_cross; };
  const Corner& from = start_group.corner;
  const Corner& to = end_group.corner;
  const HeadKind first = start_group.back().kind;
  const HeadKind last = end_group.front().kind;
  Place start = Place::unknown;
  if (first == HeadKind::first_normal)
    start = radial(same(from));
  else if (meets(first) || first == HeadKind::second_normal || offset.nearest == 0)
    start = Place::on_circle;
  Place end = Place::unknown;
  if (meets(last) || last == HeadKind::first_normal || offset.nearest == 0)
    end = Place::on_circle;
  else if (last == HeadKind::second_normal)
    end = radial(to.turn.c == 0 && to.turn.k < 0);
  if (start == Place::on_circle && end == Place::on_circle) {
    if (!path.spiral) return Radii::agree;
    // Unless one end has run through the centre.
    const double r = offset.nearest;
    const bool through = path.sigma == block.end_side && (path.radius_start <= r || path.radius_end <= r);
    return through ? Radii::unknown : Radii::differ;
  }
  if (path.spiral || start == Place::unknown || end == Place::unknown || start == end) return Radii::unknown;
  return Radii::differ;
}

}  // namespace

Interference check_interference(const CheckedBlock& block, const std::optional<double>& sweep, CutterGroup& start,
                                CutterGroup& end, const InterferenceParameters& parameters) {
  const PlanePath& path = *block.path;
  return check_pairs(
      path.arc, start, end, [&] { return arc_interferes(block, sweep); },
      [&](std::size_t v, std::size_t w) { return line_interferes(path, start, v, end, w); }, parameters);
}

void set_tool_arc(spec::Arc<double>& arc, const CheckedBlock& block, const CutterGroup& start, const CutterGroup& end) {
  set_tool_arc(arc, *block.path, start.back().vector, end.front().vector, compare_radii(block, start, end));
}

}  // namespace toolcomp::fast

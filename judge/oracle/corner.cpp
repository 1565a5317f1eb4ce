// SPDX-License-Identifier: Apache-2.0
#include "judge/oracle/corner.h"

#include <algorithm>
#include <cmath>

#include "judge/oracle/number.h"
#include "judge/oracle/policy.h"

namespace toolcomp::judge {
namespace {

Flat in_plane(const Space& v, std::size_t plane) { return {v.at(kInPlane.at(plane)[0]), v.at(kInPlane.at(plane)[1])}; }

Space in_space(const Flat& v, std::size_t plane) {
  Space result{};
  result.at(kInPlane.at(plane)[0]) = v[0];
  result.at(kInPlane.at(plane)[1]) = v[1];
  return result;
}

std::size_t normal_axis(std::size_t plane) {
  constexpr std::array<std::size_t, 3> axes = {2, 1, 0};
  return axes.at(plane);
}
double normal_to(const Space& v, std::size_t plane) { return v.at(normal_axis(plane)); }

Space difference(const Space& a, const Space& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

// What two estimates that should be the same may differ by, of their size: far above the rounding of either.
constexpr double kSame = policy::kSlack;

}  // namespace

Space space_of(const spec::AxisValues<model::Real>& values, const std::array<std::size_t, 3>& index) {
  Space v{};
  for (std::size_t i = 0; i < 3; ++i)
    if (index.at(i) != spec::Axes::kNone && values.has(index.at(i))) v.at(i) = approximate(values[index.at(i)]);
  return v;
}

Space way_of(const Programmed& from, const Programmed& to, const std::array<std::size_t, 3>& index) {
  Space v{};
  for (std::size_t i = 0; i < 3; ++i)
    if (const std::size_t axis = index.at(i); axis != spec::Axes::kNone && from.has(axis) && to.has(axis))
      v.at(i) = approximate(to[axis] - from[axis]);
  return v;
}

const model::Event* movement(const model::Event& event) {
  return event.kind == spec::EventKind::move ? &event : event.unmade.get();
}

std::optional<FlatPiece> Corners::piece(const model::Event& event, const View& view, const Programmed& from,
                                        std::size_t plane) {
  if (event.cause == spec::Cause::corner) return std::nullopt;
  FlatPiece p;
  const Space way = way_of(from, event.programmed, view.index);
  const Space end = space_of(event.programmed, view.index);
  p.way = in_plane(way, plane);
  p.end = in_plane(end, plane);
  if (event.arc && static_cast<std::size_t>(event.arc->plane) == plane) {
    const Space center = difference(space_of(event.arc->center, view.index), view.shift);
    p.center = in_plane(center, plane);
    p.weight = radius_arc(event, way, difference(end, center), view.rounded).weight();
  }
  if (!p.center && p.way == Flat{}) return std::nullopt;
  return p;
}

double Corners::error(std::span<const model::Event> window, const View& view, const Space& vector, Heads* heads) const {
  const Space at = space_of(window.front().programmed, view.index);
  double worst = 0;
  for (std::size_t plane = 0; plane < 3; ++plane) {
    const Flat v = in_plane(vector, plane);
    if (length(v) == 0 || std::fabs(normal_to(vector, plane)) > kSame * length(v)) continue;
    const Flat corner = in_plane(at, plane);
    // The path that ends at the corner: this event's own, or that of the block before it.
    std::optional<FlatPiece> former = before_.at(plane);
    if (former && former->end != corner) former.reset();
    std::optional<FlatPiece> latter;
    bool cancels = false;
    for (std::size_t i = 1; i < window.size() && !latter; ++i) {
      const model::Event* const next = movement(window[i]);
      if (next == nullptr) continue;
      latter = piece(*next, view, window.front().programmed, plane);
      cancels = next->cause == spec::Cause::cancel;
    }
    if (!former) continue;
    const auto cross_at = [&](const HeadCondition& a, const HeadCondition& b) {
      const double error = crossing(a, b, length(v));
      if (heads == nullptr) worst = std::max(worst, error);
      if (heads == nullptr || error == 0) return;
      Head& head = heads->emplace_back();
      head.bands = {band_of(a, in_space(a.normal, plane)), band_of(b, in_space(b.normal, plane))};
      head.across.normal = in_space({0, 0}, plane);
      head.across.normal.at(normal_axis(plane)) = 1;
      head.reach = error;
    };
    for (const auto* path : {&former, &latter}) {
      if (!*path || (*path)->weight == 1) continue;
      for (const auto& a : head_conditions(**path, corner, v))
        if (a) worst = std::max(worst, alone(*a, length(v)));
    }
    for (const auto& a : head_conditions(*former, corner, v)) {
      if (!a) continue;
      if (latter)
        for (const auto& b : head_conditions(*latter, corner, v))
          if (b) cross_at(*a, *b);
      if (!cancels) continue;
      // G40 with I and J: some line at the same distance, on either side of the vector.
      const double along = std::sqrt(std::max(0.0, dot(v, v) - a->distance * a->distance));
      for (const double sign : {-1.0, 1.0}) {
        HeadCondition line;
        const Flat across = left_of(v);
        for (const std::size_t i : {0U, 1U})
          line.normal.at(i) = (a->distance * v.at(i) + sign * along * across.at(i)) / dot(v, v);
        line.distance = a->distance;
        line.slide = along;
        line.size = length(v);
        cross_at(*a, line);
      }
    }
  }
  return worst;
}

void Corners::follow(const model::Event& event, const View& view, const Programmed& from) {
  for (std::size_t plane = 0; plane < 3; ++plane)
    if (auto p = piece(event, view, from, plane)) before_.at(plane) = p;
}

}  // namespace toolcomp::judge

// SPDX-License-Identifier: Apache-2.0
#include "certify/path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include "judge/oracle/number.h"

namespace toolcomp::certify {
namespace {

constexpr std::array<char, 3> kLetters{'X', 'Y', 'Z'};

// The first and second axis of the plane, and the one along it.
std::array<std::size_t, 3> axes_of(spec::Plane plane) {
  switch (plane) {
    case spec::Plane::zx:
      return {2, 0, 1};
    case spec::Plane::yz:
      return {1, 2, 0};
    case spec::Plane::xy:
      break;
  }
  return {0, 1, 2};
}

const spec::AxisValues<double>& position(const spec::Event<double>& event, PathOf what) {
  if (what == PathOf::programmed) return event.programmed;
  return what == PathOf::point ? event.point : event.axes;
}

// `from` with the coordinates that `values` gives.
Point3 moved(const spec::Axes& axes, Point3 from, const spec::AxisValues<double>& values) {
  for (std::size_t i = 0; i < 3; ++i)
    if (const std::size_t axis = axes.index(kLetters[i]); axis != spec::Axes::kNone && values.has(axis))
      from[i] = values[axis];
  return from;
}

// Chords from `a` to `b` around the centre; radius and height change evenly with the angle. The event's sweep is that
// of the tool's own arc: the programmed one goes by its ends alone.
void add_arc(std::vector<Point3>& points, const Point3& a, const Point3& b, const spec::Arc<double>& arc,
             const spec::Axes& axes, bool own) {
  const auto [u, v, w] = axes_of(arc.plane);
  const Point3 center = moved(axes, a, arc.center);
  const auto polar = [&, first = u, second = v](const Point3& p) {
    const double x = p[first] - center[first];
    const double y = p[second] - center[second];
    return std::pair(std::hypot(x, y), std::atan2(y, x));
  };
  const auto [radius_a, angle_a] = polar(a);
  const auto [radius_b, angle_b] = polar(b);
  const bool ccw = arc.direction == spec::ArcDirection::ccw;
  double sweep = ccw ? angle_b - angle_a : angle_a - angle_b;
  if (arc.sweep && own) {
    sweep = *arc.sweep * std::numbers::pi / 180;
  } else if (sweep <= 0) {
    sweep += 2 * std::numbers::pi;
  }
  if (!std::isfinite(sweep) || sweep < 0 || sweep > 7) return;  // a full turn is 6.28…: more is no arc
  const int chords = std::max(1, static_cast<int>(std::ceil(sweep * 36 / std::numbers::pi)));
  for (int i = 1; i < chords; ++i) {
    const double t = static_cast<double>(i) / chords;
    const double angle = angle_a + (ccw ? t : -t) * sweep;
    const double radius = radius_a + t * (radius_b - radius_a);
    Point3 p{};
    p[u] = center[u] + radius * std::cos(angle);
    p[v] = center[v] + radius * std::sin(angle);
    p[w] = a[w] + t * (b[w] - a[w]);
    points.push_back(p);
  }
}

bool finite(const Point3& p) {
  return std::ranges::all_of(p, [](double x) { return std::isfinite(x); });
}

// Beside the level where the tool stands, down to the bottom, and back to the level of return.
void add_hole(Path& path, Point3& at, const spec::Axes& axes, const spec::Event<double>& event, PathOf what,
              std::size_t index) {
  const spec::Hole<double>& hole = *event.hole;
  const std::string_view letters(kLetters.data(), kLetters.size());
  const std::size_t along = letters.find(axes.letter(hole.axis));
  if (along == std::string_view::npos) return;
  const bool of_axes = what == PathOf::axes && event.axes.has(hole.axis);
  Point3 over = moved(axes, at, of_axes ? event.axes : event.point);
  const double length = of_axes ? event.axes[hole.axis] - hole.level : 0;
  PathMove move;
  move.event = index;
  for (const double level : {at.at(along), hole.bottom + length, hole.level + length}) {
    over.at(along) = level;
    move.points.push_back(over);
  }
  if (!std::ranges::all_of(move.points, finite)) return;
  path.moves.push_back(std::move(move));
  at = over;
}

}  // namespace

bool same_course(const Path& a, const Path& b) {
  return std::ranges::equal(a.moves, b.moves,
                            [](const PathMove& m, const PathMove& n) { return m.points == n.points; });
}

Path follow(const spec::Axes& axes, const Point3& start, std::span<const spec::Event<double>> events, PathOf what) {
  Path path;
  path.start = start;
  Point3 at = start;
  Point3 tool = start;
  std::vector<Point3> sampled;  // of the move to come
  for (std::size_t i = 0; i < events.size(); ++i) {
    const spec::Event<double>& event = events[i];
    if (event.kind == spec::EventKind::sample && !position(event, what).empty())
      sampled.push_back(moved(axes, sampled.empty() ? at : sampled.back(), position(event, what)));
    if (event.hole) {
      add_hole(path, at, axes, event, what, i);
      tool = at;
      continue;
    }
    if (event.kind != spec::EventKind::move || position(event, what).empty()) continue;
    const Point3 end = moved(axes, at, position(event, what));
    PathMove move;
    move.rapid = event.type == spec::MoveType::rapid;
    move.event = i;
    const Point3 tool_end = moved(axes, tool, event.point);
    const bool own = what != PathOf::programmed || event.point.empty() || (at == tool && end == tool_end);
    tool = tool_end;
    // The tip runs on its arc, whatever the axes do for it.
    const bool as_sampled = !sampled.empty() && (what == PathOf::axes || !event.arc);
    if (as_sampled)
      move.points = sampled;
    else if (event.arc)
      add_arc(move.points, at, end, *event.arc, axes, own);
    sampled.clear();
    move.points.push_back(end);
    if (!std::ranges::all_of(move.points, finite)) continue;
    path.moves.push_back(std::move(move));
    at = end;
  }
  return path;
}

std::vector<ToolStroke> tool_strokes(const spec::Axes& axes, const Point3& start,
                                     std::span<const spec::Event<double>> events) {
  std::vector<ToolStroke> strokes;
  Point3 tip = start;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const spec::Event<double>& event = events[i];
    const bool sample = event.kind == spec::EventKind::sample;
    if (!sample && event.kind != spec::EventKind::move) continue;
    tip = moved(axes, tip, event.point.empty() ? event.programmed : event.point);
    if (!event.tool_axis || !finite(tip) || !finite(*event.tool_axis)) continue;
    strokes.push_back({tip, *event.tool_axis, i, !sample && event.type == spec::MoveType::rapid, sample});
  }
  return strokes;
}

Point3 start_of(const spec::Setup& setup) {
  Point3 start{};
  for (std::size_t i = 0; i < start.size(); ++i)
    if (const auto entry = setup.position.find(kLetters[i]); entry != setup.position.end())
      start[i] = judge::approximate(entry->second);
  return start;
}

}  // namespace toolcomp::certify

#include "fuzz/oracle/corner.h"

#include <algorithm>
#include <cmath>

#include "fuzz/oracle/number.h"
#include "fuzz/oracle/policy.h"

namespace toolcomp::fuzz {
namespace {

using Flat = std::array<double, 2>;

Flat operator-(const Flat& a, const Flat& b) { return {a[0] - b[0], a[1] - b[1]}; }
Flat operator+(const Flat& a, const Flat& b) { return {a[0] + b[0], a[1] + b[1]}; }
double dot(const Flat& a, const Flat& b) { return a[0] * b[0] + a[1] * b[1]; }
double cross(const Flat& a, const Flat& b) { return a[0] * b[1] - a[1] * b[0]; }
double length(const Flat& a) { return std::hypot(a[0], a[1]); }
Flat left_of(const Flat& a) { return {-a[1], a[0]}; }

// X Y, Z X, Y Z.
Flat in_plane(const Space& v, std::size_t plane) {
  constexpr std::array<std::array<std::size_t, 2>, 3> axes = {{{0, 1}, {2, 0}, {1, 2}}};
  return {v.at(axes.at(plane)[0]), v.at(axes.at(plane)[1])};
}

double normal_to(const Space& v, std::size_t plane) {
  constexpr std::array<std::size_t, 3> axes = {2, 1, 0};
  return v.at(axes.at(plane));
}

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

// One of the two things that place a head: how far it is from a line or a circle.
struct Corners::Condition {
  Flat normal{};        // unit, in which the distance grows
  double distance = 0;  // of the head from the path, unsigned
  double slide = 0;     // along the path
  double error = 0;     // of the distance, besides the slide's: of centre and radius
  double size = 0;      // of the numbers it is made of
};

std::optional<Corners::Piece> Corners::piece(const model::Event& event, const std::array<std::size_t, 3>& index,
                                             const Space& from, const Space& shift, std::size_t plane) {
  const bool inserted = event.cause == spec::Cause::corner;
  if (event.kind != spec::EventKind::move || inserted) return std::nullopt;
  Piece p;
  p.start = in_plane(from, plane);
  p.end = in_plane(space_of(event.programmed, index), plane);
  if (event.arc && static_cast<std::size_t>(event.arc->plane) == plane)
    p.center = in_plane(difference(space_of(event.arc->center, index), shift), plane);
  if (!p.center && p.start == p.end) return std::nullopt;
  return p;
}

// By the path itself, and for an arc by its tangent too: the vectors of an outer corner are made of tangents.
std::array<std::optional<Corners::Condition>, 2> Corners::conditions(const Piece& piece, const Flat& corner,
                                                                     const Flat& vector) {
  std::array<std::optional<Condition>, 2> found;
  const Flat out = piece.center ? corner - *piece.center : left_of(piece.end - piece.start);
  const double radius = length(out);
  if (radius == 0) return found;
  const Flat normal = {out[0] / radius, out[1] / radius};
  Condition& tangent = found[0].emplace();
  tangent.normal = normal;
  tangent.distance = std::fabs(dot(vector, normal));
  tangent.slide = std::fabs(cross(vector, normal));
  tangent.size = length(vector);
  if (!piece.center) return found;
  const Flat head = out + vector;
  const double reach = length(head);
  if (reach == 0) return found;
  Condition& circle = found[1].emplace();
  circle.normal = {head[0] / reach, head[1] / reach};
  circle.distance = std::fabs(reach - radius);
  circle.slide = tangent.slide;
  circle.error = circle.size = reach + radius;
  return found;
}

// 0 where the head is not where the two cross.
double Corners::crossing(const Condition& a, const Condition& b, double length) {
  const double size = a.size + b.size;
  if (std::fabs(a.distance - b.distance) > kSame * size) return 0;
  // On a perpendicular of both paths: made of one direction.
  if (std::max(a.slide, b.slide) <= policy::kEstimateNoise * size) return 0;
  const double sine = std::fabs(cross(a.normal, b.normal));
  if (sine < policy::kParallel) return 0;
  const bool circles = a.error > 0 || b.error > 0;
  return (a.slide + b.slide + a.error + b.error + (circles ? length : 0)) / sine;
}

double Corners::error(std::span<const model::Event> window, const std::array<std::size_t, 3>& index,
                      const Space& vector, const Space& shift) const {
  const Space at = space_of(window.front().programmed, index);
  double worst = 0;
  for (std::size_t plane = 0; plane < 3; ++plane) {
    const Flat v = in_plane(vector, plane);
    if (length(v) == 0 || std::fabs(normal_to(vector, plane)) > kSame * length(v)) continue;
    const Flat corner = in_plane(at, plane);
    // The path that ends at the corner: this event's own, or that of the block before it.
    std::optional<Piece> former = before_.at(plane);
    if (former && former->end != corner) former.reset();
    std::optional<Piece> latter;
    bool cancels = false;
    for (std::size_t i = 1; i < window.size() && !latter; ++i) {
      latter = piece(window[i], index, at, shift, plane);
      cancels = window[i].cause == spec::Cause::cancel;
    }
    if (!former) continue;
    for (const auto& a : conditions(*former, corner, v)) {
      if (!a) continue;
      if (latter)
        for (const auto& b : conditions(*latter, corner, v))
          if (b) worst = std::max(worst, crossing(*a, *b, length(v)));
      if (!cancels) continue;
      // G40 with I and J: some line at the same distance, on either side of the vector.
      const double along = std::sqrt(std::max(0.0, dot(v, v) - a->distance * a->distance));
      for (const double sign : {-1.0, 1.0}) {
        Condition line;
        const Flat across = left_of(v);
        for (const std::size_t i : {0U, 1U})
          line.normal.at(i) = (a->distance * v.at(i) + sign * along * across.at(i)) / dot(v, v);
        line.distance = a->distance;
        line.slide = along;
        line.size = length(v);
        worst = std::max(worst, crossing(*a, line, length(v)));
      }
    }
  }
  return worst;
}

void Corners::follow(const model::Event& event, const std::array<std::size_t, 3>& index, const Space& from,
                     const Space& shift) {
  for (std::size_t plane = 0; plane < 3; ++plane)
    if (auto p = piece(event, index, from, shift, plane)) before_.at(plane) = p;
}

}  // namespace toolcomp::fuzz

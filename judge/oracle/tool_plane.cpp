// SPDX-License-Identifier: Apache-2.0
#include "judge/oracle/tool_plane.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "judge/oracle/policy.h"

namespace toolcomp::judge {
namespace {

constexpr std::size_t kBefore = 2;
constexpr std::size_t kAfter = 3;

double scalar(const Space& a, const Space& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double norm(const Space& a) { return std::hypot(a[0], a[1], a[2]); }
Space difference(const Space& a, const Space& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Space product(const Space& a, const Space& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The plane at right angles to the unit vector `tool`, by two of its unit vectors.
class Plane {
 public:
  explicit Plane(const Space& tool) {
    std::size_t least = 0;
    for (const std::size_t i : {1U, 2U})
      if (std::fabs(tool.at(i)) < std::fabs(tool.at(least))) least = i;
    Space helper{};
    helper.at(least) = 1;
    first_ = product(tool, helper);
    const double size = norm(first_);
    for (double& x : first_) x /= size;
    second_ = product(tool, first_);
  }
  [[nodiscard]] Flat flat(const Space& v) const { return {scalar(v, first_), scalar(v, second_)}; }
  [[nodiscard]] Space space(const Flat& v) const {
    Space result{};
    for (std::size_t i = 0; i < 3; ++i) result.at(i) = v[0] * first_.at(i) + v[1] * second_.at(i);
    return result;
  }

 private:
  Space first_{};
  Space second_{};
};

// A movement that ends at `end` as the plane sees it: a line by its way, an arc by what leads `out` of its centre
// there; nothing where it has no direction.
std::optional<FlatPiece> seen(const Plane& plane, const Space& end, const Space& way, const std::optional<Space>& out) {
  FlatPiece piece;
  piece.end = plane.flat(end);
  piece.way = plane.flat(way);
  const Flat flat = out ? plane.flat(*out) : piece.way;
  const double sine = length(flat) / norm(out ? *out : way);
  if (!(sine >= policy::kParallel)) return std::nullopt;
  if (out) piece.center = piece.end - flat;
  piece.weight = 1 / sine;
  return piece;
}

}  // namespace

std::optional<ToolPlane::Piece> ToolPlane::piece(const model::Event& event, const View& view, const Programmed& from) {
  if (event.cause == spec::Cause::corner) return std::nullopt;
  Piece p;
  p.start = space_of(from, view.index);
  p.end = space_of(event.programmed, view.index);
  p.way = way_of(from, event.programmed, view.index);
  if (event.arc) {
    constexpr std::array<std::size_t, 3> across = {2, 1, 0};  // of X Y, Z X, Y Z
    p.across = across.at(static_cast<std::size_t>(event.arc->plane));
    p.center = difference(space_of(event.arc->center, view.index), view.shift);
    p.weight = radius_arc(event, p.way, difference(p.end, *p.center), view.rounded).weight();
  }
  if (!p.center && p.way == Space{}) return std::nullopt;
  return p;
}

double ToolPlane::error(std::span<const model::Event> window, const View& view, const Space& vector, const Space& tool,
                        Heads* heads) const {
  const Plane plane(tool);
  const Flat v = plane.flat(vector);
  const double size = length(v);
  if (size == 0) return 0;
  // An end of a piece as the plane sees it, with the conditions it puts on the head there.
  const auto conditions = [&](const Piece& p, bool at_end) -> std::array<std::optional<HeadCondition>, 2> {
    const Space& corner = at_end ? p.end : p.start;
    std::optional<Space> out;
    if (p.center) {
      out = difference(corner, *p.center);
      out->at(p.across) = 0;
    }
    // Of an arc only the corner and the centre are asked.
    auto flat = seen(plane, p.center ? corner : p.end, p.way, out);
    if (!flat) return {};
    flat->weight *= p.weight;
    return head_conditions(*flat, plane.flat(corner), v);
  };
  std::vector<HeadCondition> former;
  std::vector<HeadCondition> latter;
  const auto take = [](std::vector<HeadCondition>& to, const std::array<std::optional<HeadCondition>, 2>& found) {
    for (const auto& c : found)
      if (c) to.push_back(*c);
  };
  for (const Piece& p : before_) take(former, conditions(p, true));
  const Programmed* from = &window.front().programmed;
  std::size_t after = 0;
  for (std::size_t i = 1; i < window.size() && after < kAfter; ++i) {
    const model::Event* const next = movement(window[i]);
    if (next == nullptr) continue;
    if (const auto p = piece(*next, view, *from)) {
      take(latter, conditions(*p, false));
      ++after;
    }
    from = &next->programmed;
  }
  double worst = 0;
  double crossed = 0;
  for (const auto* side : {&former, &latter})
    for (const HeadCondition& a : *side) worst = std::max(worst, alone(a, size));
  for (const HeadCondition& a : former)
    for (const HeadCondition& b : latter) {
      const double error = crossing(a, b, size);
      crossed = std::max(crossed, error);
      if (heads == nullptr || error == 0) continue;
      Head& head = heads->emplace_back();
      head.bands = {band_of(a, plane.space(a.normal)), band_of(b, plane.space(b.normal))};
      head.across.normal = tool;
      head.reach = error;
    }
  // What one direction makes no two conditions place.
  if (heads != nullptr) return worst;
  return std::max(worst, crossed);
}

void ToolPlane::follow(const model::Event& event, const View& view, const Programmed& from) {
  if (const auto p = piece(event, view, from)) {
    before_.push_front(*p);
    if (before_.size() > kBefore) before_.pop_back();
  }
}

}  // namespace toolcomp::judge

// SPDX-License-Identifier: Apache-2.0
#include "judge/oracle/space_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "judge/oracle/number.h"
#include "judge/oracle/policy.h"

namespace toolcomp::judge {
namespace {

constexpr double kMillimetresAnInch = 25.4;
constexpr double kHalfTurn = 180;

Space space_of(const std::array<exact::Real, 3>& v) {
  return {approximate(v[0]), approximate(v[1]), approximate(v[2])};
}

Space rough_space_of(const std::array<exact::Real, 3>& v) { return {roughly(v[0]), roughly(v[1]), roughly(v[2])}; }

double length(const Space& v) { return std::hypot(v[0], v[1], v[2]); }
double dot(const Space& a, const Space& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Space difference(const Space& a, const Space& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Space cross(const Space& a, const Space& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double largest(const Space& v) { return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])}); }

// Error of t x d / |t x d| of a movement between two programmed points, relative; nothing where it does not exist, as
// far as doubles can tell.
std::optional<double> error_of(const Space& tool, const Space& from, const Space& to) {
  const Space travel = difference(to, from);
  const double distance = length(travel);
  if (distance == 0) return std::nullopt;
  const double sine = length(cross(tool, travel)) / distance;
  if (sine < policy::kParallel) return std::nullopt;
  return (policy::ulp(1) + policy::ulp(std::max(largest(from), largest(to))) / distance) / sine;
}

double largest(double size, const std::array<exact::Real, 3>& v) {
  for (const exact::Real& x : v) size = std::max(size, std::fabs(roughly(x)));
  return size;
}

}  // namespace

SpaceScales::SpaceScales(const spec::Setup& setup)
    : index_{setup.axes.index('X'), setup.axes.index('Y'), setup.axes.index('Z')} {
  for (const spec::ToolRow& tool : setup.tools)
    for (const spec::Decimal& d : {tool.r, tool.r2, tool.dl, tool.dr, tool.dr2})
      radius_ = std::max(radius_, std::fabs(approximate(d)));
  for (const auto& [name, points] : setup.dr2_tables) {
    auto& table = tables_.emplace_back();
    for (const auto& [angle, deviation] : points) table.emplace_back(approximate(angle), approximate(deviation));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto start = setup.position.find("XYZ"[i]);
    if (start != setup.position.end()) before_.at(i) = approximate(start->second);
  }
  units(setup.units);
}

void SpaceScales::units(spec::Units units) { to_program_ = units == spec::Units::inch ? 1 / kMillimetresAnInch : 1; }

Scale SpaceScales::next(std::span<const model::Event> window) {
  const model::Event& event = window.front();
  Scale scale;
  scale.position = radius_ * to_program_;
  if (event.hole) return hole(event, scale);
  if (event.kind != spec::EventKind::move) {
    if (event.unmade) before_ = judge::space_of(event.unmade->programmed, index_);
    return scale;
  }
  const auto include = [&](const spec::AxisValues<model::Real>& values) {
    for (std::size_t i = 0; i < spec::kMaxAxes; ++i)
      if (event.programmed.has(i) && values.has(i))
        scale.position = std::max(scale.position, std::fabs(roughly(values[i])));
  };
  include(event.programmed);
  include(event.point);
  include(event.axes);
  const Space at = judge::space_of(event.programmed, index_);
  if (event.space) {
    scale.position = largest(scale.position, event.space->tool_center);
    if (event.space->carrier) scale.position = largest(scale.position, *event.space->carrier);
    if (event.space->contact) scale.position = largest(scale.position, event.space->contact->point);
    if (event.space->contact)
      scale.pose.tip = face(event);
    else
      beside(window, at, scale);
  }
  if (!event.space || event.space->contact) former_ = 0;
  before_ = at;
  return scale;
}

// The next move goes from its level of return.
Scale SpaceScales::hole(const model::Event& event, Scale scale) {
  spec::AxisValues<model::Real> end = event.point;
  end.set(event.hole->axis, event.hole->level);
  for (std::size_t i = 0; i < spec::kMaxAxes; ++i)
    for (const auto* values : {&std::as_const(end), &event.axes})
      if (values->has(i)) scale.position = std::max(scale.position, std::fabs(roughly((*values)[i])));
  for (const model::Real* level : {&event.hole->point_r, &event.hole->bottom})
    scale.position = std::max(scale.position, std::fabs(roughly(*level)));
  before_ = judge::space_of(end, index_);
  former_ = 0;
  return scale;
}

double SpaceScales::face(const model::Event& event) const {
  if (!event.tool_axis) return 0;
  const spec::Contact<model::Real>& contact = *event.space->contact;
  double error = 0;
  const Space contact_to_center = difference(rough_space_of(event.space->tool_center), rough_space_of(contact.point));
  const double ring = std::max(radius_ * to_program_, length(contact_to_center));
  if (!contact.flat) {
    double sine = length(cross(rough_space_of(contact.normal), rough_space_of(*event.tool_axis)));
    // Nearly parallel: what is rough would be seen.
    if (sine * policy::kSlack < policy::kWellKnown)
      sine = length(cross(space_of(contact.normal), space_of(*event.tool_axis)));
    error = policy::ulp(ring) / std::max(sine, policy::kParallel);
  }
  if (contact.angle) error += steepest(approximate(*contact.angle)) * to_program_ * policy::ulp(kHalfTurn);
  return error;
}

// Of the segments of all tables that the angle lies in, mm a degree.
double SpaceScales::steepest(double angle) const {
  double slope = 0;
  for (const auto& table : tables_)
    for (std::size_t i = 1; i < table.size(); ++i) {
      const auto& [from, first] = table[i - 1];
      const auto& [to, second] = table[i];
      const double slack = policy::kSlack * kHalfTurn;
      if (angle >= from - slack && angle <= to + slack)
        slope = std::max(slope, std::fabs(second - first) / (to - from));
    }
  return slope;
}

void SpaceScales::beside(std::span<const model::Event> window, const Space& at, Scale& scale) {
  const model::Event& event = window.front();
  if (!event.tool_axis) return;
  const Space tool = space_of(*event.tool_axis);
  const auto across_tool = [&](Space v) {
    const double along = dot(v, tool);
    for (std::size_t i = 0; i < 3; ++i) v.at(i) -= along * tool.at(i);
    return v;
  };
  // The shifts are made with the same direction, and may be longer: an effective radius of 0 leaves no vector.
  Space vector = across_tool(difference(judge::space_of(event.point, index_), at));
  for (const auto* shift : {&event.space->shift, &event.space->tool_shift})
    if (const Space v = across_tool(space_of(*shift)); length(v) > length(vector)) vector = v;
  const double size = length(vector);
  Space next = at;
  for (std::size_t i = 1; i < window.size(); ++i)
    if (const model::Event* const behind = movement(window[i])) {
      next = judge::space_of(behind->programmed, index_);
      break;
    }
  const std::optional<double> own_error = error_of(tool, before_, at);
  const std::optional<double> next_error = error_of(tool, at, next);
  const double worst = std::max(own_error.value_or(former_), next_error.value_or(former_));
  // The offset, which a mitre has across either path; a perpendicular has all of it across one.
  const auto offset_across = [&](const Space& path) {
    const Space across = cross(tool, path);
    return std::fabs(dot(vector, across)) / length(across);
  };
  double offset = size;
  if (own_error) offset = offset_across(difference(at, before_));
  if (next_error) {
    const double other = offset_across(difference(next, at));
    const bool mitre = !own_error || std::fabs(other - offset) <= policy::kSlack * size;
    offset = mitre ? other : std::max(offset, other);
  }
  former_ = next_error.value_or(own_error.value_or(former_));
  if (size == 0) return;
  scale.pose.tip = size * worst * (1 + size / std::max(offset, size * policy::kParallel));
  if (scale.pose.tip <= policy::kByConditions || !own_error || !next_error) return;
  // On the offset line of either block.
  const double position = policy::ulp(scale.position);
  Head head;
  const auto band = [&](const Space& from, const Space& to, double error) {
    const Space across = cross(tool, difference(to, from));
    const double length_across = length(across);
    HeadBand result;
    for (std::size_t i = 0; i < 3; ++i) result.normal.at(i) = across.at(i) / length_across;
    result.width = position + size * error;
    return result;
  };
  head.bands = {band(before_, at, *own_error), band(at, next, *next_error)};
  head.across.normal = tool;
  head.across.width = position + size * policy::ulp(1);
  head.reach = position + scale.pose.tip;
  scale.heads = {head};
  scale.vector = size;
}

}  // namespace toolcomp::judge

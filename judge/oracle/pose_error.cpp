// SPDX-License-Identifier: Apache-2.0
#include "judge/oracle/pose_error.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "judge/oracle/number.h"
#include "judge/oracle/policy.h"

namespace toolcomp::judge {
namespace {

constexpr double kDegreesPerRadian = 57.29577951308232;

double norm(const Space& a) { return std::hypot(a[0], a[1], a[2]); }
double scalar(const Space& a, const Space& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Space product(const Space& a, const Space& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Space difference(const Space& a, const Space& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

// The length of the sum of unit vectors: of nearly opposite ones doubles would leave noise.
double bisector_of(const std::array<model::Real, 3>& v, const std::array<model::Real, 3>& w) {
  Space sum{};
  for (std::size_t i = 0; i < 3; ++i) sum.at(i) = approximate(v.at(i) + w.at(i));
  return norm(sum);
}

bool moves(const model::Event& event) { return event.kind == spec::EventKind::move; }

}  // namespace

RotaryZeros::RotaryZeros(const spec::Setup& setup, const std::optional<RotaryMachine>& machine)
    : counts_(machine && setup.rotary_angles == spec::RotaryAngles::machine) {
  if (!counts_) return;
  axis_ = {machine->tool, machine->work};
  for (std::size_t i = 0; i < 2; ++i) {
    if (axis_.at(i) == spec::Axes::kNone) continue;
    const auto found = setup.workpiece.front().find(setup.axes.letter(axis_.at(i)));
    if (found != setup.workpiece.front().end()) zero_.at(i) = approximate(found->second);
  }
}

void RotaryZeros::follow(const model::Event& event) {
  for (std::size_t i = 0; counts_ && i < 2; ++i)
    if (const std::size_t axis = axis_.at(i); event.machine.has(axis) && event.axes.has(axis))
      zero_.at(i) = approximate(event.machine[axis]) - approximate(event.axes[axis]);
}

PoseErrors::PoseErrors(const spec::Setup& setup, const ProgramFacts* facts)
    : axes_(setup.axes),
      machine_(RotaryMachine::of(setup)),
      zeros_(setup, machine_),
      index_{setup.axes.index('X'), setup.axes.index('Y'), setup.axes.index('Z')},
      facts_(facts) {}

// Where the block goes at its end: the tangent of an arc or helix, else the way of the tip.
Space PoseErrors::travel(const model::Event& event, const Space& point) const {
  const Space way = difference(point, before_.point);
  if (!event.arc) return way;
  constexpr std::array<std::size_t, 3> normals = {2, 1, 0};  // of X Y, Z X, Y Z
  const std::size_t normal = normals.at(static_cast<std::size_t>(event.arc->plane));
  Space axis{};
  axis.at(normal) = event.arc->direction == spec::ArcDirection::ccw ? 1 : -1;
  Space from_center = difference(point, space_of(event.arc->center, index_));
  from_center.at(normal) = 0;
  Space tangent = product(axis, from_center);
  // The pitch over the angle swept, where that is known.
  const double sweep = event.arc->sweep ? approximate(*event.arc->sweep) / kDegreesPerRadian : 0;
  if (sweep > 0) tangent.at(normal) = way.at(normal) / sweep;
  return tangent;
}

// How much more than e a direction is off that was leant by a Q word towards the travel: the plane of the two is as
// good as the angle between them was large before.
PoseErrors::Lean PoseErrors::leant(const Space& direction, const Space& travel, const model::Event& event) const {
  const double lean = facts_ == nullptr ? 0 : facts_->lean(event.line);
  // Along the travel nothing leans.
  if (!event.clauses.empty() && !event.clauses.contains(policy::kLeant)) return {};
  if (lean == 0 || !(norm(travel) > 0)) return {};
  const double by = lean / kDegreesPerRadian;
  const double angle = std::atan2(norm(product(direction, travel)), scalar(direction, travel));
  Lean result;
  // What leant was at an angle to the travel between 0 and a half turn; the lean may have carried it past the travel.
  for (const double beside : {angle, -angle}) {
    const double sine = std::sin(beside + by);
    if (sine <= -policy::kSlack) continue;
    result.factor = std::max(result.factor, 1 + std::fabs(std::sin(by)) / std::max(sine, policy::kSlack));
    result.hardly = result.hardly || sine < policy::kHardly;
  }
  return result;
}

PoseErrors::End PoseErrors::end(const model::Event& event, double turned) const {
  End end;
  end.exact = event.tool_axis;
  if (event.tool_axis)
    for (std::size_t i = 0; i < 3; ++i) end.direction.at(i) = approximate((*event.tool_axis)[i]);
  end.point = space_of(event.point, index_);
  // A move inserted at a corner goes with the tool of the block that ends there.
  if (event.cause == spec::Cause::corner) {
    end.error = std::max(before_.error, policy::ulp(1));
    end.hardly = before_.hardly;
    return end;
  }
  const Lean lean = leant(end.direction, travel(event, end.point), event);
  // What leans follows the travel.
  end.error = policy::ulp(1) * lean.factor + turned * (lean.factor - 1);
  end.hardly = lean.hardly;
  return end;
}

// On a great circle errors of the ends weigh sin((1-t)A)/sin A and sin(tA)/sin A, together 1/cos(A/2) = 2/|V + W| at
// most. Under conventional control the direction is that of the positions.
void PoseErrors::inside(std::span<const model::Event> window, double turned, PoseScale& scale) const {
  const model::Event& event = window.front();
  End to = before_;
  const auto next = std::ranges::find_if(window, moves);
  if (next != window.end()) to = end(*next, turned);
  scale.direction = std::max({before_.error, to.error, policy::ulp(1)});
  scale.hardly = before_.hardly || to.hardly;
  if (machine_ && !event.clauses.contains(policy::kOnAGreatCircle)) return;
  // Nothing where no event before said one. Exactly opposite ones have no great circle.
  const double bisector = before_.exact && to.exact ? bisector_of(*before_.exact, *to.exact) : 2;
  if (bisector == 0) return;
  scale.direction *= 2 / std::max(bisector, policy::kSlack);
  scale.hardly = scale.hardly || bisector < policy::kHardly;
}

void PoseErrors::rotary(std::span<const model::Event> window, PoseScale& scale) const {
  const bool sample = !moves(window.front());
  const auto end = std::ranges::find_if(window, moves);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (!spec::is_rotary_axis(axes_.letter(i))) continue;
    double largest = 0;
    if (sample && axes_before_.has(i)) largest = std::fabs(approximate(axes_before_[i]));
    if (sample && end != window.end() && end->axes.has(i))
      largest = std::max(largest, std::fabs(approximate(end->axes[i])));
    if (sample) scale.rotary.at(i) = policy::ulp(largest);
    if (!machine_ || (i != machine_->tool && i != machine_->work)) continue;
    scale.rotary.at(i) += policy::ulp(1) * kDegreesPerRadian;
    // A position is rounded as the angle that it is made of.
    const double zero = i == machine_->tool ? zeros_.tool() : zeros_.work();
    const model::Event& event = window.front();
    if (zero != 0 && event.axes.has(i)) scale.rotary.at(i) += policy::ulp(approximate(event.axes[i]) + zero);
  }
}

PoseScale PoseErrors::next(std::span<const model::Event> window, double turned) {
  const model::Event& event = window.front();
  PoseScale scale;
  if (event.kind == spec::EventKind::sample) {
    inside(window, turned, scale);
    rotary(window, scale);
    return scale;
  }
  if (!moves(event)) return scale;
  zeros_.follow(event);
  before_ = end(event, turned);
  axes_before_ = event.axes;
  scale.direction = before_.error;
  scale.hardly = before_.hardly;
  if (event.tool_axis && !event.machine.empty() && event.cause != spec::Cause::reference) rotary(window, scale);
  return scale;
}

void PositionErrors::follow(const model::Event& event) {
  if (!machine_ || machine_->tool == spec::Axes::kNone) return;
  // In a block of which no move is given, an alarm say, positions are those of the block before.
  double& worst = of_line_.try_emplace(event.line, before_).first->second;
  if (!moves(event) || !event.axes.has(machine_->tool)) return;
  zeros_.follow(event);
  const Posture posture(*machine_, approximate(event.axes[machine_->tool]) + zeros_.tool());
  const double e = policy::ulp(1);
  before_ = posture.singular ? 1 : std::max(posture.tool_error(e), posture.work_error(e)) / e;
  worst = std::max(worst, before_);
}

double PositionErrors::at(std::uint64_t line) const {
  const auto found = of_line_.find(line);
  return found == of_line_.end() ? 1 : found->second;
}

double PositionErrors::deviation(std::uint64_t line) const {
  const auto later = std::ranges::lower_bound(deviations_, line, {}, &Deviation::after);
  return later == deviations_.begin() ? 0 : std::prev(later)->radians;
}

}  // namespace toolcomp::judge

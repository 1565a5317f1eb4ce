#include "fuzz/oracle/pose_error.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fuzz/oracle/number.h"
#include "fuzz/oracle/policy.h"

namespace toolcomp::fuzz {
namespace {

constexpr double kDegreesPerRadian = 57.29577951308232;

double norm(const Space& a) { return std::hypot(a[0], a[1], a[2]); }
double scalar(const Space& a, const Space& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Space product(const Space& a, const Space& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Space sum(const Space& a, const Space& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Space difference(const Space& a, const Space& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

// Whether two positions are one, as far as doubles can tell.
bool same(double a, double b) { return std::fabs(a - b) <= policy::kSlack * (1 + std::fabs(a)); }

// Whether one position comes from the other by a number a program writes: kept, or moved by G91.
bool stepped(double from, double to) {
  constexpr double counts = 1e5;  // least increments in a degree
  const double step = (to - from) * counts;
  return same(from, to) || std::fabs(step - std::round(step)) <= policy::kWholeStep;
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
      length_(longest_tool(setup)),
      index_{setup.axes.index('X'), setup.axes.index('Y'), setup.axes.index('Z')},
      turning_frame_(machine_ && machine_->type != RotaryMachine::Type::head && setup.bit(19696, 5)),
      facts_(facts) {}

PoseErrors::Pose PoseErrors::read(const model::Event& event) const {
  Pose pose;
  if (machine_ && event.axes.has(machine_->tool)) pose.tool = approximate(event.axes[machine_->tool]) + zeros_.tool();
  if (machine_ && event.axes.has(machine_->work)) pose.work = approximate(event.axes[machine_->work]) + zeros_.work();
  if (event.tool_axis)
    for (std::size_t i = 0; i < 3; ++i) pose.direction.at(i) = approximate((*event.tool_axis)[i]);
  pose.point = space_of(event.point, index_);
  return pose;
}

// How much more than e a direction is off that was leant by a Q word towards the travel: the plane of the two is as
// good as their angle is large.
double PoseErrors::leant(const Pose& pose, std::uint64_t line) const {
  if (facts_ == nullptr) return 1;
  const Space travel = difference(pose.point, before_.point);
  const Space normal = product(pose.direction, travel);
  const double size = norm(normal);
  double worst = 1;
  for (const auto& [since, lean] : facts_->leans()) {
    if (since > line) break;
    if (!(size > 0)) return 1 / policy::kSlack;
    for (const double sign : {1.0, -1.0}) {
      const Space about{sign * normal[0] / size, sign * normal[1] / size, sign * normal[2] / size};
      const Space upright = rotated(pose.direction, about, -lean);
      const double sine = std::max(norm(product(upright, travel)) / norm(travel), policy::kSlack);
      worst = std::max(worst, 1 + std::fabs(std::sin(lean / kDegreesPerRadian)) / sine);
    }
  }
  return worst;
}

PoseErrors::Pose PoseErrors::end(std::span<const model::Event> window) const {
  Pose pose = read(window.front());
  const std::uint64_t line = window.front().line;
  const double own = (policy::ulp(1) + frozen_) * leant(pose, line);
  pose.direction_error = own;
  const bool commanded = facts_ != nullptr && !facts_->give_positions(line);
  if (commanded || !machine_) return pose;
  const Posture posture(*machine_, pose.tool);
  pose.tool_error = posture.tool_error(own);
  pose.work_error = posture.work_error(own);
  if (posture.singular) {
    const double sine = std::max(norm(product(before_.direction, pose.direction)), policy::kSlack);
    pose.work_error = std::max(before_.work_error, own / sine);
    for (const model::Event& event : window.subspan(1)) {
      if (!moves(event) || !event.tool_axis) continue;
      const Posture next(*machine_, read(event).tool);
      if (next.singular) continue;
      pose.work_error = std::max(pose.work_error, next.work_error(own));
      break;
    }
  }
  keep(pose);
  return pose;
}

void PoseErrors::keep(Pose& pose) const {
  if (!machine_) return;
  if (stepped(before_.work, pose.work)) {
    pose.work_error = std::max(pose.work_error, before_.work_error);
    pose.direction_error += before_.work_error * Posture(*machine_, pose.tool).polar_sine;
  }
  if (stepped(before_.tool, pose.tool)) {
    pose.tool_error = std::max(pose.tool_error, before_.tool_error);
    pose.direction_error += before_.tool_error;
  }
}

PoseErrors::Pose PoseErrors::inside(std::span<const model::Event> window) const {
  const model::Event& event = window.front();
  Pose pose = read(event);
  Pose to = before_;
  for (std::size_t i = 1; i < window.size(); ++i)
    if (moves(window[i])) {
      to = end(window.subspan(i));
      break;
    }
  // Unit vectors, or zero where no event before said one.
  const bool known = scalar(before_.direction, before_.direction) > 0 && scalar(to.direction, to.direction) > 0;
  const double bisector = known ? std::max(norm(sum(before_.direction, to.direction)), policy::kSlack) : 2;
  const double ends = std::max({before_.direction_error, to.direction_error, policy::ulp(1)});
  pose.direction_error = ends * (1 + 2 / bisector);
  const double t = static_cast<double>(event.t_numerator) / static_cast<double>(event.t_denominator);
  if (machine_) inside_of_rotary(t, to, pose);
  return pose;
}

void PoseErrors::inside_of_rotary(double t, const Pose& to, Pose& pose) const {
  const Posture posture(*machine_, pose.tool);
  pose.tool_error = posture.tool_error(pose.direction_error);
  // Counted from the azimuth of the start.
  const Posture start(*machine_, before_.tool);
  const double counted = start.singular ? before_.work_error : start.work_error(before_.direction_error);
  pose.work_error = posture.singular ? std::max(before_.work_error, to.work_error)
                                     : std::max(counted, posture.work_error(pose.direction_error));
  const auto linear = [t](double from, double at, double until) { return same(at, from + t * (until - from)); };
  if (linear(before_.work, pose.work, to.work) && linear(before_.tool, pose.tool, to.tool)) {
    const double work = std::max(before_.work_error, to.work_error);
    const double tool = std::max(before_.tool_error, to.tool_error);
    pose.work_error = std::max(pose.work_error, work);
    pose.tool_error = std::max(pose.tool_error, tool);
    pose.direction_error = std::max(pose.direction_error, work * posture.polar_sine + tool);
  }
  // Positions of many turns are rounded before their sines are taken.
  const double tool_ulp = policy::ulp(std::max(std::fabs(before_.tool), std::fabs(to.tool))) / kDegreesPerRadian;
  const double work_ulp = policy::ulp(std::max(std::fabs(before_.work), std::fabs(to.work))) / kDegreesPerRadian;
  pose.tool_error += tool_ulp;
  pose.work_error += work_ulp;
  pose.direction_error += tool_ulp + work_ulp * posture.polar_sine;
}

void PoseErrors::evenly(std::span<const model::Event> window, PoseScale& scale) const {
  const auto end = std::ranges::find_if(window, moves);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (!spec::is_rotary_axis(axes_.letter(i)) || (machine_ && (i == machine_->tool || i == machine_->work))) continue;
    double largest = 0;
    if (axes_before_.has(i)) largest = std::fabs(approximate(axes_before_[i]));
    if (end != window.end() && end->axes.has(i)) largest = std::max(largest, std::fabs(approximate(end->axes[i])));
    scale.rotary.at(i) = policy::ulp(largest);
  }
}

PoseScale PoseErrors::scale(const Pose& pose, double length) const {
  PoseScale s;
  s.direction = pose.direction_error;
  s.tip = carried_;
  s.control_point = pose.direction_error * length_;
  if (!machine_) return s;
  const RotaryMachine& m = *machine_;
  const double half_turn = std::numbers::pi;
  if (m.tool != spec::Axes::kNone) s.rotary.at(m.tool) = std::min(pose.tool_error, half_turn) * kDegreesPerRadian;
  if (m.work != spec::Axes::kNone) s.rotary.at(m.work) = std::min(pose.work_error, half_turn) * kDegreesPerRadian;
  // A position is rounded as the angle that it is made of.
  if (zeros_.tool() != 0) s.rotary.at(m.tool) += policy::ulp(pose.tool);
  if (zeros_.work() != 0) s.rotary.at(m.work) += policy::ulp(pose.work);
  const double tool = m.length + norm(m.head);
  if (m.type == RotaryMachine::Type::head) {
    const Space head =
        rotated(rotated(m.head, m.tool_line, m.tool_sense * pose.tool), m.work_line, m.work_sense * pose.work);
    const Space step = rotated(m.head_step, m.work_line, m.work_sense * pose.work);
    const double radius = Posture(m, pose.tool).polar_sine * m.length + norm(product(m.work_line, sum(head, step)));
    s.control_point += pose.work_error * radius + pose.tool_error * tool;
  } else {
    const double radius = 3 * length + norm(m.table) + norm(m.table_step) + tool;
    s.control_point += (pose.work_error + pose.tool_error + frozen_) * radius;
  }
  if (turning_frame_) {
    s.tip += s.control_point;
    s.direction += pose.work_error + pose.tool_error;
  }
  return s;
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

PoseScale PoseErrors::next(std::span<const model::Event> window, double length) {
  const model::Event& event = window.front();
  if (event.kind == spec::EventKind::sample) {
    PoseScale s = scale(inside(window), length);
    evenly(window, s);
    return s;
  }
  if (!moves(event)) return {};
  zeros_.follow(event);
  axes_before_ = event.axes;
  const bool controlled = event.tool_axis && !event.machine.empty() && event.cause != spec::Cause::reference;
  if (!controlled) {
    if (active_) carried_ = std::max(carried_, last_);
    active_ = false;
    Pose pose = read(event);
    pose.direction_error = policy::ulp(1);
    keep(pose);
    before_ = pose;
    PoseScale s = scale(pose, length);
    s.control_point = 0;
    s.tip = carried_;
    return s;
  }
  // The pose of the block that begins it freezes the programming coordinate system.
  const bool begins = !active_ || event.clauses.contains(spec::Clause::fanuc_tool_center_point_block);
  if (begins) {
    carried_ = std::max(carried_, last_);
    frozen_ = 0;
  }
  const Pose pose = end(window);
  if (begins && machine_ && machine_->type != RotaryMachine::Type::head) frozen_ = pose.tool_error + pose.work_error;
  active_ = true;
  const PoseScale s = scale(pose, length);
  before_ = pose;
  last_ = s.control_point;
  return s;
}

}  // namespace toolcomp::fuzz

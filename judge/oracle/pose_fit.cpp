// SPDX-License-Identifier: Apache-2.0
#include "judge/oracle/pose_fit.h"

#include <algorithm>
#include <cmath>

#include "judge/oracle/number.h"
#include "judge/oracle/policy.h"
#include "model/basis/number.h"

namespace toolcomp::judge {
namespace {

using exact::Rational;
using exact::Real;
using model::Vector;
using spec::EventKind;

constexpr double kDegreesPerRadian = 57.29577951308232;
constexpr double kHalfTurn = 180;

// Far finer than any width: the enclosure of an exact value is 2^-100 of it wide.
Rational middle(const Real& x) {
  if (x.is_rational()) return x.rational();
  const exact::Enclosure e = x.enclosure();
  return (e.lower + e.upper) / 2;
}

Rational rational(double x) {
  const Rational exact(x);
  return exact;
}
Rational rational(const Rational& x) { return x; }

double rough_length(const Vector& v) { return std::hypot(approximate(v.x), approximate(v.y), approximate(v.z)); }
Vector vector(const std::array<Real, 3>& v) { return {v[0], v[1], v[2]}; }

double magnitude(const Rational& degrees) { return std::fabs(degrees.to_double()); }

}  // namespace

// One event under or outside tool center point control.
template <class Number>
struct PoseFit<Number>::View {
  const model::Event& event;
  bool sample = false;
  bool controlled = false;
  Positions expected;
  Positions own;
  Off off;
  model::ProgrammingFrame frame;
  model::ProgrammingFrame own_frame;
  // Of the tool, expected and from the controller's own positions, in the programming system; of the machine where that
  // does not turn with the table.
  Vector tool;
  Vector own_tool;
};

template <class Number>
PoseFit<Number>::PoseFit(const Rules& rules, const spec::Setup& setup, const ProgramFacts* facts)
    : rules_(rules),
      facts_(facts),
      index_{setup.axes.index('X'), setup.axes.index('Y'), setup.axes.index('Z')},
      estimate_(RotaryMachine::of(setup)),
      mechanical_(setup.rotary_angles == spec::RotaryAngles::machine) {
  for (std::size_t i = 0; i < setup.axes.size(); ++i) {
    const auto found = setup.workpiece.front().find(setup.axes.letter(i));
    if (found != setup.workpiece.front().end() && spec::is_rotary_axis(setup.axes.letter(i)))
      zero_.at(i) = model::plain(found->second);
  }
  if (!estimate_) return;
  machine_.emplace(setup);
  const bool turns_with_table = setup.bit(19746, 4) && !machine_->programs_workpiece();
  table_stands_ = setup.series == spec::Series::series_30i && !turns_with_table;
  in_workpiece_ = machine_->programs_workpiece() && machine_->type() != model::MachineType::head;
}

template <class Number>
bool PoseFit<Number>::has_positions(const model::Event& expected, const spec::Event<Number>& actual) const {
  if (!machine_ || !expected.tool_axis || !rules_.judges("axes")) return false;
  const auto has = [&](const model::Turn& turn) {
    if (!turn.axis) return true;
    return expected.axes.has(*turn.axis) && actual.axes.has(*turn.axis) && is_finite(actual.axes[*turn.axis]);
  };
  return has(machine_->tool_side()) && has(machine_->work_side());
}

template <class Number>
typename PoseFit<Number>::Positions PoseFit<Number>::of(const model::Event& expected) const {
  const auto position = [&](const model::Turn& turn) {
    return turn.axis ? Rational(middle(expected.axes[*turn.axis]) + angle_zero(*turn.axis)) : Rational(0);
  };
  return {position(machine_->tool_side()), position(machine_->work_side())};
}

template <class Number>
typename PoseFit<Number>::Positions PoseFit<Number>::of(const spec::Event<Number>& actual) const {
  const auto position = [&](const model::Turn& turn) {
    return turn.axis ? Rational(rational(actual.axes[*turn.axis]) + angle_zero(*turn.axis)) : Rational(0);
  };
  return {position(machine_->tool_side()), position(machine_->work_side())};
}

template <class Number>
typename PoseFit<Number>::Off PoseFit<Number>::off(const model::Event& expected,
                                                   const spec::Event<Number>& actual) const {
  const auto of_axis = [&](const model::Turn& turn) {
    return turn.axis ? signed_distance(expected.axes[*turn.axis], actual.axes[*turn.axis]) : 0;
  };
  return {of_axis(machine_->tool_side()), of_axis(machine_->work_side())};
}

template <class Number>
void PoseFit<Number>::find_zeros(const model::Event& event) {
  for (std::size_t i = 0; i < spec::kMaxAxes; ++i)
    if (event.machine.has(i) && event.axes.has(i)) zero_.at(i) = middle(event.machine[i]) - middle(event.axes[i]);
}

// The pose of the block that begins the mode freezes the programming coordinate system.
template <class Number>
bool PoseFit<Number>::begins(const model::Event& event) const {
  return !active_ || event.clauses.contains(policy::kBeginsTipControl);
}

template <class Number>
Vector PoseFit<Number>::linear(const spec::AxisValues<Real>& values) const {
  Vector result;
  for (std::size_t i = 0; i < 3; ++i)
    if (index_.at(i) != spec::Axes::kNone && values.has(index_.at(i)))
      model::component(result, i) = values[index_.at(i)];
  return result;
}

template <class Number>
void PoseFit<Number>::set_linear(spec::AxisValues<Real>& values, const Vector& to) const {
  for (std::size_t i = 0; i < 3; ++i)
    if (index_.at(i) != spec::Axes::kNone && values.has(index_.at(i)))
      values.set(index_.at(i), model::component(to, i));
}

template <class Number>
typename PoseFit<Number>::View PoseFit<Number>::view(const model::Event& event,
                                                     const spec::Event<Number>& actual) const {
  const bool sample = event.kind == EventKind::sample;
  const bool controlled = sample || (!event.machine.empty() && event.cause != spec::Cause::reference);
  const Positions expected = of(event);
  const Positions own = of(actual);
  const bool frozen_here = controlled && !sample && begins(event);
  Vector origin;
  for (std::size_t i = 0; i < 3; ++i)
    if (index_.at(i) != spec::Axes::kNone) model::component(origin, i) = Real(zero_.at(index_.at(i)));
  View view{event,
            sample,
            controlled,
            expected,
            own,
            off(event, actual),
            {*machine_, (frozen_here ? expected : frozen_).pose(), origin},
            {*machine_, (frozen_here ? own : own_frozen_).pose(), origin},
            {},
            {}};
  view.tool = vector(*event.tool_axis);
  if (!controlled) {
    view.own_tool = reported(own);
  } else {
    view.own_tool = view.own_frame.direction(own.pose());
    if (in_workpiece_) view.tool = view.frame.direction(expected.pose());
  }
  return view;
}

// The direction of the tool that events report outside tool center point control.
template <class Number>
Vector PoseFit<Number>::reported(const Positions& positions) const {
  return table_stands_ ? machine_->direction_in_machine(positions.pose()) : machine_->direction(positions.pose());
}

template <class Number>
double PoseFit<Number>::rounded(const View& view) {
  return (policy::ulp(magnitude(view.own.tool)) + policy::ulp(magnitude(view.own.work))) / kDegreesPerRadian;
}

template <class Number>
Posture PoseFit<Number>::posture_at(const Positions& positions) const {
  Posture posture(*estimate_, positions.tool.to_double());
  if (!posture.singular) return posture;
  // Doubles do not tell it from one hardly beside it.
  posture.polar_sine = rough_length(cross(machine_->tilted(positions.tool), machine_->work_side().line));
  posture.singular = posture.polar_sine < policy::kExactlyParallel;
  return posture;
}

// The positions turn the tool into the direction expected, on its branch. Where the work-side axis does not turn the
// tool it may stand elsewhere; a position of many turns is rounded before its sine is taken.
template <class Number>
bool PoseFit<Number>::turns_into(const View& view, const Scale& scale) const {
  const bool along_a_great_circle = view.sample && view.event.clauses.contains(policy::kOnAGreatCircle);
  if (!view.controlled || !(along_a_great_circle || directed(view.event))) return false;
  const double error = std::max(policy::ulp(1), scale.pose.direction) + rounded(view);
  // Inside a block the directions at its ends count, as the controller has them.
  const double inherited = view.sample ? direction_ * scale.pose.direction / policy::ulp(1) : 0;
  if (rough_length(view.own_tool - view.tool) >
      rules_.budget().tool_axis * error + inherited + 2 * rules_.angle_resolution() / kDegreesPerRadian)
    return false;
  const double position = magnitude(view.expected.tool);
  const Posture posture = posture_at(view.expected);
  const double branch = posture.tool_error(error + inherited) * kDegreesPerRadian + policy::ulp(position);
  return std::fabs(view.off.tool) <= rules_.budget().rotary * branch + rules_.angle_resolution() &&
         std::fabs(view.off.work) <= kHalfTurn * (1 + policy::kSlack) + rules_.angle_resolution();
}

// Each axis goes as expected from where the controller had it.
template <class Number>
bool PoseFit<Number>::goes_as_expected(std::span<const model::Event> window, const View& view) const {
  // What the end of the block may be off by: of positions inside it, and of the turn before it.
  Off ahead;
  if (view.sample || view.event.cause == spec::Cause::pre_turn) {
    const auto next = std::ranges::find_if(window.subspan(view.sample ? 0 : 1), [](const model::Event& event) {
      return event.kind == EventKind::move && event.tool_axis.has_value();
    });
    if (next != window.end() && directed(*next)) {
      const Posture end = posture_at(of(*next));
      const double k = rules_.budget().rotary * kDegreesPerRadian;
      // Directions are commanded in the programming coordinate system, as the controller has it.
      const Off frame{magnitude(own_frozen_.tool - frozen_.tool), magnitude(own_frozen_.work - frozen_.work)};
      const double tilt = frame.tool / kDegreesPerRadian;
      ahead.tool = k * end.tool_error(policy::ulp(1)) + kDegreesPerRadian * end.tool_error(tilt);
      ahead.work = k * end.work_error(policy::ulp(1)) + kDegreesPerRadian * end.work_error(tilt) + frame.work;
      ahead.work = std::min(ahead.work, kHalfTurn);
    }
  }
  const auto fits = [&](double off, double before, double ahead_of, const Rational& expected, const Rational& own) {
    const double rounding = rules_.budget().rotary * (policy::ulp(std::max(magnitude(expected), magnitude(own))) +
                                                      policy::ulp(1) * kDegreesPerRadian) +
                            rules_.angle_resolution();
    if (view.sample) return std::fabs(off) <= std::fabs(before) + ahead_of + rounding;
    return std::fabs(off) <= ahead_of + rounding || std::fabs(off - before) <= 2 * rounding;
  };
  return fits(view.off.tool, before_.tool, ahead.tool, view.expected.tool, view.own.tool) &&
         fits(view.off.work, before_.work, ahead.work, view.expected.work, view.own.work);
}

template <class Number>
std::optional<typename PoseFit<Number>::Seen> PoseFit<Number>::seen(std::span<const model::Event> window,
                                                                    const spec::Event<Number>& actual,
                                                                    const Scale& scale) {
  const model::Event& event = window.front();
  if (event.kind != actual.kind || (event.kind != EventKind::move && event.kind != EventKind::sample))
    return std::nullopt;
  if (!machine_) return without_kinematics(event, actual, scale);
  if (!has_positions(event, actual)) return std::nullopt;
  find_zeros(event);
  const View at = view(event, actual);
  // In coordinates whose zero no event has said positions do not tell what the tool is.
  if (!at.controlled && rough_length(reported(at.expected) - at.tool) > policy::kEstimateNoise) return std::nullopt;
  if (!turns_into(at, scale) && !goes_as_expected(window, at)) return std::nullopt;
  const double direction = rough_length(at.own_tool - at.tool);
  return Seen{adjusted(at, off_tip(event, actual, scale)), direction, rounded(at)};
}

// A tip that two conditions place (head.h) lies where the controller has it; that it may is judged as of any point.
template <class Number>
Vector PoseFit<Number>::off_tip(const model::Event& event, const spec::Event<Number>& actual,
                                const Scale& scale) const {
  Vector off;
  if ((scale.heads.empty() && !scale.between) || in_workpiece_ || !rules_.judges("point")) return off;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t axis = index_.at(i);
    if (axis == spec::Axes::kNone || !event.point.has(axis) || !actual.point.has(axis)) continue;
    if (is_finite(actual.point[axis]))
      model::component(off, i) = Real(rational(actual.point[axis])) - event.point[axis];
  }
  return off;
}

// The event with the controller's own rotary positions, and what follows from them. On the work stand: the tip, where
// it is programmed on the table; its coordinates in the workpiece system, where it is programmed in that.
template <class Number>
model::Event PoseFit<Number>::adjusted(const View& view, const Vector& off_tip) const {
  model::Event event = view.event;
  const auto place = [&](const model::Turn& turn, const Rational& own) {
    if (!turn.axis) return;
    event.axes.set(*turn.axis, Real(Rational(own - angle_zero(*turn.axis))));
    if (event.machine.has(*turn.axis))
      event.machine.set(*turn.axis, Real(Rational(own - angle_zero(*turn.axis) + zero_.at(*turn.axis))));
  };
  place(machine_->tool_side(), view.own.tool);
  place(machine_->work_side(), view.own.work);
  const model::Pose expected = view.expected.pose();
  const model::Pose own = view.own.pose();
  const Vector tool = in_workpiece_ && view.controlled ? machine_->direction_in_machine(own) : view.own_tool;
  event.tool_axis = {tool.x, tool.y, tool.z};
  if (!view.controlled) return event;

  const Vector point = linear(event.point);
  Vector tip = point;
  Vector own_tip = point;
  if (in_workpiece_) {
    tip = view.frame.of_workpiece(point, expected);
    const bool stands_on_table = view.sample || event.cause == spec::Cause::pre_turn;
    own_tip = stands_on_table ? tip : view.own_frame.of_workpiece(point, own);
    if (stands_on_table) set_linear(event.point, view.own_frame.in_workpiece(own_tip, own));
  }
  const Vector axes = linear(event.axes);
  const Real length = dot(axes - view.frame.control_point(tip, expected, 0), machine_->direction_in_machine(expected));
  const Vector own_axes = view.own_frame.control_point(own_tip + off_tip, own, length);
  if (!event.machine.empty()) set_linear(event.machine, linear(event.machine) + own_axes - axes);
  set_linear(event.axes, own_axes);
  return event;
}

// The direction of the tool is that of I J K itself: what a controller reports stands for the positions it does not
// have.
template <class Number>
std::optional<typename PoseFit<Number>::Seen> PoseFit<Number>::without_kinematics(const model::Event& expected,
                                                                                  const spec::Event<Number>& actual,
                                                                                  const Scale& scale) const {
  const bool controlled =
      expected.kind == EventKind::sample || (!expected.machine.empty() && expected.cause != spec::Cause::reference);
  if (!controlled || !expected.tool_axis || !actual.tool_axis || !rules_.judges("tool_axis")) return std::nullopt;
  for (const Number& x : *actual.tool_axis)
    if (!is_finite(x)) return std::nullopt;
  const auto& a = *actual.tool_axis;
  const Vector own{Real(rational(a[0])), Real(rational(a[1])), Real(rational(a[2]))};
  const Vector tool = vector(*expected.tool_axis);
  const double direction = rough_length(own - tool);
  const double inherited = expected.kind == EventKind::sample ? direction_ * scale.pose.direction / policy::ulp(1) : 0;
  if (direction > rules_.budget().tool_axis * std::max(policy::ulp(1), scale.pose.direction) + inherited +
                      2 * rules_.vector_resolution())
    return std::nullopt;
  Seen result{expected, direction, 0};
  const Vector axes = linear(expected.axes);
  const Vector moved = dot(axes - linear(expected.point), tool) * (own - tool);
  set_linear(result.event.axes, axes + moved);
  if (!expected.machine.empty()) set_linear(result.event.machine, linear(expected.machine) + moved);
  result.event.tool_axis = {own.x, own.y, own.z};
  return result;
}

template <class Number>
bool PoseFit<Number>::controlled(const model::Event& event) {
  return event.tool_axis.has_value() && !event.machine.empty() && event.cause != spec::Cause::reference;
}

template <class Number>
bool PoseFit<Number>::were_both(std::size_t axis) const {
  return axis != spec::Axes::kNone && axes_before_.has(axis) && own_before_.has(axis) && is_finite(own_before_[axis]);
}

template <class Number>
double PoseFit<Number>::apart() const {
  double largest = 0;
  double far = 0;
  for (const std::size_t axis : index_) {
    if (!were_both(axis)) continue;
    const double off = std::fabs(signed_distance(axes_before_[axis], own_before_[axis]));
    largest = std::max(largest, off);
    far = std::hypot(far, std::max(0.0, off - rules_.resolution()));
  }
  // A table turns what lies farther off than it is rounded.
  return std::max(largest, far);
}

// By axis: one that the block names has a position of its own.
template <class Number>
std::optional<Vector> PoseFit<Number>::taken_over(const model::Event& event, const spec::Event<Number>& actual) const {
  if (event.kind != EventKind::move || !takes_over(event)) return std::nullopt;
  std::optional<Vector> by;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t axis = index_.at(i);
    if (!were_both(axis) || !event.programmed.has(axis) || !actual.programmed.has(axis)) continue;
    const double off = signed_distance(event.programmed[axis], actual.programmed[axis]);
    if (std::fabs(off - signed_distance(axes_before_[axis], own_before_[axis])) >= std::fabs(off)) continue;
    if (!by) by.emplace();
    model::component(*by, i) = Real(rational(own_before_[axis])) - axes_before_[axis];
  }
  return by;
}

template <class Number>
void PoseFit<Number>::follow(const model::Event& expected, const spec::Event<Number>& actual, double direction) {
  if (expected.kind != EventKind::move) return;
  const bool controlled = PoseFit::controlled(expected);
  if (takes_over(expected)) carried_ = std::max(carried_, apart());
  const bool follows = controlled && rules_.judges("axes");
  axes_before_ = follows ? expected.axes : spec::AxisValues<Real>();
  own_before_ = follows ? actual.axes : spec::AxisValues<Number>();
  find_zeros(expected);
  if (has_positions(expected, actual)) {
    before_ = off(expected, actual);
    direction_ = direction;
    if (controlled && begins(expected)) {
      frozen_ = of(expected);
      own_frozen_ = of(actual);
    }
    const double radians = std::max(std::fabs(before_.tool), std::fabs(before_.work)) / kDegreesPerRadian;
    if (radians > policy::kDeviation || !deviations_.empty()) deviations_.push_back({expected.line, radians});
  }
  active_ = controlled;
}

template class PoseFit<double>;
template class PoseFit<Rational>;

}  // namespace toolcomp::judge

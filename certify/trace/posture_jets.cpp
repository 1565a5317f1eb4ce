// SPDX-License-Identifier: Apache-2.0
#include "certify/trace/posture_jets.h"

#include <cmath>
#include <limits>

namespace toolcomp::certify {
namespace {

Interval turn_rate(const model::Turn& turn, const model::Angle& by) {
  const Interval result = radians(enclosed(by.plain_degrees()));
  return turn.sense < 0 ? -result : result;
}

// Of the middles; they, the function and its result are off by a few ulps.
Interval angle(const Interval& x, const Interval& y) {
  constexpr double ulps = 16 * std::numeric_limits<double>::epsilon();
  return Interval(std::atan2(median(y), median(x))) + Interval(-ulps, ulps) + (width(x) + width(y)) * Interval(-2, 2);
}
}  // namespace

Interval enclosed(const exact::Real& x) {
  const exact::DoubleEnclosure bounds = x.double_enclosure();
  return {bounds.lower, bounds.upper};
}
IntervalVector enclosed(const exact::Vector3& v) { return {enclosed(v.x), enclosed(v.y), enclosed(v.z)}; }

Interval radians(const Interval& degrees) {
  const Rounding upward;
  return degrees * boost::numeric::interval_lib::pi<Interval>() / 180.0;
}

JetVector RotaryAxis::across(const JetVector& v) const {
  if (about_ == 3) return v - dot(constant(line_), v) * constant(line_);
  JetVector result = v;
  result.at(about_) = Jet();
  return result;
}
JetVector RotaryAxis::turned(const JetVector& v, const Turned& by) const {
  if (about_ == 3) {
    const JetVector k = constant(line_);
    const JetVector part = across(v);
    return (v - part) + by.cosine * part + by.sine * cross(k, v);
  }
  const std::size_t j = (about_ + 1) % 3;
  const std::size_t k = (about_ + 2) % 3;
  JetVector result = v;
  result.at(j) = by.cosine * v.at(j) - by.sine * v.at(k);
  result.at(k) = by.sine * v.at(j) + by.cosine * v.at(k);
  return result;
}

Turned turn_at(const model::Turn& turn, const model::Angle& position) {
  const model::Angle angle = turn.angle(position);
  return {enclosed(angle.cosine()), enclosed(angle.sine())};
}

Even::Even(const model::Machine& machine, const model::EvenTurns& turns)
    : start_{turn_at(machine.tool_side(), turns.start.tool), turn_at(machine.work_side(), turns.start.work)},
      tool_(turn_rate(machine.tool_side(), turns.end.tool - turns.start.tool)),
      work_(turn_rate(machine.work_side(), turns.end.work - turns.start.work)) {}

Even::Even(const model::Machine& machine, const model::LiftedSwing& level)
    : start_{turn_at(machine.tool_side(), level.start.tool), turn_at(machine.work_side(), level.start.work)},
      tool_(0.0),
      work_(static_cast<double>(level.side) * radians(enclosed(level.direction.degrees))) {}

Turns Even::at(const Interval& t) const {
  return {start_.tool + turning(t, 0.0, tool_), start_.work + turning(t, 0.0, work_)};
}

Swing::Swing(const model::DirectionSwing& swing)
    : from_(enclosed(swing.from)), ahead_(enclosed(swing.ahead)), rate_(radians(enclosed(swing.degrees))) {}

JetVector Swing::at(const Interval& t) const {
  const Turned swept = turning(t, 0.0, rate_);
  return swept.cosine * constant(from_) + swept.sine * constant(ahead_);
}

Lifted::Lifted(const model::Machine& machine, const model::LiftedSwing& swing)
    : swing_(swing.direction),
      axis_(machine.work_side()),
      along_(enclosed(machine.heights().along)),
      across_(enclosed(machine.heights().across)),
      ahead_(enclosed(machine.heights().ahead)),
      mean_(enclosed(machine.heights().mean)),
      a_(enclosed(machine.heights().a)),
      b_(enclosed(machine.heights().b)),
      swing2_(enclosed(machine.heights().swing2)),
      upper_pole_(machine.singular(1) != nullptr),
      lower_pole_(machine.singular(-1) != nullptr),
      branch_(swing.branch) {}

Turns Lifted::at(const Interval& t) const {
  const JetVector direction = swing_.at(t);
  const Jet along = dot(constant(axis_.line()), direction);
  const JetVector aside = axis_.across(direction);
  const Jet aside2 = square(aside[0]) + square(aside[1]) + square(aside[2]);
  const Interval rho = boost::numeric::sqrt(swing2_);
  const Jet height = along - Jet(mean_);
  const Jet one(1.0);
  const Jet below = upper_pole_ && along.value.lower() > 0 ? aside2 * inverse(one + along) : Jet(rho) - height;
  const Jet above = lower_pole_ && along.value.upper() < 0 ? aside2 * inverse(one - along) : Jet(rho) + height;
  const Jet depth = branch_ * root(below * above);
  Turns result;
  const Interval scale = 1.0 / swing2_;
  result.tool.cosine = scale * (a_ * height - b_ * depth);
  result.tool.sine = scale * (b_ * height + a_ * depth);
  const JetVector tilted =
      constant(along_) + result.tool.cosine * constant(across_) + result.tool.sine * constant(ahead_);
  const Jet scale2 = inverse(aside2);
  result.work.cosine = dot(tilted, aside) * scale2;
  result.work.sine = dot(cross(constant(axis_.line()), tilted), aside) * scale2;
  return result;
}

Meridian::Meridian(const model::Machine& machine, const model::LiftedSwing& swing, int pole)
    : pole_(pole),
      work_(turn_at(machine.work_side(), swing.start.work)),
      cosine_(enclosed(exact::dot(machine.tool_side().line, machine.heights().along))) {
  const Swing direction(swing.direction);
  rate_ = direction.rate();
  const IntervalVector axis = enclosed(machine.work_side().line);
  const Interval a = enclosed(machine.heights().a);
  const Interval b = enclosed(machine.heights().b);
  const Interval swing2 = enclosed(machine.heights().swing2);
  const Rounding upward;
  const double side = pole;
  const Interval rho = boost::numeric::sqrt(swing2);
  tool_ = {side * a / rho, side * b / rho};
  // Behind the pole φ is negative.
  double before = -1;
  if (swing.pole == 0) {
    phi_ = angle(side * dot(constant(axis), constant(direction.from())).value,
                 side * dot(constant(axis), constant(direction.ahead())).value);
    before = phi_.lower() > 0 ? 1 : -1;
  }
  scale_ = before * side * swing.branch / boost::numeric::sqrt(1.0 - boost::numeric::square(cosine_));
  const Turned start = swung(0.0).second;
  turned_back_ = {start.cosine.value, start.sine.value};
}

Turns Meridian::at(const Interval& t) const {
  const auto [delta, psi] = swung(t);
  const Turned by = turned_back_ + -psi;
  return {tool_ + delta, work_ + (pole_ > 0 ? by : -by)};
}

std::pair<Turned, Turned> Meridian::swung(const Interval& t) const {
  const Turned half = turning(t, phi_ / 2.0, -rate_ / 2.0);
  const Jet s = scale_ * half.sine;
  const Jet c = root(Jet(1.0) - square(s));
  const Jet scale = inverse(half.cosine);
  return {{Jet(1.0) - Interval(2.0) * square(s), Interval(2.0) * (s * c)}, {c * scale, cosine_ * s * scale}};
}

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
#include "judge/oracle/pairing.h"

#include <algorithm>

#include "judge/oracle/number.h"
#include "judge/oracle/policy.h"

namespace toolcomp::judge {
namespace {

using exact::Rational;
using exact::Real;
using model::Vector;
using spec::EventKind;

void add(spec::AxisValues<Real>& values, const std::array<std::size_t, 3>& index, const Vector& shift) {
  for (std::size_t i = 0; i < 3; ++i)
    if (index.at(i) != spec::Axes::kNone && values.has(index.at(i)))
      values.set(index.at(i), values[index.at(i)] + model::component(shift, i));
}

}  // namespace

// On a line, (1 - t) of what the head it starts from lies off; the rest is the business of the head it leads to.
template <class Number>
std::optional<Vector> Pairing<Number>::shift(const model::Event& sample, const Scale& scale) const {
  if (!head_ || !placed_ || !scale.between) return std::nullopt;
  const Real t = Real(Rational(sample.t_numerator, sample.t_denominator));
  return (1 - t) * head_->end().off;
}

template <class Number>
void Pairing<Number>::move_by(model::Event& event, const Vector& by) const {
  for (auto* values : {&event.programmed, &event.point, &event.axes, &event.machine}) add(*values, index_, by);
}

template <class Number>
std::optional<Difference> Pairing<Number>::next(std::span<const model::Event> window, const spec::Event<Number>& actual,
                                                Tally& tally) {
  const model::Event& event = window.front();
  Scale scale = conditions_.next(window);
  scale.carried = fit_.carried();
  const std::optional<Vector> by = event.kind == EventKind::sample ? shift(event, scale) : std::nullopt;
  Tally judged = tally;
  std::optional<Difference> difference;
  if (by) {
    model::Event shifted = event;
    add(shifted.point, index_, *by);
    add(shifted.axes, index_, *by);
    difference = compare(rules_, shifted, scale, actual, judged);
  } else {
    difference = compared(event, scale, actual, judged);
  }
  const std::optional<Vector> own = difference ? fit_.taken_over(event, actual) : std::nullopt;
  if (own) {
    judged = tally;
    model::Event moved = event;
    move_by(moved, *own);
    difference = compared(moved, scale, actual, judged);
  }
  double direction = 0;
  if (difference) {
    if (auto seen = fit_.seen(window, actual, scale)) {
      judged = tally;
      direction = seen->direction;
      // A vector made with that tool axis is off with it.
      const double tilt = std::max(1.0, direction / policy::ulp(1));
      scale.condition *= tilt;
      scale.rest *= tilt;
      // So is all that positions told rounded to a double do not tell.
      scale.pose.tip += seen->rounded * scale.position / rules_.budget().coordinate;
      scale.pose.direction = std::max(scale.pose.direction, policy::ulp(1)) + seen->rounded / rules_.budget().tool_axis;
      if (by) add(seen->event.point, index_, *by);
      if (own) move_by(seen->event, *own);
      difference = compared(seen->event, scale, actual, judged);
    }
  }
  tally = judged;
  if (difference) return difference;
  fit_.follow(event, actual, direction);
  follow(event, actual);
  if (event.kind == EventKind::move) placed_ = !scale.heads.empty();
  return std::nullopt;
}

template <class Number>
void Pairing<Number>::pass(std::span<const model::Event> window) {
  conditions_.next(window);
  if (window.front().kind != EventKind::move) return;
  head_.reset();
  placed_ = false;
}

template <class Number>
std::optional<Difference> Pairing<Number>::compared(const model::Event& expected, const Scale& scale,
                                                    const spec::Event<Number>& actual, Tally& tally) const {
  const bool uncertain =
      std::max(scale.start, scale.vector > 0 ? scale.condition * policy::ulp(scale.vector) : 0) > policy::kByConditions;
  if (expected.arc && uncertain && head_)
    if (const auto end = heads(expected, actual)) {
      if (auto arc = fitted(*expected.arc, head_->end(), end->end(), index_)) {
        model::Event own = expected;
        own.arc = std::move(arc);
        Scale narrow = scale;
        narrow.by_own_heads = true;
        return compare(rules_, own, narrow, actual, tally);
      }
    }
  return compare(rules_, expected, scale, actual, tally);
}

template <class Number>
std::optional<typename Pairing<Number>::Heads> Pairing<Number>::heads(const model::Event& expected,
                                                                      const spec::Event<Number>& actual) const {
  if (!rules_.judges("point")) return std::nullopt;
  Heads result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t axis = index_.at(i);
    if (axis == spec::Axes::kNone || !expected.point.has(axis)) continue;
    if (!actual.point.has(axis) || !is_finite(actual.point[axis])) return std::nullopt;
    model::component(result.expected, i) = expected.point[axis];
    result.actual.at(i) = actual.point[axis];
  }
  return result;
}

// How far the controller's lies off the exact one.
template <class Number>
ArcEnd Pairing<Number>::Heads::end() const {
  Vector off;
  for (std::size_t i = 0; i < 3; ++i)
    model::component(off, i) = Real(Rational(actual.at(i))) - model::component(expected, i);
  return {expected, off};
}

template <class Number>
void Pairing<Number>::follow(const model::Event& expected, const spec::Event<Number>& actual) {
  if (expected.kind == EventKind::move) head_ = heads(expected, actual);
}

template class Pairing<double>;
template class Pairing<Rational>;

}  // namespace toolcomp::judge

// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/leading_edge_offset/leading_edge_offset.h"

#include "spec/language/input_error.h"

namespace toolcomp::fast {
namespace {

// Parameter 19631, normally 1.0 degree.
spec::Decimal angle_limit(const spec::Setup& setup) {
  const auto value = setup.parameter(19631);
  if (!value) return spec::decimal(1);
  spec::Decimal magnitude = *value;
  magnitude.negative = false;
  if (!fits_count(magnitude) || Count::of(spec::decimal(90)) < Count::of(magnitude))
    throw spec::InputError("setup", 0, 0, "parameters.\"19631\": must be from -90 to 90 degrees");
  return *value;
}

}  // namespace

LeadingEdgeOffset::LeadingEdgeOffset(const spec::Setup& setup, const Kinematics& kinematics, EventSink& sink)
    : kinematics_(kinematics),
      compensation_(angle_limit(setup)),
      sink_(&sink),
      xyz_{setup.axes.index('X'), setup.axes.index('Y'), setup.axes.index('Z')} {}

void LeadingEdgeOffset::take_free() {
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    bool used = false;
    for (std::uint8_t k = 0; k < held_count_; ++k) used |= held_[k] == i;
    if (!used) {
      free_ = static_cast<std::uint8_t>(i);
      return;
    }
  }
}

void LeadingEdgeOffset::send(Move& move, const Vector3<double>& vector) {
  Event& event = move.event;
  if (active_)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t axis = xyz_[i];
      if (axis == spec::Axes::kNone) continue;
      event.point.value[axis] += vector[i];
      event.axes.value[axis] += vector[i];
      event.machine.value[axis] += vector[i];  // read only where present
    }
  sink_->on(event);
}

void LeadingEdgeOffset::send_held() {
  for (std::uint8_t i = 0; i < held_count_; ++i) send(ring_[held_[i]], vector_);
  held_count_ = 0;
}

void LeadingEdgeOffset::start() {
  active_ = true;
  starting_ = true;
  still_ = 0;
  vector_ = {};
  start_line_ = next().event.line;
  start_n_ = next().event.n;
  hold();
}

Alarm LeadingEdgeOffset::block(bool own, bool moving) {
  Move& move = next();
  if (starting_) {
    if (!moving) return AlarmCause::leading_edge_command;
    const Move& start = ring_[held_[0]];
    if (const Alarm a = update(move.displacement, *start.direction, start.radius)) return a;
    starting_ = false;
    send_held();
    hold();
    return AlarmCause::none;
  }
  if (moving) {
    if (held_count_ > 0) {
      const Move& former = ring_[held_[0]];
      update(move.displacement, *former.direction, former.radius);
      send_held();
    }
    hold();
    still_ = 0;
    return AlarmCause::none;
  }
  // No movement: one such block shares the vector of the moving block before it, which looks past it; a second one
  // makes both keep the vector from before.
  if (still_ < 2) ++still_;
  if (held_count_ == 0) {
    if (own) send_compensated();
    return AlarmCause::none;
  }
  if (still_ == 1) {
    if (own) hold();
    return AlarmCause::none;
  }
  send_held();
  if (own) send_compensated();
  return AlarmCause::none;
}

Alarm LeadingEdgeOffset::release() {
  if (starting_) return AlarmCause::leading_edge_command;
  // The free slot is not touched: next() may already be filled.
  send_held();
  return AlarmCause::none;
}

Alarm LeadingEdgeOffset::finish() {
  if (starting_) return AlarmCause::leading_edge_command;
  if (held_count_ > 0) {
    // The last moving block has no next one: its own movement serves.
    const Move& former = ring_[held_[0]];
    update(former.displacement, *former.direction, former.radius);
  }
  send_held();
  return AlarmCause::none;
}

void LeadingEdgeOffset::cancel() {
  send(next(), {});
  active_ = false;
  vector_ = {};
}

}  // namespace toolcomp::fast

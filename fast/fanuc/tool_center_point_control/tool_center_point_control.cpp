// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_center_point_control/tool_center_point_control.h"

#include <bit>

#include "fast/basis/axis_mask.h"

namespace toolcomp::fast {
namespace {

double between(double start, double end, double t) { return start + t * (end - start); }

}  // namespace

ToolCenterPointControl::ToolCenterPointControl(const spec::Setup& setup, const Machine& machine, EventSink& out,
                                               std::uint32_t samples)
    : machine_(machine),
      out_(out),
      samples_(samples),
      xyz_{setup.axes.index('X'), setup.axes.index('Y'), setup.axes.index('Z')},
      xyz_first_(xyz_[0] == 0 && xyz_[1] == 1 && xyz_[2] == 2),
      count_(setup.axes.size()),
      fraction_(samples) {
  for (std::size_t axis = 0; axis < count_; ++axis) {
    all_ = static_cast<std::uint16_t>(all_ | bit(axis));
    if (spec::is_linear_axis(setup.axes.letter(axis))) linear_ = static_cast<std::uint16_t>(linear_ | bit(axis));
    const bool tip = axis == xyz_[0] || axis == xyz_[1] || axis == xyz_[2];
    if (!tip && axis != machine_.rotary_axis(0) && axis != machine_.rotary_axis(1))
      even_ = static_cast<std::uint16_t>(even_ | bit(axis));
  }
  sample_.kind = spec::EventKind::sample;
  sample_.axes.present = all_;
  sample_.point.present = linear_;
  notice_.kind = spec::EventKind::warning;
}

void ToolCenterPointControl::set_origin(const std::array<double, spec::kMaxAxes>& origin) {
  moves_on_table_ = machine_.workpiece_frame() && machine_.has_table();
  origin_ = origin;
  const auto of = [&](std::size_t i) { return xyz_[i] == spec::Axes::kNone ? 0 : origin[xyz_[i]]; };
  origin_xyz_ = {of(0), of(1), of(2)};
}

TipBlock& ToolCenterPointControl::next() {
  const double length = block().length;
  current_ = (current_ + 1U) % static_cast<std::uint32_t>(blocks_.size());
  block().length_before = length;
  return block();
}

Vector3<double> ToolCenterPointControl::point_of(const Event& event) const {
  if (xyz_first_) [[likely]]
    return {event.point.value[0], event.point.value[1], event.point.value[2]};
  const auto of = [&](std::size_t i) { return xyz_[i] == spec::Axes::kNone ? 0 : event.point.value[xyz_[i]]; };
  return {of(0), of(1), of(2)};
}

void ToolCenterPointControl::on(const Event& event) {
  if (event.kind != spec::EventKind::move) {
    out_.on(event);
    return;
  }
  TipBlock& block = blocks_[event.t_numerator];
  const bool sampled = samples() && block.sampled && event.cause != spec::Cause::corner;
  if (!active_) {
    if (sampled) send_direction_samples(event, block);
    event_ = event;
    event_.t_numerator = 0;
    tip_ = point_of(event);
    out_.on(event_);
    return;
  }
  const PosturePlan& plan = block.plan;
  if (event.cause == spec::Cause::corner) {
    take(event);
    finish(plan.end, plan.end, block.length);
    return;
  }
  if (plan.branch_warning) [[unlikely]]
    warn(event);
  if (plan.pre_turn) [[unlikely]]
    turn(event, plan.turned, block.length_before, spec::Cause::pre_turn);
  if (sampled) send_samples(event, block);
  take(event);
  finish(plan.post_turn ? plan.arrived : plan.end, plan.end, block.length);
  if (plan.post_turn) [[unlikely]]
    turn(event, plan.end, block.length, spec::Cause::post_turn);
}

void ToolCenterPointControl::warn(const Event& event) {
  notice_.number = "posture-branch";
  notice_.message = "the rotary positions cannot be reached in the plane of the tool";
  notice_.line = event.line;
  notice_.n = event.n;
  out_.on(notice_);
}

[[gnu::always_inline]] inline void ToolCenterPointControl::set_axes(Event& event, const Vector3<double>& point,
                                                                    double first, double second) const {
  put(event.axes.value, point);
  if (machine_.rotary_axis(0) != spec::kMaxAxes) event.axes.value[machine_.rotary_axis(0)] = first;
  if (machine_.rotary_axis(1) != spec::kMaxAxes) event.axes.value[machine_.rotary_axis(1)] = second;
}

// Sines and cosines are not looked at where the tool itself tells the way.
[[gnu::always_inline]] inline void ToolCenterPointControl::set_axes(Event& event, const Vector3<double>& tip,
                                                                    const Pose& pose, double length) const {
  const Vector3<double> tool{pose.tool.unit[0], pose.tool.unit[1], pose.tool.unit[2]};
  const Vector3<double> point =
      machine_.along_tool() ? tip + tool * length : machine_.control_point(tip, turns(pose), length, origin_xyz_);
  set_axes(event, point, machine_.programmed_degrees(pose, 0), machine_.programmed_degrees(pose, 1));
}

// Only the work-side axis turns; X Y Z follow at a standing tip.
void ToolCenterPointControl::turn(const Event& owner, const Pose& pose, double length, spec::Cause cause) {
  event_.line = owner.line;
  event_.n = owner.n;
  event_.type = owner.type == spec::MoveType::rapid ? spec::MoveType::rapid : spec::MoveType::linear;
  event_.cause = cause;
  event_.arc.reset();
  event_.feed = owner.feed;
  set_axes(event_, tip_, pose, length);
  set_machine(event_);
  send_beside_name(pose);
}

// `event_`, whose point is named for another pose.
void ToolCenterPointControl::send_beside_name(const Pose& pose) {
  if (!moves_on_table_) {
    out_.on(event_);
    return;
  }
  const auto named = event_.point.value;
  put(event_.point.value, machine_.from_table(tip_, turns(pose), origin_xyz_));
  out_.on(event_);
  event_.point.value = named;
}

// An own or inserted move, as it ends; its point is named for the pose `end`, where a turn may follow.
void ToolCenterPointControl::finish(const Pose& pose, const Pose& end, double length) {
  event_.t_numerator = 0;
  tip_ = point_of(event_);
  if (moves_on_table_) tip_ = on_table(tip_, turns(end));
  set_axes(event_, tip_, pose, length);
  set_machine(event_);
  set_tool_axis(event_, {pose.tool.unit[0], pose.tool.unit[1], pose.tool.unit[2]});
  if (&pose != &end) [[unlikely]]
    send_beside_name(pose);
  else
    out_.on(event_);
}

void ToolCenterPointControl::take(const Event& move) {
  event_.line = move.line;
  event_.n = move.n;
  event_.type = move.type;
  event_.cause = move.cause;
  event_.feed = move.feed;
  event_.programmed.present = move.programmed.present;
  event_.point.present = move.point.present;
  event_.axes.present = move.axes.present;
  std::size_t axis = 0;
  if (xyz_first_) [[likely]] {
    event_.programmed.value[0] = move.programmed.value[0];
    event_.programmed.value[1] = move.programmed.value[1];
    event_.programmed.value[2] = move.programmed.value[2];
    event_.point.value[0] = move.point.value[0];
    event_.point.value[1] = move.point.value[1];
    event_.point.value[2] = move.point.value[2];
    // No axis is left that the posture does not make.
    axis = even_ == 0 ? count_ : 3;
  }
  for (; axis < count_; ++axis) {
    event_.programmed.value[axis] = move.programmed.value[axis];
    event_.point.value[axis] = move.point.value[axis];
    event_.axes.value[axis] = move.axes.value[axis];
  }
  if (move.arc || event_.arc) [[unlikely]]
    event_.arc = move.arc;
}

void ToolCenterPointControl::set_tool_axis(Event& event, const Vector3<double>& tool) {
  event.tool_axis.emplace(std::array<double, 3>{tool.x + 0.0, tool.y + 0.0, tool.z + 0.0});  // never -0
}

void ToolCenterPointControl::set_machine(Event& event) const {
  event.machine.present = all_;
  std::size_t axis = 0;
  if (xyz_first_) [[likely]] {
    event.machine.value[0] = event.axes.value[0] + origin_[0];
    event.machine.value[1] = event.axes.value[1] + origin_[1];
    event.machine.value[2] = event.axes.value[2] + origin_[2];
    axis = 3;
  }
  for (; axis < count_; ++axis) event.machine.value[axis] = event.axes.value[axis] + origin_[axis];
}

void ToolCenterPointControl::begin_samples(const Event& event) {
  sample_.line = event.line;
  sample_.n = event.n;
  fraction_.restart();
}

void ToolCenterPointControl::set_even(const Event& event, double t) {
  for (unsigned rest = even_; rest != 0; rest &= rest - 1) {
    const auto axis = static_cast<std::size_t>(std::countr_zero(rest));
    sample_.axes.value[axis] = between(event_.axes[axis], event.axes[axis], t);
    sample_.point.value[axis] = between(event_.point[axis], event.point[axis], t);
  }
}

void ToolCenterPointControl::send_sample() {
  sample_.t_numerator = fraction_.numerator();
  sample_.t_denominator = fraction_.denominator();
  out_.on(sample_);
}

// `event_` is where the block starts, `event` where it ends.
void ToolCenterPointControl::send_samples(const Event& event, TipBlock& block) {
  begin_samples(event);
  const Vector3<double> point = point_of(event);
  // On the table; an arc with WKP = 1 is described in the workpiece system, where the table stands at its end.
  const bool in_workpiece = moves_on_table_ && event.arc.has_value();
  const TipPath path = event.arc ? TipPath(in_workpiece ? point_of(event_) : tip_, point, *event.arc, xyz_)
                                 : TipPath(tip_, on_table(point, turns(block.plan.end)));
  PostureSample sample;
  for (std::uint32_t k = 1; k < samples_; ++k) {
    fraction_.advance();
    const double t = static_cast<double>(k) / static_cast<double>(samples_);
    block.plan.motion.at(k, samples_, sample);
    set_even(event, t);
    Vector3<double> at = path.at(t);
    Vector3<double> tip = at;
    if (in_workpiece) tip = on_table(at, turns(block.plan.end));
    if (moves_on_table_) at = machine_.from_table(tip, sample.turns, origin_xyz_);
    put(sample_.point.value, at);
    const double length = between(block.length_before, block.length, t);
    const Vector3<double> control = machine_.along_tool()
                                        ? tip + sample.tool * length
                                        : machine_.control_point(tip, sample.turns, length, origin_xyz_);
    set_axes(sample_, control, machine_.programmed_degrees(sample.degrees[0], 0),
             machine_.programmed_degrees(sample.degrees[1], 1));
    set_tool_axis(sample_, sample.tool);
    send_sample();
  }
}

void ToolCenterPointControl::send_direction_samples(const Event& event, TipBlock& block) {
  begin_samples(event);
  const TipPath path = event.arc ? TipPath(tip_, point_of(event), *event.arc, xyz_) : TipPath(tip_, point_of(event));
  for (std::uint32_t k = 1; k < samples_; ++k) {
    fraction_.advance();
    const double t = static_cast<double>(k) / static_cast<double>(samples_);
    const Vector3<double> tool = block.direction.at(k, samples_);
    const Vector3<double> at = path.at(t);
    const double length = between(block.length_before, block.length, t);
    set_even(event, t);
    for (std::size_t i = 0; i < 3; ++i) {
      if (xyz_[i] == spec::Axes::kNone) continue;
      sample_.point.value[xyz_[i]] = at[i];
      sample_.axes.value[xyz_[i]] = at[i] + length * tool[i];
    }
    set_tool_axis(sample_, tool);
    send_sample();
  }
}

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_center_point_control/tip_moves.h"

#include <utility>

#include "model/fanuc/tool_center_point_control/tip_path.h"
#include "model/fanuc/tool_posture_control/motions.h"

namespace toolcomp::model {
namespace {

bool turns(const Machine& machine, std::size_t axis) {
  return machine.tool_side().axis == axis || machine.work_side().axis == axis;
}

// Inside a block no sign of an angle may be asked: positions are subtracted as numbers.
Real programmed_position(const ControlFrame& frame, const Pose& pose, std::size_t axis) {
  const bool tool = frame.machine.tool_side().axis == axis;
  const Angle& angle = tool ? pose.tool : pose.work;
  const Angle& zero = tool ? frame.zero.tool : frame.zero.work;
  if (zero.is_rational()) return (angle - zero).degrees();
  return angle.degrees() - zero.degrees();
}

PointPath path_of(const Move& last, const Move& move, const spec::Axes& axes) {
  Vector from = on_table(*last.tip, tip_at(last, axes));
  Vector to = on_table(*move.tip, tip_at(move, axes));
  if (move.leg.arc) return path_along(std::move(from), std::move(to), *move.leg.arc, axes);
  return {std::move(from), std::move(to), {}};
}

// The position inside a block at the fraction t of its own move, 0 < t < 1, exact: point, axes and tool axis. `last`:
// the move before it.
Event position_inside(const Move& last, const Move& move, const OwnMotion& inside, const spec::Axes& axes,
                      const Rational& t);

class TipInside : public InsideMove {
 public:
  TipInside(Move last, Move move, OwnMotion inside, spec::Axes axes)
      : last_(std::move(last)), move_(std::move(move)), inside_(std::move(inside)), axes_(std::move(axes)) {}

  [[nodiscard]] spec::AxisValues<Real> axes_at(const Rational& t) const override {
    return position_inside(last_, move_, inside_, axes_, t).axes;
  }
  [[nodiscard]] Form form() const override {
    return {path_of(last_, move_, axes_), inside_.motion->form(), inside_.length_before, move_.tip->length,
            move_.tip->frame};
  }

 private:
  Move last_;
  Move move_;
  OwnMotion inside_;
  spec::Axes axes_;
};

}  // namespace

Vector tip_at(const Move& move, const spec::Axes& axes) {
  Vector tip = move.offset;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (const char letter = axes.letter(i); is_space_axis(letter))
      component(tip, space_index(letter)) += move.leg.actual(i).value();
  return tip;
}

Vector axes_at(const Move& move, const spec::Axes& axes) {
  return control_point(*move.tip, {tip_at(move, axes), move.tool.unit});
}

std::optional<Vector> tip_beside_name(const Move& move, const spec::Axes& axes) {
  if (!move.tip || !move.tip->in_workpiece || !move.tip->named_at) return std::nullopt;
  return move.tip->frame->frame.in_workpiece(on_table(*move.tip, tip_at(move, axes)), move.tip->pose);
}

// fanuc.tool-center-point.samples: If N samples are requested, the positions at t = k/N, k from 1 to N - 1, come before
// every own move of a block under tool center point control, that of a lone H included. The block of the code, inserted
// moves and turns give none.
namespace {

Event position_inside(const Move& last, const Move& move, const OwnMotion& inside, const spec::Axes& axes,
                      const Rational& t) {
  const Posture posture = inside.motion->at(t);
  const Vector on_table = TipPath(path_of(last, move, axes)).at(t);
  const ToolPose& end = *move.tip;
  const Rational length = (1 - t) * inside.length_before + t * end.length;
  Vector tool = posture.tool;
  Vector point = on_table;
  Vector control = on_table + Real(length) * tool;
  if (end.frame) {
    control = end.frame->frame.control_point(on_table, posture.pose, length);
    if (end.in_workpiece) {
      point = end.frame->frame.in_workpiece(on_table, posture.pose);
      tool = end.frame->machine.direction_in_machine(posture.pose);
    }
  }
  Event event;
  event.kind = spec::EventKind::sample;
  event.tool_axis = {tool.x, tool.y, tool.z};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const char letter = axes.letter(i);
    if (is_space_axis(letter)) {
      event.point.set(i, component(point, space_index(letter)));
      event.axes.set(i, component(control, space_index(letter)));
    } else if (end.frame && turns(end.frame->machine, i)) {
      event.axes.set(i, programmed_position(*end.frame, posture.pose, i));
    } else {
      // Every other axis runs evenly.
      const Coordinate from = last.leg.actual(i);
      const Real at = from.value() + t * (move.leg.actual(i) - from).value();
      if (spec::is_linear_axis(letter)) event.point.set(i, at);
      event.axes.set(i, at);
    }
  }
  return event;
}

}  // namespace

void TipMoves::take(const Move& move) {
  if (!move.tip) {
    last_.reset();
    moves_(move, nullptr);
    return;
  }
  const bool inside = move.inside && last_;
  if (inside && move.inside->pre_turn) turn(*last_, *move.inside->pre_turn, spec::Cause::pre_turn, move);
  if (inside && samples_ > 1) sample(move);
  moves_(move, inside && with_inside_ ? std::make_shared<TipInside>(*last_, move, *move.inside, axes_) : nullptr);
  last_ = move;
  if (!inside || !move.inside->post_turn) return;
  turn(move, *move.inside->post_turn, spec::Cause::post_turn, move);
  last_->tip->pose = *move.inside->post_turn;
  last_->tip->named_at.reset();
  last_->tip->frame->place(last_->tip->pose, last_->leg.end);
}

// The work-side axis alone turns, at a standing tip.
void TipMoves::turn(const Move& at, const Pose& to, spec::Cause cause, const Move& of) const {
  Move result = at;
  result.inside.reset();
  // The tip stands on the table.
  result.tip->named_at = at.tip->named_at.value_or(at.tip->pose);
  result.tip->pose = to;
  result.tip->frame->place(to, result.leg.end);
  result.leg.cause = cause;
  result.leg.type = of.leg.type == spec::MoveType::rapid ? spec::MoveType::rapid : spec::MoveType::linear;
  result.leg.arc.reset();
  result.feed = of.feed;
  if (!with_inside_) {
    moves_(result, nullptr);
    return;
  }
  // The tip stands, and the tool.
  OwnMotion turning;
  turning.motion = even_motion(at.tip->frame, at.tip->pose, to);
  turning.length_before = at.tip->length;
  moves_(result, std::make_shared<TipInside>(at, result, std::move(turning), axes_));
}

void TipMoves::sample(const Move& move) const {
  for (std::uint32_t k = 1; k < samples_; ++k) {
    const Rational t(k, samples_);
    Event event = position_inside(*last_, move, *move.inside, axes_, t);
    event.t_numerator = static_cast<std::uint32_t>(numerator(t));
    event.t_denominator = static_cast<std::uint32_t>(denominator(t));
    inside_(event);
  }
}

}  // namespace toolcomp::model

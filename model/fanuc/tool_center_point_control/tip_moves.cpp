// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_center_point_control/tip_moves.h"

#include <utility>

#include "model/fanuc/tool_posture_control/motions.h"
#include "model/geometry/plane_vector.h"

namespace toolcomp::model {
namespace {

// The programmed position of an axis that turns tool or table; nothing of another axis. Inside a block no sign of an
// angle may be asked: positions are subtracted as numbers.
std::optional<Real> turned_position(const ControlFrame& frame, const Pose& pose, std::size_t axis) {
  const bool tool = frame.machine.tool_side().axis == axis;
  if (!tool && frame.machine.work_side().axis != axis) return std::nullopt;
  const Angle& angle = tool ? pose.tool : pose.work;
  const Angle& zero = tool ? frame.zero.tool : frame.zero.work;
  return zero.is_rational() ? (angle - zero).degrees() : angle.degrees() - zero.degrees();
}

// The compensated tip at the end of a move, in the programming system.
Vector tip_at(const Move& move, const spec::Axes& axes) {
  return move.offset + in_space(axes, [&](std::size_t axis) { return move.leg.actual(axis).value(); });
}

// fanuc.tool-center-point.tip-path: Inside a block the tip is at the fraction t of its path in the system fixed to the
// table, whatever WKP is. On an arc t is the fraction of the sweep, and the radius and the travel across the plane go
// evenly with it. An arc that has no sweep, because an end lies in its centre, counts as the line between its ends. In
// a block that does not move the tip, t is the fraction of the rotation. Axes that are neither X Y Z nor rotary axes of
// 19681 and 19686 go evenly.
Vector point_at(const PointPath& path, const Rational& t) {
  Vector result = path.from + Real(t) * (path.to - path.from);
  if (!path.turn) return result;
  const PointPath::Turn& turn = *path.turn;
  const Real angle = t * turn.sweep;
  const Real cosine = exact::cos_real_degrees(angle);
  const Real sine = exact::sin_real_degrees(angle);
  const PlanePoint radius = in_plane_of(turn.plane, path.from) - turn.center;
  const PlanePoint turned = turn.center + (1 + t * turn.growth) * (cosine * radius + sine * left(radius));
  // What lies across the plane goes evenly.
  component(result, space_index(letters(turn.plane).first)) = turned[0];
  component(result, space_index(letters(turn.plane).second)) = turned[1];
  return result;
}

class TipInside : public InsideMove {
 public:
  // `last`: the move before it.
  TipInside(Move last, Move move, spec::Axes axes)
      : last_(std::move(last)), move_(std::move(move)), axes_(std::move(axes)) {}

  // Point, axes and tool axis at the fraction t, 0 < t < 1, exact.
  [[nodiscard]] Event position(const Rational& t) const {
    const Posture posture = move_.inside->motion->at(t);
    const Vector on_table = point_at(path(), t);
    const ToolPose& end = *move_.tip;
    const Rational length = (1 - t) * move_.inside->length_before + t * end.length;
    Vector tool = posture.tool;
    Vector point = on_table;
    Vector control = on_table + Real(length) * tool;
    if (end.frame) control = end.frame->frame.control_point(on_table, posture.pose, length);
    if (end.in_workpiece) {
      point = end.frame->frame.in_workpiece(on_table, posture.pose);
      tool = end.frame->machine.direction_in_machine(posture.pose);
    }
    Event event;
    event.kind = spec::EventKind::sample;
    event.tool_axis = {tool.x, tool.y, tool.z};
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      const char letter = axes_.letter(i);
      if (is_space_axis(letter)) {
        event.point.set(i, component(point, space_index(letter)));
        event.axes.set(i, component(control, space_index(letter)));
      } else if (const auto turned = end.frame ? turned_position(*end.frame, posture.pose, i) : std::nullopt) {
        event.axes.set(i, *turned);
      } else {
        // Every other axis runs evenly.
        const Coordinate from = last_.leg.actual(i);
        const Real at = from.value() + t * (move_.leg.actual(i) - from).value();
        if (spec::is_linear_axis(letter)) event.point.set(i, at);
        event.axes.set(i, at);
      }
    }
    return event;
  }

  [[nodiscard]] spec::AxisValues<Real> axes_at(const Rational& t) const override { return position(t).axes; }
  [[nodiscard]] Form form() const override {
    return {path(), move_.inside->motion->form(), move_.inside->length_before, move_.tip->length, move_.tip->frame};
  }

 private:
  [[nodiscard]] PointPath path() const {
    Vector from = on_table(*last_.tip, tip_at(last_, axes_));
    Vector to = on_table(*move_.tip, tip_at(move_, axes_));
    if (move_.leg.arc) return path_along(std::move(from), std::move(to), *move_.leg.arc, axes_);
    return {std::move(from), std::move(to), {}};
  }

  Move last_;
  Move move_;
  spec::Axes axes_;
};

}  // namespace

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
void TipMoves::take(const Move& move) {
  const auto own = last_ ? move.inside : nullptr;
  std::shared_ptr<const TipInside> inside;
  if (own) {
    if (own->pre_turn) turn(*last_, *own->pre_turn, spec::Cause::pre_turn, move);
    // Two copies of a move are dear: they are made only where somebody looks inside.
    if (samples_ > 1 || with_inside_) inside = std::make_shared<const TipInside>(*last_, move, axes_);
    for (std::uint32_t k = 1; k < samples_; ++k) {
      const Rational t(k, samples_);
      Event event = inside->position(t);
      event.t_numerator = static_cast<std::uint32_t>(numerator(t));
      event.t_denominator = static_cast<std::uint32_t>(denominator(t));
      inside_(event);
    }
  }
  moves_(move, with_inside_ ? inside : nullptr);
  last_ = move.tip ? std::optional(move) : std::nullopt;
  if (!own || !own->post_turn) return;
  turn(move, *own->post_turn, spec::Cause::post_turn, move);
  last_->tip->pose = *own->post_turn;
  last_->tip->named_at.reset();
  last_->tip->frame->place(last_->tip->pose, last_->leg.end);
}

// The work-side axis alone turns, at a standing tip.
void TipMoves::turn(const Move& at, const Pose& to, spec::Cause cause, const Move& of) const {
  Move result = at;
  result.inside.reset();
  if (with_inside_) {
    // The tip stands on the table, and the tool.
    OwnMotion turning;
    turning.motion = even_motion(at.tip->frame, at.tip->pose, to);
    turning.length_before = at.tip->length;
    result.inside = std::make_shared<const OwnMotion>(std::move(turning));
  }
  result.tip->named_at = at.tip->named_at.value_or(at.tip->pose);
  result.tip->pose = to;
  result.tip->frame->place(to, result.leg.end);
  result.leg.cause = cause;
  result.leg.type = of.leg.type == spec::MoveType::rapid ? spec::MoveType::rapid : spec::MoveType::linear;
  result.leg.arc.reset();
  result.feed = of.feed;
  moves_(result, with_inside_ ? std::make_shared<const TipInside>(at, result, axes_) : nullptr);
}

}  // namespace toolcomp::model

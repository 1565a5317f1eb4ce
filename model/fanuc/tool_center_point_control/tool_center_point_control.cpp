#include "model/fanuc/tool_center_point_control/tool_center_point_control.h"

#include <memory>
#include <utility>

#include "model/basis/alarm.h"
#include "model/fanuc/tool_center_point_control/lean.h"
#include "model/fanuc/tool_posture_control/direction_motion.h"
#include "model/geometry/plane.h"
#include "model/kinematics/mechanism.h"

namespace toolcomp::model {
namespace {

Rational direction_word(const Command& command, char letter, const Numbers& numbers) {
  const spec::Decimal* const word = command.words.find(letter);
  return word == nullptr ? Rational(0) : numbers.length(*word);
}

Direction direction_words(const Command& command, const Numbers& numbers) {
  return Direction::of({direction_word(command, 'I', numbers), direction_word(command, 'J', numbers),
                        direction_word(command, 'K', numbers)});
}

Direction of_unit(const Vector& unit) { return {unit, 1, unit, true}; }

// X Y Z of a position; a machine without one of them stands at 0 in it.
Vector in_space(const Position& position, const spec::Axes& axes) {
  Vector result;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (const char letter = axes.letter(i); is_space_axis(letter))
      component(result, space_index(letter)) = position.at(i).value();
  return result;
}

// The shift of G45 to G48 in X Y Z.
Vector shift_of(const Leg& leg, const spec::Axes& axes) {
  Vector result;
  if (!leg.shift) return result;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (const char letter = axes.letter(i); is_space_axis(letter))
      component(result, space_index(letter)) = leg.shift->at(i);
  return result;
}

// Known to be one pose.
bool same(const Pose& a, const Pose& b) {
  return known_difference(a.tool, b.tool) == Rational(0) && known_difference(a.work, b.work) == Rational(0);
}

Clause control_point_clause(MachineType type) {
  switch (type) {
    case MachineType::table:
      return Clause::fanuc_tool_center_point_control_point_table_rotation;
    case MachineType::mixed:
      return Clause::fanuc_tool_center_point_control_point_mixed;
    default:
      return Clause::fanuc_tool_center_point_control_point_tool_rotation;
  }
}

}  // namespace

ToolCenterPointControl::ToolCenterPointControl(const spec::Setup& setup, Recorder& recorder,
                                               const WorkCoordinates& work, const Position& start, bool with_motion)
    : recorder_(recorder),
      work_(work),
      axes_(setup.axes),
      by_machine_(setup.rotary_angles == spec::RotaryAngles::machine),
      kinematics_(setup),
      holder_offset_(parameter(setup, 19666)),
      posture_by_default_(setup.bit(19604, 0)),
      with_motion_(with_motion) {
  if (parameter(setup, 19680) != 0) {
    machine_.emplace(setup);
    choice_.emplace(setup, *machine_, recorder);
    posture_.emplace(setup, *machine_, *choice_, recorder);
  }
  tool_ = of_pose(start);
}

Position ToolCenterPointControl::angles(const Position& position) const {
  Position result = position;
  for (std::size_t i = 0; by_machine_ && i < axes_.size(); ++i)
    if (kinematics_.turns(i)) result.at(i) = result.at(i) + work_.zero(i);
  return result;
}

bool ToolCenterPointControl::is_displaced() const {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (!kinematics_.turns(i)) continue;
    const Angle zero = work_.zero(i).angle();
    if (!zero.is_rational() || zero.rational() != 0) return true;
  }
  return false;
}

void ToolCenterPointControl::decide_angles() const {
  if (is_displaced()) recorder_.decide(Clause::fanuc_tool_direction_rotary_angles, by_machine_);
}

// Computed again only where an axis that turns the tool has moved.
const Direction& ToolCenterPointControl::of_pose(const Position& position) {
  Position turned = angles(position);
  bool same = pose_.has_value();
  for (std::size_t i = 0; same && i < axes_.size(); ++i)
    if (kinematics_.turns(i)) same = turned.at(i) == pose_->at(i);
  if (!same) {
    pose_direction_ = kinematics_.direction(turned);
    pose_ = std::move(turned);
  }
  return pose_direction_;
}

ToolAtEnd ToolCenterPointControl::at(const Position& end) {
  recorder_.decide(Clause::fanuc_tool_direction_of_pose, kinematics_.present());
  decide_angles();
  follow(end);
  return standing();
}

void ToolCenterPointControl::follow(const Position& position) {
  tip_.reset();
  tool_ = of_pose(position);
}

void ToolCenterPointControl::rename_position(const TipMarks& marks, const Leg& standing,
                                             Interpreter& interpreter) const {
  if (!tip_) return;
  const bool on_table = tip_->frame && machine_->type() != MachineType::head;
  const Vector shift = shift_of(standing, axes_);
  const Vector tip = in_space(standing.end, axes_) + shift;
  if (marks.ends) {
    recorder_.reach(Clause::fanuc_tool_center_point_end);
    if (on_table)
      interpreter.stand_in_space(control_point(*tip_, {tip, tool_.unit}) - shift);
    else
      interpreter.shift_position(control_point(*tip_, {Vector(), tool_.unit}));
  } else if (marks.again) {
    recorder_.reach(Clause::fanuc_tool_center_point_again);
    if (on_table && !tip_->in_workpiece)
      interpreter.stand_in_space(tip_->frame->frame.in_workpiece(tip, tip_->pose) - shift);
  }
}

TurnedBlock ToolCenterPointControl::turn(const Command& command, const TipMarks& marks, const Interpreter& interpreter,
                                         const Rational& offset, Leg& leg) {
  recorder_.reach(Clause::fanuc_tool_center_point_length);
  if (machine_) recorder_.reach(control_point_clause(machine_->type()));
  TurnedBlock result;
  if (marks.starts) {
    start(command, marks, interpreter, leg);
    tip_->length = offset + holder_offset_;
    result.end = standing();
    return result;
  }
  const Rational before = std::exchange(tip_->length, offset + holder_offset_);
  result = machine_ ? turn_axes(command, marks, interpreter, leg) : turn_directly(command, interpreter, leg);
  result.motion->length_before = before;
  return result;
}

// The block of the code.
void ToolCenterPointControl::start(const Command& command, const TipMarks& marks, const Interpreter& interpreter,
                                   Leg& leg) {
  recorder_.reach(Clause::fanuc_tool_center_point_block);
  standing_.reset();
  last_lean_.reset();
  const bool direction =
      marks.directed && recorder_.decide(Clause::fanuc_tool_center_point_direction_words, command.direction);
  if (direction) now_ = direction_words(command, interpreter.numbers());
  tip_.emplace();
  if (!machine_) {
    // There are no rotary positions to take it from again.
    if (!direction && !marks.again) now_ = of_pose(leg.end);
    now_.reported = true;
    tool_ = kept_ = now_;
    return;
  }
  decide_angles();
  frozen_ = machine_->pose(angles(leg.end));
  // Only heads have a direction here: their frame does not turn.
  if (direction) frozen_ = choice_->choose(now_, frozen_).pose;
  Vector origin;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (const char letter = axes_.letter(i); is_space_axis(letter))
      component(origin, space_index(letter)) = interpreter.work().zero(i).value();
  // No block of the mode changes the coordinates.
  tip_->frame = std::make_shared<const ControlFrame>(*machine_, frozen_, origin, machine_->pose(angles(Position())));
  place(frozen_, leg.end);
  tip_->in_workpiece = machine_->programs_workpiece() && machine_->type() != MachineType::head;
  tip_->pose = frozen_;
  if (!direction) now_ = of_unit(tip_->frame->frame.direction(frozen_));
  kept_ = now_;
  tool_ = tip_->in_workpiece ? of_unit(reported_tool(*tip_)) : now_;
}

// What the block is asked to turn the tool to; nothing where it stands.
std::optional<Direction> ToolCenterPointControl::direction_asked(const Command& command, const Interpreter& interpreter,
                                                                 const Leg& leg) {
  const bool given = recorder_.decide(Clause::fanuc_tool_center_point_direction_words, command.direction);
  const bool may_lean = lean_ != 0 && (given || !is_zero(leg.travel));
  if (given) kept_ = direction_words(command, interpreter.numbers());
  if (may_lean) {
    Lean now{kept_.vector, lean_travel(leg, axes_), leaned(recorder_, kept_, leg, axes_, lean_)};
    // The same lean again is known to be the same direction.
    if (last_lean_ && known_same(last_lean_->tool, now.tool) && known_same(last_lean_->travel, now.travel))
      now.to = last_lean_->to;
    last_lean_ = now;
    return now.to;
  }
  return given ? std::optional(kept_) : std::nullopt;
}

TurnedBlock ToolCenterPointControl::turn_directly(const Command& command, const Interpreter& interpreter,
                                                  const Leg& leg) {
  TurnedBlock result;
  result.motion.emplace();
  Direction to = direction_asked(command, interpreter, leg).value_or(now_);
  if (with_motion_) result.motion->motion = std::make_shared<DirectionMotion>(now_, to);
  tool_ = now_ = std::move(to);
  result.end = standing();
  return result;
}

TurnedBlock ToolCenterPointControl::turn_axes(const Command& command, const TipMarks& marks,
                                              const Interpreter& interpreter, Leg& leg) {
  const bool tip_alone = !has_axis_word(command, is_space_axis);
  if (tip_alone && (has_axis_word(command, spec::is_rotary_axis) || (marks.directed && command.direction)))
    recorder_.reach(Clause::fanuc_tool_center_point_tip_alone);
  if (leg.arc) recorder_.reach(Clause::fanuc_tool_center_point_arc);
  if (leg.arc && tip_->in_workpiece) restrict_arc_on_table(leg);
  PosturePlan found = marks.directed ? directed(command, interpreter, leg) : commanded(leg);
  const Pose end = found.post_turn.value_or(found.end);
  if (tip_->in_workpiece) keep_tip_on_table(tip_alone, interpreter.position(), end, leg);
  place(end, leg.end);

  TurnedBlock result;
  result.motion.emplace();
  result.motion->branch_differs = found.branch_differs;
  if (found.pre_turn) result.motion->pre_turn = found.start;
  result.motion->post_turn = found.post_turn;
  result.motion->motion = std::move(found.motion);
  now_ = std::move(found.tool);
  tip_->pose = found.end;
  tool_ = tip_->in_workpiece ? of_unit(reported_tool(*tip_)) : now_;
  result.end = standing();
  // The end is given as it is when all has turned.
  if (found.post_turn) result.end.tip->named_at = end;
  tip_->pose = end;
  return result;
}

PosturePlan ToolCenterPointControl::commanded(const Leg& leg) const {
  const Pose end = machine_->pose(angles(leg.end));
  if (same(end, tip_->pose)) return ToolPostureControl::stand(tip_->frame, {tip_->pose, now_, now_, end, {}});
  return plan({tip_->pose, now_, of_unit(tip_->frame->frame.direction(end)), end, {}});
}

PosturePlan ToolCenterPointControl::directed(const Command& command, const Interpreter& interpreter, const Leg& leg) {
  const std::optional<Direction> to = direction_asked(command, interpreter, leg);
  if (!to) return ToolPostureControl::stand(tip_->frame, {tip_->pose, now_, now_, {}, {}});
  PostureBlock block{tip_->pose, now_, *to, {}, {}};
  if (lean_ != 0 && known_same(kept_.vector, now_.vector)) block.leaned_toward = lean_travel(leg, axes_);
  PosturePlan found = plan(block);
  if (found.changed) kept_ = found.tool;
  return found;
}

PosturePlan ToolCenterPointControl::plan(const PostureBlock& block) const {
  return with_posture_ ? posture_->plan(tip_->frame, block) : posture_->conventional(tip_->frame, block);
}

void ToolCenterPointControl::restrict_arc_on_table(const Leg& leg) const {
  const Pose end = machine_->pose(angles(leg.end));
  const std::size_t normal =
      3 - space_index(letters(leg.arc->plane).first) - space_index(letters(leg.arc->plane).second);
  bool turned_about_normal = false;
  const auto look_at = [&](const Turn& axis, Angle Pose::* position) {
    const Angle& start = tip_->pose.*position;
    if (end.*position == start && start == frozen_.*position) return;
    Vector normal_vector;
    component(normal_vector, normal) = 1;
    if (!is_zero(cross(axis.line, normal_vector)))
      raise(recorder_, Clause::fanuc_tool_center_point_arc_in_workpiece_system, "PS5421",
            "an arc in the workpiece coordinate system while a table axis not normal to its plane is turned");
    turned_about_normal = true;
  };
  if (machine_->type() == MachineType::table) look_at(machine_->tool_side(), &Pose::tool);
  look_at(machine_->work_side(), &Pose::work);
  if (turned_about_normal)
    raise(recorder_, Clause::fanuc_tool_center_point_arc_with_table_turned, "ARC_WITH_TABLE_TURNED",
          "an arc in the workpiece coordinate system while the table is turned");
}

void ToolCenterPointControl::keep_tip_on_table(bool tip_alone, const Position& from, const Pose& end, Leg& leg) {
  if (!tip_alone) {
    recorder_.reach(Clause::fanuc_tool_center_point_workpiece_system_end);
    standing_.reset();
    return;
  }
  if (same(end, tip_->pose)) return;
  recorder_.reach(Clause::fanuc_tool_center_point_tip_alone_in_workpiece_system);
  // The tip stands where a shift left by G45 to G48 has it.
  const Vector shift = shift_of(leg, axes_);
  if (!standing_) standing_ = tip_->frame->frame.of_workpiece(in_space(from, axes_) + shift, tip_->pose);
  const Vector now = tip_->frame->frame.in_workpiece(*standing_, end) - shift;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (const char letter = axes_.letter(i); is_space_axis(letter))
      leg.end.at(i) = Coordinate(component(now, space_index(letter)));
}

}  // namespace toolcomp::model

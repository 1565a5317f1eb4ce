// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_center_point_control/tool_center_point_control.h"

#include <memory>
#include <utility>

#include "model/basis/alarm.h"
#include "model/fanuc/tool_posture_control/motions.h"
#include "model/geometry/plane.h"
#include "model/kinematics/mechanism.h"

namespace toolcomp::model {
namespace {

Direction direction_words(const Command& command, const Numbers& numbers) {
  const auto word = [&](char letter) {
    const spec::Decimal* const given = command.words.find(letter);
    return given == nullptr ? Rational(0) : numbers.length(*given);
  };
  return Direction::of({word('I'), word('J'), word('K')});
}

// X Y Z of a position.
Vector place_of(const Position& position, const spec::Axes& axes) {
  return in_space(axes, [&](std::size_t axis) { return position.at(axis).value(); });
}

// The shift of G45 to G48 in X Y Z.
Vector shift_of(const Leg& leg, const spec::Axes& axes) {
  if (!leg.shift) return {};
  return in_space(axes, [&](std::size_t axis) { return leg.shift->at(axis); });
}

// Known to be one pose.
bool same(const Pose& a, const Pose& b) {
  return known_difference(a.tool, b.tool) == Rational(0) && known_difference(a.work, b.work) == Rational(0);
}

Clause control_point_clause(MachineType type) {
  switch (type) {
    case MachineType::table:
      // fanuc.tool-center-point.control-point-table-rotation: On machines of type 12 the first axis goes through A
      // (19700 to 19702, in machine coordinates). The second axis goes through A + d (d: 19703 to 19705) when the first
      // axis is at 0.
      return Clause::fanuc_tool_center_point_control_point_table_rotation;
    case MachineType::mixed:
      // fanuc.tool-center-point.control-point-mixed: On machines of type 21 the table axis goes through A (19700 to
      // 19702), and the control point is E. E is found from the tip along the tool by L, and then by 19709 to 19711,
      // turned with the tool axis.
      return Clause::fanuc_tool_center_point_control_point_mixed;
    default:
      // fanuc.tool-center-point.control-point-tool-rotation: On machines of type 2 the control point is F, three steps
      // from the tip. The first goes along the tool by L to D. The second goes by 19709 to 19711 (given with both axes
      // at 0) to E on the second axis. The third goes by 19712 to 19714 to F on the first axis.
      return Clause::fanuc_tool_center_point_control_point_tool_rotation;
  }
}

}  // namespace

ToolCenterPointControl::ToolCenterPointControl(const spec::Setup& setup, Recorder& recorder, Interpreter& interpreter,
                                               bool with_motion)
    : recorder_(recorder),
      interpreter_(interpreter),
      axes_(setup.axes),
      by_machine_(setup.rotary_angles == spec::RotaryAngles::machine),
      cancel_moves_(setup.tip_control_cancel == spec::TipControlCancel::moves),
      kinematics_(setup),
      holder_offset_(parameter(setup, 19666)),
      posture_by_default_(setup.bit(19604, 0)),
      with_motion_(with_motion) {
  if (parameter(setup, 19680) != 0) {
    machine_.emplace(setup);
    choice_.emplace(setup, *machine_, recorder);
    posture_.emplace(setup, *machine_, *choice_, recorder);
  }
  tool_ = of_pose(interpreter.position());
}

Position ToolCenterPointControl::angles(const Position& position) const {
  Position result = position;
  for (std::size_t i = 0; by_machine_ && i < axes_.size(); ++i)
    if (kinematics_.turns(i)) result.at(i) = result.at(i) + interpreter_.work().zero(i);
  return result;
}

void ToolCenterPointControl::decide_angles() const {
  bool displaced = false;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (!kinematics_.turns(i)) continue;
    const Angle zero = interpreter_.work().zero(i).angle();
    displaced = displaced || !zero.is_rational() || !zero.rational().is_zero();
  }
  // fanuc.tool-direction.rotary-angles: The angles of the rotary axes that turn tool and table are machine coordinates:
  // programmed position plus workpiece zero and G92 shift of the axis. A change of coordinates moves nothing and
  // changes no direction.
  if (displaced) recorder_.decide(Clause::fanuc_tool_direction_rotary_angles, by_machine_);
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
  // fanuc.tool-direction.of-pose: The tool direction VT points from the tip to the holder and follows the positions of
  // the rotary axes at the end of the block. If a setup has no rotary axes that turn the tool, VT is (0, 0, 1), and its
  // events carry no tool axis.
  recorder_.decide(Clause::fanuc_tool_direction_of_pose, kinematics_.present());
  // fanuc.tool-direction.table-stands: On 30i machines with table axes, outside tool center point control, compensation
  // is programmed in the workpiece system, which stands while the table turns. VT is then the direction of the tool in
  // the machine.
  if (kinematics_.has_table()) recorder_.decide(Clause::fanuc_tool_direction_table_stands, kinematics_.table_stands());
  decide_angles();
  follow(end);
  return standing();
}

void ToolCenterPointControl::follow(const Position& position) {
  tip_.reset();
  tool_ = of_pose(position);
}

// fanuc.tool-center-point.end: G49 ends tool center point control without a move and without an event. The programmed X
// Y Z become those of the axes, without a shift left by G45 to G48, which stays. The rotary positions stay. G54 to G59
// in the same block count after that. Axis words of the block move from there.
// fanuc.tool-center-point.end-moves: With the setup key tip_control_cancel = moves, the G49 that ends tool center point
// control takes the offset back. The programmed X Y Z stay those of the tip, seen in the workpiece system if a table
// has turned it. The block makes one move, even without an axis word, in which the linear axes go to the programmed
// position without the vector from tip to control point.
// fanuc.tool-center-point.again: G43.4 or G43.5 under tool center point control, the same code or the other one, ends
// the control and starts it anew. Before the words of the block count, the tip stays where it is. The programmed X Y Z
// become its coordinates in the workpiece system at the present pose, without a shift left by G45 to G48, which stays.
// The direction kept is that of the rotary positions (without kinematics the direction in force). P, Q and the frame
// are those of the new block, and so is H if the block gives it.
void ToolCenterPointControl::rename_position(const TipMarks& marks, const Leg& standing) {
  if (!tip_) return;
  const bool on_table = kinematics_.has_table();
  const Vector shift = shift_of(standing, axes_);
  const Vector tip = place_of(standing.end, axes_) + shift;
  const bool stays = marks.ends && !recorder_.decide(Clause::fanuc_tool_center_point_end_moves, marks.takes_back);
  if (stays) {
    recorder_.reach(Clause::fanuc_tool_center_point_end);
    if (on_table)
      interpreter_.stand_in_space(control_point(*tip_, {tip, tool_.unit}) - shift);
    else
      interpreter_.shift_position(control_point(*tip_, {Vector(), tool_.unit}));
    return;
  }
  if (marks.again) recorder_.reach(Clause::fanuc_tool_center_point_again);
  if (on_table && !tip_->in_workpiece)
    interpreter_.stand_in_space(tip_->frame->frame.in_workpiece(tip, tip_->pose) - shift);
}

// fanuc.tool-center-point.length: The length L along the tool is the offset of the H number plus the tool holder offset
// 19666. H and edited values follow the rules of G43, except that no G43 or G44 adds or subtracts the offset. A change
// comes into force in the same blocks as under G43. In a block in which L changes, it goes evenly with the path from
// the old value to the new one.
TurnedBlock ToolCenterPointControl::turn(const Command& command, const TipMarks& marks, const Rational& offset,
                                         Leg& leg) {
  recorder_.reach(Clause::fanuc_tool_center_point_length);
  if (machine_) recorder_.reach(control_point_clause(machine_->type()));
  if (marks.starts) {
    start(command, marks, leg);
    tip_->length = offset + holder_offset_;
    return {standing(), {}};
  }
  const Rational before = std::exchange(tip_->length, offset + holder_offset_);
  TurnedBlock result = machine_ ? turn_axes(command, marks, leg) : turn_directly(command, leg);
  result.motion->length_before = before;
  return result;
}

// fanuc.tool-center-point.block: The block of G43.4 or G43.5 itself is not yet run under tool center point control.
// Each of its axes goes to its end by itself, and the tool length is applied there. The block always makes one move,
// even if nothing moves.
// fanuc.tool-center-point.frozen-pose: The table system is the copy of the workpiece system at the pose at which the
// block of G43.4 or G43.5 ends. The rotary axes that move in that block have then moved. Even if the table is turned by
// then, the table system is parallel to the machine.
void ToolCenterPointControl::start(const Command& command, const TipMarks& marks, Leg& leg) {
  recorder_.reach(Clause::fanuc_tool_center_point_block);
  standing_.reset();
  last_lean_.reset();
  const bool direction =
      marks.directed && recorder_.decide(Clause::fanuc_tool_center_point_direction_words, command.direction);
  if (direction) now_ = direction_words(command, interpreter_.numbers());
  tip_.emplace();
  if (!machine_) {
    // There are no rotary positions to take it from again.
    if (!direction && !marks.again) now_ = of_pose(leg.end);
    now_.reported = true;
    tool_ = kept_ = now_;
    return;
  }
  decide_angles();
  Pose frozen = machine_->pose(angles(leg.end));
  // Only heads have a direction here: their frame does not turn.
  if (direction) frozen = choice_->choose(now_, frozen).pose;
  const Vector origin = in_space(axes_, [this](std::size_t axis) { return interpreter_.work().zero(axis).value(); });
  // No block of the mode changes the coordinates.
  tip_->frame = std::make_shared<const ControlFrame>(*machine_, frozen, origin, machine_->pose(angles(Position())));
  tip_->frame->place(frozen, leg.end);
  tip_->in_workpiece = machine_->programs_workpiece() && kinematics_.has_table();
  tip_->pose = frozen;
  if (!direction) now_ = Direction::of_unit(tip_->frame->frame.direction(frozen));
  kept_ = now_;
  tool_ = tip_->in_workpiece ? Direction::of_unit(reported_tool(*tip_)) : now_;
}

// fanuc.tool-center-point.direction-words: Under G43.5 I J K are the direction from tip to holder in the programming
// system, of any length. If only some of them are given, the missing ones are 0. Without I J K the direction last
// commanded is kept, without its lean. After a block whose end posture was changed, the actual direction is kept. From
// a block of G43.5 without I J K on, the direction of the rotary positions is kept. In a block without I J K the rotary
// axes stand still, whatever the range, if Q is 0 or the tip has no travel. I J K alone make a move.
std::optional<Direction> ToolCenterPointControl::direction_asked(const Command& command, const Leg& leg) {
  const bool given = recorder_.decide(Clause::fanuc_tool_center_point_direction_words, command.direction);
  const bool may_lean = lean_ != 0 && (given || !is_zero(leg.travel));
  if (given) kept_ = direction_words(command, interpreter_.numbers());
  if (may_lean) {
    Lean now{kept_.vector, lean_travel(leg), leaned(kept_, leg)};
    // The same lean again is known to be the same direction.
    if (last_lean_ && known_same(last_lean_->tool, now.tool) && known_same(last_lean_->travel, now.travel))
      now.to = last_lean_->to;
    last_lean_ = now;
    return now.to;
  }
  return given ? std::optional(kept_) : std::nullopt;
}

// fanuc.tool-center-point.without-kinematics: With 19680 = 0 G43.4 raises PS5459. G43.5 then takes I J K, leaned by Q
// as on any machine, for the direction itself. Nothing is turned, reached or chosen, no posture is singular, WKP does
// not count, and P makes no difference. Inside a block the direction goes evenly along the great circle. Between
// opposite directions there is no great circle, and the direction stays the first one until the end.
TurnedBlock ToolCenterPointControl::turn_directly(const Command& command, const Leg& leg) {
  OwnMotion own;
  Direction to = direction_asked(command, leg).value_or(now_);
  if (with_motion_) own.motion = direction_motion(now_, to);
  tool_ = now_ = std::move(to);
  return {standing(), std::move(own)};
}

// fanuc.tool-center-point.tip-alone: In a block without X Y Z, with rotary axes or I J K only, the tip stays where it
// is on the table while the axes move.
// fanuc.tool-center-point.arc: The tip runs arcs and helices of the selected plane in the programming system, on a
// table machine relative to the table. The rotary axes or the direction change as in a straight block.
TurnedBlock ToolCenterPointControl::turn_axes(const Command& command, const TipMarks& marks, Leg& leg) {
  const bool tip_alone = !has_axis_word(command, is_space_axis);
  if (tip_alone && (has_axis_word(command, spec::is_rotary_axis) || (marks.directed && command.direction)))
    recorder_.reach(Clause::fanuc_tool_center_point_tip_alone);
  if (leg.arc) recorder_.reach(Clause::fanuc_tool_center_point_arc);
  if (leg.arc && tip_->in_workpiece) require_table_still(leg.arc->plane, machine_->pose(angles(leg.end)));
  PosturePlan found = marks.directed ? directed(command, leg) : commanded(leg);
  const Pose end = found.post_turn.value_or(found.end);
  if (tip_->in_workpiece) keep_tip_on_table(tip_alone, end, leg);
  tip_->frame->place(end, leg.end);

  now_ = found.tool;
  tip_->pose = found.end;
  tool_ = tip_->in_workpiece ? Direction::of_unit(reported_tool(*tip_)) : now_;
  TurnedBlock result{standing(), std::move(found)};
  // The end is given as it is when all has turned.
  if (result.motion->post_turn) result.end.tip->named_at = end;
  tip_->pose = end;
  return result;
}

PosturePlan ToolCenterPointControl::commanded(const Leg& leg) const {
  const Pose end = machine_->pose(angles(leg.end));
  if (same(end, tip_->pose)) return even_plan(tip_->frame, tip_->pose, tip_->pose, now_);
  return plan({tip_->pose, now_, Direction::of_unit(tip_->frame->frame.direction(end)), end, {}});
}

PosturePlan ToolCenterPointControl::directed(const Command& command, const Leg& leg) {
  const std::optional<Direction> to = direction_asked(command, leg);
  if (!to) return even_plan(tip_->frame, tip_->pose, tip_->pose, now_);
  PostureBlock block{tip_->pose, now_, *to, {}, {}};
  if (lean_ != 0 && known_same(kept_.vector, now_.vector)) block.leaned_toward = lean_travel(leg);
  PosturePlan found = plan(block);
  if (found.changed) kept_ = found.tool;
  return found;
}

PosturePlan ToolCenterPointControl::plan(const PostureBlock& block) const {
  return with_posture_ ? posture_->plan(tip_->frame, block) : posture_->conventional(tip_->frame, block);
}

// fanuc.tool-center-point.workpiece-system-end: With WKP = 1 an end point is programmed as it will be after the table
// has turned. The tip still runs straight relative to the table. Axes without a word keep their coordinate in the
// workpiece system.
// fanuc.tool-center-point.tip-alone-in-workpiece-system: With WKP = 1 too the tip stays on the table in a block without
// X Y Z. The programmed X Y Z become those of the place where the tip then is. A block with one of X Y Z is no such
// block.
void ToolCenterPointControl::keep_tip_on_table(bool tip_alone, const Pose& end, Leg& leg) {
  if (!tip_alone) {
    recorder_.reach(Clause::fanuc_tool_center_point_workpiece_system_end);
    standing_.reset();
    return;
  }
  if (same(end, tip_->pose)) return;
  recorder_.reach(Clause::fanuc_tool_center_point_tip_alone_in_workpiece_system);
  // The tip stands where a shift left by G45 to G48 has it.
  const Vector shift = shift_of(leg, axes_);
  if (!standing_)
    standing_ = tip_->frame->frame.of_workpiece(place_of(interpreter_.position(), axes_) + shift, tip_->pose);
  const Vector now = tip_->frame->frame.in_workpiece(*standing_, end) - shift;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (const char letter = axes_.letter(i); is_space_axis(letter))
      leg.end.at(i) = Coordinate(component(now, space_index(letter)));
}

}  // namespace toolcomp::model

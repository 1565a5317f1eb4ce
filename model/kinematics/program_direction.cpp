#include "model/kinematics/program_direction.h"

#include "model/program/alarm.h"

namespace toolcomp::model {
namespace {

Rational direction_word(const Command& command, char letter, const Numbers& numbers) {
  const spec::Decimal* const word = command.words.find(letter);
  return word == nullptr ? Rational(0) : numbers.length(*word);
}

Vector direction_words(const Command& command, const Numbers& numbers) {
  return {direction_word(command, 'I', numbers), direction_word(command, 'J', numbers),
          direction_word(command, 'K', numbers)};
}

bool leaves_the_path(OneShot code) { return code != OneShot::none && code != OneShot::dwell && code != OneShot::data; }

}  // namespace

bool ProgramDirection::has_rotary_word(const Command& command) const {
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if ((command.axes >> i & 1U) != 0 && spec::is_rotary_axis(axes_.letter(i))) return true;
  return false;
}

ProgramDirection::Marks ProgramDirection::read(const Command& command, const ToolLengthOffset& length,
                                               const Compensated& compensated, const Numbers& numbers) {
  const std::optional<LengthCode>& code = command.codes.length;
  Marks marks;
  marks.starts = code == LengthCode::tool_direction;
  marks.ends = length.tip_control() && code == LengthCode::cancel;
  marks.tip_control = marks.starts || (length.tip_control() && !marks.ends);
  if (marks.tip_control || marks.ends) restrict(command, length, compensated, marks, numbers);
  return marks;
}

void ProgramDirection::restrict(const Command& command, const ToolLengthOffset& length, const Compensated& compensated,
                                const Marks& marks, const Numbers& numbers) {
  const Codes& codes = command.codes;
  const bool cutter = codes.compensation && is_cutter_side(*codes.compensation);
  if (marks.tip_control && (leaves_the_path(codes.one_shot) || codes.workpiece || cutter))
    raise(recorder_, Clause::fanuc_tool_direction_forbidden, "FORBIDDEN_UNDER_TOOL_DIRECTION",
          "a command that is not allowed while G43.5 is in force");
  const bool axis_offset_code = codes.length == LengthCode::plus || codes.length == LengthCode::minus;
  if (axis_offset_code || (marks.starts && length.axis_offset()))
    raise(recorder_, Clause::fanuc_tool_direction_exclusion, "LENGTH_OFFSET_EXCLUSION",
          "G43 or G44 together with G43.5; G49 must stand between");
  if (marks.starts && !kinematics_.tip_control_built())
    raise(recorder_, Clause::fanuc_tool_direction_kinematics, "KINEMATICS_NOT_BUILT",
          "G43.5 on a machine with table axes or head offsets");
  if (marks.tip_control && command.words.has('Q') && (marks.starts || !compensated.side_after))
    raise(recorder_, Clause::fanuc_tool_direction_lean, "LEAN_ANGLE_NOT_BUILT", "a lean angle Q under G43.5");
  const bool side = compensated.side_before || compensated.side_after;
  const bool in_compensation = (compensated.edge || side) && (marks.starts || marks.ends);
  const bool in_arc = command.is_arc_motion() && (marks.starts || (marks.tip_control && command.direction));
  if (in_compensation || in_arc)
    raise(recorder_, Clause::fanuc_tool_direction_format, "TOOL_DIRECTION_FORMAT",
          "G43.5 or its end in a compensation in space, or a tool direction in G02 or G03");
  if (!marks.tip_control) return;
  if (has_rotary_word(command) && side)
    raise(recorder_, Clause::fanuc_tool_side_rotary_word, "PS5460",
          "a rotary axis word while tool side compensation is on under G43.5");
  if (has_rotary_word(command))
    raise(recorder_, Clause::fanuc_tool_direction_rotary_word, "PS5421", "a rotary axis word while G43.5 is in force");
  if (command.direction && is_zero(direction_words(command, numbers)))
    raise(recorder_, Clause::fanuc_tool_direction_zero, "PS5421", "a tool direction of which all of I J K are zero");
}

// Computed again only where an axis that turns the tool has moved.
const Direction& ProgramDirection::of_pose(const Position& position) {
  bool same = pose_.has_value();
  for (std::size_t i = 0; same && i < axes_.size(); ++i)
    if (kinematics_.turns(i)) same = position.at(i) == pose_->at(i);
  if (!same) {
    pose_direction_ = kinematics_.direction(position);
    pose_ = position;
  }
  return pose_direction_;
}

const Direction& ProgramDirection::at(const Command& command, const Marks& marks, const Position& end,
                                      const Numbers& numbers) {
  if (!marks.tip_control) {
    recorder_.decide(Clause::fanuc_tool_direction_of_pose, kinematics_.present());
    direction_ = of_pose(end);
  } else if (recorder_.decide(Clause::fanuc_tool_direction_words, command.direction)) {
    direction_ = Direction::of(direction_words(command, numbers));
  } else {
    // Without words the direction stays: at the start that of the rotary axes.
    direction_.reported = true;
  }
  return direction_;
}

}  // namespace toolcomp::model

// What the words of a block mean to tool center point control, and what they must not say.
#include "model/basis/alarm.h"
#include "model/basis/number.h"
#include "model/fanuc/tool_center_point_control/tool_center_point_control.h"
#include "model/geometry/plane.h"

namespace toolcomp::model {
namespace {

bool leaves_the_path(OneShot code) { return code != OneShot::none && !takes_letters_as_data(code); }

// A word that is no data of G04 or G10.
const spec::Decimal* word(const Command& command, char letter) {
  return takes_letters_as_data(command.codes.one_shot) ? nullptr : command.words.find(letter);
}

bool is_zero_word(const Command& command, char letter) {
  const spec::Decimal* const value = command.words.find(letter);
  return value == nullptr || value->digits == 0;
}

}  // namespace

bool ToolCenterPointControl::has_axis_word(const Command& command, bool (*is_of)(char)) const {
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if ((command.axes >> i & 1U) != 0 && is_of(axes_.letter(i))) return true;
  return false;
}

TipMarks ToolCenterPointControl::read(const Command& command, const ToolLengthOffset& length, const Pipeline& stages) {
  const std::optional<LengthCode>& code = command.codes.length;
  TipMarks marks;
  marks.starts = code && is_tip_control(*code);
  marks.again = marks.starts && length.tip_control();
  marks.ends = length.tip_control() && code == LengthCode::cancel;
  marks.tip_control = marks.starts || (length.tip_control() && !marks.ends);
  marks.directed = marks.tip_control && (marks.starts ? code == LengthCode::tool_direction : length.directed());
  if (!marks.tip_control && !marks.ends) return marks;
  restrict_mode(command, length, marks);
  if (marks.starts) restrict_start(command, marks);
  restrict_compensation(command, marks, stages);
  if (!marks.tip_control) return marks;
  if (marks.directed) restrict_words(command, marks, stages);
  restrict_arc(command, marks);
  if (marks.starts) {
    const spec::Decimal* const lean = marks.directed ? word(command, 'Q') : nullptr;
    lean_ = lean == nullptr ? Rational(0) : plain(*lean);
  }
  return marks;
}

void ToolCenterPointControl::restrict_mode(const Command& command, const ToolLengthOffset& length,
                                           const TipMarks& marks) const {
  const Codes& codes = command.codes;
  const bool cutter = codes.compensation && is_cutter_side(*codes.compensation);
  if (marks.tip_control && (leaves_the_path(codes.one_shot) || codes.workpiece || cutter))
    raise(recorder_, Clause::fanuc_tool_center_point_forbidden, "FORBIDDEN_UNDER_TOOL_DIRECTION",
          "a command that is not allowed while G43.4 or G43.5 is in force");
  const bool axis_offset_code = codes.length == LengthCode::plus || codes.length == LengthCode::minus;
  if (axis_offset_code || (marks.starts && length.axis_offset()))
    raise(recorder_, Clause::fanuc_tool_center_point_exclusion, "LENGTH_OFFSET_EXCLUSION",
          "G43 or G44 together with G43.4 or G43.5; G49 must stand between");
}

void ToolCenterPointControl::restrict_start(const Command& command, const TipMarks& marks) {
  const bool without = recorder_.decide(Clause::fanuc_tool_center_point_without_kinematics, !machine_);
  if (without && !marks.directed) throw Alarm("PS5459", "G43.4 on a machine without kinematics (19680 = 0)");
  if (!without &&
      recorder_.decide(Clause::fanuc_tool_center_point_programming_system, machine_->programs_workpiece()) &&
      marks.directed)
    raise(recorder_, Clause::fanuc_tool_center_point_type_2_in_workpiece_system, "PS5459",
          "G43.5 in the workpiece coordinate system (19696#5 = 1)");
  read_posture_word(command);
  if (without) return;
  if (marks.directed || with_posture_) {
    const bool inverse = posture_->is_possible();
    if (recorder_.decide(Clause::fanuc_tool_center_point_not_invertible, !inverse) && marks.directed)
      throw Alarm("PS5459", "G43.5 on a machine whose axes do not turn the tool to every direction about them");
    with_posture_ = with_posture_ && inverse;
  }
  if (marks.directed) choice_->require_ranges();
}

void ToolCenterPointControl::read_posture_word(const Command& command) {
  const spec::Decimal* const p = word(command, 'P');
  if (p == nullptr) {
    with_posture_ = recorder_.decide(Clause::fanuc_tool_posture_default, posture_by_default_);
    return;
  }
  const Rational value = plain(*p);
  if (value != 0 && value != 1)
    raise(recorder_, Clause::fanuc_tool_posture_word_value, "PS5421", "P of G43.4 or G43.5 other than 0 or 1");
  with_posture_ = recorder_.decide(Clause::fanuc_tool_posture_word, value == 1);
}

void ToolCenterPointControl::restrict_compensation(const Command& command, const TipMarks& marks,
                                                   const Pipeline& stages) const {
  const Pipeline::InForce in_space = stages.in_force(Extent::space, command);
  if ((in_space.any() && (marks.starts || marks.ends)) || (marks.starts && command.is_arc_motion()))
    raise(recorder_, Clause::fanuc_tool_center_point_format, "TOOL_DIRECTION_FORMAT",
          "G43.4, G43.5 or their end in a compensation in space, or G43.4 or G43.5 in G02 or G03");
  const bool on_table = machine_ && machine_->programs_workpiece() && machine_->type() != MachineType::head;
  if (marks.tip_control && on_table && in_space.after)
    raise(recorder_, Clause::fanuc_tool_center_point_compensation_in_workpiece_system,
          "COMPENSATION_IN_WORKPIECE_SYSTEM",
          "a compensation in space with a table axis in the workpiece coordinate system (19696#5 = 1)");
}

// Type 2.
void ToolCenterPointControl::restrict_words(const Command& command, const TipMarks& marks,
                                            const Pipeline& stages) const {
  if (has_axis_word(command, spec::is_rotary_axis)) {
    stages.refuse_rotary_word(command);
    raise(recorder_, Clause::fanuc_tool_center_point_rotary_word, "PS5421",
          "a rotary axis word while G43.5 is in force");
  }
  if (!command.direction) return;
  const bool on_table = machine_ && machine_->type() != MachineType::head;
  if (marks.starts && recorder_.decide(Clause::fanuc_tool_center_point_direction_at_start, on_table))
    throw Alarm("PS5421", "I J K in the block of G43.5 on a machine with a table axis");
  if (is_zero_word(command, 'I') && is_zero_word(command, 'J') && is_zero_word(command, 'K'))
    raise(recorder_, Clause::fanuc_tool_center_point_zero, "PS5421", "a tool direction of which all of I J K are zero");
}

void ToolCenterPointControl::restrict_arc(const Command& command, const TipMarks& marks) const {
  if (!command.is_arc_motion() || leaves_the_path(command.codes.one_shot)) return;
  const bool radius = word(command, 'R') != nullptr;
  const PlaneLetters in_plane = letters(command.plane);
  const auto named = [&](char letter) { return axes_.has(letter) && word(command, letter) != nullptr; };
  if (marks.directed && !radius && (named(in_plane.first) || named(in_plane.second)))
    raise(recorder_, Clause::fanuc_tool_center_point_arc_by_radius, "PS5421", "an arc under G43.5 without R");
  const bool turns = marks.directed ? command.direction
                                    : has_axis_word(command, spec::is_rotary_axis) && !command.direction && !radius;
  if (turns && !has_axis_word(command, spec::is_linear_axis))
    raise(recorder_, Clause::fanuc_tool_center_point_arc_rotary_only, "PS5421",
          "the tool turned alone under G02 or G03");
}

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
// What the words of a block mean to tool center point control, and what they must not say.
#include "model/basis/alarm.h"
#include "model/basis/number.h"
#include "model/fanuc/tool_center_point_control/tool_center_point_control.h"
#include "model/geometry/plane.h"

namespace toolcomp::model {
namespace {

bool leaves_the_path(OneShot code) { return code != OneShot::none && !is_dwell_or_data(code); }

// A word that is no data of a code.
const spec::Decimal* word(const Command& command, char letter) {
  return command.codes.letters_are_data ? nullptr : command.words.find(letter);
}

bool is_zero_word(const Command& command, char letter) {
  const spec::Decimal* const value = command.words.find(letter);
  return value == nullptr || value->digits == 0;
}

}  // namespace

bool ToolCenterPointControl::has_axis_word(const Command& command, bool (*is_of)(char)) const {
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (command.names(i) && is_of(axes_.letter(i))) return true;
  return false;
}

TipMarks ToolCenterPointControl::read(const Command& command, const ToolLengthOffset& length, const Passes& passes) {
  const std::optional<LengthCode>& code = command.codes.length;
  TipMarks marks;
  marks.starts = code && is_tip_control(*code);
  marks.again = marks.starts && length.tip_control();
  marks.ends = length.tip_control() && code == LengthCode::cancel;
  marks.takes_back = marks.ends && cancel_moves_;
  marks.tip_control = marks.starts || (length.tip_control() && !marks.ends);
  marks.directed = marks.tip_control && (marks.starts ? code == LengthCode::tool_direction : length.directed());
  if (!marks.tip_control && !marks.ends) return marks;
  restrict_mode(command, length, marks);
  if (marks.starts) restrict_start(command, marks);
  restrict_compensation(command, marks, passes);
  if (!marks.tip_control) return marks;
  if (marks.directed) restrict_words(command, marks, passes);
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
  // fanuc.tool-center-point.forbidden: G28 G29 G30 G30.1 G37 G39 G41 G42 G45 to G48 G52 G53 G54 to G59 G54.1 G92 and
  // G10 L2 L20 raise FORBIDDEN_UNDER_TOOL_DIRECTION in a block under G43.4 or G43.5, the block of the code included. So
  // does a block in the drilling mode there (fanuc.canned-cycle.mode).
  if (marks.tip_control &&
      (command.cycle.on || leaves_the_path(codes.one_shot) || codes.workpiece || codes.writes_origin || cutter))
    raise(recorder_, Clause::fanuc_tool_center_point_forbidden, AlarmCause::forbidden_under_tool_direction);
  const bool axis_offset_code = codes.length == LengthCode::plus || codes.length == LengthCode::minus;
  // fanuc.tool-center-point.exclusion: G43 or G44 under tool center point control, and G43.4 or G43.5 while an axis has
  // a length offset that is not zero, raise LENGTH_OFFSET_EXCLUSION. G49 must come between them.
  if (axis_offset_code || (marks.starts && length.axis_offset()))
    raise(recorder_, Clause::fanuc_tool_center_point_exclusion, AlarmCause::length_offset_exclusion);
}

void ToolCenterPointControl::restrict_start(const Command& command, const TipMarks& marks) {
  // fanuc.tool-center-point.without-kinematics: With 19680 = 0 G43.4 raises PS5459.
  const bool without = recorder_.decide(Clause::fanuc_tool_center_point_without_kinematics, !machine_);
  if (without && !marks.directed) throw Alarm(AlarmCause::tip_control_parameters);
  // fanuc.tool-center-point.programming-system: WKP (19696#5) chooses the programming system. WKP = 0 programs in the
  // table coordinate system, a copy of the workpiece system that is fixed to the table and turns with the table, not
  // with a head. WKP = 1 programs in the workpiece system, which does not turn. Events give the programmed end, the
  // point and the tool axis in the programming system. Asked in the block of the code.
  // fanuc.tool-center-point.type-2-in-workpiece-system: G43.5 with WKP = 1 raises PS5459, on every type of machine.
  if (!without &&
      recorder_.decide(Clause::fanuc_tool_center_point_programming_system, machine_->programs_workpiece()) &&
      marks.directed)
    raise(recorder_, Clause::fanuc_tool_center_point_type_2_in_workpiece_system, AlarmCause::tip_control_parameters);
  read_posture_word(command);
  if (without) return;
  if (marks.directed || with_posture_) {
    const bool inverse = machine_->is_invertible();
    // fanuc.tool-center-point.not-invertible: If an axis is hypothetical, or u_t is parallel to t0 or to u_w,
    // directions cannot be reached by turning the two axes. G43.5 then raises PS5459. G43.4 with posture control then
    // runs every block under conventional control, without a warning. Asked in the block of G43.5, and in that of G43.4
    // with posture control, on a machine with 19680 other than 0.
    if (recorder_.decide(Clause::fanuc_tool_center_point_not_invertible, !inverse) && marks.directed)
      throw Alarm(AlarmCause::tip_control_parameters);
    with_posture_ = with_posture_ && inverse;
  }
  if (marks.directed) choice_->require_ranges();
}

void ToolCenterPointControl::read_posture_word(const Command& command) {
  const spec::Decimal* const p = word(command, 'P');
  if (p == nullptr) {
    // fanuc.tool-posture.default: Without P in the block of G43.4 or G43.5 TPC (19604#0) decides: 1 posture control, 0
    // conventional control.
    with_posture_ = recorder_.decide(Clause::fanuc_tool_posture_default, posture_by_default_);
    return;
  }
  const Rational value = plain(*p);
  // fanuc.tool-posture.word-value: A P other than 0 or 1 in the block of G43.4 or G43.5 raises PS5421.
  if (value != 0 && value != 1) raise(recorder_, Clause::fanuc_tool_posture_word_value, AlarmCause::tip_control_word);
  // fanuc.tool-posture.word: P of the block of G43.4 or G43.5 chooses the interpolation until G49: P1 posture control,
  // P0 conventional control.
  with_posture_ = recorder_.decide(Clause::fanuc_tool_posture_word, value == 1);
}

void ToolCenterPointControl::restrict_compensation(const Command& command, const TipMarks& marks,
                                                   const Passes& passes) const {
  const Passes::InForce in_space = passes.in_force(Extent::space, command);
  // fanuc.tool-center-point.format: TOOL_DIRECTION_FORMAT is raised by G43.4 or G43.5, and by the G49 that ends it, in
  // the leading edge offset or in the block that starts it, or if tool side compensation is on before or after the
  // block. G43.4 or G43.5 in a block under G02 or G03 raises it too.
  if ((in_space.any() && (marks.starts || marks.ends)) || (marks.starts && command.is_arc_motion()))
    raise(recorder_, Clause::fanuc_tool_center_point_format, AlarmCause::tool_direction_format);
  const bool on_table = kinematics_.has_table() && machine_->programs_workpiece();
  // fanuc.tool-center-point.compensation-in-workpiece-system: With WKP = 1 on a machine with a table axis (19680 = 12,
  // 21), a block under G43.4 after which tool side compensation or the leading edge offset is on raises
  // COMPENSATION_IN_WORKPIECE_SYSTEM, a name of ours. 19746 bit 4 is about compensation outside tool center point
  // control (fanuc.tool-direction.table-stands). Whether it is set or not, the block is refused.
  if (marks.tip_control && on_table && in_space.after)
    raise(recorder_, Clause::fanuc_tool_center_point_compensation_in_workpiece_system,
          AlarmCause::compensation_in_workpiece_system);
}

void ToolCenterPointControl::restrict_words(const Command& command, const TipMarks& marks, const Passes& passes) const {
  if (has_axis_word(command, spec::is_rotary_axis)) {
    passes.refuse_rotary_word(command);
    // fanuc.tool-center-point.rotary-word: A rotary axis word in a block under G43.5, the block of the code included,
    // raises PS5421 (with tool side compensation PS5460, fanuc.tool-side.rotary-word).
    raise(recorder_, Clause::fanuc_tool_center_point_rotary_word, AlarmCause::tool_direction);
  }
  if (!command.direction) return;
  // fanuc.tool-center-point.direction-at-start: I J K in the block of G43.5 turn a tool rotation machine (type 2) in
  // that block, to the pair chosen by fanuc.tool-center-point.choice. P0 and P1 are alike there, and there is no lean.
  // On a machine with a table axis (types 12, 21) they raise PS5421.
  if (marks.starts && recorder_.decide(Clause::fanuc_tool_center_point_direction_at_start, kinematics_.has_table()))
    throw Alarm(AlarmCause::direction_at_start);
  // fanuc.tool-center-point.zero: I J K that are all zero under G43.5 raise PS5421.
  if (is_zero_word(command, 'I') && is_zero_word(command, 'J') && is_zero_word(command, 'K'))
    raise(recorder_, Clause::fanuc_tool_center_point_zero, AlarmCause::tool_direction);
}

void ToolCenterPointControl::restrict_arc(const Command& command, const TipMarks& marks) const {
  if (!command.is_arc_motion()) return;
  const bool radius = word(command, 'R') != nullptr;
  const PlaneLetters in_plane = letters(command.plane);
  const bool in_plane_named = command.names(axes_, in_plane.first) || command.names(axes_, in_plane.second);
  // fanuc.tool-center-point.arc-by-radius: Under G43.5 the centre of an arc is given by R alone, because I J K are the
  // direction. An axis word of the plane without R under G02 or G03 raises PS5421 (the number is ours). A full circle
  // cannot be given: R with an end that is the start is an arc of 0 degrees (fanuc.program.arc-radius-without-chord).
  if (marks.directed && !radius && in_plane_named)
    raise(recorder_, Clause::fanuc_tool_center_point_arc_by_radius, AlarmCause::tip_control_arc);
  const bool turns = marks.directed ? command.direction
                                    : has_axis_word(command, spec::is_rotary_axis) && !command.direction && !radius;
  // fanuc.tool-center-point.arc-rotary-only: A block under G02 or G03 that would only turn the tool raises PS5421.
  // Under G43.4 this is a block with a rotary axis word, without a linear axis word and without I J K R. Under G43.5 it
  // is a block with I J K without a linear axis word. The manual allows such a block in G00 and G01 only. The number is
  // ours.
  if (turns && !has_axis_word(command, spec::is_linear_axis))
    raise(recorder_, Clause::fanuc_tool_center_point_arc_rotary_only, AlarmCause::tip_control_arc);
}

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_side_compensation/tool_side_stage.h"

#include "fast/fanuc/control/xyz_travel.h"

namespace toolcomp::fast {
namespace {

constexpr std::uint32_t kDirectionLetters = Words::set_of("IJK");
constexpr std::uint32_t kAuxiliaryLetters = Words::set_of("MST");

CutterSide side_of(Code code) {
  switch (code) {
    case kNone:
      return CutterSide::unchanged;
    case kG41_2:
    case kG41_6:
      return CutterSide::left;
    case kG42_2:
    case kG42_6:
      return CutterSide::right;
    default:
      return CutterSide::off;  // of the same group
  }
}

bool is_own(Code code) { return code == kG41_2 || code == kG41_6 || code == kG42_2 || code == kG42_6; }

}  // namespace

void ToolSideStage::release() {
  if (!compensation_.active()) return;
  if (const StageEnd held = compensation_.release()) control_.end(held);
}

void ToolSideStage::read(const Words& words, const Command& /*command*/) {
  const Code code = words.code(Words::kCompensation);
  const CutterSide side = side_of(code) == CutterSide::unchanged ? word_ : side_of(code);
  const bool before = is_on();
  const bool after = side != CutterSide::off && control_.cutter_value.number_after(words).number != 0;
  set_read(before || after || is_own(code), before, after);
}

bool ToolSideStage::names_arc(const Words& words, Code motion, spec::Plane plane) const {
  if (motion <= kG01) return false;
  Mask in_plane = 0;
  for (const std::size_t axis : control_.modal.axes_of(plane))
    if (axis != spec::Axes::kNone) in_plane = static_cast<Mask>(in_plane | bit(axis));
  return (words.axes() & in_plane) != 0 || words.has('R') || words.has_any(kDirectionLetters);
}

// The alarms that words and state alone show (clause fanuc.program.alarm-order).
Alarm ToolSideStage::check(const Words& words, const Command& command) const {
  const Code code = words.code(Words::kCompensation);
  const Code plane = words.code(Words::kPlane);
  const spec::Plane selected = plane == kNone ? control_.modal.plane() : plane_of(plane);
  const bool before = on_before();
  const bool after = on_after();
  if (is_own(code) && (code == kG41_2 || code == kG42_2) == command.vector) return AlarmCause::side_mode;
  if (before && selected != control_.modal.plane()) return AlarmCause::plane_change;

  const bool moves = words.axes() != 0 || (command.vector && words.has_any(kDirectionLetters));
  const bool arc = words.code(Words::kOneShot) == kNone && names_arc(words, command.motion, selected);
  if (after && (words.code(Words::kWorkpiece) != kNone || words.code(Words::kUnits) != kNone ||
                words.refused_in_space() || ((moves || arc) && words.has_any(kAuxiliaryLetters))))
    return AlarmCause::forbidden_in_compensation;
  if ((before || after) && words.code(Words::kOneShot) != kNone) return AlarmCause::forbidden_in_compensation;
  if (before && (code == kG41 || code == kG42 || code == kG41_3)) return AlarmCause::forbidden_in_compensation;
  if (after && words.has('Q') && (whole_number(words['Q'], 3) > 3 || words['Q'].is_zero()))
    return AlarmCause::treatment;

  if (compensation_.type() == StartType::c) {
    const bool starts = after && !before;
    if ((starts || (before && !after)) && (moves || command.motion > kG01 || (starts && words.suppresses_look_ahead())))
      return AlarmCause::type_c_format;
  } else if (arc && after != compensation_.active()) {
    return AlarmCause::arc_at_start_or_cancel;
  }
  if (arc && after && refuses_arcs_) return AlarmCause::arc_in_compensation;

  // The value is read where the number is given, where a code comes into force, and after an edit.
  const CutterValue& value = control_.cutter_value;
  const bool reads = value.commanded(words) || (after && word_ == CutterSide::off) || value.takes_edited();
  if (after && reads && !control_.memory.fits(value.of(value.number_after(words)))) return AlarmCause::offset_value;
  return AlarmCause::none;
}

// The code of a block, and the value of its number.
Alarm ToolSideStage::take(const Words& words, Command& command) {
  const CutterSide word = side_of(words.code(Words::kCompensation));
  const CutterSide before = word_;
  CutterValue& value = control_.cutter_value;
  if (word != CutterSide::unchanged) word_ = word;
  compensation_.next().repeated = word == before && word != CutterSide::off;
  wanted_ = word_ != CutterSide::off && value.number().number != 0;
  set_on(is_on());
  set_takes_moves(on_before() || on_after());
  command.taken |= takes_moves();
  if (word_ == CutterSide::off) return AlarmCause::none;
  if (before == CutterSide::off || value.commanded(words) || value.takes_edited()) {
    value.take_value();
    compensation_.set_value(value.value() < Count() ? -value.value() : value.value());
  }
  sign_ = (word_ == CutterSide::right) == (value.value() < Count()) ? 1 : -1;
  return AlarmCause::none;
}

Alarm ToolSideStage::move(const Words& words, const OwnMove& own) {
  if (words.suppresses_look_ahead())
    if (const StageEnd end = compensation_.release()) {
      control_.end(end);
      return AlarmCause::none;
    }
  return pass(words, own.extra, own.arc);
}

Alarm ToolSideStage::plain_block(const Words& words) {
  static const BlockArc kLine;
  if (!control_.positions.along_tool() || !words.any()) control_.attitude.directions().begin_block();
  compensation_.next().repeated = false;
  if (control_.modal.motion() <= kG01) [[likely]]
    return pass(words, false, kLine);
  if (compensation_.type() == StartType::c) {
    if (!wanted_) return AlarmCause::type_c_format;
  } else if (wanted_ != compensation_.active() && names_arc(words, control_.modal.motion(), control_.modal.plane())) {
    return AlarmCause::arc_at_start_or_cancel;
  }
  if (refuses_arcs_ && wanted_ && names_arc(words, control_.modal.motion(), control_.modal.plane()))
    return AlarmCause::arc_in_compensation;
  if (const Alarm a = control_.plan_arc(words, arc_, false, false)) return a;
  return pass(words, false, arc_);
}

void ToolSideStage::set_arc(ToolSideBlock& block, const ArcWords& words) const {
  const ModalState& modal = control_.modal;
  block.clockwise = words.clockwise;
  block.by_radius = words.by_radius;
  block.to_center = words.to_center;
  block.radius = words.radius;
  block.axis = modal.axes_of(modal.plane());
  for (std::size_t i = 0; i < 2; ++i) {
    block.in[i] = in_plane(modal.plane(), i);
    block.start[i] = control_.positions.actual(block.axis[i]);
  }
}

void ToolSideStage::rename() {
  control_.name_place(place_);
  renames_ = true;
}

Alarm ToolSideStage::pass(const Words& words, bool extra, const BlockArc& arc) {
  Control& control = control_;  // at hand: behind what is written through it, it would be looked up again
  ToolSideBlock& block = compensation_.next();
  const AxisPositions& positions = control.positions;
  const Mask named = words.axes();
  const std::uint32_t q = words.has('Q') ? whole_number(words['Q'], 3) : 0;
  block.renamed = renames_ ? &place_ : nullptr;
  renames_ = false;
  block.wanted = wanted_;
  block.side = sign_;
  block.treatment = static_cast<Treatment>(q > 3 ? 0 : q);
  block.arc = arc.event.has_value();
  const XyzTravel xyz(control);
  if (block.arc) set_arc(block, arc.words);

  if (const Alarm a = control.place_words(words, named)) return a;

  Travel& travel = compensation_.next_travel();
  if (xyz.is_small()) [[likely]]
    set_travel(travel, xyz.small(0), xyz.small(1), xyz.small(2));
  else
    set_travel(travel, xyz.from(), positions.programmed_xyz(), xyz.slack(named));
  const ToolDirections& directions = control.attitude.directions();
  block.tool = &directions.now();
  block.tool_number = directions.number();
  block.tool_before = &directions.before();
  block.own = named != 0 || extra || block.arc || (control.modal.by_vector() && words.has_any(kDirectionLetters));
  control.fill_here(block.event, block.arc ? spec::MoveType::arc : control.modal.straight(), spec::Cause::programmed);
  if (block.arc) {
    block.event.arc = arc.event;
    for (std::size_t i = 0; i < 2; ++i) block.end[i] = positions.actual(block.axis[i]);
  }
  const StageEnd end = compensation_.block();
  set_on(is_on());
  if (end) control.end(end);
  return AlarmCause::none;
}

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/cutter_compensation/cutter_compensation.h"

#include <memory>
#include <utility>

#include "model/basis/alarm.h"

namespace toolcomp::model {
namespace {

std::optional<CutterSide> side_of(Compensation code) {
  if (code == Compensation::cancel) return CutterSide::none;
  if (!is_cutter_side(code)) return std::nullopt;
  return code == Compensation::left ? CutterSide::left : CutterSide::right;
}

PlaneMotion motion_of(const CutterBlock& block, const std::vector<Leg>& legs) {
  if (legs.empty()) return PlaneMotion::none;
  if (is_reference_return(block.one_shot)) return PlaneMotion::reference;
  if (block.one_shot == OneShot::machine_coordinates || block.one_shot == OneShot::from_reference)
    return PlaneMotion::machine;
  if (legs.front().arc) return PlaneMotion::arc;
  if (!block.has_plane_word()) return PlaneMotion::none;
  const bool travels = block.end[0] != block.start[0] || block.end[1] != block.start[1];
  return travels ? PlaneMotion::line : PlaneMotion::zero_travel;
}

std::optional<PlanePoint> direction_of(const CutterBlock& block, const BlockWords& now) {
  const bool corner_arc = block.one_shot == OneShot::corner_arc;
  if (block.direction_letters && (corner_arc || !now.command.is_arc_motion())) {
    const auto component = [&](char letter) {
      const spec::Decimal* const word = now.command.words.find(letter);
      return word == nullptr ? Rational(0) : now.interpreter.numbers().length(*word);
    };
    return PlanePoint{component(letters(block.plane).first_center), component(letters(block.plane).second_center)};
  }
  if (!corner_arc || !block.has_plane_word()) return std::nullopt;
  // G39: the axis words are a point in the direction, and nothing moves there.
  return in_plane_of(block.plane, now.interpreter.toward(now.command).travel);
}

PlanePoint point(spec::Plane plane, const Leg& leg, const spec::Axes& axes) {
  return in_axes(plane, axes, [&](std::size_t axis) { return leg.actual(axis).value(); });
}

}  // namespace

CutterCompensation::CutterCompensation(const Place& place, bool by_number)
    : Pass(place), words_(place, side_of), by_number_(by_number) {}

bool CutterCompensation::on_after(const Command& command) const {
  return wanted(words_.side_after(command), words_.number_after(command));
}

void CutterCompensation::read(const BlockWords& now, StepWords& words) {
  const Command& command = now.command;
  const OneShot one_shot = command.codes.one_shot;
  const bool by_motion = one_shot == OneShot::none || is_tool_offset(one_shot);
  auto block = std::make_shared<CutterBlock>();
  if (!words_.read(now, one_shot == OneShot::corner_arc, by_motion, *block)) return;
  words.cutter = block;
  block->plane = command.plane;
  block->one_shot = one_shot;
  const PlaneLetters in_plane = letters(command.plane);
  block->word = {command.names(setup().axes, in_plane.first), command.names(setup().axes, in_plane.second)};
  block->axis_word = command.axes != 0;
  // Whatever they mean in the block.
  block->direction_letters =
      command.direction && (command.words.has(in_plane.first_center) || command.words.has(in_plane.second_center));
  block->direction = direction_of(*block, now);
  check_common(*block, command);
  check(*block, command);
  words_.add_value(*block);
}

void CutterCompensation::see(const BlockWay& way, StepWords& words) const {
  if (!words.cutter) return;
  CutterBlock& block = *words.cutter;
  const std::vector<Leg>& legs = way.legs;
  block.start = point(block.plane, way.start, setup().axes);
  block.end = legs.empty() ? block.start : point(block.plane, legs.back(), setup().axes);
  if (!legs.empty()) block.first_end = point(block.plane, legs.front(), setup().axes);
  block.motion = motion_of(block, legs);
  block.add_place(way);
  if (block.motion == PlaneMotion::arc) block.arc = arc_of(legs.front(), block.radius, setup().axes);
}

void CutterCompensation::make_corner_arc(Leg& leg, const CutterBlock& block, spec::Arc<Real> arc) const {
  const PlaneLetters in_plane = letters(block.plane);
  arc.center.set(setup().axes.index(in_plane.first), block.start[0]);
  arc.center.set(setup().axes.index(in_plane.second), block.start[1]);
  arc.plane = block.plane;
  leg.type = spec::MoveType::arc;
  leg.cause = spec::Cause::corner;
  leg.arc = std::move(arc);
}

void CutterCompensation::check_common(const CutterBlock& words, const Command& command) const {
  const PlaneLetters in_plane = letters(command.plane);
  const bool lacks_axis = !setup().axes.has(in_plane.first) || !setup().axes.has(in_plane.second);
  const bool tip_control = command.codes.length && is_tip_control(*command.codes.length);
  const bool in_force = words.side != CutterSide::none;
  // fanuc.cutter.plane-axes: A block in which G41 or G42 is in force raises PS0028 if the machine lacks an axis of the
  // plane. U, V and W are axes outside every plane.
  if (in_force && lacks_axis) raise(recorder(), Clause::fanuc_cutter_plane_axes, AlarmCause::plane_axis_missing);
  // fanuc.cutter.plane-change: A G17, G18 or G19 that changes the plane raises PS0037 if cutter compensation is on
  // before the block. This holds also for the block that cancels it.
  if (on() && words.plane_changed) raise(recorder(), Clause::fanuc_cutter_plane_change, AlarmCause::plane_change);
  // fanuc.cutter.excluded: G41.3, G41.2, G42.2, G41.6 and G42.6 raise FORBIDDEN_IN_CUTTER_COMPENSATION if cutter
  // compensation is on before the block. G43.4 and G43.5 raise it if cutter compensation is on before the block, or if
  // G41 or G42 is in force in the block.
  if ((on() && words.other_compensation) || ((on() || in_force) && tip_control))
    raise(recorder(), Clause::fanuc_cutter_excluded, AlarmCause::forbidden_in_cutter_compensation);
  // fanuc.tool-offset.in-cutter-compensation: G45 to G48 raise PS0042 if cutter compensation B or C is on before or
  // after the block, with or without an axis word. It counts as on by fanuc.cutter.on, and also after a lone G40 while
  // a vector waits for its removal.
  if ((on() || wanted(words)) && is_tool_offset(words.one_shot))
    raise(recorder(), Clause::fanuc_tool_offset_in_cutter_compensation, AlarmCause::tool_offset_in_cutter_compensation);
}

}  // namespace toolcomp::model

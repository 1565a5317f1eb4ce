// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/cutter_compensation/cutter_words.h"

#include <bit>

namespace toolcomp::model {
namespace {

CutterSide side_of(Compensation code) {
  if (!is_cutter_side(code)) return CutterSide::none;
  return code == Compensation::left ? CutterSide::left : CutterSide::right;
}

// The block moves by its code of group 01.
bool is_path(OneShot code) { return code == OneShot::none || is_tool_offset(code); }

// I J (K I, J K), whatever they mean in the block.
bool has_center_letter(const Command& command) {
  const PlaneLetters in_plane = letters(command.plane);
  return command.direction && (command.words.has(in_plane.first_center) || command.words.has(in_plane.second_center));
}

PlaneMotion motion_of(const CutterBlock& block, const std::vector<Leg>& legs) {
  if (legs.empty()) return PlaneMotion::none;
  switch (block.one_shot) {
    case OneShot::machine_coordinates:
      return PlaneMotion::machine_coordinates;
    case OneShot::reference:
    case OneShot::other_reference:
    case OneShot::floating_reference:
      return PlaneMotion::reference;
    case OneShot::from_reference:
      return PlaneMotion::from_reference;
    default:
      break;
  }
  if (legs.front().arc) return PlaneMotion::arc;
  if (!block.has_plane_word()) return PlaneMotion::none;
  const bool travels = block.end[0] != block.start[0] || block.end[1] != block.start[1];
  return travels ? PlaneMotion::line : PlaneMotion::zero_travel;
}

}  // namespace

CutterWords::CutterWords(const spec::Setup& setup, const OffsetMemory& memory, Recorder& recorder)
    : offset_(setup, memory, recorder), axes_(setup.axes) {}

std::optional<PlanePoint> CutterWords::direction(const Command& command, const Interpreter& interpreter) const {
  const PlaneLetters in_plane = letters(command.plane);
  const bool corner_arc = command.codes.one_shot == OneShot::corner_arc;
  if (has_center_letter(command) && (corner_arc || !command.is_arc_motion())) {
    const auto component = [&](char letter) {
      const spec::Decimal* const word = command.words.find(letter);
      return word == nullptr ? Rational(0) : interpreter.numbers().length(*word);
    };
    return PlanePoint{component(in_plane.first_center), component(in_plane.second_center)};
  }
  if (!corner_arc || !(command.names(axes_, in_plane.first) || command.names(axes_, in_plane.second)))
    return std::nullopt;
  // G39: the axis words are a point in the direction, and nothing moves there.
  const Vector travel = interpreter.toward(command).travel;
  return in_plane_of(command.plane, travel);
}

CutterSide CutterWords::side_after(const Command& command) const {
  return command.codes.compensation ? side_of(*command.codes.compensation) : side_;
}

std::uint32_t CutterWords::number_after(const Command& command) const {
  return offset_.number_after(command.codes).number;
}

std::shared_ptr<CutterBlock> CutterWords::read(const BlockWords& now) {
  const Command& command = now.command;
  const Codes& codes = command.codes;
  auto result = std::make_shared<CutterBlock>();
  CutterBlock& block = *result;
  block.before = side_;
  block.number_before = offset_.number().number;
  side_ = side_after(command);
  if (codes.compensation == Compensation::cancel || (codes.compensation && is_cutter_side(*codes.compensation)))
    block.code = side_;
  block.side = side_;
  seen_ = seen_ || side_ != CutterSide::none || codes.one_shot == OneShot::corner_arc;
  block.number_given = offset_.take(codes);
  block.plane = command.plane;
  block.plane_changed = command.plane != plane_;
  plane_ = command.plane;
  if (!seen_) return nullptr;
  offset_.decide_address(codes);

  block.number = offset_.number().number;
  block.one_shot = codes.one_shot;
  block.direction = direction(command, now.interpreter);
  const PlaneLetters in_plane = letters(command.plane);
  block.word = {command.names(axes_, in_plane.first), command.names(axes_, in_plane.second)};
  block.axis_word = command.axes != 0;
  block.axis_word_outside = std::popcount(command.axes) > int{block.word[0]} + int{block.word[1]};
  block.direction_letters = has_center_letter(command);
  block.arc_words = command.is_arc_motion() && is_path(codes.one_shot) &&
                    (block.has_plane_word() || command.direction || command.words.has('R'));
  block.other_compensation = codes.compensation && !block.code;
  block.tip_control = codes.length && is_tip_control(*codes.length);
  block.lacks_axis = !axes_.has(in_plane.first) || !axes_.has(in_plane.second);
  if (const spec::Decimal* const r = command.words.find('R'); block.arc_words && r != nullptr) {
    const Rational radius = now.interpreter.numbers().length(*r);
    block.radius = radius < 0 ? Rational(-radius) : radius;
  }
  block.changes_workpiece_system = codes.workpiece.has_value() || codes.writes_origin;
  return result;
}

void CutterWords::add_value(CutterBlock& block) {
  if (block.side == CutterSide::none) return;
  block.offset = offset_.value(block.number_given || block.before == CutterSide::none);
}

PlanePoint CutterWords::point(spec::Plane plane, const Leg& leg) const {
  const PlaneLetters in_plane = letters(plane);
  // A machine without an axis of the plane stands at 0 in it.
  const auto at = [&](char letter) { return axes_.has(letter) ? leg.actual(axes_.index(letter)).value() : Real(0); };
  return {at(in_plane.first), at(in_plane.second)};
}

void CutterWords::add_movement(CutterBlock& block, const BlockWay& way) const {
  const std::vector<Leg>& legs = way.legs;
  block.start = point(block.plane, way.start);
  block.end = legs.empty() ? block.start : point(block.plane, legs.back());
  block.motion = motion_of(block, legs);
  for (const Leg& leg : legs) block.ends.push_back(point(block.plane, leg));
  block.add_place(way);
  if (block.motion != PlaneMotion::arc) return;
  const spec::Arc<Real>& arc = *legs.front().arc;
  const PlaneLetters in_plane = letters(block.plane);
  const auto center = [&](char letter) { return axes_.has(letter) ? arc.center[axes_.index(letter)] : Real(0); };
  block.arc = ArcGeometry{{center(in_plane.first), center(in_plane.second)}, arc.sweep, arc.radius};
  block.arc_direction = arc.direction;
}

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_side_compensation/tool_side_words.h"

#include "model/geometry/plane.h"

namespace toolcomp::model {
namespace {

CutterSide side_of(Compensation code) {
  switch (code) {
    case Compensation::tool_side_left:
    case Compensation::directed_tool_side_left:
      return CutterSide::left;
    case Compensation::tool_side_right:
    case Compensation::directed_tool_side_right:
      return CutterSide::right;
    default:
      return CutterSide::none;
  }
}

bool is_directed(Compensation code) {
  return code == Compensation::directed_tool_side_left || code == Compensation::directed_tool_side_right;
}

// Q1, Q2, Q3; 0 for any other value.
std::optional<int> treatment(const Command& command) {
  const spec::Decimal* const word = command.words.find('Q');
  if (word == nullptr) return std::nullopt;
  const Rational value = plain(*word);
  for (const int known : {1, 2, 3})
    if (value == known) return known;
  return 0;
}

}  // namespace

ToolSideWords::ToolSideWords(const spec::Setup& setup, const OffsetMemory& memory, Recorder& recorder)
    : offset_(setup, memory, recorder), axes_(setup.axes) {}

CutterSide ToolSideWords::side_after(const Command& command) const {
  return command.codes.compensation ? side_of(*command.codes.compensation) : side_;
}

bool ToolSideWords::wanted(const Command& command) const {
  return side_after(command) != CutterSide::none && offset_.number_after(command.codes).number != 0;
}

std::shared_ptr<ToolSideBlock> ToolSideWords::read(const BlockWords& now) {
  const Command& command = now.command;
  const Codes& codes = command.codes;
  auto result = std::make_shared<ToolSideBlock>();
  ToolSideBlock& block = *result;
  block.before = side_;
  side_ = side_after(command);
  block.side = side_;
  const bool tool_side_code = codes.compensation && is_tool_side(*codes.compensation);
  if (codes.compensation == Compensation::cancel || tool_side_code) block.code = side_;
  block.other_compensation = codes.compensation && !block.code;
  block.wrong_mode = tool_side_code && is_directed(*codes.compensation) != now.directed;
  seen_ = seen_ || tool_side_code;
  block.number_given = offset_.take(codes);
  block.number = offset_.number().number;
  block.plane_changed = command.plane != plane_;
  plane_ = command.plane;
  if (!seen_) return nullptr;
  offset_.decide_address(codes);

  block.treatment = treatment(command);
  block.leaves_the_path = codes.one_shot != OneShot::none;
  block.refused_while_on = codes.workpiece || codes.units || codes.refused_in_space;
  block.auxiliary = codes.auxiliary;
  block.stops_look_ahead = codes.stops_look_ahead;
  block.moves = now.moves();
  block.arc_mode = command.is_arc_motion();
  const PlaneLetters in_plane = letters(command.plane);
  block.arc_words = block.arc_mode && !block.leaves_the_path &&
                    (command.names(axes_, in_plane.first) || command.names(axes_, in_plane.second) ||
                     command.direction || command.words.has('R'));
  if (const spec::Decimal* const r = command.words.find('R'); block.arc_words && r != nullptr) {
    const Rational radius = now.interpreter.numbers().length(*r);
    block.radius = radius < 0 ? Rational(-radius) : radius;
  }
  block.changes_workpiece_system = codes.workpiece.has_value();
  return result;
}

void ToolSideWords::add_value(ToolSideBlock& block) {
  if (block.side == CutterSide::none) return;
  block.offset = offset_.value(block.number_given || block.before == CutterSide::none);
}

}  // namespace toolcomp::model

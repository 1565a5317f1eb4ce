// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/corner/corner_block.h"

#include "model/basis/number.h"
#include "spec/language/input_error.h"

namespace toolcomp::model {

ArcEnds arc_of(const Leg& leg, const std::optional<Rational>& radius, const spec::Axes& axes) {
  const spec::Arc<Real>& arc = *leg.arc;
  const PlanePoint end =
      in_axes(arc.plane, axes, [&](std::size_t axis) { return leg.actual(axis).value() - arc.center[axis]; });
  const int turn = arc.direction == spec::ArcDirection::ccw ? 1 : -1;
  return {end - in_plane_of(arc.plane, leg.travel), end, turn, radius, !arc.radius};
}

CutterSide CornerWords::side_after(const Command& command) const {
  const auto& code = command.codes.compensation;
  return code ? side_of_(*code).value_or(CutterSide::none) : side_;
}

bool CornerWords::read(const BlockWords& now, bool starts, bool by_motion, CornerBlock& block) {
  const Command& command = now.command;
  const Codes& codes = command.codes;
  block.before = side_;
  block.number_before = offset_.number().number;
  block.side = side_ = side_after(command);
  if (codes.compensation) block.code = side_of_(*codes.compensation);
  block.other_compensation = codes.compensation && !block.code;
  seen_ = seen_ || starts || side_ != CutterSide::none;
  block.number_given = offset_.take(codes);
  block.number = offset_.number().number;
  block.plane_changed = command.plane != plane_;
  plane_ = command.plane;
  if (!seen_) return false;
  offset_.decide_address(codes);
  const PlaneLetters in_plane = letters(command.plane);
  block.arc_words = command.is_arc_motion() && by_motion &&
                    (command.names(axes_, in_plane.first) || command.names(axes_, in_plane.second) ||
                     command.direction || command.words.has('R'));
  if (const spec::Decimal* const r = command.words.find('R'); block.arc_words && r != nullptr)
    block.radius = abs(now.interpreter.numbers().length(*r));
  block.changes_workpiece_system = codes.workpiece.has_value() || codes.writes_origin;
  return true;
}

void CornerWords::add_value(CornerBlock& block) {
  if (block.side == CutterSide::none) return;
  block.offset = offset_.value(block.number_given || block.before == CutterSide::none);
}

int blocks_read(const spec::Setup& setup) {
  const std::optional<spec::Decimal> given = setup.parameter(19625);
  if (setup.series != spec::Series::series_30i || !given) return 3;
  for (int blocks = 3; blocks <= 8; ++blocks)
    if (plain(*given) == blocks) return blocks;
  throw spec::InputError("setup", 0, 0, "parameters.\"19625\": expected a number of blocks from 3 to 8");
}

}  // namespace toolcomp::model

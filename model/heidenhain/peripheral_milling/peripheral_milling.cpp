#include "model/heidenhain/peripheral_milling/peripheral_milling.h"

#include <utility>

#include "model/basis/alarm.h"

namespace toolcomp::model::klartext {

void PeripheralMilling::meet(const Motion& next) {
  release(&next);
  recorder_.at(next.line);
}

void PeripheralMilling::take(Motion motion) {
  held_is_first_ = !std::exchange(on_, true);
  held_ = std::move(motion);
}

bool PeripheralMilling::pass() { return std::exchange(on_, false); }

void PeripheralMilling::release(const Motion* next) {
  if (!held_) return;
  Motion motion = *std::exchange(held_, std::nullopt);
  recorder_.at(motion.line);
  recorder_.resume(std::move(motion.clauses));
  Compensated result;
  try {
    recorder_.reach(Clause::heidenhain_program_length_along_the_tool);
    recorder_.reach(Clause::heidenhain_peripheral_applies);
    const ProgrammedContour::Flank flank = contour_.flank(motion);
    const EffectiveTool& tool = *motion.tool;
    const Vector side = side_vector(motion, next);
    result.shift = tool.dr * side;
    result.point = flank.from + flank.delta * side;
    result.tool_center = result.point + (tool.r2 + tool.dr2) * motion.direction.unit;
  } catch (Alarm& alarm) {
    alarm.line = motion.line;
    alarm.n = motion.n;
    throw;
  }
  if (next == nullptr || !next->is_peripheral()) directions_.forget();
  result.cause = held_is_first_ ? spec::Cause::start_up : spec::Cause::programmed;
  motion.clauses = recorder_.take_clauses();
  output_(motion, result);
}

Vector PeripheralMilling::side_vector(const Motion& motion, const Motion* next) {
  if (recorder_.decide(Clause::heidenhain_peripheral_first_block, held_is_first_)) return at_first_block(motion, next);
  const LateralDirection own = directions_.make(motion.direction, motion.travel, motion.side);
  const bool last = next == nullptr || !next->is_peripheral();
  if (recorder_.decide(Clause::heidenhain_peripheral_last_block, last)) return own.unit;
  recorder_.decide(Clause::heidenhain_peripheral_side_change, next->side != motion.side);
  return directions_.mitre(own, directions_.make(motion.direction, next->travel, next->side));
}

// The tool arrives perpendicular to the start of the contour.
Vector PeripheralMilling::at_first_block(const Motion& motion, const Motion* next) {
  if (recorder_.decide(Clause::heidenhain_peripheral_first_without_next, next == nullptr))
    return directions_.make(motion.direction, motion.travel, motion.side).unit;
  const Side side = next->is_peripheral() ? next->side : motion.side;
  return directions_.make(motion.direction, next->travel, side).unit;
}

}  // namespace toolcomp::model::klartext

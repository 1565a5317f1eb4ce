// SPDX-License-Identifier: Apache-2.0
#include "model/heidenhain/peripheral_milling/rules.h"

#include "model/basis/alarm.h"
#include "model/basis/event.h"

namespace toolcomp::model::klartext {
namespace {

// |v|², the number 0 where v is 0: its components are shorter to prove than the sum of their squares.
Real proven_squared_norm(const Vector& v) { return exact::is_zero(v) ? Real() : squared_norm(v); }

// v/|v|. Where |v|² is rational the factor is a rational times one root, and components stay as short.
Vector unit(const Vector& v, const Real& norm2) {
  return norm2.is_rational() ? (sqrt(norm2) / norm2) * v : v / sqrt(norm2);
}

}  // namespace

// heidenhain.peripheral.applies: Under TCPM an L block, or an LN block without a normal, with RL or RR in force is
// compensated perpendicular to the movement and to the tool. The amount is the total of the deltas, dR. dL acts along
// the tool, and dR2 has no effect. An LN block without a normal takes its side from an earlier block.
PeripheralEnd PeripheralRules::compensate(const Motion& motion, const Motion* next, bool is_first,
                                          const std::optional<LateralDirection>& former) const {
  recorder_.reach(Clause::heidenhain_peripheral_applies);
  const EffectiveTool& tool = *motion.tool;
  const ProgrammedContour::Flank flank = contour_.flank(motion);
  const bool first = recorder_.decide(Clause::heidenhain_peripheral_first_block, is_first);
  const Beside beside = first ? at_first_block(motion, next, former) : at_later_block(motion, next, former);
  Compensated end;
  end.shift = tool.dr * beside.side;
  end.point = flank.from + flank.delta * beside.side;
  end.tool_center = end.point + (tool.r2 + tool.dr2) * motion.direction.unit;
  return {end, beside.latest};
}

// heidenhain.peripheral.direction: The direction of compensation is perpendicular to the movement of the block and to
// the tool. If the tool is parallel to the movement, or nothing moves, there is no such direction, and the direction
// made last counts. At a junction c_i is made first, then c_(i+1). The test is exact. Asked for every direction that is
// needed.
LateralDirection PeripheralRules::direction(const Direction& tool, const Vector& travel, Side side,
                                            const std::optional<LateralDirection>& former) const {
  const Vector across = cross(tool.vector, travel);
  const Real norm2 = proven_squared_norm(across);
  const Real travel2 = squared_norm(travel);
  const Real scale = travel2.sign() == Sign::zero ? Real(1) : tool.norm2 * travel2;
  if (recorder_.decide(Clause::heidenhain_peripheral_direction, norm2, scale) == Sign::zero) {
    // heidenhain.peripheral.former-direction: If a block has no direction of its own, and no direction was made since
    // the first compensated block, E_NO_DIRECTION is raised. The alarm names the block whose end point is needed.
    if (!recorder_.decide(Clause::heidenhain_peripheral_former_direction, former.has_value())) {
      recorder_.list(Clause::heidenhain_peripheral_former_direction);
      throw Alarm(AlarmCause::no_direction);
    }
    return *former;
  }
  if (norm2.sign() == Sign::zero) throw NotFinite();  // only a forced outcome comes here
  // heidenhain.peripheral.side: RL compensates to the left of the movement and RR to the right, seen from the tool
  // carrier.
  const bool left = recorder_.decide(Clause::heidenhain_peripheral_side, side == Side::left);
  const Vector c = left ? across : -across;
  return {c, norm2, unit(c, norm2)};
}

// heidenhain.peripheral.first-block: The first compensated block ends beside its end point, in the direction of
// compensation of the next block. A block is the first if the block before it was without this compensation. The next
// block is the next one with an axis word or M140 (a movement along the tool), whatever its compensation. Delta and
// tool are those of the first block, and so is the side if the next block has no RL or RR of this compensation. So the
// tool arrives perpendicular to the start of the contour. The move of the first block has the cause start-up.
// heidenhain.peripheral.first-without-next: If nothing that moves follows the first compensated block, its own
// direction counts. This is so at the end of the run and before an alarm.
PeripheralRules::Beside PeripheralRules::at_first_block(const Motion& motion, const Motion* next,
                                                        const std::optional<LateralDirection>& former) const {
  recorder_.decide(Clause::heidenhain_peripheral_first_without_next, next == nullptr);
  const Vector& travel = next == nullptr ? motion.travel : next->travel;
  const Side side = next != nullptr && next->is_peripheral() ? next->side : motion.side;
  const LateralDirection made = direction(motion.direction, travel, side, former);
  return {made.unit, made};
}

// heidenhain.peripheral.last-block: The last compensated block ends beside its end point, in its own direction. A block
// is the last if the next block with an axis word or M140 is without this compensation (R0, a normal, TCPM off), or if
// there is no next block. Asked of every compensated block that is not the first.
// heidenhain.peripheral.side-change: If RL changes to RR without R0, or RR to RL, each direction takes the side of its
// own block, and the rule of the mitre holds unchanged.
PeripheralRules::Beside PeripheralRules::at_later_block(const Motion& motion, const Motion* next,
                                                        const std::optional<LateralDirection>& former) const {
  const LateralDirection own = direction(motion.direction, motion.travel, motion.side, former);
  const bool last = next == nullptr || !next->is_peripheral();
  recorder_.decide(Clause::heidenhain_peripheral_last_block, last);
  if (last) return {own.unit, own};
  recorder_.decide(Clause::heidenhain_peripheral_side_change, next->side != motion.side);
  const LateralDirection behind = direction(motion.direction, next->travel, next->side, own);
  return {mitre(own, behind), behind};
}

// heidenhain.peripheral.mitre: Between two compensated blocks the end point is the intersection of both offset lines in
// the plane across the tool, so that it lies on both lines. The delta is that of the former block.
// heidenhain.peripheral.reversal: If the directions of two consecutive compensated blocks are opposite, their offset
// lines do not meet, and E_REVERSAL is raised. The alarm names the block whose end point is needed. The test is exact.
//
// Where the angle is obtuse 1 + c.c' = |c x c'|²/(1 - c.c'), which is 0 without a root.
Vector PeripheralRules::mitre(const LateralDirection& a, const LateralDirection& b) const {
  const Real product = dot(a.vector, b.vector);
  const Real norms2 = a.norm2 * b.norm2;
  const Real cosine = product / sqrt(norms2);
  Real sum = 1 + cosine;
  if (product.sign() == Sign::negative) sum = proven_squared_norm(cross(a.vector, b.vector)) / (norms2 * (1 - cosine));
  if (recorder_.decide(Clause::heidenhain_peripheral_reversal, sum, 2) == Sign::zero)
    throw Alarm(AlarmCause::opposite_directions);
  if (sum.sign() == Sign::zero) throw NotFinite();  // only a forced outcome comes here
  recorder_.reach(Clause::heidenhain_peripheral_mitre);
  return (a.unit + b.unit) / sum;
}

}  // namespace toolcomp::model::klartext

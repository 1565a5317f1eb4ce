// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/leading_edge_offset/rules.h"

#include "model/basis/alarm.h"
#include "model/basis/event.h"
#include "model/basis/number.h"
#include "spec/language/input_error.h"

namespace toolcomp::model {

// fanuc.leading-edge.vector: The compensation vector at the end of block n lies in the plane of the tool direction VT
// there and the movement VM of the next block. It is at right angles to the tool and as long as the offset value R. V,
// as in the formula, points against the movement.
// fanuc.leading-edge.negative-radius: A negative offset value reverses the vector; the side that is carried to an angle
// of 90 degrees does not change.
EdgeVector EdgeRules::vector(Sense sense, const Vector& movement, const Direction& tool, const Rational& radius) const {
  recorder_.reach(Clause::fanuc_leading_edge_vector);
  recorder_.decide(Clause::fanuc_leading_edge_negative_radius, radius < 0);
  const Vector normal = cross(movement, tool.vector);
  const Real length2 = squared_norm(normal) * tool.norm2;   // |V|² = |VM × VT|² |VT|²
  if (length2.sign() != Sign::positive) throw NotFinite();  // only a forced angle comes here with VM along VT
  const Rational signed_radius = sense == Sense::backward ? radius : Rational(-radius);
  return {(signed_radius / sqrt(length2)) * cross(normal, tool.vector), sense};
}

// fanuc.leading-edge.fluctuation: Parameter 19631 is the fluctuation D: within D, an angle near 0, 90 or 180 degrees
// counts as that angle. The ranges include their ends. D is in degrees and usually about 1; 1 is used if the setup
// gives none. A setup with a value above 90 or below -90 is refused.
EdgeRules::EdgeRules(const spec::Setup& setup, Recorder& recorder) : recorder_(recorder) {
  if (const auto given = setup.parameter(19631)) fluctuation_ = plain(*given);
  if (fluctuation_ > 90 || fluctuation_ < -90)
    throw spec::InputError("setup", 0, 0, "parameters.19631: expected an angle from -90 to 90");
  // By the double angle, whose cosine is rational where the squares are.
  const Real cosine_of_double = exact::cos_degrees(fluctuation_ <= 0 ? Rational(0) : Rational(2 * fluctuation_));
  cosine2_ = (1 + cosine_of_double) / 2;
  sine2_ = (1 - cosine_of_double) / 2;
}

// fanuc.leading-edge.near-0: An angle from 0 to D counts as 0 degrees: the tool points along the movement.
// fanuc.leading-edge.near-180: An angle from 180 - D to 180 degrees counts as 180: the tool points against the
// movement.
//
// Every comparison is one of squares: no root decides.
EdgeCase EdgeRules::classify(const Vector& movement, const Direction& tool) const {
  const Real product = dot(movement, tool.vector);
  const Real lengths2 = squared_norm(movement) * tool.norm2;
  // fanuc.leading-edge.sign: The angle between the tool direction and the movement tells the side: below 90 degrees the
  // tool leans forward and the vector points backward, above 90 degrees it leans back and the vector points forward.
  const Sign side = recorder_.decide(Clause::fanuc_leading_edge_sign, product, sqrt(lengths2));
  if (side == Sign::zero) return {EdgeAngle::across, side};

  const Real product2 = square(product);
  // fanuc.leading-edge.order-of-ranges: From D = 45 on, the ranges overlap; they are tested in the order 0, 180, 90.
  recorder_.decide(Clause::fanuc_leading_edge_order_of_ranges, fluctuation_ >= 45);
  const Clause near_parallel =
      side == Sign::positive ? Clause::fanuc_leading_edge_near_0 : Clause::fanuc_leading_edge_near_180;
  if (recorder_.decide(near_parallel, product2 - cosine2_ * lengths2, lengths2) != Sign::negative)
    return {EdgeAngle::along, side};
  // fanuc.leading-edge.exact-only: If 19631 is 0 or below, only exact angles of 0, 90 and 180 degrees count as such.
  // The range of the parameter admits negative values; the manual gives them no meaning.
  // fanuc.leading-edge.near-90: An angle from 90 - D to 90 + D counts as 90 degrees.
  if (!recorder_.decide(Clause::fanuc_leading_edge_exact_only, fluctuation_ <= 0) &&
      recorder_.decide(Clause::fanuc_leading_edge_near_90, sine2_ * lengths2 - product2, lengths2) != Sign::negative)
    return {EdgeAngle::across, side};
  return {EdgeAngle::leaning, side};
}

// fanuc.leading-edge.kept-along-the-tool: At an angle that counts as 0 or 180 degrees, the vector of the block before
// is kept, over any number of such blocks.
// fanuc.leading-edge.across-keeps-sense: At an angle that counts as 90 degrees, the vector is made of its own pair (VM,
// VT), on the side of the vector before it.
EdgeVector EdgeRules::next(const EdgeVector& before, const Vector& movement, const Direction& tool,
                           const Rational& radius) const {
  const EdgeCase found = classify(movement, tool);
  if (found.angle == EdgeAngle::along) {
    recorder_.reach(Clause::fanuc_leading_edge_kept_along_the_tool);
    return before;
  }
  if (found.angle == EdgeAngle::leaning) return vector(static_cast<Sense>(found.lean), movement, tool, radius);
  recorder_.decide(Clause::fanuc_leading_edge_across_keeps_sense, before.sense == Sense::backward);
  return vector(before.sense, movement, tool, radius);
}

// fanuc.leading-edge.start: At G41.3 the tool moves from the programmed point by the vector that is made of the tool
// direction there and the movement of the next block. Nothing else moves.
EdgeVector EdgeRules::first(const Vector& movement, const Direction& tool, const Rational& radius) const {
  recorder_.reach(Clause::fanuc_leading_edge_start);
  const EdgeCase found = classify(movement, tool);
  // fanuc.leading-edge.start-along-the-tool: At the start, an angle that counts as 0 or 180 degrees raises PS5408 at
  // the G41.3 block. That the ranges of 19631 hold here is our definition.
  if (found.angle == EdgeAngle::along)
    raise(recorder_, Clause::fanuc_leading_edge_start_along_the_tool, AlarmCause::leading_edge_start);
  const bool backward = found.lean != Sign::negative;
  // fanuc.leading-edge.start-across: At the start there is no vector before, so at an angle that counts as 90 degrees
  // the sign of the angle itself decides (fanuc.leading-edge.sign). An exact right angle counts as if the tool leaned
  // forward.
  if (found.angle == EdgeAngle::across) recorder_.decide(Clause::fanuc_leading_edge_start_across, backward);
  return vector(backward ? Sense::backward : Sense::forward, movement, tool, radius);
}

}  // namespace toolcomp::model

#include "model/fanuc/leading_edge_offset/edge_vector.h"

#include "model/basis/alarm.h"
#include "model/basis/event.h"

namespace toolcomp::model {

EdgeRules::EdgeRules(const Rational& fluctuation, Recorder& recorder)
    : recorder_(recorder), exact_only_(fluctuation <= 0), overlapping_(fluctuation >= 45) {
  // By the double angle, whose cosine is rational where the squares are.
  const Real cosine_of_double = exact::cos_degrees(exact_only_ ? Rational(0) : Rational(2 * fluctuation));
  cosine2_ = (1 + cosine_of_double) / 2;
  sine2_ = (1 - cosine_of_double) / 2;
}

// Every comparison is one of squares: no root decides.
EdgeCase EdgeRules::classify(const Vector& movement, const Direction& tool) const {
  const Real product = dot(movement, tool.vector);
  const Real lengths2 = squared_norm(movement) * tool.norm2;
  const Sign lean = recorder_.decide(Clause::fanuc_leading_edge_sign, product, sqrt(lengths2));
  if (lean == Sign::zero) return {EdgeAngle::across, lean};

  const Real product2 = square(product);
  const bool ahead = lean == Sign::positive;
  recorder_.decide(Clause::fanuc_leading_edge_order_of_ranges, overlapping_);
  const Clause near_parallel = ahead ? Clause::fanuc_leading_edge_near_0 : Clause::fanuc_leading_edge_near_180;
  if (recorder_.decide(near_parallel, product2 - cosine2_ * lengths2, lengths2) != Sign::negative)
    return {ahead ? EdgeAngle::along : EdgeAngle::against, lean};
  if (!recorder_.decide(Clause::fanuc_leading_edge_exact_only, exact_only_) &&
      recorder_.decide(Clause::fanuc_leading_edge_near_90, sine2_ * lengths2 - product2, lengths2) != Sign::negative)
    return {EdgeAngle::across, lean};
  return {ahead ? EdgeAngle::forward : EdgeAngle::back, lean};
}

// ±R·V/|V| with V = (VM × VT) × VT, which points against the travel; |V|² = |VM × VT|² |VT|².
EdgeVector EdgeRules::vector(Sense sense, const Vector& movement, const Direction& tool, const Rational& radius) const {
  recorder_.reach(Clause::fanuc_leading_edge_vector);
  recorder_.decide(Clause::fanuc_leading_edge_negative_radius, radius < 0);
  const Vector normal = cross(movement, tool.vector);
  const Real length2 = squared_norm(normal) * tool.norm2;
  if (length2.sign() != Sign::positive) throw NotFinite();  // only a forced angle comes here with VM along VT
  const Rational signed_radius = sense == Sense::backward ? radius : Rational(-radius);
  return {(signed_radius / sqrt(length2)) * cross(normal, tool.vector), sense};
}

EdgeVector EdgeRules::next(const EdgeVector& before, const Vector& movement, const Direction& tool,
                           const Rational& radius) const {
  switch (classify(movement, tool).angle) {
    case EdgeAngle::along:
    case EdgeAngle::against:
      recorder_.reach(Clause::fanuc_leading_edge_kept_along_the_tool);
      return before;
    case EdgeAngle::across:
      recorder_.decide(Clause::fanuc_leading_edge_across_keeps_sense, before.sense == Sense::backward);
      return vector(before.sense, movement, tool, radius);
    case EdgeAngle::forward:
      return vector(Sense::backward, movement, tool, radius);
    case EdgeAngle::back:
      return vector(Sense::forward, movement, tool, radius);
  }
  return before;
}

EdgeVector EdgeRules::first(const Vector& movement, const Direction& tool, const Rational& radius) const {
  const EdgeCase found = classify(movement, tool);
  switch (found.angle) {
    case EdgeAngle::along:
    case EdgeAngle::against:
      raise(recorder_, Clause::fanuc_leading_edge_start_along_the_tool, "PS5408",
            "leading edge offset started with the tool along the movement");
    case EdgeAngle::across: {
      // No vector before it: the formula of the angle itself, an exact right angle as the first case.
      const bool backward = recorder_.decide(Clause::fanuc_leading_edge_start_across, found.lean != Sign::negative);
      return vector(backward ? Sense::backward : Sense::forward, movement, tool, radius);
    }
    case EdgeAngle::forward:
      return vector(Sense::backward, movement, tool, radius);
    case EdgeAngle::back:
      break;
  }
  return vector(Sense::forward, movement, tool, radius);
}

}  // namespace toolcomp::model

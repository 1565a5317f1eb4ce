// The compensation vector of the leading edge offset at the end of one block.
#pragma once

#include "model/basis/recorder.h"
#include "model/geometry/vector.h"
#include "model/kinematics/tool_direction.h"

namespace toolcomp::model {

// On which side the vector lies: against the travel (the tool leans forward) or along it (it leans back).
enum class Sense : std::int8_t { forward = -1, backward = 1 };

// The vector in force, setup units, and the side of the last one that was computed.
struct EdgeVector {
  Vector vector;
  Sense sense = Sense::backward;
};

// How the angle between the tool direction VT and the movement VM counts, with the fluctuation of parameter 19631.
enum class EdgeAngle : std::uint8_t {
  along,    // as 0°
  against,  // as 180°
  across,   // as 90°
  forward,  // under 90°: the tool leans forward
  back      // over 90°
};

// The class of an angle, and the sign of the scalar product it was told by.
struct EdgeCase {
  EdgeAngle angle = EdgeAngle::across;
  Sign lean = Sign::zero;
};

// The rules of one pair (VM, VT). Clauses: fanuc.leading-edge.sign, near-0, near-180, near-90, vector.
class EdgeRules {
 public:
  // `fluctuation`: parameter 19631 in degrees, at most 90; 0 and below count only exact angles.
  EdgeRules(const Rational& fluctuation, Recorder& recorder);

  // The angle of a tool direction and a movement that is not zero.
  [[nodiscard]] EdgeCase classify(const Vector& movement, const Direction& tool) const;
  // At the end of a block, from the vector before it. `radius` is the offset value with its sign.
  [[nodiscard]] EdgeVector next(const EdgeVector& before, const Vector& movement, const Direction& tool,
                                const Rational& radius) const;
  // At the start; throws Alarm PS5408 where the tool points along or against the movement.
  [[nodiscard]] EdgeVector first(const Vector& movement, const Direction& tool, const Rational& radius) const;

 private:
  [[nodiscard]] EdgeVector vector(Sense sense, const Vector& movement, const Direction& tool,
                                  const Rational& radius) const;

  Recorder& recorder_;
  bool exact_only_;
  bool overlapping_;
  Real cosine2_;  // squares of the cosine and sine of the fluctuation
  Real sine2_;
};

}  // namespace toolcomp::model

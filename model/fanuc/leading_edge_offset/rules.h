// SPDX-License-Identifier: Apache-2.0
// The rules of the leading edge offset: the compensation vector at the end of one block. Clauses: fanuc.leading-edge.*.
#pragma once

#include "model/basis/recorder.h"
#include "model/geometry/vector.h"
#include "model/kinematics/tool_direction.h"
#include "spec/language/setup.h"

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
  along,   // as 0° or 180°
  across,  // as 90°
  leaning  // between
};

// The class of an angle, and the sign of the scalar product it was told by: positive where the tool leans forward.
struct EdgeCase {
  EdgeAngle angle = EdgeAngle::across;
  Sign lean = Sign::zero;
};

// The vector of one pair: the movement VM of a block, not zero, and the tool direction VT where it begins. `radius` is
// the offset value with its sign.
class EdgeRules {
 public:
  // With the fluctuation of parameter 19631. Throws spec::InputError naming it.
  EdgeRules(const spec::Setup& setup, Recorder& recorder);

  // At the end of a block, from the vector before it.
  [[nodiscard]] EdgeVector next(const EdgeVector& before, const Vector& movement, const Direction& tool,
                                const Rational& radius) const;
  // At the start; throws Alarm PS5408 where the tool points along or against the movement.
  [[nodiscard]] EdgeVector first(const Vector& movement, const Direction& tool, const Rational& radius) const;

 private:
  // ±R·V/|V| with V = (VM × VT) × VT.
  [[nodiscard]] EdgeVector vector(Sense sense, const Vector& movement, const Direction& tool,
                                  const Rational& radius) const;
  [[nodiscard]] EdgeCase classify(const Vector& movement, const Direction& tool) const;

  Recorder& recorder_;
  Rational fluctuation_ = 1;  // degrees
  Real cosine2_;              // squares of its cosine and sine
  Real sine2_;
};

}  // namespace toolcomp::model

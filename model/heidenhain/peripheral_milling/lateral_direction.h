// The direction of compensation across movement and tool, and the mitre of two of them.
#pragma once

#include <optional>

#include "model/basis/recorder.h"
#include "model/geometry/vector.h"
#include "model/heidenhain/program/motion.h"

namespace toolcomp::model::klartext {

// c = s (t x d)/|t x d|.
struct LateralDirection {
  Vector vector;  // s (T x d)
  Real norm2;
  Vector unit;  // c
};

// Makes directions, and keeps the one made last for blocks that have none of their own. Clauses:
// heidenhain.peripheral.direction, .former-direction, .side, .side-change, .mitre, .reversal.
class LateralDirections {
 public:
  explicit LateralDirections(Recorder& recorder) : recorder_(recorder) {}

  // c of a movement with the tool at a junction. Throws Alarm E_NO_DIRECTION.
  LateralDirection make(const Direction& tool, const Vector& travel, Side side);
  // (c + c')/(1 + c.c'). Throws Alarm E_REVERSAL.
  [[nodiscard]] Vector mitre(const LateralDirection& a, const LateralDirection& b) const;
  // The compensated blocks end: what was made is forgotten.
  void forget() { former_.reset(); }

 private:
  Recorder& recorder_;
  std::optional<LateralDirection> former_;
};

}  // namespace toolcomp::model::klartext

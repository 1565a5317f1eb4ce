// SPDX-License-Identifier: Apache-2.0
// The rules of peripheral milling: the direction of compensation across movement and tool, and where a block ends.
#pragma once

#include <optional>

#include "model/basis/recorder.h"
#include "model/geometry/vector.h"
#include "model/heidenhain/program/compensated.h"
#include "model/heidenhain/program/motion.h"
#include "model/heidenhain/programmed_contour/rules.h"

namespace toolcomp::model::klartext {

// c = s (t x d)/|t x d|.
struct LateralDirection {
  Vector vector;  // s (T x d)
  Real norm2;
  Vector unit;  // c
};

// Where a compensated block ends, and the direction made last.
struct PeripheralEnd {
  Compensated end;
  LateralDirection latest;
};

// Clauses: heidenhain.peripheral.*.
class PeripheralRules {
 public:
  explicit PeripheralRules(Recorder& recorder) : recorder_(recorder), contour_(recorder) {}

  // Of a motion that is peripheral. `next`: the one behind it, if there is any; `is_first`: the one before was without
  // this compensation; `former`: the direction made last. Throws Alarm E_NO_DIRECTION or E_REVERSAL.
  [[nodiscard]] PeripheralEnd compensate(const Motion& motion, const Motion* next, bool is_first,
                                         const std::optional<LateralDirection>& former) const;

 private:
  // By how much of delta the end point is moved, and the direction made last.
  struct Beside {
    Vector side;
    LateralDirection latest;
  };

  // c of a movement with the tool at a junction, or the one made last.
  [[nodiscard]] LateralDirection direction(const Direction& tool, const Vector& travel, Side side,
                                           const std::optional<LateralDirection>& former) const;
  [[nodiscard]] Beside at_first_block(const Motion& motion, const Motion* next,
                                      const std::optional<LateralDirection>& former) const;
  [[nodiscard]] Beside at_later_block(const Motion& motion, const Motion* next,
                                      const std::optional<LateralDirection>& former) const;
  // (c + c')/(1 + c.c').
  [[nodiscard]] Vector mitre(const LateralDirection& a, const LateralDirection& b) const;

  Recorder& recorder_;
  ProgrammedContour contour_;
};

}  // namespace toolcomp::model::klartext

// SPDX-License-Identifier: Apache-2.0
// The rules of cutter compensation C: the vectors at a corner. Clauses: fanuc.cutter-c.*.
#pragma once

#include <optional>

#include "model/fanuc/corner/corner.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Block A, which ends at a corner, and block B, which starts there.
struct CutterCorner {
  const PathEnd& former;                // with its offset, which counts for both
  const OffsetPath& latter;             // with the offset at its start
  bool starts = false;                  // A is the start-up block
  bool side_changes = false;            // from A to B
  bool repeated = false;                // G41 or G42 repeated in B, or in a block between
  bool cancels = false;                 // B is the cancel block
  std::optional<PlanePoint> direction;  // of the I J of its G40, not zero
};

class CutterRules {
 public:
  // Parameters 5003#0 and 5010.
  CutterRules(const spec::Setup& setup, Recorder& recorder);

  // The group, before small movements are dropped; nothing where an inner corner has no intersection (PS0033).
  [[nodiscard]] std::optional<VectorGroup> by_first_rule(const CutterCorner& corner) const;

  // The single rules. The offset at the end of `former` is not 0.
  [[nodiscard]] VectorGroup start_or_cancel(const PathEnd& former, const PathEnd& latter, bool cancels) const;
  [[nodiscard]] VectorGroup cancel_along(const PathEnd& former, const PlanePoint& direction) const;
  void drop_small_movements(VectorGroup& group, const OffsetPath& latter) const;

 private:
  Recorder& recorder_;
  bool type_b_;             // 5003#0, SUP
  Rational smallest_move_;  // 5010, setup units
};

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
// The rules of chapter 14 by which cutter compensation C and tool side compensation make the vectors at a corner of a
// plane. Clauses: fanuc.cutter-c.*.
#pragma once

#include <optional>

#include "model/fanuc/corner/vector_group.h"

namespace toolcomp::model {

// Out of the block that ends at the corner and the one that starts there. The offset at the end of `former` is not 0,
// but for square_to.
class CornerRules {
 public:
  explicit CornerRules(Recorder& recorder) : recorder_(recorder) {}

  // P1 alone; of an offset of 0 the vector 0.
  [[nodiscard]] VectorGroup square_to(const PathEnd& former) const;
  // Offset mode; nothing where an inner corner has no intersection (PS0033).
  [[nodiscard]] std::optional<VectorGroup> offset_mode(const PathEnd& former, const PathEnd& latter) const;
  // The side changes; `latter.offset` is the opposite of `former.offset`.
  [[nodiscard]] VectorGroup direction_change(const PathEnd& former, const PathEnd& latter) const;
  // Whether an arc from `start` to `end`, seen from its centre, sweeps less than a half circle. `radii`: their product.
  [[nodiscard]] bool is_under_half_circle(const ArcEnds& arc, const Real& radii) const;
  [[nodiscard]] bool is_under_half_circle(const ArcEnds& arc) const {
    return is_under_half_circle(arc, sqrt(squared_norm(arc.start) * squared_norm(arc.end)));
  }

 protected:
  [[nodiscard]] Recorder& recorder() const { return recorder_; }

 private:
  Recorder& recorder_;
};

}  // namespace toolcomp::model

// The compensation vectors at one corner, in space, and the rules that make them.
#pragma once

#include <optional>
#include <vector>

#include "model/fanuc/corner/vector_group.h"
#include "model/fanuc/tool_side_compensation/side_path.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// The block that ends at a corner and the one that starts there, in the plane at the end of the former. Refers to them.
struct SideCorner {
  const CompensationPlane& plane;
  const SideEnd& former;
  const SideEnd& latter;

  [[nodiscard]] bool of_lines() const { return !former.arc && !latter.arc; }
};

// Corners of two lines are told by the rules of this section, without a frame; corners with an arc by those of cutter
// compensation C, in a frame of the compensation plane. The offset at the end of the former is not 0, but for
// square_to.
class SideRules {
 public:
  // Parameters 5003#0 and 5010, and the second reading of type B.
  SideRules(const spec::Setup& setup, Recorder& recorder);

  // The former is the start-up block. Clauses: fanuc.tool-side.type-b, start-up-*, type-b-perpendicular.
  [[nodiscard]] SpaceGroup start_up(const SideCorner& corner) const;
  // The latter is the cancel block. Clauses: the same, cancel-*.
  [[nodiscard]] SpaceGroup cancel(const SideCorner& corner) const;
  // The mode; nothing where an inner corner with an arc has no intersection (PS0033). Clauses: fanuc.tool-side.inner,
  // outer-obtuse, outer-acute; with arcs those of chapter 14.
  [[nodiscard]] std::optional<SpaceGroup> in_mode(const SideCorner& corner) const;
  // The side changes: the offset of the latter is the opposite of the former's. Clauses:
  // fanuc.cutter-c.direction-change-*.
  [[nodiscard]] SpaceGroup side_change(const SideCorner& corner) const;
  // r n1 alone; of an offset of 0 the vector 0 (fanuc.cutter-c.value-zero).
  [[nodiscard]] SpaceGroup square_to(const CompensationPlane& plane, const SideEnd& former) const;
  // r n2 alone.
  [[nodiscard]] SpaceGroup square_to_latter(const CompensationPlane& plane, const SideEnd& latter) const;

  // Drops vectors that hardly differ from the last one kept. `distance`: r. Clause: fanuc.tool-side.small-difference.
  void drop_small_differences(SpaceGroup& group, const Rational& distance) const;

 private:
  // The vectors of type B at start-up or cancel; nothing where there is one as in type A.
  [[nodiscard]] std::optional<SpaceGroup> detour(const SideCorner& corner, bool cancels) const;

  Recorder& recorder_;
  CornerRules plane_rules_;
  bool type_b_;              // 5003#0, SUP
  bool with_perpendicular_;  // of the start-up or cancel block itself
  Rational limit_;           // 5010, setup units
};

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
// The rules of tool side compensation: the vectors at a corner. Clauses: fanuc.tool-side.*, and those of chapter 14
// that they name.
#pragma once

#include <optional>

#include "model/fanuc/corner/corner.h"
#include "model/fanuc/tool_side_compensation/side_corner.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// What counts at the corner between a block A and a block B beside their paths.
struct SideCase {
  bool starts = false;                     // A is the start-up block
  bool cancels = false;                    // B is the cancel block
  bool side_changes = false;               // from A to B
  bool repeated = false;                   // the code repeated in B, or in a block between
  int treatment = 0;                       // Q of A: 1, 2 or 3; 0 without
  const std::optional<SideArc>& next_arc;  // B, if it is one
};

// Corners of two lines are told by the rules of this section, without a frame; corners with an arc by those of
// chapter 14, in a frame of the compensation plane.
class SideRules {
 public:
  // Parameters 5003#0 and 5010, and the second reading of type B.
  SideRules(const spec::Setup& setup, Recorder& recorder)
      : setup_(setup), recorder_(recorder), limit_(parameter(setup, 5010)) {}

  // The group; nothing where an inner corner with an arc has no intersection (PS0033).
  [[nodiscard]] std::optional<SideGroup> group(const SideCorner& corner, const SideCase& given) const;
  // r n1 alone; of an offset of 0 the vector 0.
  [[nodiscard]] SpaceGroup square_to(const SideEnd& former) const;
  // Says where a group lies, and its stop point.
  [[nodiscard]] SpaceGroup in_plane(SpaceGroup group) const;

 private:
  [[nodiscard]] std::optional<SideGroup> by_first_rule(const SideCorner& corner, const SideCase& given) const;
  [[nodiscard]] std::optional<SideGroup> in_mode(const SideCorner& corner) const;
  [[nodiscard]] SideGroup start_or_cancel(const SideCorner& corner, bool cancels) const;
  [[nodiscard]] SideGroup side_change(const SideCorner& corner) const;
  void drop_small_differences(SideGroup& group, const Rational& offset, const std::optional<SideArc>& next_arc) const;

  const spec::Setup& setup_;
  Recorder& recorder_;
  Rational limit_;  // 5010, setup units
};

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
// The vectors at a corner of tool side compensation, in the order the tool goes through them (clauses fanuc.tool-side).
#pragma once

#include <array>
#include <cstdint>

#include "fast/fanuc/corner/corner_group.h"
#include "fast/fanuc/tool_side_compensation/plane_change.h"
#include "fast/fanuc/tool_side_compensation/side_corner.h"
#include "fast/fanuc/tool_side_compensation/tool_side_block.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// Start-up and cancel.
enum class StartType : std::uint8_t { a, b, c };

struct SideParameters : CornerParameters {
  // Throws spec::InputError for parameters no control could have.
  explicit SideParameters(const spec::Setup& setup);

  StartType type = StartType::a;  // 5003#0 SUP, 5003#1 SUV
  bool bare_b = false;            // type B without the perpendicular vector of lines
  bool no_plane_change = false;   // 19605#5, NIC
  PlaneChangeLimit tilt;          // 6261
  Amount no_movement;             // 19630; 0: none
};

struct SideHead {
  Vector3<double> vector;
  HeadKind kind = HeadKind::zero;
  bool kept = false;  // of a corner before: SideGroup::kept
};

struct SideGroup : HeadGroup<SideHead, SideCorner> {
  Vector3<DoubleDouble> kept;
};

class SideGroups : public CornerGroups<SideGroups, SideGroup> {
 public:
  SideGroups(const SideGeometry& geometry, const SideParameters& parameters)
      : CornerGroups(parameters), geometry_(geometry), parameters_(parameters) {}

  // As CornerGroups::make, with the Q of the former block.
  [[nodiscard]] bool make(SideGroup& group, CornerRule rule, Treatment treatment) const;
  // The last vector alone, without the corner it was made at.
  void keep_last(SideGroup& group) const {
    group.kept = fine(group, group.size - 1U);
    group.head[0] = group.back();
    group.head[0].kept = true;
    group.size = 1;
  }
  // A vector to about 90 bits.
  [[nodiscard]] Vector3<DoubleDouble> fine(const SideGroup& group, std::size_t i) const {
    const SideHead& head = group.head[i];
    return head.kept ? group.kept : geometry_.fine_vector(group.corner, head.kind);
  }
  [[nodiscard]] const SideGeometry& geometry() const { return geometry_; }

 private:
  friend CornerGroups;
  [[nodiscard]] bool starts_with_normal() const { return !parameters_.bare_b; }
  [[nodiscard]] bool cancels_with_normal() const { return !parameters_.bare_b; }

  static int cross(const SideCorner& corner) { return SideGeometry::cross(corner); }
  static int along(const SideCorner& corner) { return SideGeometry::along(corner); }
  static const Corner& in_plane(const SideGroup& group) { return group.corner.plane; }
  void set_vector(const SideCorner& corner, HeadKind kind, Vector3<double>& vector) const {
    geometry_.set_vector(corner, kind, vector);
  }
  [[nodiscard]] bool meet(const SideCorner& corner, HeadKind kind, Vector3<double>& vector) const;
  [[nodiscard]] bool is_under_one_degree(const SideCorner& corner) const {
    return geometry_.is_under_one_degree(corner);
  }
  // |a - b| <= limit.
  [[nodiscard]] bool is_small_movement(const SideGroup& group, std::size_t a, std::size_t b) const;

  const SideGeometry& geometry_;
  const SideParameters& parameters_;
};

inline bool SideGroups::make(SideGroup& group, CornerRule rule, Treatment treatment) const {
  const bool in_mode = rule == CornerRule::ordinary || rule == CornerRule::repeated;
  if (treatment == Treatment::perpendicular && in_mode && group.corner.offset->nearest != 0) {
    set(group, HeadKind::first_normal);
    return true;
  }
  if (!CornerGroups::make(group, rule)) return false;
  const bool first_only = treatment == Treatment::first_only && rule == CornerRule::ordinary && !group.corner.flat;
  if (first_only) group.size = 1;
  return true;
}

}  // namespace toolcomp::fast

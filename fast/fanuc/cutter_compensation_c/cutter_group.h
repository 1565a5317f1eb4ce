// SPDX-License-Identifier: Apache-2.0
// The vectors at a corner of cutter compensation C.
#pragma once

#include <cstddef>
#include <cstdint>

#include "fast/fanuc/corner/corner_group.h"
#include "fast/fanuc/corner/interference.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

struct CutterParameters : CornerParameters {
  // Throws spec::InputError for parameters no control could have.
  explicit CutterParameters(const spec::Setup& setup);

  bool acts_alone = false;              // 5003#1, SUV
  bool keeps_mode = false;              // 5003#2, CCN
  InterferenceParameters interference;  // 5008#1, CNC; 5008#3, CNV
};

struct CutterHead {
  Vector2<double> vector;
  HeadKind kind = HeadKind::zero;
};

struct CutterGroup : HeadGroup<CutterHead, Corner> {
  // The vector of a head to about 90 bits.
  [[nodiscard]] Vector2<DoubleDouble> fine(std::size_t index) const {
    return fine_head_vector(corner, head[index].kind);
  }
};

class CutterGroups : public CornerGroups<CutterGroups, CutterGroup> {
 public:
  explicit CutterGroups(const CornerParameters& parameters) : CornerGroups(parameters) {}

 private:
  friend CornerGroups;
  static bool starts_with_normal() { return true; }
  static bool cancels_with_normal() { return true; }

  static double cross(const Corner& corner) { return corner.turn.c; }
  static double along(const Corner& corner) { return corner.turn.k; }
  static const Corner& in_plane(const CutterGroup& group) { return group.corner; }
  static void set_vector(const Corner& corner, HeadKind kind, Vector2<double>& vector) {
    vector = head_vector(corner, kind);
  }
  static bool meet(const Corner& corner, HeadKind kind, Vector2<double>& vector) {
    return offset_paths_meet(corner, kind, vector);
  }
  static bool is_under_one_degree(const Corner& corner);
  // Within the limit in both axes.
  [[nodiscard]] bool is_small_movement(const CutterGroup& group, std::size_t a, std::size_t b) const;
};

}  // namespace toolcomp::fast

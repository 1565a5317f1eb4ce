// SPDX-License-Identifier: Apache-2.0
// The rules of cutter compensation B: the vector at the end of a block, and the arc on which the tool goes there. Plane
// coordinates, setup units.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "model/fanuc/cutter_compensation/cutter_block.h"

namespace toolcomp::model {

// The way of the tool on an arc from head to head, each counted from the centre.
struct HeadArc {
  std::optional<Real> sweep;                    // degrees; absent where a head lies in the centre
  std::optional<std::pair<Real, Real>> radius;  // at start and end, where they differ
  bool one_head = false;                        // the heads are one
};

// What G39 does.
struct CornerArcOfB {
  PlanePoint vector;  // from there on
  spec::ArcDirection direction = spec::ArcDirection::cw;
  HeadArc way;
  bool moves = true;
};

// How G40 takes the vector away.
enum class Removal : std::uint8_t {
  none,
  in_own_move,
  alone  // without an axis word: in the move of the length offset, or one of its own
};

// What each kind of block makes of the vector in force. Clauses: fanuc.cutter-b.*, fanuc.cutter.side.
class CutterBRules {
 public:
  explicit CutterBRules(Recorder& recorder) : recorder_(recorder) {}

  // At the end of a straight block; nothing where the vector in force is kept.
  [[nodiscard]] std::optional<PlanePoint> at_end_of_line(const CutterBlock& block) const;
  // At the end of an arc. Throws Alarm PS0038.
  [[nodiscard]] PlanePoint at_end_of_arc(const CutterBlock& block) const;
  [[nodiscard]] HeadArc head_to_head(spec::ArcDirection direction, const PlanePoint& from, const PlanePoint& to) const;
  // `started`: the start-up is made.
  [[nodiscard]] Removal removal(const CutterBlock& block, bool started, const PlanePoint& vector) const;
  [[nodiscard]] CornerArcOfB corner_arc(const CutterBlock& block, const PlanePoint& before) const;

 private:
  // The offset value to the left of the path, with its sign.
  [[nodiscard]] Rational to_the_left(const CutterBlock& block) const;

  Recorder& recorder_;
};

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
// The choice between the computed angles of a direction, and the ranges of the rotary axes (type 2, I J K).
#pragma once

#include <array>
#include <optional>

#include "model/basis/recorder.h"
#include "model/kinematics/inverse.h"
#include "model/kinematics/machine.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Parameters 19741-19744 and 19608#5. Clauses: fanuc.tool-center-point.choice*, .range*.
class PairChoice {
 public:
  PairChoice(const spec::Setup& setup, const Machine& machine, Recorder& recorder);

  // For the block in which type 2 starts. Throws the alarm PS5459 where a lower limit is above its upper limit.
  void require_ranges() const;
  // Both axes of the pose are in their ranges.
  [[nodiscard]] bool inside(const Pose& pose) const;
  // Throws the alarm PS5459 where they are not.
  void require_inside(const Pose& pose) const;

  // The pair that the rules take from `present` for a direction in the table frame, or of its pairs, whole turns
  // included; its branch with it. `has_it`: the present pose is known to have that direction, or where negative the
  // opposite one; then one of the pairs is made of it as it is, so that an axis is known to stand, or to turn by just
  // half a turn. Throws the alarm PS5459 where the direction is out of reach or
  // no pair is in range.
  [[nodiscard]] Solution choose(const Direction& direction, const Pose& present) const;
  [[nodiscard]] Solution choose(Solutions solutions, const Pose& present, Sign has_it) const;

 private:
  // Limits of one rotary axis, inclusive; degrees.
  struct Range {
    Rational lower;
    Rational upper;
  };
  // One axis as the rules see it.
  struct Axis {
    Angle Pose::* position;
    std::optional<Range> range;
    Clause move{};       // its step by moving angles
    Clause near_zero{};  // its step by nearness to 0
  };
  // Where an axis may go for one computed angle: the nearest position in its range, or the two equally near; none where
  // it has none in range.
  struct Targets {
    std::array<Angle, 2> at;
    std::size_t count = 0;
    Angle move;         // the moving angle, not negative
    bool open = false;  // the whole turns could not be decided: the first position, and cosines alone
  };
  struct Candidate {
    Solution solution;
    std::array<Targets, 2> targets;  // of the axis judged first, of the other
  };

  static std::optional<Range> range(const spec::Setup& setup, std::uint32_t upper);
  [[nodiscard]] bool within(const Axis& axis, const Angle& position) const;
  [[nodiscard]] Targets targets(const Axis& axis, const Angle& angle, const Angle& present) const;
  // The same; of an axis without a range open where exact::Undecided.
  [[nodiscard]] Targets targets_or_open(const Axis& axis, const Angle& angle, const Angle& present) const;
  // The other way round, where that is equally far.
  void add_other_way(const Axis& axis, const Angle& present, Targets& targets) const;
  // Puts a pose of the direction in place of the pair of its branch, and what is its pair then where that is plain.
  void put(const Pose& pose, Solutions& solutions) const;
  // Of the direction that the present pose has, or where negative of the opposite one, if that is plain.
  void put_present(const Pose& present, Sign has_it, Solutions& solutions) const;
  [[nodiscard]] Targets standing(const Axis& axis, const Angle& present) const;
  // The two computed angles of the tool-side axis, and all of its whole turns, lie alike on both sides of `about`,
  // whatever the direction: a singular position, or an edge of reach.
  [[nodiscard]] bool are_alike(const Axis& axis, const Angle& about) const;
  // Negative: the first of two candidates moves less.
  [[nodiscard]] Sign compare_moves(const Axis& axis, const Targets& a, const Targets& b, const Angle& present) const;
  [[nodiscard]] Sign compare_nearness(const Axis& axis, const Targets& a, const Targets& b) const;
  // The position taken of them; throws exact::Undecided where they are open.
  [[nodiscard]] const Angle& greatest(const Targets& targets) const;
  [[nodiscard]] bool takes_second(const Candidate& a, const Candidate& b, const Pose& present) const;

  const Machine& machine_;
  Recorder& recorder_;
  bool reversed_;
  std::array<Axis, 2> axes_;  // in the order in which they are judged
};

}  // namespace toolcomp::model

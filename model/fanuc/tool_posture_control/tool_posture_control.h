// SPDX-License-Identifier: Apache-2.0
// Tool posture control: what a block with P1 does to the tool and the rotary axes. Vectors are in the programming
// frame.
#pragma once

#include <optional>
#include <vector>

#include "model/basis/recorder.h"
#include "model/fanuc/tool_posture_control/arc_view.h"
#include "model/fanuc/tool_posture_control/great_circle_motion.h"
#include "model/fanuc/tool_posture_control/lift.h"
#include "model/fanuc/tool_posture_control/rules.h"
#include "model/kinematics/control_frame.h"
#include "model/kinematics/pair_choice.h"
#include "model/kinematics/posture_motion.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// A block before its posture is found.
struct PostureBlock {
  Pose start;
  Direction from;
  Direction to;
  std::optional<Pose> commanded;        // type 1: the end pair, which has the direction `to`
  std::optional<Vector> leaned_toward;  // a travel toward which `to` is `from` leaned
};

// What it does.
struct PosturePlan {
  Pose start;  // of its own move; elsewhere than where the axes stand: behind a pre-turn
  bool pre_turn = false;
  Pose end;                       // of its own move
  Direction tool;                 // there
  bool changed = false;           // it is not the one commanded
  std::optional<Pose> post_turn;  // where the axes turn afterwards
  bool branch_differs = false;    // the warning posture-branch
  SharedMotion motion;
};

// Clauses: fanuc.tool-posture.*.
class ToolPostureControl {
 public:
  // Parameters 19738, 19739, 19696#3.
  ToolPostureControl(const spec::Setup& setup, const Machine& machine, const PairChoice& choice, Recorder& recorder);

  // Posture control can follow directions on this machine.
  [[nodiscard]] bool is_possible() const { return lift_.is_possible(); }

  // With P1. Throws Alarm PS5459 or PS5421.
  [[nodiscard]] PosturePlan plan(const SharedFrame& frame, const PostureBlock& block) const;
  // With P0, and where there is no plane. Throws Alarm PS5459.
  [[nodiscard]] PosturePlan conventional(const SharedFrame& frame, const PostureBlock& block) const;
  // The rotary axes stand.
  [[nodiscard]] static PosturePlan stand(const SharedFrame& frame, const PostureBlock& block);

 private:
  // A block in the making.
  struct Found {
    const SharedFrame& frame;
    const PostureBlock& block;
    ArcView view;  // of the arc
    GreatCircle arc;
    AxisPassed work_axis;
    Solutions solutions;  // type 2: the pairs of the end
  };

  // The directions of a block as its arc is looked at.
  struct Ends {
    ArcView view;
    Direction from;
    Direction to;
  };
  [[nodiscard]] static Ends ends(const SharedFrame& frame, const PostureBlock& block);
  // `commanded`: the pose of that direction, where poses are commanded (type 1).
  [[nodiscard]] const Pole* pole_along(Clause clause, const Found& found, const Direction& direction,
                                       const Pose* commanded) const;

  [[nodiscard]] PosturePlan from_pole(const Found& found, const Pole& pole) const;
  [[nodiscard]] PosturePlan to_pole(const Found& found, const LiftStart& start, const Pole& pole) const;
  [[nodiscard]] PosturePlan along(const Found& found, const LiftStart& start, const Passing& passed) const;
  // The direction of a changed end.
  [[nodiscard]] Direction mirrored(const Found& found, const Pose& end) const;
  // An end changed so that the block passes the singular posture that it comes near to; nothing where it stays.
  [[nodiscard]] std::optional<PosturePlan> changed(const Found& found, const LiftStart& start, const Way& way,
                                                   const Pose& end) const;
  [[nodiscard]] PosturePlan give_way(const Found& found, const Pose& end) const;
  [[nodiscard]] Solution pair(const SharedFrame& frame, const PostureBlock& block) const;
  [[nodiscard]] LiftStart lift_start(const Found& found) const;
  [[nodiscard]] SharedMotion motion(const Found& found, const BranchPart& part, int side,
                                    const std::optional<Crossing>& crossing, const Pose& end) const;

  const Machine& machine_;
  const PairChoice& choice_;
  Recorder& recorder_;
  Lift lift_;
  PostureRules rules_;
};

}  // namespace toolcomp::model

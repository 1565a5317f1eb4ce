// SPDX-License-Identifier: Apache-2.0
// Tool posture control: what a block with P1 does to the tool and the rotary axes. Vectors are in the programming
// frame.
#pragma once

#include <optional>

#include "model/basis/recorder.h"
#include "model/fanuc/tool_posture_control/motions.h"
#include "model/fanuc/tool_posture_control/rules.h"
#include "model/kinematics/control_frame.h"
#include "model/kinematics/pair_choice.h"
#include "model/kinematics/tool_pose.h"
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

// What it does, the length of the tool apart.
struct PosturePlan : OwnMotion {
  Pose start;            // of its own move; elsewhere than where the axes stand: behind a pre-turn
  Pose end;              // of its own move
  Direction tool;        // there
  bool changed = false;  // it is not the one commanded
};

// Both axes run evenly from pose to pose; where these are the same, they stand. `tool`: at the end.
PosturePlan even_plan(const SharedFrame& frame, const Pose& start, const Pose& end, const Direction& tool);

// Clauses: fanuc.tool-posture.*.
class ToolPostureControl {
 public:
  // Parameters 19738, 19739, 19696#3.
  ToolPostureControl(const spec::Setup& setup, const Machine& machine, const PairChoice& choice, Recorder& recorder)
      : choice_(choice), recorder_(recorder), rules_(setup, machine, recorder) {}

  // With P1. Throws Alarm PS5459 or PS5421.
  [[nodiscard]] PosturePlan plan(const SharedFrame& frame, const PostureBlock& block) const;
  // With P0, and where there is no plane. Throws Alarm PS5459.
  [[nodiscard]] PosturePlan conventional(const SharedFrame& frame, const PostureBlock& block) const;

 private:
  struct InPlane;
  [[nodiscard]] Solution pair(const SharedFrame& frame, const PostureBlock& block) const;

  const PairChoice& choice_;
  Recorder& recorder_;
  PostureRules rules_;
};

}  // namespace toolcomp::model

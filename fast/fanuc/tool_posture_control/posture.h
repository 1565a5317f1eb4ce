// SPDX-License-Identifier: Apache-2.0
// The motion of the tool in one block of tool center point control: P0
// (fanuc.tool-center-point.conventional) and P1 (fanuc.tool-posture.*).
#pragma once

#include <array>
#include <cstdint>

#include "fast/basis/alarm.h"
#include "fast/fanuc/tool_posture_control/posture_arc.h"
#include "fast/fanuc/tool_posture_control/posture_motion.h"
#include "fast/kinematics/machine.h"

namespace toolcomp::fast {

// What a block does with the rotary axes and the tool.
struct PosturePlan {
  enum class Outcome : std::uint8_t {
    good,
    unreachable,  // PS5459
    refused,      // PS5421: the change at a singular posture was refused, and NPC = 1
  };
  Outcome outcome = Outcome::good;
  bool branch_warning = false;  // `posture-branch`, before the block's move
  bool changed = false;         // type 2: the end was changed to pass a singular posture
  bool pre_turn = false;        // an own event from the block's start pose to `turned`, before the move
  bool post_turn = false;       // an own event from `arrived` to `end`, after the move
  Pose turned;                  // with pre_turn: the pose in which the block's own move starts
  Pose arrived;                 // with post_turn: the pose in which it ends
  Pose end;                     // what the next block starts from
  PostureMotion motion;         // between
};

// What ends the run by a plan.
inline Alarm alarm_of(PosturePlan::Outcome outcome) {
  switch (outcome) {
    case PosturePlan::Outcome::unreachable:
      return AlarmCause::unreachable;
    case PosturePlan::Outcome::refused:
      return AlarmCause::singular_posture;
    case PosturePlan::Outcome::good:
      break;
  }
  return AlarmCause::none;
}

// Plans blocks; keeps nothing between them. The machine is frozen in the mode.
class ToolPostureControl {
 public:
  // Reads 19604#0, 19696#3, 19738, 19739.
  ToolPostureControl(const spec::Setup& setup, const Machine& machine);

  [[nodiscard]] bool by_default() const { return by_default_; }  // 19604#0: P1 where P is not given

  // Type 1: to the commanded pose, which may be plan.end. `posture`: P1. `plan` may not hold `start`.
  void plan(const Pose& start, const Pose& commanded, bool posture, PosturePlan& plan) const;
  // Type 2: to the direction `tool` (programming coordinate system, after Q).
  void plan(const Pose& start, const Direction& tool, bool posture, PosturePlan& plan) const;
  // A block in which nothing turns.
  void stand(const Pose& start, PosturePlan& plan) const;

 private:
  // The end of a block: the pose commanded (type 1) or the direction (type 2).
  struct Target {
    const Pose* pose = nullptr;
    const Direction* tool = nullptr;
  };
  static void begin(PosturePlan& plan);
  [[nodiscard]] int branch_toward(const Pose& from, const Pose& to) const;
  [[nodiscard]] static bool stays(const Pose& start, const Direction& tool);
  void conventional(const Pose& start, const Pose& end, PosturePlan& plan) const;
  // posture_in_doubles.cpp: what plan_finely() would plan. False where doubles cannot tell.
  [[nodiscard]] bool plan_in_doubles(const Pose& start, const Target& target, PosturePlan& plan) const;
  void set_motion_in_doubles(const Pose& start, int azimuth, PosturePlan& plan) const;
  void plan_finely(const Pose& start, const Target& target, PosturePlan& plan) const;

  // Cases of plan_finely.
  struct FineArc;
  void from_singular(const FineArc& arc, PosturePlan& plan) const;
  void to_singular(const FineArc& arc, PosturePlan& plan) const;
  void along(const FineArc& arc, PosturePlan& plan) const;
  [[nodiscard]] bool change_end(const FineArc& arc, int pole, PosturePlan& plan) const;
  void mismatch(const FineArc& arc, PosturePlan& plan) const;
  [[nodiscard]] bool ends_in_range(const Pose& pose) const {
    return machine_.in_range(pose, 0) && machine_.in_range(pose, 1);
  }

  const Machine& machine_;
  bool by_default_ = false;
  bool refusal_alarms_ = false;  // NPC, 19696#3
  NearLimit near_;               // 19738
  Count veto_;                   // 19739
};

}  // namespace toolcomp::fast

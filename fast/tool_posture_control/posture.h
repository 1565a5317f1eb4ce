// The motion of the tool inside one block of tool center point control: P0 and P1 (posture sheet 6 to 9).
#pragma once

#include <array>
#include <cstdint>

#include "fast/kinematics/machine.h"
#include "fast/tool_posture_control/posture_motion.h"

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
  bool pre_turn = false;        // an own event from the block's start pose to `turned`, before the move
  bool post_turn = false;       // an own event from `arrived` to `end`, after the move
  Pose turned;                  // with pre_turn: the pose in which the block's own move starts
  Pose arrived;                 // with post_turn: the pose in which it ends
  Pose end;                     // what the next block starts from
  PostureMotion motion;         // between
};

// Plans blocks; keeps nothing between them. The machine must be frozen in the mode.
class ToolPostureControl {
 public:
  // Reads 19604#0, 19696#3, 19738, 19739.
  ToolPostureControl(const spec::Setup& setup, const Machine& machine);

  [[nodiscard]] bool by_default() const { return by_default_; }  // 19604#0: P1 where P is not given

  // Type 1: to the commanded pose. `posture`: P1.
  void plan(const Pose& start, const Pose& commanded, bool posture, PosturePlan& plan) const;
  // Type 2: to the direction `tool` (programming coordinate system, after Q).
  void plan(const Pose& start, const Direction& tool, bool posture, PosturePlan& plan) const;
  // A block in which nothing turns.
  void stand(const Pose& start, PosturePlan& plan) const;

 private:
  const Machine& machine_;
  bool by_default_ = false;
};

}  // namespace toolcomp::fast

// The tool direction in force: of the rotary axes, or of I J K under G43.5.
#pragma once

#include "model/kinematics/tool_direction.h"
#include "model/program/interpreter.h"
#include "model/recorder.h"
#include "model/tool_length_offset/tool_length_offset.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Follows G43.5 from its block to the G49 that ends it. Clauses: fanuc.tool-direction.*.
class ProgramDirection {
 public:
  // The direction in force first is that of the start pose. Throws spec::InputError for parameters that make no sense.
  ProgramDirection(const spec::Setup& setup, Recorder& recorder, const Position& start)
      : kinematics_(setup), recorder_(recorder), axes_(setup.axes), direction_(of_pose(start)) {}

  // What a block means under G43.5.
  struct Marks {
    bool starts = false;       // the G43.5 block
    bool ends = false;         // G49 that ends it
    bool tip_control = false;  // in force in this block
  };
  // The other compensations in space, before and after the block.
  struct Compensated {
    bool edge = false;  // the leading edge offset is on before or after it
    bool side_before = false;
    bool side_after = false;  // tool side compensation is on
  };
  // Throws the alarms of G43.5.
  Marks read(const Command& command, const ToolLengthOffset& length, const Compensated& compensated,
             const Numbers& numbers);

  // The direction in force before the block.
  [[nodiscard]] const Direction& now() const { return direction_; }
  // At the end of a leg of the block, from which on it is in force.
  const Direction& at(const Command& command, const Marks& marks, const Position& end, const Numbers& numbers);
  // After a block outside G43.5: the direction follows the programmed position also where only its zero has changed.
  void follow(const Position& position) { direction_ = of_pose(position); }

 private:
  void restrict(const Command& command, const ToolLengthOffset& length, const Compensated& compensated,
                const Marks& marks, const Numbers& numbers);
  [[nodiscard]] bool has_rotary_word(const Command& command) const;
  [[nodiscard]] const Direction& of_pose(const Position& position);

  Kinematics kinematics_;
  Recorder& recorder_;
  spec::Axes axes_;
  std::optional<Position> pose_;  // of pose_direction_
  Direction pose_direction_;
  Direction direction_;  // made by of_pose: declared behind what that needs
};

}  // namespace toolcomp::model

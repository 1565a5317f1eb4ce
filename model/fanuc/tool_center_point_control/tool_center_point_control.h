// SPDX-License-Identifier: Apache-2.0
// Tool center point control: G43.4 (type 1) and G43.5 (type 2) from their block to the G49 that ends them. It finds the
// tool and the rotary axes at the end of every block, before any compensation moves the tip.
#pragma once

#include <optional>

#include "model/basis/recorder.h"
#include "model/fanuc/passes/passes.h"
#include "model/fanuc/program/interpreter.h"
#include "model/fanuc/tool_length_offset/tool_length_offset.h"
#include "model/fanuc/tool_posture_control/tool_posture_control.h"
#include "model/kinematics/machine.h"
#include "model/kinematics/pair_choice.h"
#include "model/kinematics/tool_direction.h"
#include "model/kinematics/tool_pose.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// What a block means to tool center point control.
struct TipMarks {
  bool starts = false;       // the block of G43.4 or G43.5
  bool again = false;        // under the one or the other
  bool ends = false;         // G49 that ends it
  bool takes_back = false;   // and moves the axes by what ends (tip_control_cancel)
  bool tip_control = false;  // in force in this block
  bool directed = false;     // and of type 2: I J K are a direction
};

// The tool at the end of a move.
struct ToolAtEnd {
  Direction tool;               // as events report it
  std::optional<ToolPose> tip;  // under tool center point control
};

// What a block does to the tool.
struct TurnedBlock {
  ToolAtEnd end;                    // of its own move, before a post-turn
  std::optional<OwnMotion> motion;  // of a block run under tool center point control
};

// Clauses: fanuc.tool-center-point.*, fanuc.tool-posture.word, default, word-value.
class ToolCenterPointControl {
 public:
  // Outside the mode the direction follows the rotary axes. `interpreter`: of the program, with its positions and what
  // they mean at any time. `with_motion`: positions inside blocks will be asked for. Throws spec::InputError for
  // parameters that make no sense.
  ToolCenterPointControl(const spec::Setup& setup, Recorder& recorder, Interpreter& interpreter, bool with_motion);

  // The words of a block. `passes` tell which compensation is on. Throws the alarms of the mode that words alone raise.
  TipMarks read(const Command& command, const ToolLengthOffset& length, const Passes& passes);

  // The block ends the mode, or starts it again: what is called the position of the tool is renamed. `standing`: where
  // the last block has ended, with the shift left by G45 to G48.
  void rename_position(const TipMarks& marks, const Leg& standing);

  // The end of the block's leg, with the offset of the H number in force there: rotary positions are filled in, behind
  // a post-turn. Throws the alarms of a pose that cannot be.
  TurnedBlock turn(const Command& command, const TipMarks& marks, const Rational& offset, Leg& leg);
  // The tool where the last block has ended.
  [[nodiscard]] ToolAtEnd standing() const { return {tool_, tip_}; }

  // Outside the mode, at the end of a leg; from there on it is in force.
  ToolAtEnd at(const Position& end);
  // After a block outside the mode: where programmed coordinates turn the tool (rotary_angles) the direction follows
  // them also where only their zero has changed.
  void follow(const Position& position);

 private:
  // words.cpp
  void restrict_mode(const Command& command, const ToolLengthOffset& length, const TipMarks& marks) const;
  void restrict_start(const Command& command, const TipMarks& marks);
  void restrict_compensation(const Command& command, const TipMarks& marks, const Passes& passes) const;
  void restrict_words(const Command& command, const TipMarks& marks, const Passes& passes) const;
  void restrict_arc(const Command& command, const TipMarks& marks) const;
  void read_posture_word(const Command& command);
  [[nodiscard]] bool has_axis_word(const Command& command, bool (*is_of)(char)) const;

  // rules.cpp
  //
  // What the lean of a leg is toward: its travel; of an arc the tangent at its end, of any length.
  [[nodiscard]] Vector lean_travel(const Leg& leg) const;
  // The direction leaned by Q towards that, or the direction itself where it lies along it.
  [[nodiscard]] Direction leaned(const Direction& tool, const Leg& leg) const;
  // With 19696#5 = 1 on a machine with a table axis, an arc to a pose. Throws Alarm PS5421 or ARC_WITH_TABLE_TURNED.
  void require_table_still(spec::Plane plane, const Pose& end) const;

  void start(const Command& command, const TipMarks& marks, Leg& leg);
  // What the block is asked to turn the tool to; nothing where it stands.
  [[nodiscard]] std::optional<Direction> direction_asked(const Command& command, const Leg& leg);
  TurnedBlock turn_directly(const Command& command, const Leg& leg);
  TurnedBlock turn_axes(const Command& command, const TipMarks& marks, Leg& leg);
  // Type 1 and type 2: what the block does to the axes.
  [[nodiscard]] PosturePlan commanded(const Leg& leg) const;
  [[nodiscard]] PosturePlan directed(const Command& command, const Leg& leg);
  [[nodiscard]] PosturePlan plan(const PostureBlock& block) const;
  // With 19696#5 = 1 on a machine with a table axis.
  void keep_tip_on_table(bool tip_alone, const Pose& end, Leg& leg);

  [[nodiscard]] const Direction& of_pose(const Position& position);
  // The positions with the angles of the axes that turn tool and table in their place.
  [[nodiscard]] Position angles(const Position& position) const;
  // Where one of them has a zero in force.
  void decide_angles() const;

  Recorder& recorder_;
  Interpreter& interpreter_;
  spec::Axes axes_;
  bool by_machine_;    // rotary_angles
  bool cancel_moves_;  // tip_control_cancel
  Kinematics kinematics_;
  std::optional<Machine> machine_;  // none: 19680 = 0
  std::optional<PairChoice> choice_;
  std::optional<ToolPostureControl> posture_;
  Rational holder_offset_;   // 19666
  bool posture_by_default_;  // 19604#0, TPC
  bool with_motion_;

  std::optional<Position> pose_;  // the angles of pose_direction_
  Direction pose_direction_;
  Direction tool_;  // in force, as events report it; made by of_pose: declared behind what that needs

  // The mode.
  bool with_posture_ = false;    // P1
  Rational lean_;                // Q, degrees
  std::optional<ToolPose> tip_;  // at the end of the last block
  Direction now_;                // the tool there, in the frame
  Direction kept_;               // what a block without I J K keeps
  // The last block leaned `tool` toward `travel` and came to `to`.
  struct Lean {
    Vector tool;
    Vector travel;
    Direction to;
  };
  std::optional<Lean> last_lean_;   // of this G43.5
  std::optional<Vector> standing_;  // the tip on the table while it stands there, in the frame
};

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
// How the tool stands: by the rotary axes, by I J K, and under tool center point control.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "fast/basis/alarm.h"
#include "fast/basis/event.h"
#include "fast/fanuc/control/axes.h"
#include "fast/fanuc/control/axis_positions.h"
#include "fast/fanuc/control/modal_state.h"
#include "fast/fanuc/control/tool_directions.h"
#include "fast/fanuc/control/word_units.h"
#include "fast/fanuc/program/words.h"
#include "fast/fanuc/tool_center_point_control/tool_center_point_control.h"
#include "fast/fanuc/tool_posture_control/posture.h"
#include "fast/kinematics/kinematics.h"
#include "fast/kinematics/machine.h"

namespace toolcomp::fast {

// Owns the machine and the stages that plan and complete moves of tool center point control. Under G43.4 and G43.5 it
// also makes positions: those of the rotary axes, and of a tip that keeps its place on the table.
class ToolAttitude {
 public:
  // Throws spec::InputError for a machine no control could have. Moves completed go to `sink`.
  ToolAttitude(const spec::Setup& setup, Kinematics& kinematics, const ControlAxes& axes, const WordUnits& units,
               const ModalState& modal, AxisPositions& positions, EventSink& sink, std::uint32_t samples);

  [[nodiscard]] ToolDirections& directions() { return tool_; }
  [[nodiscard]] const ToolDirections& directions() const { return tool_; }
  [[nodiscard]] const Machine& machine() const { return machine_; }
  [[nodiscard]] ToolCenterPointControl& tip() { return tip_; }
  [[nodiscard]] const ToolCenterPointControl& tip() const { return tip_; }

  // The rotary axes stand at their programmed positions.
  void turn();
  // The zeros of machine coordinates have changed: where those count, they turn tool and table.
  void take_zeros();
  // I J K are not all zero, or none is there.
  [[nodiscard]] static bool names_direction(const Words& words) {
    if (!words.has_any(Words::set_of("IJK"))) return true;
    const auto some = [&](char letter) { return words.has(letter) && !words[letter].is_zero(); };
    return some('I') || some('J') || some('K');
  }
  // A block under G43.5 without kinematics: I J K, or the direction in force.
  void direct(const Words& words);

  // The length L along the tool, under G43.4 or G43.5: the offset of the H number and the tool holder offset.
  void take_length() { along_length_ = tool_length().nearest(); }
  [[nodiscard]] double along_length() const { return along_length_; }

  // Under G43.4 or G43.5 on a machine with kinematics, and under G43.5 without where Q leans the tool: positions of a
  // block are placed by place().
  [[nodiscard]] bool plans_tool() const { return plans_tool_; }
  // The block to come starts it.
  [[nodiscard]] bool starts() const { return starts_tip_; }
  // Whether the own move of the block to come is run in the mode, and sampled.
  void set_sampled(bool sampled) { samples_block_ = sampled; }
  // The words of a block with G43.4 or G43.5. Nothing is held then.
  void begin(const Words& words);
  // Moves go to tip(), which completes them.
  [[nodiscard]] bool completes_moves() const { return tip_.active() || tip_.samples(); }
  // The positions of these axes, the direction of the tool, and what follows from it for the rotary axes.
  [[nodiscard]] Alarm place(const Words& words, Mask axes);
  // G49: the programmed position becomes that of the axes. `again`, by another G43.4 or G43.5: that of the tip, and so
  // it does where cancel_moves().
  void end(bool again);
  // The G49 that ends the mode moves the axes to the programmed position.
  [[nodiscard]] bool cancel_moves() const { return cancel_moves_; }

  // tool_axis of a move at the programmed positions, and what the length along the tool makes of it. Where the setup or
  // the program defines a direction.
  void fill(Event& event);

 private:
  using RotaryPositions = std::array<Count, 2>;  // of the 1st and 2nd rotary axis, where they are there

  // tool_attitude.cpp
  // The direction of the I J K of a block.
  void read_direction(const Words& words, Direction& direction) const;
  // The same of usual words, in place; false, and nothing done, for any other (read_words.h).
  [[nodiscard]] bool read_usual_direction(const Words& words, Direction& direction) const;
  [[nodiscard]] Count tool_length() const { return positions_.length().length() + machine_.holder_offset(); }
  void take_position_along_tool();
  void end_by_vector_alone(bool again);
  void add_length(Event& event) const;
  [[nodiscard]] std::uint32_t tag_direction();

  // tip_control.cpp: on a machine with kinematics.
  [[nodiscard]] Alarm start(const Words& words);
  [[nodiscard]] Alarm plan_posture(const Words& words, Mask axes, const std::array<Count, 3>& from,
                                   const RotaryPositions& before);
  // The pose at the programmed positions, as the plan of a block by rotary words looks at it.
  void pose_commanded(Pose& pose) {
    if (posture_control_)
      machine_.pose(positions_.programmed(), rounded_angles(), pose);
    else
      machine_.attitude(positions_.programmed(), rounded_angles(), pose);
  }
  [[nodiscard]] Alarm plan_direction(const Words& words, const std::array<Count, 3>& from, TipBlock& block);
  [[nodiscard]] bool asks_direction(const Words& words, const std::array<Count, 3>& from);
  // Of a block that asks for a direction: the one commanded or kept, under Q leaned where it can be.
  [[nodiscard]] const Direction& leaned(const Words& words, const std::array<Count, 3>& from);
  [[nodiscard]] bool lean(const Words& words, const std::array<Count, 3>& from, Direction& to_direction) const;
  [[nodiscard]] Alarm check_workpiece_arc(const RotaryPositions& before, const Pose& start) const;
  void keep_tip_on_table(Mask axes, const Pose& start, const Pose& end, const std::array<Count, 3>& from);
  void take_posture(const Pose& pose);
  [[nodiscard]] bool stands_as_before() const;
  void end_tip_control(bool again);
  [[nodiscard]] Vector3<DoubleDouble> fine_origin() const;
  // Axes whose angles, programmed positions and their zeros, are rounded.
  [[nodiscard]] Mask rounded_angles() const {
    return machine_angles_ ? static_cast<Mask>(positions_.rounded() | positions_.rounded_zeros())
                           : positions_.rounded();
  }

  Kinematics& kinematics_;
  const ControlAxes& axes_;
  const WordUnits& units_;
  const ModalState& modal_;
  AxisPositions& positions_;
  Machine machine_;
  ToolPostureControl posture_;
  ToolCenterPointControl tip_;
  bool machine_angles_;  // rotary_angles: machine coordinates turn tool and table
  bool cancel_moves_;    // tip_control_cancel
  ToolDirections tool_;
  double along_length_ = 0;

  bool plans_tool_ = false;
  bool starts_tip_ = false;
  bool samples_block_ = true;
  bool posture_control_ = false;  // P1
  Count lean_angle_;              // Q
  Direction commanded_;           // the direction kept, without the lean
  Direction leaned_;              // and with it
  // Where a head stood, and its rotary positions, as another G43.4 or G43.5 ended the mode of I J K.
  std::optional<Pose> standing_;
  std::array<Count, 2> standing_at_;
  Positions frozen_;            // of the rotary axes where the mode began
  bool has_table_tip_ = false;  // WKP = 1: the tip has kept its place on the table since table_tip_
  Vector3<DoubleDouble> table_tip_;
};

// The direction of the tool, and under G43.5 without kinematics its length along it.
[[gnu::always_inline]] inline void ToolAttitude::fill(Event& event) {
  const Eigen::Vector3d& unit = tool_.now().unit;
  event.tool_axis.emplace(std::array<double, 3>{unit[0] + 0.0, unit[1] + 0.0, unit[2] + 0.0});  // never -0
  if (tip_.active()) {
    event.t_numerator = tip_.tag();
    return;
  }
  if (!positions_.along_tool()) return;
  positions_.fill_machine(event);
  if (tip_.samples()) [[unlikely]]
    event.t_numerator = tag_direction();
  if (along_length_ != 0) add_length(event);
}

}  // namespace toolcomp::fast

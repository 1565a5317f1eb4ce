// SPDX-License-Identifier: Apache-2.0
// Cutter compensation B or C as a stage: what its words say, and what it is told about each block.
#pragma once

#include <array>

#include "fast/fanuc/control/stage.h"
#include "fast/fanuc/cutter_compensation_b/cutter_compensation_b.h"
#include "fast/fanuc/cutter_compensation_c/cutter_compensation_c.h"

namespace toolcomp::fast {

// Compensation: CutterCompensationB or CutterCompensationC.
template <class Compensation>
class CutterStage final : public Stage {
 public:
  // Throws spec::InputError for parameters no control could have.
  CutterStage(const spec::Setup& setup, Control& control, EventSink& sink)
      : Stage(control, false), compensation_(setup, sink) {}

  void release() override;
  [[nodiscard]] Alarm plain_block(const Words& words) override;
  [[nodiscard]] std::size_t lines(const LineChunk& chunk) override;
  void read(const Words& words, const Command& command) override;
  [[nodiscard]] bool is_built(const Words& words) const override;
  [[nodiscard]] Alarm check(const Words& words, const Command& command) const override;
  [[nodiscard]] bool makes_arc(const Words& words) const override;
  [[nodiscard]] bool judges_arc_about_start() const override;
  [[nodiscard]] Alarm take(const Words& words, Command& command) override;
  [[nodiscard]] Alarm move(const Words& words, const OwnMove& own) override;
  [[nodiscard]] Alarm shift(const Words& words, const OwnMove& own) override;
  [[nodiscard]] Alarm leave_path(CutterMotion motion, spec::Cause cause, bool with_machine) override;
  void begin_leg(const Words& words) override { begin_leg(words, CutterSide::unchanged, false); }
  void retire() override;
  void rename() override;

 private:
  // Compensation is wanted, or its vector is not removed yet (clause fanuc.cutter.on).
  [[nodiscard]] bool is_on() const;
  // G41 or G42 is in force after the codes of the block.
  [[nodiscard]] bool in_force_after(const Words& words) const;
  // What the words command, for the alarms of B and C.
  [[nodiscard]] CutterCommand command_of(const Words& words, Code motion, spec::Plane plane) const;
  // Whether the axis words in `axes` name the position at which the axes stand, or in G91 no travel.
  [[nodiscard]] bool stays(const Words& words, unsigned axes) const;
  // Everything about a move but where it ends. The second move of G28 or G29 commands nothing of its own.
  void begin_leg(const Words& words, CutterSide word, bool d_word);
  void read_direction(const Words& words, CutterBlock& block) const;
  // G39 with axis words and without I J K: the words are a direction, from the current point.
  [[nodiscard]] Alarm corner_direction(const Words& words, CutterBlock& block) const;
  // Of plain_block(): the alarms and the path of an arc, and blocks whose arc or place the control has to work out.
  [[nodiscard]] Alarm check_plain_arc(const Words& words) const;
  [[nodiscard]] Alarm take_arc(const Words& words, CutterBlock& block);
  [[nodiscard]] Alarm plan_and_move(const Words& words);
  // The alarms of an arc from block.start to block.end, in their order, its words and its centre. Sweep and radii are
  // left to the stage.
  [[nodiscard]] Alarm read_arc(const Words& words, CutterBlock& block, std::array<double, 2>& center) const;
  // The alarm of a block whose words could not be placed: those of its arc come first.
  [[nodiscard]] Alarm refuse(const Words& words, CutterBlock& block, Alarm placed);
  void set_arc_event(CutterBlock& block, const std::array<double, 2>& center);
  // To the end of the block.
  void send(CutterBlock& block);
  void pass();
  void pass_alone(const CutterBlock& block);

  Compensation compensation_;
  CutterSide side_ = CutterSide::off;  // G40 G41 G42 in force
  bool stops_ = false;                 // the block stops the look-ahead
};

}  // namespace toolcomp::fast

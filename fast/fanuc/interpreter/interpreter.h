// SPDX-License-Identifier: Apache-2.0
// Interprets blocks: the way of a block through the parts of the control and the stages of compensation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "fast/basis/alarm.h"
#include "fast/basis/event.h"
#include "fast/fanuc/canned_cycle/canned_cycle.h"
#include "fast/fanuc/control/control.h"
#include "fast/fanuc/control/stage.h"
#include "fast/fanuc/program/words.h"
#include "fast/fanuc/tool_length_measurement/tool_length_measurement.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

class Interpreter {
 public:
  // Refers to control and stages. Throws spec::InputError for a setup the control could not have.
  Interpreter(const spec::Setup& setup, Control& control, const Stages& stages, EventSink& sink);

  void block(const spec::Block& block);
  // Lines after the last block, as arrays: how many of them have been taken, as block() would have.
  [[nodiscard]] std::size_t lines(const LineChunk& chunk);
  void end();

 private:
  // interpreter.cpp: one block, step by step.
  // Any but a plain one.
  [[gnu::noinline]] void other_block(const Words& words);
  // A block without commands: its words change nothing but positions, feed and the code of group 01, and nothing waits
  // for a block to come.
  [[nodiscard]] Alarm plain_block(const Words& words, Stage* stage);
  // A block with commands, first checked; then everything is allowed but what depends on positions (arcs) and on the
  // length offset, whose alarms come last.
  [[nodiscard]] Alarm block_with_commands(const Words& words);
  // Whether such a block may wake a stage that rests.
  [[nodiscard]] bool wakes_stages(const Words& words) const;
  [[nodiscard]] Alarm apply(const Words& words, Command& command);
  void take_codes(const Words& words, const Command& command);
  // Whether a block outside the drilling mode moves by G01, G02 or G03 with words of its own; `motion`: the code of
  // group 01 then.
  [[nodiscard]] static bool cuts(const Words& words, Code motion) {
    if (motion == kG00 || (words.code(Words::kOneShot) != kNone && !words.is_tool_offset())) return false;
    return words.axes() != 0 || (motion > kG01 && words.has_any(Words::set_of("IJKR")));
  }
  // The F in force after a block with codes is none, or 0.
  [[nodiscard]] bool lacks_feed(const Words& words) const;
  [[nodiscard]] Alarm take_arc(const Words& words, BlockArc& arc) const;
  [[nodiscard]] Alarm take_length(const Words& words, const Command& command, bool& extra);
  [[nodiscard]] bool shift_system();
  // The moves of a block; `stage`: they go through it.
  [[nodiscard]] Alarm move(const Words& words, const Command& command, Stage* stage, const OwnMove& own);
  // Without any stage; without `own` the words move nothing.
  [[nodiscard]] Alarm uncompensated(const Words& words, bool own, bool extra,
                                    const std::optional<spec::Arc<double>>& arc);
  // The same of a block under G02 or G03.
  [[nodiscard, gnu::noinline]] Alarm uncompensated_arc(const Words& words);
  void set_feed(const Words& words) { control_.modal.set_feed(control_.units.feed(words['F'])); }
  void send_to(EventSink& sink);
  void raise(Alarm alarm, const char* more = nullptr);
  // The run ends undecided at the block, which is absent from the path.
  void leave_open(const char* clause);
  // Everything a stage holds goes out; true if that ended the run.
  [[nodiscard]] bool release_held();

  // lines.cpp: lines for which no stage is on.
  [[nodiscard]] std::size_t uncompensated_lines(const LineChunk& chunk);
  // The axes its words name; 0: it has other words, or an offset of many places or digits.
  [[nodiscard]] Mask axes_of(const LineChunk& chunk) const;

  // check.cpp: the alarms of commands, in their order.
  [[nodiscard]] Alarm check(const Words& words, Command& command) const;
  void read_command(const Words& words, Command& command) const;
  // The words as stages see a block in the drilling mode, which names no axis for them; of another block, nothing.
  [[nodiscard]] static std::optional<Words> for_stages(const Words& words, const Command& command);
  [[nodiscard]] Alarm check_measurement(const Words& words) const;
  [[nodiscard]] Alarm check_offset_write(const Words& words, std::uint32_t list, Command& command) const;
  [[nodiscard]] static bool names_origin(const Words& words, std::uint32_t list);
  [[nodiscard]] std::uint32_t reference_point(const Words& words) const;
  // Of a block in the drilling mode; where it is left undecided none, and the clause in the command.
  [[nodiscard]] Alarm check_cycle(const Words& words, Command& command) const;
  // check_tip_control.cpp
  [[nodiscard]] Alarm check_tip_control(const Words& words, const Command& command) const;
  [[nodiscard]] Alarm check_tip_control_start(const Words& words, const Command& command, bool in_space) const;
  // Of the words that move, under G43.4 or G43.5. `stage`: the one that is on in space, or nullptr.
  [[nodiscard]] Alarm check_tip_move(const Words& words, Code motion, bool vector, const Stage* stage) const;

  // canned_cycles.cpp: blocks that drill. `extra`: one with K0 moves by a change of its length offset.
  [[nodiscard]] Alarm drill(const Words& words, const CycleCommand& command, Stage* stage, bool extra);
  [[nodiscard]] Alarm send_holes(const Words& words, const CycleCommand& command);
  // The position range of so many holes, each `travel` further.
  [[nodiscard]] Alarm check_holes(Mask axes, const Positions& travel, std::uint32_t holes) const;
  // What is the same of all holes of a block; POSITION_RANGE.
  [[nodiscard]] Alarm begin_hole(Event& event, std::size_t axis, const HoleLevels& levels) const;
  // Where the axes stand behind it.
  void fill_hole(Event& event) const;

  // machine_moves.cpp: G53, G28, G30, G30.1, G29, G54 to G59, G54.1, G10 L2 L20.
  [[nodiscard]] Alarm to_machine_position(const Words& words, Stage* stage);
  [[nodiscard]] Alarm to_reference(const Words& words, Stage* stage);
  [[nodiscard]] Alarm from_reference(const Words& words, Stage* stage);
  // The next rapid move, named `motion` to the stage.
  [[nodiscard]] Alarm send_rapid(Stage* stage, spec::Cause cause, bool with_machine, CutterMotion motion);
  void select_workpiece(std::size_t system);
  void write_origins(const Words& words);

  // one_shot_moves.cpp: G45 to G48, G37.
  struct Shifts {  // what G45 to G48 add to the shift of the axes of the block
    Mask axes = 0;
    Positions by;
  };
  [[nodiscard]] Alarm plan_tool_offset(const Words& words, BlockArc& arc, Shifts& shifts) const;
  [[nodiscard]] Alarm shift_axes(const Shifts& shifts);
  [[nodiscard]] Alarm measure(const Words& words, Stage* stage);
  [[nodiscard]] Alarm send_measuring_move(std::size_t axis, const Count& to, double commanded, bool measuring);

  Control& control_;
  bool is_30i_;
  const Stages& stages_;
  std::span<const std::unique_ptr<Stage>> asked_;  // to which a block with commands is shown: all of them, or none
  ToolLengthMeasurement measurement_;
  CannedCycle cycle_;
  bool shifts_system_;  // 5006#6, TOS
  EventSink& sink_;
  EventSink* moves_;  // where uncompensated moves go
  Event move_;        // the next one
  // Behind the last block with commands: the stage that was on, and whether all of them rest.
  Stage* on_ = nullptr;
  bool rest_ = true;
};

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
// A stage of compensation: a section whose vectors need other blocks, or that inserts moves. The interpreter knows it
// by this interface only.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fast/arrays/line_chunk.h"
#include "fast/basis/alarm.h"
#include "fast/basis/event.h"
#include "fast/fanuc/control/control.h"
#include "fast/fanuc/program/cutter_block.h"
#include "fast/fanuc/program/cycle_command.h"
#include "fast/fanuc/program/words.h"

namespace toolcomp::fast {

// What the words of a block command, before anything is changed.
struct Command {
  Code motion = kG00;       // group 01 after the block
  bool along = false;       // G43.4 or G43.5 is in force after the block
  bool vector = false;      // and it is G43.5
  bool ends_along = false;  // the one in force before is ended, by G49 or by another
  bool taken = false;       // a stage before in the list takes the moves of the block
  bool writes = false;      // G10, and its event is still to be sent
  OffsetMemory::Write write;
  CycleCommand cycle;
  const char* undecided = nullptr;  // the clause that leaves open what the block does
};

// What the move of a block has besides words. `extra`: it moves without axis words too.
struct OwnMove {
  Code one_shot = kNone;
  bool extra = false;
  const BlockArc& arc;
};

// Of the stages one at most is on. It gets every block without commands (plain_block). A block with commands is shown
// to all of them: read() and check() before anything is changed, take() behind that; its moves go to the first one that
// takes_moves(), by move() and the like. While all rests(), only blocks are shown that may wake one. An alarm that is
// returned is one of the block; an end of the run by a block that is held goes to Control::end().
class Stage {
 public:
  Stage(Control& control, bool in_space) : control_(control), in_space_(in_space) {}
  virtual ~Stage() = default;
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  // Its vectors are in space, along or across the tool; others are in the plane.
  [[nodiscard]] bool in_space() const { return in_space_; }
  // Where the moves go from here on; nothing is held. Asked for stages in space only.
  virtual void set_sink(EventSink& /*sink*/) {}
  // Between blocks: a vector is made or held, or its code is in force.
  [[nodiscard]] bool on() const { return on_; }
  // No further block is known: everything held goes out.
  virtual void release() = 0;

  // --- blocks without commands ---
  // Positions, F and a code of group 01 (taken already), or nothing but a number; with their alarms.
  [[nodiscard]] virtual Alarm plain_block(const Words& words) = 0;

  // Lines after the last block, as arrays: how many of them have been taken, as plain_block() would have. Asked where
  // Control::awaits_lines().
  [[nodiscard]] virtual std::size_t lines(const LineChunk& /*chunk*/) { return 0; }

  // --- blocks with commands ---
  // What the words of a block say to it.
  virtual void read(const Words& words, const Command& command) = 0;
  // Of the block read: its vectors are on before it, and on after it.
  [[nodiscard]] bool on_before() const { return on_before_; }
  [[nodiscard]] bool on_after() const { return on_after_; }
  // The block read concerns it.
  [[nodiscard]] bool concerned() const { return concerned_; }
  // It is off, and the last block shown did not concern it: only one with a code of compensation, a number, or a code
  // of group 00 but G37 and G45 to G48 may.
  [[nodiscard]] bool rests() const { return !(on_ || concerned_ || on_before_ || on_after_ || takes_moves_); }
  // A use of its codes that is not built.
  [[nodiscard]] virtual bool is_built(const Words& /*words*/) const { return true; }
  // The alarms of its words; where it is concerned.
  [[nodiscard]] virtual Alarm check(const Words& words, const Command& command) const = 0;
  // The alarm of a rotary word under G43.5 where it is on.
  [[nodiscard]] virtual Alarm rotary_word() const { return AlarmCause::tool_direction; }
  // It makes sweep and radii of arcs, for the tool.
  [[nodiscard]] virtual bool makes_arc(const Words& /*words*/) const { return false; }
  // It judges arcs about their start.
  [[nodiscard]] virtual bool judges_arc_about_start() const { return false; }
  // What it sends for the block is no own move of it.
  [[nodiscard]] virtual bool replaces_move(bool /*extra*/) const { return false; }
  // Its codes and values come into force; lengths and numbers have. A G10 whose event it sends itself it takes from the
  // command.
  [[nodiscard]] virtual Alarm take(const Words& words, Command& command) = 0;
  [[nodiscard]] bool takes_moves() const { return takes_moves_; }
  // The block's own move.
  [[nodiscard]] virtual Alarm move(const Words& words, const OwnMove& own) = 0;
  // G52 or G92, and its own move.
  [[nodiscard]] virtual Alarm shift(const Words& words, const OwnMove& own) {
    if (const Alarm a = move(words, own)) return a;
    return control_.shift_coordinates(words);
  }
  // The moves of G53, G28, G30 and G29, positions placed; begin_leg() before a second one.
  [[nodiscard]] virtual Alarm leave_path(CutterMotion /*motion*/, spec::Cause /*cause*/, bool /*with_machine*/) {
    return AlarmCause::forbidden_in_compensation;
  }
  virtual void begin_leg(const Words& /*words*/) {}
  // The block goes its own way: the stage learns of its codes alone. G37, holes.
  virtual void retire() {}
  // The workpiece system has changed.
  virtual void rename() {}

 protected:
  Control& control_;  // NOLINT(misc-non-private-member-variables-in-classes): what every stage works on
  void set_on(bool on) { on_ = on; }
  void set_read(bool concerned, bool before, bool after) {
    concerned_ = concerned;
    on_before_ = before;
    on_after_ = after;
  }
  void set_takes_moves(bool takes) { takes_moves_ = takes; }

 private:
  bool in_space_;
  bool on_ = false;
  bool concerned_ = false;
  bool on_before_ = false;
  bool on_after_ = false;
  bool takes_moves_ = false;
};

// In the order in which they are asked.
using Stages = std::vector<std::unique_ptr<Stage>>;

}  // namespace toolcomp::fast

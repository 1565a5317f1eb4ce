// SPDX-License-Identifier: Apache-2.0
// The look-ahead of a compensation that makes vectors at corners.
//
//   hold       A block that makes a vector at its end is held. Those behind it that make none wait with it, and count.
//   meet       A block that moves at the corner of a block held makes the group of vectors there: the one held is
//              released. One that does not move there counts; to a limit, which ends it without a corner.
//              Where an earlier one still waits, the corner is known, and made when its turn comes.
//   release    The block is checked between the group at its start and that at its end, which may drop vectors of both.
//              With that the group at its start is final, and what waited for it goes out; the block itself, now with
//              its first head, waits for the group at its end, and the blocks behind it with it.
//   between    Where blocks between run at the first head nothing of them depends on the others: nothing waits.
//   stand      A lone start and G39 have one vector, made with the block that follows; they go out with it.
//   end        Without such a block what is held goes out with the vectors that the section gives it alone.
//   alarm      One of geometry names the block held; what waits goes out as it is.
//
// Inserted moves lead from head to head of a group: up to the stop point they belong to the block that ends there,
// those behind it to the next one that takes them (docs/events.md, rule 3).
//
// A section says which block is what, gives the groups (in X Y Z), and sees its blocks between them by their HeldPath.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "model/fanuc/corner/corner_block.h"
#include "model/fanuc/corner/held.h"
#include "model/fanuc/corner/interference.h"
#include "model/fanuc/program/stage.h"

namespace toolcomp::model {

// How many blocks are read at a time in the mode, the one before a corner included: No. 19625 of the 30i, else 3.
// Throws spec::InputError for another number. Clauses: fanuc.cutter-c.two-non-motion-blocks,
// fanuc.tool-side.look-ahead.
int blocks_read(const spec::Setup& setup);

enum class CornerMode : std::uint8_t {
  off,
  waiting,  // a code in force, and no start-up block yet
  on,
  leaving  // cancelled in a block that does not move: the vector waits for its removal
};

// What the look-ahead asks a section.
class CornerSection {
 public:
  CornerSection() = default;
  CornerSection(const CornerSection&) = delete;
  CornerSection& operator=(const CornerSection&) = delete;
  virtual ~CornerSection() = default;

  // The group at the end of a block held that moves and has no corner there.
  virtual SpaceGroup without_corner(const Held& held) = 0;
  // The first of those held stands by itself, and no block comes that it can be made with.
  virtual void end_standing(Clause why) = 0;
  // A moving block has been released; its group is the one at hand.
  virtual void released(const Held& held) = 0;
};

// How a block that is taken meets the corners at the ends of those held.
struct Meeting {
  std::vector<bool> moves;  // whether it moves there, in order
  int counts = 1;           // where it does not
  Clause too_many{};        // by which a block ends without a corner where those behind it count to the limit
  // The group there; of a block that stands the one vector. It may be asked later, so it keeps what it needs.
  std::function<SpaceGroup(Held& held, std::size_t corner)> group;
};

// Takes steps whose words are a CornerBlock. Clauses: fanuc.cutter-c.interference-*,
// fanuc.cutter-c.direction-change-at-start-up.
class LookAhead {
 public:
  enum class Between : std::uint8_t { at_first_head, at_last_head };
  // Where a block between two that make a corner runs, the clause that says that there is one, and the one by which
  // blocks end where no next one makes a corner with them.
  struct Rules {
    Between between{};
    Clause one_between{};
    Clause no_next_block{};
    int limit = 2;  // a block ends without a corner where those behind it that do not move count so many
    // What parameters change of the interference check; none: they do not concern the section.
    struct Interference {
      bool keeps_vectors = false;  // the first pair that interferes is the last one
      bool no_alarm = false;       // where the tool goes against the programmed direction
    };
    std::optional<Interference> interference{};
  };

  LookAhead(const Stage::Place& place, CornerSection& section, const Rules& rules);

  CornerMode mode = CornerMode::off;
  [[nodiscard]] int limit() const { return rules_.limit; }
  // There is a vector, or a block that makes one.
  [[nodiscard]] bool in_mode() const { return mode == CornerMode::on || mode == CornerMode::leaving; }

  // In order, and the first one.
  [[nodiscard]] const std::deque<Held>& held() const { return held_; }
  [[nodiscard]] bool holds(Held::Kind kind) const { return !held_.empty() && held_.front().kind == kind; }
  // Where the tool is: at the first head of the group; the others are corner moves yet to come.
  [[nodiscard]] const SpaceGroup& here() const { return here_; }
  // Of the last block that moved anywhere, or of a lone start.
  [[nodiscard]] const CutterOffset& last_offset() const { return last_; }

  // The offset of a block that moves. `meets_first`: it moves at the end of the first of those held. Throws Alarm
  // DIR_CHANGE_AT_STARTUP.
  [[nodiscard]] CutterOffset next_offset(const Step& now, bool meets_first) const;

  void hold(Step& now, Held::Kind kind, const CutterOffset& offset, std::shared_ptr<const HeldPath> path,
            bool checked = true);
  void meet(Step& now, const Meeting& meeting);
  // The first of those held, which stands, goes out with this vector, or with the one that is there.
  void pass(SpaceGroup at);
  void pass() { pass(here_); }
  // No next block: what is held goes out; before a step that makes no corner with it, by what that step says.
  void end() { end(rules_.no_next_block); }
  void end_before(Step& now) { end_before(now, rules_.no_next_block); }
  void end_before(Step& now, Clause why);
  // What is held is a block that moves. It ends where it is programmed to, unchecked for interference, because of `now`
  // (clause `why`).
  void end_without_vector(Step& now, Clause why);
  // The same behind a step that has been taken.
  void end_behind(Clause why);

  // Makes no vector: runs with the last one, behind what is held.
  void keep(Step& now);
  // The block that runs next, or the last one kept, made a corner and makes no vector: from there on the last vector is
  // one of no corner.
  void leave_corner();
  // A block of the mode has moved, and made no vector at its end.
  void moved(const CutterOffset& offset);
  // The vector is another one from here on, without a move; the mode goes on, and no start is at hand.
  void set_vector(SpaceVector vector);
  // The block's own move takes the vector away; the mode is off.
  void take_away(Step& now);
  // A cancel in a block that does not move: the vector goes with it, by a move of its own if it has none, or with the
  // next block that moves. `has_vector`: there is one; else it is gone at once.
  void cancel_alone(Step& now, bool has_vector, bool at_once);

  // Before the step's own move, with its feed.
  void insert_corner_moves(Step& step);
  void emit(Step& step);

  // Names the first of those held. `crossing`: of Alarm.
  [[noreturn]] void raise_held(Clause clause, AlarmCause cause, Real crossing = {});
  // The blocks before go out as if this one were absent.
  [[noreturn]] void leave_open_at(Step& now, Clause clause, const char* message);

 private:
  [[nodiscard]] const CornerBlock& said(const Step& step) const;
  // The move of a block that an alarm of geometry names.
  [[nodiscard]] std::shared_ptr<const Event> unmade(const Step& step) const;
  void end(Clause why);
  void end_first(Clause why);
  // The first of those held, and those behind it, as far as their corners are known.
  void release_met();
  void release(SpaceGroup at_end);
  // What the interference check leaves of a block.
  Passage check(const Held& held, SpaceGroup& at_end, ToolArcRun* run);
  // The blocks that waited for the vectors at their end go out.
  void flush();
  void run(Step& step);
  void move_to_last_head(Step& step);
  [[nodiscard]] Move corner_move(const Move& own) const;

  Recorder& recorder_;
  std::size_t slot_;
  Stage::Output output_;
  CornerSection& section_;
  spec::Axes axes_;
  Rules rules_;
  bool checks_;  // 5008#0, CNI, is 0

  std::deque<Held> held_;
  SpaceGroup here_;
  std::vector<Step> waiting_;   // the block that ends at this corner and those behind it, until the group is final
  Move corner_;                 // where they end, for corner moves
  CutterOffset last_;           // of the last block that moved anywhere, or of a lone start
  std::optional<int> started_;  // its side, where that was a start and no block has moved behind it
};

}  // namespace toolcomp::model

// Cutter compensation C: G40, G41, G42 and G39. One stage with a look-ahead of one moving block and one other.
//
// A block that moves in the plane is held until the next one is known: the two make the group of vectors at the corner
// between them, the block goes out with it, and the next one is held. Everything else decides when the block held goes
// out without a next one.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/fanuc/corner/vector_group.h"
#include "model/fanuc/cutter_compensation/cutter_compensation.h"
#include "model/fanuc/cutter_compensation_c/block_path.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Clauses: fanuc.cutter-c.*.
class CutterCompensationC : public CutterCompensation {
 public:
  explicit CutterCompensationC(const Place& place);

  [[nodiscard]] int look_ahead() const override { return 2; }
  [[nodiscard]] bool on() const override { return state_ != State::off; }
  // In the mode: it is then an arc without a sweep, and PS0038.
  [[nodiscard]] bool takes_arc_about_its_start(const Command& command) const override { return on_after(command); }
  void take(const Step& step) override;
  void finish() override;

 private:
  enum class State : std::uint8_t {
    off,
    waiting,  // G41 or G42 in force, and no start-up block yet
    on,
    leaving  // after a lone G40 or number 0: the vector waits for its removal
  };

  // The block whose end depends on the next moving one.
  struct Held {
    enum class Kind : std::uint8_t {
      start_up,
      moving,      // a block of the offset mode
      lone_start,  // G41 or G42 of SUV = 1
      corner_arc   // G39 without a direction
    };
    Kind kind = Kind::moving;
    Step step;
    CutterOffset offset;  // in force at its end; of G39 that of the moving block before
    OffsetPath path;      // of the first two kinds
    bool checked = true;  // for interference
  };

  // cutter_compensation_c.cpp: which block is what, and what is held goes out.
  [[nodiscard]] bool wanted(CutterSide side, std::uint32_t number) const override;
  using CutterCompensation::wanted;
  void check(const CutterBlock& words) const override;
  void take_while_off(Step& now, bool wanted, bool moves);
  void take_while_on(Step& now, bool wanted, bool moves);
  void take_without_motion(Step& now);
  void check_corner_arc(const CutterBlock& words) const;
  void start_up(Step& now);
  // The block behind a lone G41 of SUV = 1; true if that block still needs its place.
  bool take_behind_lone_start(Step& now, bool wanted, bool moves);
  void start_alone(Step& now);
  void drop_lone_start();
  void cancel_alone(Step& now);
  // No next block: what is held goes out, a moving block with P1.
  void end_without_corner(Clause why);
  // The same before a step that makes no corner with it.
  void end_before(Step& now);
  // The clauses applied so far belong to this step; those from here on to the block held.
  void decide_held(Step& now);

  // moving.cpp: blocks that move in the plane.
  void take_moving(Step& now);
  void take_cancel(Step& now);
  // The offset of a block of the offset mode. Throws Alarm DIR_CHANGE_AT_STARTUP.
  [[nodiscard]] CutterOffset next_offset(const CutterBlock& block);
  // What is held goes out with its corner to the block now taken.
  void make_corner(Step& now, const OffsetPath& path, const CutterOffset& offset);
  [[nodiscard]] VectorGroup group_before(const OffsetPath& next, const CutterOffset& offset);
  [[nodiscard]] VectorGroup group_before_cancel(const CutterBlock& block, const OffsetPath& next);
  void run_lone_start(const OffsetPath& next);
  void hold(Step& now, Held::Kind kind, const CutterOffset& offset, OffsetPath path);
  // The block held goes out, from `here_` to the first head of `at_end`, and those behind it.
  void release(VectorGroup at_end);

  // machine_moves.cpp: G53, G28, G30, G29.
  void take_machine_move(Step& now, bool wanted);
  void take_reference_with_intersection(Step& now);
  void leave_vector(const CutterBlock& block);

  // corner_arc.cpp: G39.
  void take_corner_arc(Step& now);
  void run_corner_arc(Step& arc, const Heading& to, bool next_is_square);

  // emission.cpp: steps with their moves.
  void emit_at_head(Step& step);
  void emit_without_vector(Step& step);
  // The step of a code that makes or removes the vector without motion in the plane.
  void emit_change_alone(Step& step, spec::Cause cause, bool changes);
  void insert_corner_moves(Step& step);
  [[nodiscard]] Vector in_space_of(const Step& step, const PlanePoint& vector) const;
  // The step is of no use afterwards.
  void send(Step& step);
  [[noreturn]] void raise_held(Clause clause, spec::Name number, const char* message);
  [[noreturn]] void leave_open_at(Step& now, Clause clause, const char* message);

  CornerRules rules_;
  spec::Axes axes_;
  bool at_once_;         // 5003#1, SUV
  bool keeps_the_mode_;  // 5003#2, CCN
  bool checks_;          // 5008#0, CNI, is 0

  State state_ = State::off;
  std::optional<Held> held_;
  std::vector<Step> between_;  // blocks without motion behind it
  int count_ = 0;              // what they count
  bool repeated_ = false;      // G41 or G42 repeated in one of them, or in the block now taken

  // Where the tool is: at the first head of the group; the other heads are corner moves of the next moving block.
  VectorGroup here_;
  Heading here_heading_;                 // square to this, where the vector can be that of G39
  bool made_by_move_ = false;            // the vector was made by a moving block
  CutterOffset last_;                    // of the last moving block, or of a lone start
  std::optional<CutterOffset> started_;  // the last moving block was a start-up, or a lone start stands there
  bool unchecked_ = false;               // the next moving block is not checked for interference
  Move place_;                           // where the last step ended
};

}  // namespace toolcomp::model

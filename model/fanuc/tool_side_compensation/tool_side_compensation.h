// Tool side compensation: G41.2 G42.2, under G43.5 G41.6 G42.6, and G40. One stage with a look-ahead of two blocks.
//
// A block that moves in the plane at its own end is held until the next one that moves in that plane is known: the two
// make the group of vectors at the corner between them. It goes out, with the corner moves that belong to it, once the
// block that starts there has been checked for interference, which may drop vectors of that corner.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "model/fanuc/corner/interference.h"
#include "model/fanuc/program/cutter_offset.h"
#include "model/fanuc/program/stage.h"
#include "model/fanuc/tool_side_compensation/plane_change.h"
#include "model/fanuc/tool_side_compensation/side_rules.h"
#include "model/fanuc/tool_side_compensation/tool_side_block.h"
#include "model/fanuc/tool_side_compensation/tool_side_words.h"

namespace toolcomp::model {

// Hands on every move with its compensation vector (Move::offset), the moves that belong to a block but are inserted
// beside its own, arcs as the tool runs them. Clauses: fanuc.tool-side.*, and those of fanuc.cutter-c.* that they name;
// on(), on_after(): fanuc.tool-side.on.
class ToolSideCompensation : public StageOf<ToolSideBlock> {
 public:
  // Throws spec::InputError for a parameter that makes no sense.
  explicit ToolSideCompensation(const Place& place);

  [[nodiscard]] Extent extent() const override { return Extent::space; }
  [[nodiscard]] int look_ahead() const override { return 4; }
  [[nodiscard]] bool on() const override { return state_ != State::off; }
  [[nodiscard]] bool on_after(const Command& command) const override { return words_.wanted(command); }
  // Throws Alarm PS5460.
  void refuse_rotary_word(const Command& command) const override;
  // From the first G41.2, G42.2, G41.6 or G42.6 of a program on. Throws Alarm TOOL_SIDE_MODE, PS0037,
  // FORBIDDEN_IN_3D_COMPENSATION, Q_FORMAT, TYPE_C_FORMAT, PS0034 or PS0029.
  std::shared_ptr<StageWords> read(const StageCommand& now) override;
  void take(const Step& step) override;
  void finish() override;

 private:
  enum class State : std::uint8_t {
    off,
    waiting,  // a code in force, and no start-up block yet
    on,
    leaving  // after G40 or number 0 without movement: the vector waits for its removal
  };

  // A block whose end depends on those behind it.
  struct Held {
    enum class Kind : std::uint8_t {
      start_up,   // of types A and B
      moving,     // a block of the mode
      lone_start  // of type C
    };
    Kind kind = Kind::moving;
    Step step;
    CutterOffset offset;      // in force at its end
    CompensationPlane plane;  // at its end
    SidePath path;
    SideEnd end;
    Rational offset_at_start;  // signed, to the left
    PathEnd start;             // of an arc: as seen in the plane of the corner there, else in its own
    // Behind it, as its own corner sees them.
    int without_movement = 0;   // blocks that do not move in `plane`
    bool repeated = false;      // the code repeated in one of them, or in the block now taken
    std::vector<Step> keeping;  // of these blocks, those that make no vector at their own end
  };

  // How a block moves: asked at each corner by itself (fanuc.tool-side.moving-block).
  struct Movement {
    SidePath path;
    CompensationPlane own;  // at its end
    // How it leaves the corners at the ends of the blocks held, in order; nothing where it does not move in the plane
    // there. Of an arc once the tool's view of it is known.
    std::vector<std::optional<SideEnd>> starts;
    std::optional<SideEnd> end;  // how it reaches its own end; nothing where it does not move in the plane there

    [[nodiscard]] bool moves_behind() const;
    [[nodiscard]] bool moves() const { return end || moves_behind(); }
  };

  // tool_side_compensation.cpp: which block is what, and what is held goes out.
  void check(const ToolSideBlock& words) const;
  void forbid(const ToolSideBlock& words) const;
  void check_type_c(const ToolSideBlock& words, bool starts, bool cancels) const;
  void take_while_off(Step& now, bool wanted, Movement& movement);
  void take_while_on(Step& now, bool wanted, Movement& movement);
  void start_up(Step& now, Movement& movement);
  void start_alone(Step& now);
  void cancel_alone(Step& now, bool cuts_corner);
  // No next block: the first of those held goes out, or all of them, a moving block with r n1.
  void end_first_without_corner(Clause why);
  void end_without_corner(Clause why);
  // The same before a step that makes no corner with it.
  void end_before(Step& now, Clause why);

  // moving.cpp: blocks of the mode, and the corners between them.
  [[nodiscard]] Movement movement_of(const Step& now) const;
  [[nodiscard]] bool crosses_tool(const CompensationPlane& plane, const SideEnd& line) const;
  void take_in_mode(Step& now, Movement& movement);
  void look_at_movement(Step& now, Movement& movement, const CutterOffset& offset);
  void check_side_behind_start(const Movement& movement, const CutterOffset& offset) const;
  void meet_corners(Step& now, const Movement& movement, const CutterOffset& offset);
  void take_cancel(Step& now, Movement& movement);
  void meet_corners_before_cancel(Step& now, Movement& movement);
  void look_at_arc(Step& now, Movement& movement);
  [[nodiscard]] int sense(const Direction& tool, spec::Plane plane) const;
  [[nodiscard]] bool leans(const Direction& tool, spec::Plane plane) const;
  void make_corner(const Step& now, const Movement& movement, const SideEnd& start, const CutterOffset& offset);
  [[nodiscard]] SideGroup group_before(const Step& now, const Movement& movement, const SideEnd& start,
                                       const CutterOffset& offset);
  [[nodiscard]] SideGroup group_before_cancel(const SideEnd& start);
  [[nodiscard]] bool may_drop(const SideGroup& group, const SidePath& next) const;
  void run_lone_start(const SideEnd& start);
  void keep_vector(Step& now, bool cuts_corner);
  void hold(Step& now, Held::Kind kind, const CutterOffset& offset, const Movement& movement);

  // passage.cpp: a block between the vectors at its start and its end.
  void release(SideGroup at_end);
  Passage remove_interference(const Held& held, SideGroup& at_end, ToolArcRun* run);
  [[nodiscard]] bool line_interferes(const Held& held, const Vector& from, const Vector& to) const;
  [[nodiscard]] HeadPair pair_of(const Held& held, const SideVector& to) const;
  [[nodiscard]] static CornerVector head(const SideArc& arc, const CompensationPlane& plane, const SideVector& vector);
  void flush();
  void insert_corner_moves(Step& step);
  void emit(Step& step);
  void emit_at_head(Step& step);
  void emit_change_alone(Step& step, spec::Cause cause, bool changes);
  // The clauses applied so far belong to this step; those from here on to the first of the blocks held.
  void decide_held(Step& now);
  [[noreturn]] void raise_held(Clause clause, spec::Name number, const char* message);
  [[noreturn]] void leave_open_at(Step& now, Clause clause, const char* message);

  ToolSideWords words_;
  SideRules rules_;
  PlaneChangeCheck plane_change_;
  spec::Axes axes_;
  Rational limit_;  // 19630, setup units
  bool type_c_;     // 5003#1, SUV
  bool checks_;     // 5008#0, CNI, is 0

  State state_ = State::off;
  std::deque<Held> held_;  // at most two, between blocks

  // Where the tool is: at the first head of the group; the others are corner moves yet to come.
  SideGroup here_;
  CompensationPlane here_plane_;  // in which the group was made
  std::vector<Step> waiting_;     // the block that ends at this corner and those behind it, until the group is final
  Move corner_;                   // the end of the block before the corner, for corner moves
  CutterOffset last_;             // of the last block that moved anywhere, or of a lone start
  std::optional<int> started_;    // its side, where that was a start and no block has moved behind it
  Direction before_;              // tool at the end of the block before
};

}  // namespace toolcomp::model

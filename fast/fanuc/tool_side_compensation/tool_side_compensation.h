// SPDX-License-Identifier: Apache-2.0
// Tool side compensation G41.2 G42.2, under G43.5 G41.6 G42.6 (clauses fanuc.tool-side): a stage that holds blocks
// until the vectors at both their ends are known.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "fast/basis/alarm.h"
#include "fast/basis/event.h"
#include "fast/fanuc/control/event_in_space.h"
#include "fast/fanuc/corner/corner_queue.h"
#include "fast/fanuc/corner/usual_paths.h"
#include "fast/fanuc/tool_side_compensation/side_group.h"
#include "fast/fanuc/tool_side_compensation/side_interference.h"
#include "fast/fanuc/tool_side_compensation/side_line_arrays.h"
#include "fast/fanuc/tool_side_compensation/tool_side_block.h"
#include "fast/kinematics/kinematics.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// A corner of two lines as doubles see it: u and w are what is seen along the tool of the movements before and behind
// it.
struct LineCorner {
  double square = 0;   // of the movement behind it
  double product = 0;  // u . w
  double length1 = 0;  // |u|
  double length2 = 0;  // |w|
};

// Look-ahead: a block that moves at its own end, one block after it that does not move in the plane there, and the next
// one. The one in between may move at its own end: it then waits, as a path of its own, until the one before it is out.
// Before the path, where the corner at its start has several vectors, one block that keeps the last of them.
class ToolSideCompensation : public CornerQueue<ToolSideCompensation, ToolSideBlock, SidePath, SideGroup>,
                             public UsualPathLender {
 public:
  // Throws spec::InputError for parameters no control could have.
  ToolSideCompensation(const spec::Setup& setup, const Kinematics& kinematics, EventSink& sink);
  ToolSideCompensation(const ToolSideCompensation&) = delete;
  ToolSideCompensation& operator=(const ToolSideCompensation&) = delete;

  // A vector is made or held, or waits for its removal. While it is not active and a block does not want compensation,
  // blocks pass without this stage.
  [[nodiscard]] bool active() const { return mode_ != Mode::off; }
  [[nodiscard]] StartType type() const { return parameters_.type; }

  // The value of the number in force, without its sign, from next() on.
  void set_value(const Count& value) {
    value_ = {value, value.nearest()};
    ++value_change_;
  }
  // How next() moves.
  [[nodiscard]] SidePath& next_path() { return paths_[after(path_)]; }
  [[nodiscard]] Travel& next_travel() { return next_path().travel; }
  // Takes next(). An answer with an alarm or a typed undecided ends the run; what goes before it has been sent.
  StageEnd block();

  // The usual line, the short cut of block() (usual_line.h): behind a line another one, one vector at both ends of the
  // former. Asked behind block(): whether take_line() may take the next block, and those behind it, as long as they
  // want compensation and nothing changes but where the tool is and how it stands.
  [[nodiscard]] bool awaits_line() const { return line_.awaited; }
  // `plain`: point, axes and machine of the lines to come would be `programmed` in X, Y and Z. They need not be filled
  // in.
  void await_lines(bool plain) {
    line_.plain = plain;
    line_.filled = 0;
    // What block() holds is filled in, whatever the lines to come will be.
    if (!line_.taken) line_.held_plain = false;
  }
  // What is the same in the events of all these lines is in next().event; the first time it answers false.
  [[nodiscard]] bool is_line_filled() {
    const unsigned slot = 1U << next_;
    const bool filled = (line_.filled & slot) != 0;
    line_.filled |= slot;
    return filled;
  }
  // A line that moves by `way` (10^-6 of a setup unit, whole numbers), in two steps. Where one answers false nothing is
  // done: it is for block(), or doubles cannot tell. In between is a while for other work, as the roots are long in
  // coming: the event of next() is to be filled in. `tool`: as in a block.
  [[nodiscard]] bool see_line(const Vector3<double>& way, LineCorner& corner) const;
  [[nodiscard]] bool take_line(const Vector3<double>& way, const LineCorner& corner, const Direction& tool);

  // The same for many lines (side_line_arrays.h): from where, whether now, and how they ended: the line before the last
  // one, unless only one has been taken, and the last one, whose event is in next().
  [[nodiscard]] SideLineStart lines_start() const;
  [[nodiscard]] bool holds_plain_line() const { return line_.taken && line_.held_plain && line_.plain && count_ == 1; }
  struct TakenLine {
    Vector3<double> way;
    const Direction& tool;
  };
  void set_lines(const TakenLine* before_last, const TakenLine& last, const Vector3<double>& vector);
  // Of the event that is held.
  [[nodiscard]] const Event& held_event() { return held(0).event; }

  // Usual lines and arcs (corner/usual_paths.h), with the tool along the normal of the selected plane. Asked behind
  // block(): whether the path that is held may be lent.
  [[nodiscard]] bool awaits_paths() const { return awaits_paths_; }
  [[nodiscard]] bool lend(UsualLoan& loan) override;
  void take_back(const UsualReturn& usual) override;

  // No further block is known: one that raises an alarm of its own or stops the look-ahead, or the end of the program.
  StageEnd release();

 private:
  // What the machine asks for.
  friend CornerQueue;
  static constexpr bool kUpToStop = true;
  static bool is_arc(const ToolSideBlock& block) { return block.arc; }
  static bool repeats(const ToolSideBlock& block) { return block.repeated; }
  void set_path(SidePath& to, const ToolSideBlock& block);
  void hold_path(const SidePath& to, bool starts_up);
  void set_corner(SideGroup& group, const SidePath* second, CornerRule rule) const;
  [[nodiscard]] Alarm make_corner(SideGroup& group, const SidePath& to, CornerRule rule) const;
  void set_tool_arc(spec::Arc<double>& arc) { fast::set_tool_arc(arc, make_, *last_, at_start(), at_end()); }
  [[nodiscard]] Interference check_interference(const std::optional<double>& sweep) {
    return fast::check_interference(make_, *last_, start_of_path_, sweep, at_start(), at_end());
  }
  void add(Event& event, const Vector3<double>& vector) const;
  void announce(const ToolSideBlock& block) {
    if (block.arc && block.mismatches) [[unlikely]]
      warn_of_mismatch(block);
  }
  void warn_of_mismatch(const ToolSideBlock& block);
  // Behind the path that has gone out: the first one that waited for it is held in its place.
  bool hold_waiting_path() {
    if (waiting_count_ == 0) return false;
    hold_waiting();
    return true;
  }
  void hold_waiting();

  // block() by kinds of blocks.
  StageEnd any_block(ToolSideBlock& block);
  StageEnd second_block(ToolSideBlock& block);
  StageEnd next_block(ToolSideBlock& block);
  StageEnd still_block(ToolSideBlock& block);
  // How the next path makes a corner with one that is held or waits; nullptr: it is not known yet.
  struct NextPath {
    const SidePath* path = nullptr;
    CornerRule rule = CornerRule::ordinary;
    bool keeps = false;  // that path moves nowhere at its own end: it keeps the vector
  };
  // A block behind the path that is held which is a path too: it moves at its own end.
  struct WaitingPath {
    const SidePath* path = nullptr;
    std::uint8_t place = 0;  // of its block, behind that of the path that is held
    bool repeated = false;
    bool moves = false;  // whether next() moves there
    NextPath next;
  };
  [[nodiscard]] std::span<WaitingPath> waiting() { return std::span(waiting_).first(waiting_count_); }
  // Where a block moves in the plane: at its own end, at the end of the path that is held; WaitingPath has the others.
  struct Moves {
    bool at_end;
    bool at_path;
  };
  // A line whose tool stands as at the end of the path moves there as at its own end.
  [[nodiscard]] Moves see_moves(const ToolSideBlock& block);
  StageEnd path_block(ToolSideBlock& block, const SidePath& to, const Moves& where);
  // Behind the path that has gone out: paths go out as long as their next one is known.
  [[nodiscard]] Alarm settle();
  void keep_vector();
  StageEnd cancel_block(ToolSideBlock& block);

  // Of the usual line.
  struct UsualLine {
    bool awaited = false;     // awaits_line()
    bool taken = false;       // the path that is held was taken by take_line()
    bool plain = false;       // of await_lines()
    bool held_plain = false;  // the event that is held was left plain
    unsigned filled = 0;      // bit i: is_line_filled() of slot i
    Vector3<double> vector;   // at the start of the path that is held
    double radius = 0;        // positive to the left
  };
  // Behind block(), which has just taken `block`: what is awaited.
  void await_usual(const ToolSideBlock& block);
  // The next path makes an ordinary corner of the same side and offset with the one that is held.
  [[nodiscard]] bool holds_usual_path(const ToolSideBlock& block) const;
  [[nodiscard]] bool can_await_line();
  [[nodiscard]] bool can_await_paths();
  // The tool moves ahead for certain along the line, from the vector at its start to the one at its end; `length` in
  // the plane, whole units.
  [[nodiscard]] bool goes_forward(const SidePath& path, double length, const Vector3<double>& vector) const;
  // What take_line() leaves to be known of the path that is held and the corner at its start.
  void complete_line();

  // Of usual paths.
  [[nodiscard]] bool lend_path(UsualLoan& loan) const;
  // Of an arc: the vector at its start is one of its own offset circle.
  [[nodiscard]] bool starts_on_circle();
  void set_side_path(SidePath& to, const UsualPath& path, const std::array<std::size_t, 2>& in) const;

  // Whether a line moves in a plane (No. 19630).
  [[nodiscard]] bool moves(const SeenLine& line, const ToolPlane& plane) const;
  // Whether next() moves in the plane at its own end, and what the tool sees of it there.
  [[nodiscard]] bool next_moves();
  // Whether a block moves in the plane of `tool`.
  [[nodiscard]] bool moves_in_plane_of(bool arc, const Travel& travel, const Direction& tool) const;
  [[nodiscard]] bool next_moves_at(const Direction& tool) { return moves_in_plane_of(next().arc, next_travel(), tool); }
  [[nodiscard]] bool on_edge(const ToolSideBlock& block, const Direction& tool) const;
  [[nodiscard]] bool mismatches(const ToolSideBlock& block) const;

  // Paths refer to a copy of their tool: the interpreter keeps those of the last blocks alone. Paths of one tool share
  // it, and as many are kept as there are paths.
  [[nodiscard]] const Direction& kept_tool(const ToolSideBlock& block);
  const Direction& keep_tool(const Direction& tool);
  // A path held that does not move in the plane at its end goes out, with the vector it starts with.
  void keep_without_direction();

  SideParameters parameters_;
  SideGeometry geometry_;
  SideGroups make_;
  std::array<std::size_t, 3> xyz_;
  double shortest_;  // longer travels move for certain (No. 19630); 10^-6 of a setup unit
  bool xyz_first_;   // X Y Z are the first three axes

  std::array<Direction, kMostPaths> tools_;
  Direction* kept_ = tools_.data();  // of them the one of the last path
  static constexpr std::uint64_t kNoTool = UINT64_MAX;
  std::uint64_t kept_number_ = kNoTool;  // ToolSideBlock::tool_number of that one
  std::array<WaitingPath, kMostBlocksRead> waiting_;
  std::size_t waiting_count_ = 0;
  Direction start_tool_;  // of type C

  // Of the path that is held.
  bool moves_at_end_ = false;
  Treatment treatment_ = Treatment::none;
  NextPath next_of_path_;
  PathStart start_of_path_;
  const SidePath* joined_ = nullptr;  // the next path of the one that has gone out last; nullptr: it had none
  bool keeps_ = false;                // and that keeps the vector
  UsualLine line_;
  bool awaits_paths_ = false;

  Amount start_offset_;  // of type C
  Amount value_;         // in force
  std::uint32_t value_change_ = 0;
  Event notice_;
};

[[gnu::always_inline]] inline void ToolSideCompensation::add(Event& event, const Vector3<double>& vector) const {
  if (xyz_first_) [[likely]]
    return add_to_xyz(event, vector);
  const auto add_to = [&](spec::AxisValues<double>& values) {
    for (std::size_t i = 0; i < 3; ++i)
      if (xyz_[i] != spec::Axes::kNone) values.value[xyz_[i]] += vector[i];
  };
  add_to(event.point);
  add_to(event.axes);
  if (event.machine.present != 0) add_to(event.machine);
}

}  // namespace toolcomp::fast

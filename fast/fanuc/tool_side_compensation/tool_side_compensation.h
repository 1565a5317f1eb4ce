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
#include "fast/fanuc/tool_side_compensation/side_group.h"
#include "fast/fanuc/tool_side_compensation/side_interference.h"
#include "fast/fanuc/tool_side_compensation/side_line_arrays.h"
#include "fast/fanuc/tool_side_compensation/tool_side_block.h"
#include "fast/kinematics/kinematics.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// Look-ahead: a block that moves at its own end, one block after it that does not move in the plane there, and the next
// one. The one in between may move at its own end: it then waits, as a path of its own, until the one before it is out.
// Before the path, where the corner at its start has several vectors, one block that keeps the last of them.
class ToolSideCompensation : public CornerQueue<ToolSideCompensation, ToolSideBlock, SidePath, SideGroup> {
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

  // Lines after the last block, as arrays (lines.cpp): whether that is a line that is held, with one vector at its
  // start, and lines may make ordinary corners with it; from where they go on; the last one that has been taken, and
  // the one before it. Its event is in held_event().
  [[nodiscard]] bool awaits_lines();
  [[nodiscard]] SideLineStart lines_start();
  struct TakenLine {
    Vector3<double> way;  // 10^-6, whole numbers
    Direction tool;       // at its end
  };
  void hold_last(const TakenLine& before, const TakenLine& last, const Vector3<double>& vector);
  [[nodiscard]] const SidePath& held_path() const { return *last_; }
  [[nodiscard]] Event& held_event() { return held(0).event; }

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

  // The corner of two lines by doubles alone, as arrays make it. False where they cannot tell, or it is no usual one.
  [[nodiscard]] bool make_corner_in_doubles(SideGroup& group, const SidePath& to) const;

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
  PathStart start_of_path_;           // of an arc that is held
  const SidePath* joined_ = nullptr;  // the next path of the one that has gone out last; nullptr: it had none
  bool keeps_ = false;                // and that keeps the vector

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

// Tool side compensation G41.2 G42.2, under G43.5 G41.6 G42.6 (3D sheet part 2): a stage that holds blocks until the
// vectors at both their ends are known.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "fast/engine.h"
#include "fast/kinematics/kinematics.h"
#include "fast/program/alarm.h"
#include "fast/program/cutter_block.h"
#include "fast/program/tool_side_block.h"
#include "fast/tool_side_compensation/side_group.h"
#include "fast/tool_side_compensation/side_interference.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// Look-ahead: a block that moves in the plane, one block after it that does not, and the next one; before it, where the
// corner at its start has several vectors, one block without movement that runs at the last of them. The slots are
// fixed: nothing is allocated per block.
class ToolSideCompensation {
 public:
  // Throws spec::InputError for parameters no control could have.
  ToolSideCompensation(const spec::Setup& setup, const Kinematics& kinematics, EventSink& sink);
  ToolSideCompensation(const ToolSideCompensation&) = delete;
  ToolSideCompensation& operator=(const ToolSideCompensation&) = delete;
  // Where the moves go from here on. The stage holds none.
  void set_sink(EventSink& sink) { sink_ = &sink; }

  // A vector is made or held, or waits for its removal. While it is not active and a block does not want compensation,
  // blocks pass without this stage.
  [[nodiscard]] bool active() const { return mode_ != Mode::off; }
  [[nodiscard]] StartType type() const { return parameters_.type; }

  // The block to fill in next. It keeps what it held before: the caller writes every field.
  [[nodiscard]] ToolSideBlock& next() { return ring_[next_]; }
  // Takes next(). An answer with an alarm or a typed undecided ends the run; what goes before it has been sent.
  StageEnd block();
  // No further block is known: one that raises an alarm of its own or stops the look-ahead, or the end of the program.
  StageEnd release();

 private:
  enum class Mode : std::uint8_t {
    off,
    starts,  // type C: the vector is that of the block right after
    on,
    ends,  // after a lone G40 or number 0: the next moving block removes the vector
  };
  enum class Held : std::uint8_t { nothing, path, start };

  // block() by kinds of blocks.
  StageEnd second_block(ToolSideBlock& block);
  StageEnd first_block(ToolSideBlock& block);
  StageEnd next_block(ToolSideBlock& block);
  // The usual case of next_block() without a detour: two lines, one vector at both ends of the former. False, and
  // nothing done, where it is any other.
  bool next_line(ToolSideBlock& block);
  StageEnd cancel_block(ToolSideBlock& block);
  StageEnd still_block(ToolSideBlock& block);
  StageEnd cancel_alone(ToolSideBlock& block);
  StageEnd refuse(const ToolSideBlock& block, const Alarm& alarm);
  StageEnd undecide(const ToolSideBlock& block, const char* clause);
  StageEnd at_fault(const ToolSideBlock& block, const Alarm& alarm);

  [[nodiscard]] bool moves(const ToolSideBlock& block) const;
  [[nodiscard]] bool on_edge(const ToolSideBlock& block, const Direction& tool) const;
  [[nodiscard]] bool mismatches(const ToolSideBlock& block) const;

  SidePath& new_path() { return paths_[path_ = static_cast<std::uint8_t>((path_ + 1U) % paths_.size())]; }
  void set_path(SidePath& to, const ToolSideBlock& block);
  void set_corner(SideCorner& corner, const SidePath* second) const;

  // The corner between the path that is held and `to`; leaves the vectors there in at_start().
  StageEnd join(const SidePath& to, CornerRule rule);
  // The path that is held goes out, up to its first head; at_end() is complete.
  StageEnd finish(bool plane_change, const SidePath* to);
  void hold_path(const SidePath& to, bool starts_up);
  // Where the travel of the path that is held is along the tool at its end it goes out, with the vector it starts with.
  void keep_without_direction();
  // The vectors of the corner at the start of the path go out up to the block `owner` (nullptr: that block is at
  // fault), with the block without movement that waits for the last of them.
  void pass_corner(ToolSideBlock* owner);
  void send_corner_moves(const ToolSideBlock* owner, std::uint8_t& head);

  void hold();
  void free_first();
  [[nodiscard]] ToolSideBlock& held(std::uint8_t i) { return ring_[(first_ + i) % ring_.size()]; }
  void send_behind();
  void send(ToolSideBlock& block, const Vector3<double>& vector, bool own);
  void add(Event& event, const Vector3<double>& vector) const;
  void warn_once(const ToolSideBlock& block);
  [[nodiscard]] bool vector_is_zero() {
    const Vector3<double>& v = at_start().front().vector;
    return v.x == 0 && v.y == 0 && v.z == 0;
  }

  EventSink* sink_;
  SideParameters parameters_;
  SideGeometry geometry_;
  SideGroups make_;
  std::array<std::size_t, 3> xyz_;
  double shortest_;  // longer travels move for certain (No. 19630)

  // Held: a block that waits for the last vector of the corner before the path (waits_ 0 or 1), the path or a start of
  // type C, and blocks without movement behind it.
  std::array<ToolSideBlock, 5> ring_;
  std::array<bool, 5> mismatch_{};
  std::uint8_t next_ = 0;
  std::uint8_t first_ = 0;
  std::uint8_t count_ = 0;
  std::uint8_t waits_ = 0;
  Held held_ = Held::nothing;

  std::array<SidePath, 4> paths_;  // of the block held, the ones before and after it
  std::uint8_t path_ = 0;
  const SidePath* last_ = nullptr;  // of the moving block before

  Mode mode_ = Mode::off;
  std::uint8_t still_ = 0;    // blocks without movement since the moving one
  bool repeated_ = false;     // a repeated code among them
  bool after_start_ = false;  // the moving block before was a start-up
  Direction start_tool_;      // of type C

  // Of the path that is held.
  [[nodiscard]] SideGroup& at_start() { return groups_[group_]; }     // vectors at its start, or the one in force
  [[nodiscard]] SideGroup& at_end() { return groups_[1U - group_]; }  // vectors at its end
  std::array<SideGroup, 2> groups_;
  std::uint8_t group_ = 0;
  bool starts_up_ = false;
  Treatment treatment_ = Treatment::none;
  // Of the corner at its start; without one those of the path itself.
  const Direction* start_tool_of_path_ = nullptr;
  int start_side_ = 1;
  Amount start_offset_;

  Amount value_;       // the value that came last
  Event corner_move_;  // of the corner whose moves have not gone out: the block before it, without a vector
  Event notice_;
};

}  // namespace toolcomp::fast

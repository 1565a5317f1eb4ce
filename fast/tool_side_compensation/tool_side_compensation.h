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

  // The value of the number in force, without its sign, from next() on.
  void set_value(const Count& value) {
    value_ = {value, value.nearest()};
    ++value_change_;
  }
  // The block to fill in next and how it moves. It keeps what it held before: the caller writes every field.
  [[nodiscard]] ToolSideBlock& next() { return ring_[next_]; }
  [[nodiscard]] Travel& next_travel() { return paths_[after(path_)].travel; }
  // Takes next(). An answer with an alarm or a typed undecided ends the run; what goes before it has been sent.
  StageEnd block();
  // The usual case of block() without a detour: after a line a line, one vector at both ends of the former. False, and
  // nothing done, where next() is any other. If true its event is still to be filled in.
  // x, y, z: next_travel().value.
  [[nodiscard]] bool take_line(double x, double y, double z);
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
  StageEnd any_block(ToolSideBlock& block);
  StageEnd second_block(ToolSideBlock& block);
  StageEnd first_block(ToolSideBlock& block);
  StageEnd next_block(ToolSideBlock& block);
  StageEnd cancel_block(ToolSideBlock& block);
  StageEnd still_block(ToolSideBlock& block);
  StageEnd cancel_alone(ToolSideBlock& block);
  StageEnd refuse(const ToolSideBlock& block, const Alarm& alarm);
  StageEnd undecide(const ToolSideBlock& block, const char* clause);
  StageEnd at_fault(const ToolSideBlock& block, const Alarm& alarm);

  // take_line() may take a line behind the path that is held.
  [[nodiscard]] bool awaits_line();
  [[nodiscard]] bool moves(const ToolSideBlock& block) const;
  [[nodiscard]] bool on_edge(const ToolSideBlock& block, const Direction& tool) const;
  [[nodiscard]] bool mismatches(const ToolSideBlock& block) const;

  static std::uint8_t after(std::uint8_t path) { return static_cast<std::uint8_t>((path + 1U) % 4); }
  SidePath& new_path() { return paths_[path_ = after(path_)]; }
  // The path keeps its tool: until then it is the one of the interpreter, which keeps those of the last blocks.
  void keep_tool(std::uint8_t path);
  void keep_tools();
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
  [[nodiscard]] ToolSideBlock& held(std::uint8_t i) {
    const std::size_t slot = std::size_t{first_} + i;
    return ring_[slot < ring_.size() ? slot : slot - ring_.size()];
  }
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
  double shortest_;  // longer travels move for certain (No. 19630); 10^-6 of a setup unit
  bool has_xyz_;     // none of the three axes is missing

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
  std::array<Direction, 4> tools_;
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
  const Amount* start_offset_of_path_ = nullptr;
  bool awaits_line_ = false;

  Amount start_offset_;  // of type C
  Amount value_;         // in force
  std::uint32_t value_change_ = 0;
  Event corner_move_;  // of the corner whose moves have not gone out: the block before it, without a vector
  Event notice_;
};

}  // namespace toolcomp::fast

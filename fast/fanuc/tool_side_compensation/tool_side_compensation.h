// Tool side compensation G41.2 G42.2, under G43.5 G41.6 G42.6 (3D sheet part 2): a stage that holds blocks until the
// vectors at both their ends are known.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "fast/basis/alarm.h"
#include "fast/basis/event.h"
#include "fast/fanuc/program/cutter_block.h"
#include "fast/fanuc/tool_side_compensation/side_group.h"
#include "fast/fanuc/tool_side_compensation/side_interference.h"
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
// Before the path, where the corner at its start has several vectors, one block that keeps the last of them. The slots
// are fixed: nothing is allocated per block.
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
  StageEnd path_block(ToolSideBlock& block, const SidePath& to, bool at_end);
  StageEnd cancel_block(ToolSideBlock& block);
  StageEnd still_block(ToolSideBlock& block);
  StageEnd cancel_alone(ToolSideBlock& block);
  StageEnd refuse(const ToolSideBlock& block, const Alarm& alarm);
  StageEnd undecide(const ToolSideBlock& block, const char* clause);
  StageEnd at_fault(const ToolSideBlock& block, const Alarm& alarm);

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
  // Behind block(), which has just taken `block`: whether lines are awaited.
  void await_line(const ToolSideBlock& block);
  [[nodiscard]] bool can_await_line(const ToolSideBlock& block);
  // The tool moves ahead for certain along the line, from the vector at its start to the one at its end; `length` in
  // the plane, whole units.
  [[nodiscard]] bool goes_forward(const SidePath& path, double length, const Vector3<double>& vector) const;
  // The blocks behind the path that is held, at the vector in force.
  void send_rest();
  // What take_line() leaves to be known of the path that is held and the corner at its start.
  void complete_line();
  // The compensated positions of a plain event.
  static void set_from_programmed(Event& event, const Vector3<double>& vector);

  // Whether a block moves in the plane of `tool` (No. 19630).
  [[nodiscard]] bool moves(bool arc, const Travel& travel, const Direction& tool) const;
  [[nodiscard]] bool next_moves(const Direction& tool) { return moves(next().arc, next_travel(), tool); }
  [[nodiscard]] bool on_edge(const ToolSideBlock& block, const Direction& tool) const;
  [[nodiscard]] bool mismatches(const ToolSideBlock& block) const;

  static std::uint8_t after(std::uint8_t path) { return static_cast<std::uint8_t>((path + 1U) % 4); }
  static std::uint8_t before(std::uint8_t path) { return static_cast<std::uint8_t>((path + 3U) % 4); }
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
  // A path held that does not move in the plane at its end goes out, with the vector it starts with.
  void keep_without_direction();
  // The path that is held ends without a next one.
  StageEnd release_path();
  // Behind the path that has gone out: the one that waited for it is held in its place.
  void hold_waiting_path();
  // The vectors of the corner at the start of the path go out up to the block `owner` (nullptr: that block is at
  // fault), with the block without movement that waits for the last of them.
  void pass_corner(ToolSideBlock* owner);
  void send_corner_moves(const ToolSideBlock* owner, std::uint8_t& head);

  void hold();
  void free_first();
  [[nodiscard]] std::uint8_t after_slot(std::uint8_t slot) const {
    return slot + 1U == ring_.size() ? std::uint8_t{0} : static_cast<std::uint8_t>(slot + 1U);
  }
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
  bool xyz_first_;   // X Y Z are the first three axes

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
  std::uint8_t still_ = 0;  // blocks behind the path that do not move in the plane at its end
  bool repeated_ = false;   // a repeated code among them
  // Of these the last one, where it moves at its own end; nullptr: it does not, or is not there.
  const SidePath* waiting_path_ = nullptr;
  bool after_start_ = false;  // no block has moved since a start-up
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
  UsualLine line_;

  Amount start_offset_;  // of type C
  Amount value_;         // in force
  std::uint32_t value_change_ = 0;
  Event corner_move_;  // of the corner whose moves have not gone out: the block before it, without a vector
  Event notice_;
};

[[gnu::always_inline]] inline void ToolSideCompensation::add(Event& event, const Vector3<double>& vector) const {
  const auto add_to = [&](spec::AxisValues<double>& values) {
    if (xyz_first_) [[likely]] {
      values.value[0] += vector.x;
      values.value[1] += vector.y;
      values.value[2] += vector.z;
      return;
    }
    for (std::size_t i = 0; i < 3; ++i)
      if (xyz_[i] != spec::Axes::kNone) values.value[xyz_[i]] += vector[i];
  };
  add_to(event.point);
  add_to(event.axes);
  if (event.machine.present != 0) add_to(event.machine);
}

}  // namespace toolcomp::fast

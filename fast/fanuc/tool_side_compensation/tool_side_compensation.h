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
  // The usual case of block() without a detour: behind a line another one, one vector at both ends of the former. Asked
  // behind block(): whether take_line() may take the next block, and those behind it, as long as they want compensation
  // and nothing changes but where the tool is and how it stands.
  [[nodiscard]] bool awaits_line() const { return awaits_line_; }
  // `plain`: point, axes and machine of the lines to come would be `programmed` in X, Y and Z. They need not be filled
  // in.
  void await_lines(bool plain) {
    plain_ = plain;
    filled_ = 0;
    // What block() holds is filled in, whatever the lines to come will be.
    if (!line_taken_) held_plain_ = false;
  }
  // What is the same in the events of all these lines is in next().event; the first time it answers false.
  [[nodiscard]] bool is_line_filled() {
    const unsigned slot = 1U << next_;
    const bool filled = (filled_ & slot) != 0;
    filled_ |= slot;
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

  // take_line() may take a line behind the path that is held; `block` is the one just taken.
  [[nodiscard]] bool can_await_line(const ToolSideBlock& block);
  // The tool moves ahead for certain along the line, from the vector at its start to the one at its end; `length` in
  // the plane, whole units.
  [[nodiscard]] bool goes_forward(const SidePath& path, double length, const Vector3<double>& vector);
  // The blocks behind the path that is held, at the vector in force.
  void send_rest();
  // What take_line() leaves to be known of the path that is held and the corner at its start.
  void complete_line();
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
  // The same of a plain event.
  static void set_from_programmed(Event& event, const Vector3<double>& vector);
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
  bool awaits_line_ = false;
  bool line_taken_ = false;  // the path that is held was taken by take_line()
  bool plain_ = false;
  bool held_plain_ = false;      // the event that is held was left plain
  unsigned filled_ = 0;          // bit i: is_line_filled() of slot i
  Vector3<double> line_vector_;  // at the start of that path
  double line_radius_ = 0;       // positive to the left

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

// X and Y side by side, as fill_side_line() writes them: half of what was written at once would be waited for.
[[gnu::always_inline]] inline void ToolSideCompensation::set_from_programmed(Event& event,
                                                                             const Vector3<double>& vector) {
  const DoublePair xy = load_pair(event.programmed.value.data()) + DoublePair{vector.x, vector.y};
  const double z = event.programmed.value[2] + vector.z;
  const auto set = [&](spec::AxisValues<double>& values) {
    store_pair(values.value.data(), xy);
    values.value[2] = z;
  };
  set(event.point);
  set(event.axes);
  if (event.machine.present != 0) set(event.machine);
}

// U and W: the movements before and behind the corner, V: the tool, u and w: what is seen of them along the tool.
// |u|^2 = |U|^2 - (V . U)^2, u . w = U . W - (V . U)(V . W).
[[gnu::always_inline]] inline bool ToolSideCompensation::see_line(const Vector3<double>& way,
                                                                  LineCorner& corner) const {
  const SidePath& from = paths_[path_];
  const Vector3<double> v{from.tool->unit[0], from.tool->unit[1], from.tool->unit[2]};
  const Vector3<double>& first = from.travel.value;
  const double square = way.x * way.x + way.y * way.y + way.z * way.z;
  const double along1 = dot(v, first);
  const double along2 = dot(v, way);
  const double square1 = from.travel.square - along1 * along1;
  const double square2 = square - along2 * along2;
  // Nearer than 30 degrees to the tool the projection loses digits; longer ways are not narrow.
  constexpr double kMostSquare = 0x1p60;
  if (4 * square1 < from.travel.square || 4 * square2 < square || square > kMostSquare) [[unlikely]]
    return false;
  corner.square = square;
  corner.length1 = std::sqrt(square1);
  corner.length2 = std::sqrt(square2);
  corner.product = dot(first, way) - along1 * along2;
  return true;
}

// Inner and obtuse corners of less than 90 degrees: against the movement before, the change of the plane may matter.
// The vector: r (V x U / |u| + V x W / |w|) / (1 + cosine). Whether it turns left or right makes no difference.
[[gnu::always_inline]] inline bool ToolSideCompensation::take_line(const Vector3<double>& way, const LineCorner& corner,
                                                                   const Direction& tool) {
  const double lengths = corner.length1 * corner.length2;
  // A direction is good to 2^-43, |U||W| is at most 4 |u||w|: 14 times that and a few roundings.
  constexpr double kUncertain = 0x1p-38;
  if (corner.product <= kUncertain * lengths || corner.length2 <= shortest_ || corner.length1 <= shortest_) [[unlikely]]
    return false;
  const double scale = line_radius_ / (lengths + corner.product);
  const SidePath& from = paths_[path_];
  const Vector3<double> v{from.tool->unit[0], from.tool->unit[1], from.tool->unit[2]};
  const Vector3<double> vector = cross(v, from.travel.value * corner.length2 + way * corner.length1) * scale;
  // The tool goes forward for certain: the vector moves by less than the way.
  constexpr double kMost = (1 - 0x1p-30) / static_cast<double>(Count::kSmallPerOne);
  if (std::abs(vector.x - line_vector_.x) + std::abs(vector.y - line_vector_.y) + std::abs(vector.z - line_vector_.z) >=
          kMost * corner.length1 &&
      !goes_forward(from, corner.length1, vector)) [[unlikely]]
    return false;

  path_ = after(path_);
  Travel& travel = paths_[path_].travel;
  travel.value.x = way.x;
  travel.value.y = way.y;
  travel.value.z = way.z;
  travel.square = corner.square;
  paths_[path_].tool = &tool;
  line_vector_.x = vector.x;
  line_vector_.y = vector.y;
  line_vector_.z = vector.z;
  line_taken_ = true;
  Event& event = ring_[first_].event;
  if (held_plain_) [[likely]]
    set_from_programmed(event, vector);
  else
    add(event, vector);
  held_plain_ = plain_;
  sink_->on(event);
  if (count_ > 1) [[unlikely]]
    send_rest();
  first_ = next_;
  count_ = 1;
  next_ = after_slot(next_);
  return true;
}

}  // namespace toolcomp::fast

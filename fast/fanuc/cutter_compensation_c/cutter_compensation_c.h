// Cutter compensation C, G40 G41 G42 G39 (chapter 14.5, 14.6): a stage that holds blocks until the vectors at both
// their ends are known.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "fast/basis/event.h"
#include "fast/basis/fault.h"
#include "fast/fanuc/cutter_compensation_c/cutter_group.h"
#include "fast/fanuc/cutter_compensation_c/cutter_interference.h"
#include "fast/fanuc/program/cutter_block.h"
#include "fast/geometry/path.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// Look-ahead: a block that moves in the plane, one block after it that does not, and the next one. The slots are fixed:
// nothing is allocated per block.
class CutterCompensationC {
 public:
  // Throws spec::InputError for parameters no control could have.
  CutterCompensationC(const spec::Setup& setup, EventSink& sink);

  // From the block with G41 or G42 on, until the vector of a block with G40 is removed and nothing is held. While it is
  // not active and a block has no G41 or G42, blocks pass without this stage.
  [[nodiscard]] bool active() const { return side_ != CutterSide::off || mode_ != Mode::off; }
  // Compensation is wanted (G41 or G42 and a number other than 0), or its vector is not removed yet: PS0037, PS0042 and
  // the exclusion of other modes rest on it (clause fanuc.cutter.on).
  [[nodiscard]] bool on() const { return (side_ != CutterSide::off && number_ != 0) || mode_ != Mode::off; }
  // PS0035, then PS0034: the alarms that follow from the words and the state alone, before anything is changed (plane
  // change, G45 to G48, other modes and the range of the value are tested by the caller). Asked while active, and at a
  // block with G39, G41 or G42.
  [[nodiscard]] Alarm check(const CutterCommand& command) const;

  // PS0034 of an arc alone.
  [[nodiscard]] Alarm check_arc(CutterSide word, std::uint32_t d) const {
    const CutterSide side = word == CutterSide::unchanged ? side_ : word;
    const bool asked = side != CutterSide::off && d != 0;
    // An arc may not start the mode, nor end it.
    return (asked ? mode_ == Mode::off : mode_ == Mode::on || mode_ == Mode::ends) ? alarm::kArcAtStartOrCancel
                                                                                   : alarm::kNone;
  }

  // The block to fill in next. It keeps what it held before: the caller writes every field.
  [[nodiscard]] CutterBlock& next() { return ring_[next_]; }
  // The workpiece system changes in the block to come: positions of the corner before it are called as in next().event,
  // which has them without the vector.
  void rebase();
  // The path of next(), where it will be one of the mode: roots and quotients are begun early, while the rest of the
  // block is filled in. False if block() is to make it.
  [[nodiscard]] bool make_arc_path(const CutterBlock& block);
  [[nodiscard]] bool make_line_path(const CutterBlock& block) {
    if (mode_ != Mode::on || !wanted(block)) return false;
    set_line(new_path().path, block.start, block.end);
    return true;
  }
  // The short cut of block(), usual_line.h: takes next(), a line without a code whose path is made, if its corner is
  // the usual one, of two lines and with one vector at both ends of the former. False, and nothing is done: it is for
  // block().
  [[nodiscard]] bool usual_line();
  // Takes next(). An answer with an alarm or a typed undecided ends the run; what goes before it has been sent.
  StageEnd block();
  // No further block is known: a block that raises an alarm of its own (absent from the path), or the end of the
  // program. Everything held goes out.
  StageEnd release();

 private:
  enum class Mode : std::uint8_t {
    off,
    waits_for_block,  // a lone G41 or G42 of SUV = 1: its vector is that of the next moving block
    on,
    ends,  // after a lone G40 or number 0: the next moving block removes the vector
  };
  // What is held for the next moving block; the blocks after it are held behind it.
  enum class Held : std::uint8_t { nothing, path, corner_arc, start };

  // Where the block before ended, without vector, for corner moves: they keep the other axes there.
  struct Position {
    std::array<double, spec::kMaxAxes> programmed{};
    std::array<double, spec::kMaxAxes> point{};
    std::array<double, spec::kMaxAxes> axes{};
    std::optional<std::array<double, 3>> tool_axis;
  };
  // A path with the offset in force in it. Kept while a corner refers to it.
  struct CompensatedPath {
    PlanePath path;
    Heading direction;  // of I J, where the block has them
    int side = 1;       // +1: the tool is left of the path
    Amount offset;
  };

  // block() by kinds of blocks.
  StageEnd moving_block(CutterBlock& block);
  StageEnd first_block(CutterBlock& block);
  StageEnd next_block(CutterBlock& block);
  // Any corner of two blocks in the mode; `to` is the path of `block`, without its offset.
  StageEnd follow(CutterBlock& block, CompensatedPath& to);
  StageEnd cancel_block(CutterBlock& block);
  StageEnd still_block(CutterBlock& block);
  StageEnd corner_arc(CutterBlock& block);
  StageEnd leave_path(CutterBlock& block);
  StageEnd to_intermediate(CutterBlock& block);
  StageEnd refuse(const CutterBlock& block, const Alarm& alarm);
  StageEnd undecide(const CutterBlock& block, const char* clause);

  // The corner between what is held, or the vector in force, and `to`; leaves the vectors there in at_start().
  [[nodiscard]] Alarm join(const CompensatedPath& to, const Heading& heading, CornerRule rule);
  // The path that is held goes out, and the blocks behind it. It ends with at_end(), which may lose vectors by that.
  [[nodiscard]] Alarm finish();
  // From `to` on: it starts with the vectors of at_start().
  void hold_path(const CompensatedPath& to, bool starts_up);
  // The first block that is held is at fault.
  [[nodiscard]] StageEnd at_fault(const Alarm& alarm) const;
  // The move of a G39 block, to the vector perpendicular to `heading`.
  void send_corner_arc(CutterBlock& block, const Heading& heading);
  // The move of the lone G41 or G42 that is held, to the vector perpendicular to the start of `to`.
  void finish_start(const CompensatedPath& to);
  // A block that ends the mode and does not move in the plane; what is held is out.
  void cancel_alone(CutterBlock& block);
  void clear_components(std::uint8_t components);

  CompensatedPath& new_path() { return paths_[path_ = static_cast<std::uint8_t>((path_ + 1U) % paths_.size())]; }
  static void set_path(CompensatedPath& to, const CutterBlock& block);
  void set_offset(CompensatedPath& to, const CutterBlock& block);
  void set_normal(CutterGroup& group, const PlanePath& path, const Heading& heading, int side,
                  const Amount& offset) const;
  [[nodiscard]] static int side_of(const CutterBlock& block);
  [[nodiscard]] bool wanted(const CutterBlock& block) const { return block.side != CutterSide::off && block.d != 0; }
  [[nodiscard]] bool vector_is_zero() const;

  void hold();
  // The blocks held behind the first one, at one vector.
  void send_behind(const Vector2<double>& vector);
  void send(CutterBlock& block, const Vector2<double>& vector, bool own);
  void send(CutterBlock& block) { send(block, vector_.front().vector, block.own); }
  void send_setting(const CutterBlock& block);
  // From head to head of at_start(), before `block`.
  void send_corner_moves(const CutterBlock& block);
  void keep_position(Position& position, const Event& event) const;
  static void add(Event& event, const CutterBlock& block, const Vector2<double>& vector);

  EventSink& sink_;
  CutterParameters parameters_;
  CutterGroups make_;
  std::size_t axes_;

  std::array<CutterBlock, 4> ring_;
  std::uint8_t next_ = 0;
  std::uint8_t first_ = 0;  // slots held: first_ … , held_count_ of them
  std::uint8_t held_count_ = 0;
  Held held_ = Held::nothing;
  std::array<CompensatedPath, 4> paths_;  // of the block held, the ones before and after it
  std::uint8_t path_ = 0;
  const CompensatedPath* last_ = nullptr;  // of the moving block before

  Mode mode_ = Mode::off;
  CutterSide side_ = CutterSide::off;    // of the block before
  CutterSide before_ = CutterSide::off;  // in force before this block
  std::uint32_t number_ = 0;
  std::uint8_t still_ = 0;    // blocks without motion since the moving one, weighted
  bool repeated_ = false;     // a G41 or G42 among them that changes nothing
  bool after_start_ = false;  // the moving block before was a start-up
  bool fresh_ = false;        // nothing but a vector is known: after G53 and the like with CCN = 1
  std::uint8_t clears_ = 0;   // components that the move to the reference position removes

  // Of the path that is held.
  [[nodiscard]] CutterGroup& at_start() { return groups_[group_]; }     // vectors at its start
  [[nodiscard]] CutterGroup& at_end() { return groups_[1U - group_]; }  // vectors at its end
  std::array<CutterGroup, 2> groups_;
  std::array<Position, 2> corners_;  // of the groups that have more than one vector: where the block before ended
  std::uint8_t group_ = 0;
  bool rebased_ = false;  // rebase() has written the one at the end
  bool plain_ = false;    // a checked line, of usual numbers, with one vector at its start
  bool starts_up_ = false;
  bool checked_ = false;
  int start_side_ = 1;  // of the corner at its start
  const Amount* start_offset_ = nullptr;
  int waiting_side_ = 1;  // of the lone G41 or G42 that is held
  Amount waiting_offset_;

  std::array<Heading, 2> directions_;  // of the last two G39
  std::uint8_t direction_ = 0;
  Count late_offset_;  // of the block before
  Count value_;        // the value that came last, and its amount
  Amount amount_;
  CutterGroup vector_;              // in force behind what is held or, if nothing is, now: one vector
  const Heading* along_ = nullptr;  // the direction vector_ is perpendicular to, where it is
  Event corner_move_;
  Event notice_;
};

inline void CutterCompensationC::add(Event& event, const CutterBlock& block, const Vector2<double>& vector) {
  const auto add_to = [&event](std::size_t axis, double component) {
    if (axis == spec::Axes::kNone) [[unlikely]]
      return;
    event.point.value[axis] += component;
    event.axes.value[axis] += component;
    if (event.machine.present != 0) [[unlikely]]
      event.machine.value[axis] += component;
  };
  add_to(block.axis[0], vector.x);
  add_to(block.axis[1], vector.y);
}

inline void CutterCompensationC::send(CutterBlock& block, const Vector2<double>& vector, bool own) {
  if (own) [[likely]] {
    add(block.event, block, vector);
    sink_.on(block.event);
  }
  if (block.sets) [[unlikely]]
    send_setting(block);
}

inline void CutterCompensationC::hold() {
  if (held_count_ == 0) first_ = next_;
  ++held_count_;
  rebased_ = false;
  next_ = static_cast<std::uint8_t>((next_ + 1U) % ring_.size());
}

inline void CutterCompensationC::send_behind(const Vector2<double>& vector) {
  for (std::uint8_t i = 1; i < held_count_; ++i) {
    CutterBlock& block = ring_[(first_ + i) % ring_.size()];
    send(block, vector, block.own);
  }
  held_count_ = 0;
  held_ = Held::nothing;
  plain_ = false;
}

inline int CutterCompensationC::side_of(const CutterBlock& block) {
  const int side = block.side == CutterSide::right ? -1 : 1;
  return block.offset < Count() && !fault(Fault::c_negative_offset_ignored) ? -side : side;
}

}  // namespace toolcomp::fast

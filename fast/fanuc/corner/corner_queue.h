// SPDX-License-Identifier: Apache-2.0
// The look-ahead machine of cutter compensation C and tool side compensation.
//
//  * A path is a block that moves in the compensation plane. It is held until the vectors at its end are known; at its
//    start they are known already.
//  * A block that moves nowhere in it is held behind the path and counted. With the last that is read the path is
//    released: it ends with the vector perpendicular to it, and the blocks behind it go out at that vector.
//  * The next path makes the corner: a group of vectors at the end of the path that is held, whose interference check
//    may drop vectors at both its ends. It goes out: the moves from vector to vector of the corner before it, its own
//    move to the first vector of the corner behind it, then the blocks behind it. Now the next path is held.
//  * Who owns the moves from vector to vector: the block behind the corner (cutter compensation C), or up to the
//    single-block stop point the one before it, and blocks in between wait for the last vector (tool side
//    compensation).
//  * A block that ends compensation and moves makes the corner and goes straight to its end. One that does not releases
//    what is held; the vector is removed at once, or by the next move.
//  * Where no next block is known, what is held is released.
//
// A section derives from it, says by block() what each block does, and gives, as section(),
//   is_arc, repeats                    of a block: an arc; a code that changes nothing
//   set_path, hold_path                the path of a block, and what is kept of it
//   set_corner, make_corner, make_     the corner at the end of the path that is held; its vectors, and its alarm
//   set_tool_arc, check_interference   of the path that is held
//   add                                a vector to the positions of a move
//   release                            all that is held goes out
// and what it may leave out (below). The slots are fixed: nothing is allocated per block.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "fast/basis/alarm.h"
#include "fast/basis/event.h"
#include "fast/fanuc/corner/corner_group.h"
#include "fast/fanuc/corner/interference.h"
#include "fast/fanuc/corner/tool_arc.h"
#include "fast/fanuc/program/stage_end.h"

namespace toolcomp::fast {

// Of the blocks that one stage takes at a time.
inline constexpr std::size_t kMostSlots = std::size_t{2} * kMostBlocksRead;

template <class Section, class Block, class Path, class Group>
class CornerQueue {
 public:
  // The block to fill in next. It keeps what it held before: the caller writes every field.
  [[nodiscard]] Block& next() { return *free_; }
  // Where the moves go from here on. The queue holds none.
  void set_sink(EventSink& sink) { sink_ = &sink; }

 protected:
  using Vector = typename Group::Vector;
  enum class Mode : std::uint8_t {
    off,
    starts,  // by a block without a move of its own: its vector is that of a block behind it
    on,
    ends,  // by a block without a move of its own: the next moving block removes the vector
  };
  // What is held for the next path; the blocks after it are held behind it.
  enum class Held : std::uint8_t { nothing, path, corner_arc, start };

  // The block that starts compensation and moves: straight from where it starts, without a vector, to the first head at
  // its end.
  void first_block(Block& block) {
    Path& to = new_path();
    section().set_path(to, block);
    at_start().clear();
    mode_ = Mode::on;
    after_start_ = true;
    block.event.cause = spec::Cause::start_up;
    section().hold_path(to, true);
  }
  // The alarms of a block that is to be the next path; `joined`: it makes a corner with the one that is held.
  [[nodiscard]] Alarm check_path(const Path& to, bool joined) const {
    if (to.is_arc() && to.flat.ends_in_center) return AlarmCause::arc_ends_in_center;
    const bool changes_side = to.side != last_->side && (after_start_ || (starts_up_ && joined));
    return changes_side ? AlarmCause::side_change_at_start : AlarmCause::none;
  }
  // The corner between the path that is held and `to`: the former goes out, or is at_fault().
  [[nodiscard, gnu::always_inline]] Alarm join(const Path& to, CornerRule rule) {
    section().set_corner(at_end(), &to, rule);
    if (const Alarm a = section().make_corner(at_end(), to, rule)) return a;
    return let_out();
  }
  [[nodiscard]] CornerRule rule_before(const Block& block) const {
    if (repeated_ || section().repeats(block)) return CornerRule::repeated;
    return starts_up_ ? CornerRule::start_up : CornerRule::ordinary;
  }
  void hold_path(const Path& to, bool starts_up) {
    last_ = &to;
    starts_up_ = starts_up;
    hold();
    held_ = Held::path;
    still_ = 0;
    repeated_ = false;
  }
  // The path that is held goes out without a next one, or is at_fault().
  [[nodiscard]] Alarm release_path() {
    Group& group = at_end();
    section().set_corner(group, nullptr, CornerRule::ordinary);
    if (group.corner.offset->nearest == 0)
      group.clear();
    else
      section().make_.set(group, HeadKind::first_normal);
    return let_out();
  }
  // It goes out to its programmed end.
  void release_path_without_vector() {
    section().set_corner(at_end(), nullptr, CornerRule::ordinary);
    at_end().clear();
    checked_ = false;
    (void)let_out();
  }
  StageEnd release_paths() {
    while (held_ == Held::path)
      if (const Alarm a = release_path()) return at_fault(a);
    return {};
  }
  // In the mode, a block without movement in the plane.
  StageEnd still_block(Block& block, unsigned weight, unsigned limit) {
    if (held_ == Held::nothing) {
      send_in_force(block);
      return {};
    }
    hold();
    still_ = static_cast<std::uint8_t>(still_ + weight);
    if (still_ >= limit)
      if (const Alarm a = release_path()) return at_fault(a);
    repeated_ |= section().repeats(block);
    return {};
  }
  // The block that ends compensation removes the vector.
  void remove_vector(Block& block, bool own) {
    block.event.cause = spec::Cause::cancel;
    at_start().clear();
    mode_ = Mode::off;
    send(block, {}, own);
  }
  // The same of one that does not move in the plane; what is held is out.
  void cancel_alone(Block& block, bool at_once) {
    const bool zero = vector_is_zero();
    if (at_once) {
      if (!zero) section().rename(block);
      remove_vector(block, block.own || !zero);
      return;
    }
    mode_ = zero ? Mode::off : Mode::ends;
    send_in_force(block);
  }
  // Compensation is off.
  void pass(Block& block) {
    if (Section::is_arc(block)) {
      PlanePath& path = paths_[0].flat;  // no corner refers to any
      set_arc_path(path, block);
      set_center(block, path);
      set_programmed_arc(*block.event.arc, path);
    }
    send_in_force(block);
  }
  // The block that started compensation without a move goes out to the vector of at_start(), and those behind it.
  void send_start() {
    Block& block = held(0);
    const bool zero = vector_is_zero();
    if (!zero) section().rename(block);
    block.event.cause = spec::Cause::start_up;
    send(block, at_start().front().vector, block.own || !zero);
    free_first();
    held_ = Held::nothing;
    send_held(at_start().front().vector);
    mode_ = Mode::on;
  }
  // The moves of the corner at the start of the path go out, of blocks before `owner` and its own.
  void pass_corner(const Block& owner) { send_corner_moves(owner, pass_blocks_before()); }

  // The blocks before are given as if this block were absent.
  StageEnd refuse(const Block& block, const Alarm& alarm) {
    if (const StageEnd end = section().release()) return end;
    return end_at(block.event, alarm);
  }
  StageEnd undecide(const Block& block, const char* clause) {
    StageEnd end = refuse(block, AlarmCause::none);
    if (!end.alarm) end.undecided = clause;
    return end;
  }
  // The path that is held is; moves of the corner before it that do not belong to it go out.
  StageEnd at_fault(const Alarm& alarm) {
    const StageEnd end = end_at(held(waits_).event, alarm);
    if (held_ == Held::path) (void)pass_blocks_before();
    return end;
  }

  void hold() {
    if (count_ == 0) first_ = next_;
    ++count_;
    pass_slot();
    move_is_set_ = false;
  }
  void pass_slot() {
    next_ = after_slot(next_);
    free_ = &ring_[next_];
  }
  void free_first() {
    --count_;
    first_ = after_slot(first_);
  }
  [[nodiscard]] std::uint8_t after_slot(std::uint8_t slot) const {
    return slot + 1U == slots_ ? std::uint8_t{0} : static_cast<std::uint8_t>(slot + 1U);
  }
  [[nodiscard]] Block& held(std::size_t i) {
    const std::size_t slot = first_ + i;
    return ring_[slot < slots_ ? slot : slot - slots_];
  }
  [[gnu::always_inline]] void send(Block& block, const Vector& vector, bool own) {
    if (own) [[likely]] {
      send_to(block.event, vector);
    }
    section().sent(block);
  }
  void send_in_force(Block& block) { send(block, at_start().front().vector, block.own); }
  // All that are held.
  void send_held(const Vector& vector) {
    for (; count_ > 0; free_first()) send(held(0), vector, held(0).own);
  }

  // Of the block held, the ones before and after it, and those that wait for it.
  static constexpr std::uint8_t kMostPaths = kMostBlocksRead + 1;
  [[nodiscard]] std::uint8_t after(std::uint8_t path) const {
    return path + 1U == path_count_ ? std::uint8_t{0} : static_cast<std::uint8_t>(path + 1U);
  }
  [[nodiscard]] std::uint8_t before(std::uint8_t path) const {
    return static_cast<std::uint8_t>((path == 0 ? path_count_ : path) - 1U);
  }
  Path& new_path() { return paths_[path_ = after(path_)]; }
  // Of the path that is held: vectors at its start, or the one in force; vectors at its end.
  [[nodiscard]] Group& at_start() { return *start_; }
  [[nodiscard]] Group& at_end() { return *end_; }
  [[nodiscard]] bool vector_is_zero() { return is_zero(at_start().front().vector); }

  // Of one that has more than one vector.
  [[nodiscard]] Event& corner_move(const Group& group) {
    return corner_moves_[static_cast<std::size_t>(&group - groups_.data())];
  }
  // The move from vector to vector at the end of the path that is held, without vectors: where the block before the
  // corner has ended, all axes stay.
  void set_corner_move(const Event& before) {
    Event& move = corner_move(at_end());
    move.line = before.line;
    move.n = before.n;
    move.type = before.type == spec::MoveType::rapid ? spec::MoveType::rapid : spec::MoveType::linear;
    move.cause = spec::Cause::corner;
    move.feed = before.feed;
    move.programmed = before.programmed;
    move.point = before.point;
    move.axes = before.axes;
    move.machine.present = 0;
    if (before.machine.present != 0) [[unlikely]]
      move.machine = before.machine;
    move.tool_axis = before.tool_axis;
    move.t_numerator = before.t_numerator;
  }

  // What a section may leave out.
  static void rename(Block& /*block*/) {}            // the move of a block that makes or removes a vector
  static void sent(const Block& /*block*/) {}        // behind the move of a block
  static void announce(const Block& /*block*/) {}    // before the first move of a path
  static bool hold_waiting_path() { return false; }  // a block behind the path that has gone out is a path too
  static constexpr bool kUpToStop = false;           // moves up to the stop point belong to the former block

  EventSink* sink_;
  std::uint8_t slots_;  // no more of the ring than this section and setup take: what is small stays at hand
  std::array<Block, kMostSlots> ring_;
  std::uint8_t next_ = 0;
  Block* free_ = ring_.data();  // the slot next_: every block asks for it again and again
  std::uint8_t first_ = 0;      // slots held: first_ … , count_ of them
  std::uint8_t count_ = 0;
  std::uint8_t waits_ = 0;  // of these the blocks that wait for the last vector of the corner before the path
  Held held_ = Held::nothing;
  std::uint8_t path_count_;
  std::array<Path, kMostPaths> paths_;
  std::uint8_t path_ = 0;
  const Path* last_ = nullptr;  // of the moving block before

  Mode mode_ = Mode::off;
  std::uint8_t still_ = 0;    // blocks without movement behind the path, weighted
  bool repeated_ = false;     // a repeated code among them
  bool after_start_ = false;  // no block has moved since a start-up
  bool starts_up_ = false;    // the path that is held does
  bool checked_ = false;      // it passes the interference check
  bool move_is_set_ = false;  // set_corner_move() has been called for its end
  std::array<Group, 2> groups_;
  Group* start_ = groups_.data();      // at_start()
  Group* end_ = start_ + 1;            // at_end()
  std::array<Event, 2> corner_moves_;  // of the groups

 private:
  friend Section;
  CornerQueue(EventSink& sink, unsigned slots, unsigned paths)
      : sink_(&sink), slots_(static_cast<std::uint8_t>(slots)), path_count_(static_cast<std::uint8_t>(paths)) {}
  ~CornerQueue() = default;
  [[nodiscard]] Section& section() { return static_cast<Section&>(*this); }
  [[nodiscard]] const Section& section() const { return static_cast<const Section&>(*this); }
  // The path that is held goes out, and the blocks behind it; at_end() is complete, and becomes at_start().
  [[nodiscard, gnu::always_inline]] Alarm let_out() {
    Block& block = held(waits_);
    const Path& path = *last_;
    if (path.is_arc()) {
      set_center(block, path.flat);
      section().set_tool_arc(*block.event.arc);
    }
    if (checked_) {
      // Where it stands: a copy of what has just been written in parts would be waited for.
      static constexpr std::optional<double> kNoSweep;
      switch (section().check_interference(path.is_arc() ? block.event.arc->sweep : kNoSweep)) {
        case Interference::none:
          break;
        case Interference::straightened:
          block.event.type = spec::MoveType::linear;
          block.event.arc.reset();
          break;
        case Interference::alarm:
          return AlarmCause::interference;
      }
    }
    const std::size_t head = pass_blocks_before();
    section().announce(block);
    send_corner_moves(block, head);
    if (at_end().size > 1 && !move_is_set_) set_corner_move(Section::kUpToStop ? block.event : held(count_ - 1U).event);
    send(block, at_end().front().vector, true);
    free_first();
    std::swap(start_, end_);
    held_ = Held::nothing;
    if (section().hold_waiting_path()) return AlarmCause::none;
    if (Section::kUpToStop && at_start().size > 1)
      waits_ = count_;
    else
      send_held(at_start().front().vector);
    return AlarmCause::none;
  }
  // At the start of the path: the moves that belong to the block before the corner, and the blocks that wait for its
  // last vector. Answers the first head that is left.
  [[gnu::always_inline]] std::size_t pass_blocks_before() {
    const Group& group = at_start();
    std::size_t head = 1;
    if constexpr (Section::kUpToStop) {
      while (head < group.size && is_up_to_stop(group.head[head].kind)) send_corner_move(head++);
      for (; waits_ > 0; --waits_) {
        Block& still = held(0);
        if (still.own) {
          send_corner_moves(still, head);
          head = group.size;
        }
        send(still, group.back().vector, still.own);
        free_first();
      }
    }
    return head;
  }
  // From head to head, from `head` on.
  void send_corner_moves(const Block& owner, std::size_t head) {
    if (head >= at_start().size) [[likely]]
      return;
    Event& move = corner_move(at_start());
    move.line = owner.event.line;
    move.n = owner.event.n;
    move.type = owner.event.type == spec::MoveType::rapid ? spec::MoveType::rapid : spec::MoveType::linear;
    move.feed = owner.event.feed;
    for (; head < at_start().size; ++head) send_corner_move(head);
  }
  void send_corner_move(std::size_t head) {
    const Group& group = at_start();
    Event& move = corner_move(group);
    if (head + 1U == group.size) {
      send_to(move, group.head[head].vector);
      return;
    }
    const std::array<spec::AxisValues<double>, 3> without{move.point, move.axes, move.machine};
    send_to(move, group.head[head].vector);
    move.point = without[0];
    move.axes = without[1];
    move.machine = without[2];
  }
  [[gnu::always_inline]] void send_to(Event& move, const Vector& vector) {
    section().add(move, vector);
    sink_->on(move);
  }
};

}  // namespace toolcomp::fast

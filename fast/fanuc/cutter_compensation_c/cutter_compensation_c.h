// SPDX-License-Identifier: Apache-2.0
// Cutter compensation C, G40 G41 G42 G39 (chapter 14.5, 14.6): a stage that holds blocks until the vectors at both
// their ends are known.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "fast/basis/event.h"
#include "fast/fanuc/corner/corner_queue.h"
#include "fast/fanuc/cutter_compensation_c/cutter_group.h"
#include "fast/fanuc/cutter_compensation_c/cutter_interference.h"
#include "fast/fanuc/cutter_compensation_c/cutter_line_arrays.h"
#include "fast/fanuc/program/cutter_block.h"
#include "fast/geometry/path.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// A path with the offset in force in it. Kept while a corner refers to it.
struct CutterPath {
  PlanePath flat;
  Heading direction;  // of I J, where the block has them
  int side = 1;       // +1: the tool is left of the path
  Amount offset;
  [[nodiscard]] bool is_arc() const { return flat.arc; }
};

// Of lines as arrays: where the one before them ends in the plane, 10^-6, and the places of its words.
struct CutterLines {
  std::array<std::int64_t, 2> at{};
  std::array<std::size_t, 2> word{};
};

// Look-ahead: a block that moves in the plane, blocks after it that do not, and the next one.
class CutterCompensationC : public CornerQueue<CutterCompensationC, CutterBlock, CutterPath, CutterGroup> {
 public:
  // Throws spec::InputError for parameters no control could have.
  CutterCompensationC(const spec::Setup& setup, EventSink& sink);
  CutterCompensationC(const CutterCompensationC&) = delete;
  CutterCompensationC& operator=(const CutterCompensationC&) = delete;

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
    return (asked ? mode_ == Mode::off : mode_ == Mode::on || mode_ == Mode::ends) ? AlarmCause::arc_at_start_or_cancel
                                                                                   : AlarmCause::none;
  }

  // The workpiece system changes in the block to come: positions of the corner before it are called as in next().event,
  // which has them without the vector.
  void rebase();
  // The path of next(), where it will be one of the mode: roots and quotients are begun early, while the rest of the
  // block is filled in. False if block() is to make it.
  [[nodiscard]] bool make_arc_path(const CutterBlock& block) {
    if (mode_ != Mode::on || !wanted(block)) return false;
    set_arc_path(new_path().flat, block);
    return true;
  }
  [[nodiscard]] bool make_line_path(const CutterBlock& block) {
    if (mode_ != Mode::on || !wanted(block)) return false;
    set_line(new_path().flat, block.start, block.end);
    return true;
  }
  // Lines after the last block, as arrays, where that is a line that is held, with one vector at its start: how many of
  // them make usual corners and have been taken, as block() would have. `lines.at` goes along.
  [[nodiscard]] std::size_t lines(const LineChunk& chunk, CutterLines& lines);
  // Takes next(). An answer with an alarm or a typed undecided ends the run; what goes before it has been sent.
  StageEnd block();
  // No further block is known: a block that raises an alarm of its own (absent from the path), or the end of the
  // program. Everything held goes out.
  StageEnd release();

 private:
  // What the machine asks for.
  friend CornerQueue;
  static bool is_arc(const CutterBlock& block) { return block.motion == CutterMotion::arc; }
  // G41 or G42 that changes nothing.
  [[nodiscard]] bool repeats(const CutterBlock& block) const { return is_code(block) && block.word == before_; }
  void set_path(CutterPath& to, const CutterBlock& block);
  void hold_path(const CutterPath& to, bool starts_up);
  void set_corner(CutterGroup& group, const CutterPath* second, CornerRule rule) const;
  [[nodiscard]] Alarm make_corner(CutterGroup& group, const CutterPath& /*to*/, CornerRule rule) const {
    return make_.make(group, rule) ? AlarmCause::none : AlarmCause::no_intersection;
  }
  [[nodiscard]] CheckedBlock checked_block() const {
    return {&last_->flat, start_side_, start_offset_, last_->side, &last_->offset};
  }
  void set_tool_arc(spec::Arc<double>& arc) { fast::set_tool_arc(arc, checked_block(), at_start(), at_end()); }
  [[nodiscard]] Interference check_interference(const std::optional<double>& sweep) {
    return fast::check_interference(checked_block(), sweep, at_start(), at_end(), parameters_.interference);
  }
  void add(Event& event, const Vector2<double>& vector) const;
  // It moves in the coordinates after its G92.
  static void rename(CutterBlock& block) {
    if (block.motion == CutterMotion::shift) block.event = block.renamed;
  }
  void sent(const CutterBlock& block) {
    if (block.sets) [[unlikely]]
      send_setting(block);
  }

  // block() by kinds of blocks.
  StageEnd moving_block(CutterBlock& block);
  StageEnd next_block(CutterBlock& block);
  StageEnd second_block(CutterBlock& block, CutterPath& to);
  StageEnd cancel_block(CutterBlock& block);
  StageEnd still_block(CutterBlock& block);
  StageEnd corner_arc(CutterBlock& block);
  StageEnd leave_path(CutterBlock& block);
  StageEnd shift_in_plane(CutterBlock& block);
  StageEnd to_intermediate(CutterBlock& block);

  // What is held goes out before `to`, or is at_fault(); leaves the vectors there in at_start().
  [[nodiscard]] Alarm end_held(const CutterPath& to, CornerRule rule);
  // The move of a G39 block, to the vector perpendicular to `heading`.
  void send_corner_arc(CutterBlock& block, const Heading& heading);
  // The mode goes on without a vector.
  void take_vector_away();
  static void set_flat(PlanePath& flat, const CutterBlock& block);
  // The offset to the left of a heading, or to its right.
  void set_normal(CutterGroup& group, const PlanePath& path, const Heading& heading, int side,
                  const Amount& offset) const;
  [[nodiscard]] static int side_of(const CutterBlock& block);
  [[nodiscard]] static bool wanted(const CutterBlock& block) { return block.side != CutterSide::off && block.d != 0; }
  [[nodiscard]] static bool is_code(const CutterBlock& block) {
    return block.word == CutterSide::left || block.word == CutterSide::right;
  }
  void send_setting(const CutterBlock& block);

  // lines.cpp
  [[nodiscard]] bool awaits_lines() const;
  // The last of these lines is held.
  void hold_last(const CutterLineEnd& end, const std::array<std::int64_t, 2>& at);

  CutterParameters parameters_;
  CutterGroups make_;

  std::array<std::size_t, 2> axis_{};    // of the plane
  CutterSide side_ = CutterSide::off;    // of the block before
  CutterSide before_ = CutterSide::off;  // in force before this block
  std::uint32_t number_ = 0;
  bool fresh_ = false;   // no vector has been made again: after G52 and G92, and after G53 and the like with CCN = 1
  bool clears_ = false;  // the move to the reference position removes the vector

  // Of the path that is held.
  int start_side_ = 1;  // of the corner at its start, or of the lone G41 or G42 that is held
  const Amount* start_offset_ = nullptr;
  Amount start_amount_;  // of the lone G41 or G42

  std::array<Heading, 2> directions_;  // of the last two G39
  std::uint8_t direction_ = 0;
  Count value_;  // the value that came last, and its amount
  Amount amount_;
  Event notice_;
};

inline void CutterCompensationC::add(Event& event, const Vector2<double>& vector) const {
  const auto add_to = [&event](std::size_t axis, double component) {
    if (axis == spec::Axes::kNone) [[unlikely]]
      return;
    event.point.value[axis] += component;
    event.axes.value[axis] += component;
    if (event.machine.present != 0) [[unlikely]]
      event.machine.value[axis] += component;
  };
  add_to(axis_[0], vector.x);
  add_to(axis_[1], vector.y);
}

inline int CutterCompensationC::side_of(const CutterBlock& block) {
  const int side = block.side == CutterSide::right ? -1 : 1;
  return block.offset < Count() ? -side : side;
}

}  // namespace toolcomp::fast

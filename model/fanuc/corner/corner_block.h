// SPDX-License-Identifier: Apache-2.0
// What a block says to the compensations that make vectors at corners, cutter compensation and tool side compensation,
// and their mode.
#pragma once

#include <cstdint>
#include <optional>

#include "model/fanuc/corner/corner.h"
#include "model/fanuc/program/offset_memory.h"
#include "model/fanuc/program/pass.h"

namespace toolcomp::model {

struct CornerBlock {
  std::optional<CutterSide> code;         // a word of the section's codes, or G40
  CutterSide before = CutterSide::none;   // side in force before the block
  CutterSide side = CutterSide::none;     // and at its end
  bool number_given = false;              // a D word, or with OFH = 1 an H word
  std::uint32_t number_before = 0;        // offset number in force before the block
  std::uint32_t number = 0;               // and at its end
  Rational offset;                        // its signed value; 0 while `side` is none
  bool other_compensation = false;        // a code of group 07 that is not the section's
  bool plane_changed = false;             // of G17, G18, G19, against the block before
  bool arc_words = false;                 // an arc by its words
  std::optional<Rational> radius;         // of such an arc, where R gives it
  bool changes_workpiece_system = false;  // G54–G59, G54.1, or another origin of one
  // The programmed position of every axis where the block starts, if the workpiece system changes in it.
  std::optional<Position> position;
  Direction tool;  // there

  void add_place(const BlockWay& way) {
    if (!changes_workpiece_system) return;
    position = way.start.end;
    tool = way.tool_at(*position);
  }

  // A word G40, a word of a side, and such a word equal to the code in force before it.
  [[nodiscard]] bool says_cancel() const { return code == CutterSide::none; }
  [[nodiscard]] bool says_side() const { return code && *code != CutterSide::none; }
  [[nodiscard]] bool repeats_code() const { return says_side() && *code == before; }
  [[nodiscard]] bool changes_number() const { return number_given && number != number_before; }
};

// What `at` gives for the axes of a plane, by axis. A machine without an axis of the plane stands at 0 in it.
template <class At>
PlanePoint in_axes(spec::Plane plane, const spec::Axes& axes, At at) {
  const auto of = [&](char letter) { return axes.has(letter) ? at(axes.index(letter)) : Real(0); };
  return {of(letters(plane).first), of(letters(plane).second)};
}
// The arc of a leg in its plane. `radius`: of CornerBlock.
ArcEnds arc_of(const Leg& leg, const std::optional<Rational>& radius, const spec::Axes& axes);

// Follows the codes of one section in group 07, the offset number and the plane through the program.
class CornerWords {
 public:
  // `side_of`: of a code of the section, G40 among them.
  CornerWords(const Pass::Place& place, std::optional<CutterSide> (*side_of)(Compensation))
      : side_of_(side_of), offset_(place.setup, place.memory, place.recorder), axes_(place.setup.axes) {}

  // In force at the end of a block, which is read next or has been read last: the side, and the number.
  [[nodiscard]] CutterSide side_after(const Command& command) const;
  [[nodiscard]] std::uint32_t number_after(const Command& command) const {
    return offset_.number_after(command.codes).number;
  }

  // What the block says, without the value of its number; false before the first words of the section in a program:
  // a side, or what `starts` says. `by_motion`: the block moves by its code of group 01.
  [[nodiscard]] bool read(const BlockWords& now, bool starts, bool by_motion, CornerBlock& block);
  // The value in force at the end of the block. Throws Alarm PS0029.
  void add_value(CornerBlock& block);

 private:
  std::optional<CutterSide> (*side_of_)(Compensation);
  OffsetInForce offset_;
  spec::Axes axes_;
  bool seen_ = false;
  CutterSide side_ = CutterSide::none;
  spec::Plane plane_ = spec::Plane::xy;
};

// How many blocks are read at a time in the mode, the one before a corner included: No. 19625 of the 30i, else 3.
// Throws spec::InputError for another number. Clauses: fanuc.cutter-c.two-non-motion-blocks,
// fanuc.tool-side.look-ahead.
int blocks_read(const spec::Setup& setup);

// The mode of such a compensation.
class CornerMode {
 public:
  CornerMode(const spec::Setup& setup, Recorder& recorder) : setup_(setup), recorder_(recorder) {}

  // There is a vector, or a block that makes one.
  [[nodiscard]] bool is_on() const { return phase_ > Phase::pending; }
  // Or a code asks for one.
  [[nodiscard]] bool is_on_or_asked_for() const { return is_on() || asked_; }
  // A moving block has made the vector, or makes it.
  [[nodiscard]] bool made_by_move() const { return phase_ == Phase::started || phase_ == Phase::running; }
  // A block that asks for the mode, or no longer does, as its words say, starts or cancels it.
  [[nodiscard]] bool starts(bool wanted) const { return wanted && phase_ == Phase::off; }
  [[nodiscard]] bool cancels(bool wanted) const { return !wanted && is_on(); }

 protected:
  enum class Phase : std::uint8_t {
    off,
    pending,  // a lone start waits for the next block that moves
    started,  // no block has moved since the start-up block
    running,
    taken_away,  // the mode goes on without a vector: after G52, G92, G53 or a reference return
    ending       // after a lone cancel the vector waits for its removal
  };

  [[nodiscard]] bool is_pending() const { return phase_ == Phase::pending; }
  // fanuc.cutter-c.number-zero: Number 0 in force acts as G40 does. G41 or G42 stays in force, and a later number other
  // than 0 asks for the mode again. A number other than 0 whose value is 0 does not cancel: the mode starts and stays
  // on.
  [[nodiscard]] bool asks(const CornerBlock& block) const {
    return block.side != CutterSide::none && !recorder_.decide(Clause::fanuc_cutter_c_number_zero, block.number == 0);
  }
  // Whether the first block that moves after a start changes the side.
  [[nodiscard]] bool changes_side_at_start(const CutterOffset& offset) const {
    return (phase_ == Phase::started || is_pending()) && offset.side != last_.side;
  }

  const spec::Setup& setup_;
  Recorder& recorder_;
  Phase phase_ = Phase::off;
  bool asked_ = false;  // by the last block: a side and a number other than 0 in force
  CutterOffset last_;   // of the last block that moved, or of a lone start
};

}  // namespace toolcomp::model

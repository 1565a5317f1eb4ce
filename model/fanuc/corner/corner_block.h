// SPDX-License-Identifier: Apache-2.0
// What a block says to the compensations that make vectors at corners: cutter compensation and tool side compensation.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "model/fanuc/corner/offset_path.h"
#include "model/fanuc/program/offset_in_force.h"
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

// The arc of a leg in its plane. `radius`: of CornerBlock.
ArcEnds arc_of(const Leg& leg, const std::optional<Rational>& radius, const spec::Axes& axes);

// Follows the codes of one section in group 07, the offset number and the plane through the program.
class CornerWords {
 public:
  // `side_of`: of a code of the section, G40 among them.
  CornerWords(const Pass::Place& place, std::optional<CutterSide> (*side_of)(Compensation));

  // In force at the end of a block, which is read next or has been read last: the side, and the number.
  [[nodiscard]] CutterSide side_after(const Command& command) const;
  [[nodiscard]] std::uint32_t number_after(const Command& command) const;

  // What the block says, without the value of its number; nothing before the first words of the section in a program:
  // a side, or what `starts` says. `by_motion`: the block moves by its code of group 01.
  template <class Block>
  [[nodiscard]] std::shared_ptr<Block> read(const BlockWords& now, bool starts, bool by_motion) {
    auto block = std::make_shared<Block>();
    return fill(now, starts, by_motion, *block) ? block : nullptr;
  }
  // The value in force at the end of the block. Throws Alarm PS0029.
  void add_value(CornerBlock& block);

 private:
  bool fill(const BlockWords& now, bool starts, bool by_motion, CornerBlock& block);

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

}  // namespace toolcomp::model

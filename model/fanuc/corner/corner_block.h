// SPDX-License-Identifier: Apache-2.0
// What a block says to the compensations that make vectors at corners: cutter compensation and tool side compensation.
#pragma once

#include <cstdint>
#include <optional>

#include "model/fanuc/program/cutter_offset.h"
#include "model/fanuc/program/pass.h"

namespace toolcomp::model {

struct CornerBlock {
  std::optional<CutterSide> code;         // a word of the section's codes, or G40
  CutterSide before = CutterSide::none;   // side in force before the block
  CutterSide side = CutterSide::none;     // and at its end
  bool number_given = false;              // a D word, or with OFH = 1 an H word
  std::uint32_t number = 0;               // offset number in force at its end
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
};

}  // namespace toolcomp::model

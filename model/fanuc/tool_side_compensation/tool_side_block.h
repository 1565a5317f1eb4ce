// What a block says to tool side compensation.
#pragma once

#include <cstdint>
#include <optional>

#include "model/fanuc/program/cutter_offset.h"
#include "model/fanuc/program/stage.h"

namespace toolcomp::model {

// What a block says to tool side compensation: its words.
struct ToolSideBlock final : StageWords {
  std::optional<CutterSide> code;        // the G40, G41.2, G42.2, G41.6 or G42.6 word
  CutterSide before = CutterSide::none;  // side in force before the block
  CutterSide side = CutterSide::none;    // and at its end
  bool number_given = false;             // a D word, or with OFH = 1 an H word
  std::uint32_t number = 0;              // offset number in force at its end
  Rational offset;                       // its signed value; 0 while `side` is none
  std::optional<int> treatment;          // Q: 1, 2 or 3; 0 where it is none of them
  std::optional<Rational> radius;        // of an arc, where R gives it
  bool wrong_mode = false;               // G41.2 under G43.5, or G41.6 without it
  bool other_compensation = false;       // G41, G42, G41.3
  bool plane_changed = false;            // against the block before
  bool leaves_the_path = false;          // a code of group 00
  bool changes_coordinates = false;      // G54–G59, G20, G21
  bool auxiliary = false;                // an M, S or T word
  bool stops_look_ahead = false;         // M00 M01 M02 M30
  bool moves = false;                    // an axis word, I J K under G43.5 included
  bool arc_mode = false;                 // G02 or G03 in force
  bool arc_words = false;                // an arc by its words
  bool is_block = true;                  // any word, N and O included

  // A word equal to the code in force before it.
  [[nodiscard]] bool repeats_code() const { return code && *code != CutterSide::none && *code == before; }
  // The compensation is on after the block.
  [[nodiscard]] bool wanted() const { return side != CutterSide::none && number != 0; }
};

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
// What a block says to tool side compensation.
#pragma once

#include <optional>

#include "model/fanuc/corner/corner_block.h"

namespace toolcomp::model {

struct ToolSideBlock : CornerBlock {
  std::optional<int> treatment;   // Q: 1, 2 or 3; 0 where it is none of them
  bool wrong_mode = false;        // G41.2 under G43.5, or G41.6 without it
  bool leaves_the_path = false;   // a code of group 00
  bool refused_while_on = false;  // G54–G59, G20, G21 and the like
  bool auxiliary = false;         // an M, S or T word
  bool stops_look_ahead = false;  // an M code that does
  bool moves = false;             // an axis word, I J K under G43.5 included
  bool arc_mode = false;          // G02 or G03 in force

  // The compensation is on after the block.
  [[nodiscard]] bool wanted() const { return side != CutterSide::none && number != 0; }
};

}  // namespace toolcomp::model

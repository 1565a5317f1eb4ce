// SPDX-License-Identifier: Apache-2.0
// FUNCTION PROG PATH: what the programmed coordinates are, and what compensation starts from (heidenhain.contour.*).
#pragma once

#include "fast/heidenhain/program/effective_tool.h"

namespace toolcomp::fast::klartext {

// What compensation needs to know of the programmed point, modal.
struct ProgrammedPoint {
  bool contour = false;  // FUNCTION PROG PATH IS CONTOUR
  bool center = false;   // REFPNT CNT-CNT under TCPM

  // How far the nominal tip lies below the programmed point, along the tool: in a block that is compensated, and in one
  // that is not. IS CONTOUR counts in compensated ones alone; there the point is on the contour whatever REFPNT.
  [[nodiscard]] double tip_below(const ToolValues& tool, bool compensated) const {
    if (!center) return 0;
    if (compensated && contour) return 0;
    return tool.corner;
  }
  // The distance of the tip from the programmed point under RL and RR.
  [[nodiscard]] double lateral(const ToolValues& tool) const {
    return contour ? tool.effective_radius : tool.radius_delta;
  }
};

}  // namespace toolcomp::fast::klartext

// The direction of compensation under RL and RR: across the movement and the tool (sheet 5.7).
#pragma once

#include "fast/klartext/motion.h"

namespace toolcomp::fast::klartext {

// What a direction is made from. Both stay where they are as long as the lateral is used.
struct Lateral {
  const ToolVector* tool = nullptr;  // nullptr: no direction
  const Displacement* travel = nullptr;
  int side = 1;
  Vector unit;  // c = side (t x d)/|t x d|, within a few ulps of 1

  explicit operator bool() const { return tool != nullptr; }
};

// The direction of a tool and a movement; none where the tool is parallel to the movement or nothing moves, exactly
// (turned tools: within 2^-90).
[[nodiscard]] Lateral lateral(const ToolVector& tool, const Displacement& travel, int side);

// (c + c')/(1 + c.c'), or false where both are opposite, exactly (turned tools: within 2^-85).
[[nodiscard]] bool mitre(const Lateral& c, const Lateral& next, Vector& between);

}  // namespace toolcomp::fast::klartext

// The direction of compensation under RL and RR: across the movement and the tool (sheet 5.7).
#pragma once

#include <cmath>

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

// Where doubles lose too much: the tool leans toward the movement; 1 + c.c' is small.
[[nodiscard]] Lateral lean_lateral(Lateral c);
[[nodiscard]] bool sharp_mitre(const Lateral& c, const Lateral& next, Vector& between);

// The direction of a tool and a movement; none where the tool is parallel to the movement or nothing moves, exactly
// (turned tools: within 2^-90).
[[nodiscard]] inline Lateral lateral(const ToolVector& tool, const Displacement& travel, int side) {
  if (travel.zero) [[unlikely]]
    return {};
  Lateral c{&tool, &travel, side, {}};
  const Vector d{travel.value[0], travel.value[1], travel.value[2]};
  const Vector v = cross(tool.unit(), d);
  const double square = dot(v, v);
  // Within 30 degrees of the tool the errors of its unit vector would count more than twice.
  if (4 * square < dot(d, d)) [[unlikely]]
    return lean_lateral(c);
  c.unit = v * (side / std::sqrt(square));
  return c;
}

// (c + c')/(1 + c.c'), or false where both are opposite, exactly (turned tools: within 2^-85).
[[nodiscard]] inline bool mitre(const Lateral& c, const Lateral& next, Vector& between) {
  const double share = 1 + dot(c.unit, next.unit);
  if (share < 0.5) [[unlikely]]
    return sharp_mitre(c, next, between);
  between = (c.unit + next.unit) * (1 / share);
  return true;
}

}  // namespace toolcomp::fast::klartext

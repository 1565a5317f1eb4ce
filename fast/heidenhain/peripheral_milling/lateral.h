// SPDX-License-Identifier: Apache-2.0
// The direction of compensation under RL and RR: across the movement and the tool (heidenhain.peripheral.direction).
#pragma once

#include <cmath>

#include "fast/heidenhain/program/motion.h"

namespace toolcomp::fast::klartext {

// What a direction is made from. Both stay where they are as long as the lateral is used.
struct Lateral {
  const ToolVector* tool = nullptr;  // nullptr: no direction
  const Displacement* travel = nullptr;
  int side = 1;
};

// Where doubles lose too much: the tool leans toward the movement; 1 + c.c' is small.
[[nodiscard]] bool lean_direction(const Lateral& made_from, Vector& c);
[[nodiscard]] bool sharp_mitre(const Lateral& c, const Lateral& next, Vector& between);

// c = side (t x d)/|t x d|, within a few ulps of 1; false where the tool is parallel to the movement or nothing moves,
// exactly (turned tools: within 2^-90; ends of travel that M140 has rounded: within what they may be off by).
[[nodiscard]] inline bool direction_of(const Lateral& made_from, Vector& c) {
  if (made_from.travel->zero) [[unlikely]]
    return false;
  const Vector d{made_from.travel->value[0], made_from.travel->value[1], made_from.travel->value[2]};
  const Vector v = cross(made_from.tool->unit(), d);
  const double square = dot(v, v);
  // Within 30 degrees of the tool the errors of its unit vector would count more than twice.
  if (4 * square < dot(d, d)) [[unlikely]]
    return lean_direction(made_from, c);
  c = v * (made_from.side / std::sqrt(square));
  return true;
}

// Of two with the same tool; roots and quotients of both at once. False: one of them is not usual.
[[gnu::always_inline, nodiscard]] inline bool directions_of(const Lateral& first, const Lateral& second, Vector& c,
                                                            Vector& next) {
  if (first.travel->zero || second.travel->zero) [[unlikely]]
    return false;
  const Vector d{first.travel->value[0], first.travel->value[1], first.travel->value[2]};
  const Vector e{second.travel->value[0], second.travel->value[1], second.travel->value[2]};
  const Vector v = cross(first.tool->unit(), d);
  const Vector w = cross(first.tool->unit(), e);
  const DoublePair square{dot(v, v), dot(w, w)};
  if (4 * square[0] < dot(d, d) || 4 * square[1] < dot(e, e)) [[unlikely]]
    return false;
  const DoublePair root{std::sqrt(square[0]), std::sqrt(square[1])};
  const DoublePair scale = DoublePair{static_cast<double>(first.side), static_cast<double>(second.side)} / root;
  c = v * scale[0];
  next = w * scale[1];
  return true;
}

// (c + c')/(1 + c.c'), or false where both are opposite, exactly (turned tools: within 2^-85; rounded ends of travel,
// as above).
[[gnu::always_inline, nodiscard]] inline bool mitre(const Vector& c, const Lateral& made_from, const Vector& next,
                                                    const Lateral& next_from, Vector& between) {
  const double share = 1 + dot(c, next);
  if (share < 0.5) [[unlikely]]
    return sharp_mitre(made_from, next_from, between);
  between = (c + next) * (1 / share);
  return true;
}

}  // namespace toolcomp::fast::klartext

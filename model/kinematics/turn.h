// SPDX-License-Identifier: Apache-2.0
// One rotary axis as the parameters describe it.
#pragma once

#include <cstddef>
#include <optional>

#include "model/geometry/vector.h"
#include "model/kinematics/angle.h"
#include "model/kinematics/coordinate.h"

namespace toolcomp::model {

// A rotation about a line through the origin, with the sense in which it acts on the direction of the tool seen from
// the table: R(line, sense (position + offset)).
struct Turn {
  std::optional<std::size_t> axis;  // controlled axis; none: hypothetical, at `offset`
  Rational offset;                  // degrees, added to the position before the sense applies
  int sense = 1;                    // -1: positive positions turn left-handed
  std::size_t about = 2;            // 0, 1, 2 for X, Y, Z; 3: another line. The first three move two components only
  Vector line{0, 0, 1};             // unit

  // Of the controlled axis; 0 for a hypothetical one.
  [[nodiscard]] Angle position(const Position& of) const { return axis ? of.at(*axis).angle() : Angle(); }
  // The right-handed angle of a position, and back.
  [[nodiscard]] Angle angle(const Angle& position) const;
  [[nodiscard]] Angle position_at(const Angle& angle) const;
  // A vector or point turned by the axis at `position`, forwards or backwards.
  [[nodiscard]] Vector apply(const Vector& v, const Angle& position) const;
  [[nodiscard]] Vector apply_back(const Vector& v, const Angle& position) const;
  // Turned forwards at one position and back at another: how a table axis carries a point along.
  [[nodiscard]] Vector carry(const Vector& v, const Angle& from, const Angle& to) const;
};

}  // namespace toolcomp::model

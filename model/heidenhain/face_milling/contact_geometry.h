// SPDX-License-Identifier: Apache-2.0
// Surface normal and tool in one block: the rational quantities on which everything in face milling is decided.
#pragma once

#include "model/geometry/vector.h"
#include "model/heidenhain/program/motion.h"
#include "model/kinematics/tool_direction.h"

namespace toolcomp::model::klartext {

// N and T as written, all products rational.
struct ContactGeometry {
  // Of a motion with a normal.
  explicit ContactGeometry(const Motion& motion);

  Vector n;       // N / |N|
  Vector t;       // T / |T|
  Real along;     // N.T
  Real across2;   // |N x T|²
  Real lengths2;  // (N.N)(T.T)
  Real lengths;   // |N||T|
  Vector w;       // (T.T) N - (N.T) T: the part of N across the tool, not normalised

  // w / |w|; w is not 0.
  [[nodiscard]] Vector ring_direction() const;
  // The angle between normal and tool in degrees; a rational where it is one.
  [[nodiscard]] Real angle() const;
};

}  // namespace toolcomp::model::klartext

// SPDX-License-Identifier: Apache-2.0
// What the policy multiplies its k with.
#pragma once

#include "fuzz/oracle/head.h"
#include "fuzz/oracle/pose_error.h"

namespace toolcomp::fuzz {

// Of one event, in units of its coordinates.
struct Scale {
  double position = 0;   // the largest linear magnitude that enters the event's coordinates
  double vector = 0;     // length of the compensation vector
  double condition = 1;  // error of the vector over error of the directions it is made of
  double start = 0;      // the same product of the vector with which an arc begins
  // Arcs with a vector or by R: sum over both ends of one unit of length over their distance to the centre.
  double turn = 0;
  double own_turn = 0;        // the same of one over the distance to the centre
  double center = 0;          // an arc by R: what its centre is off by (radius_arc.h)
  double turned = 0;          // and what that turns the directions of its ends by, in radians
  bool by_own_heads = false;  // sweep and radii are those between the controller's own heads (arc_fit.h)
  // Where the condition is large: heads that may place the vector, in lengths, and the condition of what does not.
  Heads heads;
  double rest = 1;
  bool between = false;  // a sample between two heads, on a line
  double carried =
      0;             // what X Y Z are off by that were once those of axes under tool center point control; not times k
  PoseScale pose{};  // what the rotary positions add; 3D compensation: what its directions add to every X Y Z
};

}  // namespace toolcomp::fuzz

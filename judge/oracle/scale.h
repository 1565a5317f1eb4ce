// SPDX-License-Identifier: Apache-2.0
// The quantities that the policy multiplies by k.
#pragma once

#include "judge/oracle/head.h"
#include "judge/oracle/pose_error.h"

namespace toolcomp::judge {

// The scale of one event, in the units of its coordinates.
struct Scale {
  double position = 0;   // the largest linear magnitude that enters the event's coordinates
  double vector = 0;     // length of the compensation vector
  double condition = 1;  // error of the vector divided by the error of its directions
  double start = 0;      // the same product for the vector at the start of an arc
  // Arcs with a vector or by R: the sum over both ends of one unit of length divided by their distance from the centre.
  double turn = 0;
  double own_turn = 0;        // the same for 1 divided by the distance from the centre
  double center = 0;          // an arc by R: the error of its centre (radius_arc.h)
  double turned = 0;          // and the angle by which this turns the directions of its ends, in radians
  bool by_own_heads = false;  // sweep and radii are those between the controller's own heads (arc_fit.h)
  // If the condition is large: heads that may place the vector, in lengths. Then `condition` is that of everything
  // else.
  Heads heads;
  double rest = 1;
  bool between = false;  // a sample between two heads, on a line
  double carried =
      0;  // error of X Y Z that once were positions of axes under tool center point control; not multiplied by k
  PoseScale pose{};  // contribution of the rotary positions; in 3D compensation, of its directions to every X Y Z
};

}  // namespace toolcomp::judge

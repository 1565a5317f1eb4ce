// SPDX-License-Identifier: Apache-2.0
// What the great circle of a block meets: equal or opposite ends, singular postures, the edge of reach.
#pragma once

#include <cstdint>

#include "fast/kinematics/polar_frame.h"

namespace toolcomp::fast {

// No. 19738: how near to a singular posture counts. Nothing where it is 0 or less.
struct NearLimit {
  bool counts = false;
  bool above_90 = false;
  bool above_180 = false;
  SineCosine<DoubleDouble> fine{};
  double square = 0;  // of the sine
  double cosine = 1;
  explicit operator bool() const { return counts; }
};

// One arc, seen in the system of the work-side axis.
template <class T>
struct PostureArc {
  Vector3<T> start, end;  // unit
  // Errors of the horizontal components are relative (double only).
  bool relative = false;
  // The azimuth of the tool does not change, or changes by 180: known from the positions.
  bool meridian = false;
};

struct ArcFindings {
  bool parallel = false;
  int start_pole = 0;  // +1, -1: the block starts in that singular posture
  int end_pole = 0;
  int crossing = 0;     // goes through it, inside
  int azimuth = 0;      // the sign with which the tool turns about the work-side axis
  bool leaves = false;  // the directions that can be reached
  int near = 0;         // comes near that singular posture
};

// Findings of an arc; false where a double cannot tell (never with DoubleDouble: what that cannot tell is an exact
// tie).
template <class T>
[[nodiscard]] bool find(const PolarFrame& polar, const PostureArc<T>& arc, const NearLimit& limit, ArcFindings& found);

}  // namespace toolcomp::fast

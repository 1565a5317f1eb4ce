// SPDX-License-Identifier: Apache-2.0
// Vectors of a plane over exact numbers; first axis to the right, second axis up.
#pragma once

#include "model/geometry/plane.h"

namespace toolcomp::model {

inline PlanePoint operator-(const PlanePoint& a) { return {-a[0], -a[1]}; }
inline PlanePoint operator+(const PlanePoint& a, const PlanePoint& b) { return {a[0] + b[0], a[1] + b[1]}; }
inline PlanePoint operator-(const PlanePoint& a, const PlanePoint& b) { return {a[0] - b[0], a[1] - b[1]}; }
inline PlanePoint operator*(const Real& k, const PlanePoint& a) { return {k * a[0], k * a[1]}; }
inline Real dot(const PlanePoint& a, const PlanePoint& b) { return a[0] * b[0] + a[1] * b[1]; }
// Positive where b points to the left of a.
inline Real cross(const PlanePoint& a, const PlanePoint& b) { return a[0] * b[1] - a[1] * b[0]; }
inline Real squared_norm(const PlanePoint& a) { return square(a[0]) + square(a[1]); }
// A quarter turn to the left.
inline PlanePoint left(const PlanePoint& a) { return {-a[1], a[0]}; }
// Certified; throws Undecided.
inline bool is_zero(const PlanePoint& a) { return a[0].sign() == Sign::zero && a[1].sign() == Sign::zero; }

}  // namespace toolcomp::model

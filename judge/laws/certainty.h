// SPDX-License-Identifier: Apache-2.0
// Facts about an exact value that are certain. A law is about exact numbers, so there is no tolerance: the bounds of a
// residual that is zero contain zero, however wide they are, and a violation is certain if they do not.
#pragma once

#include <array>
#include <string>

#include "model/exact/real.h"

namespace toolcomp::judge::laws {

using exact::Rational;
using exact::Real;

// Each is true only if it is certain. If nothing is certain, both of two opposites are false. They distinguish values
// of 1e-27 from zero by enclosures that are rounded outwards, and need no proof of zero.
bool certainly_positive(const Real& value);
bool certainly_negative(const Real& value);
bool certainly_not_zero(const Real& value);

// The middle of its bounds, to 20 decimals, for people.
std::string amount(const Real& value);

// X, Y, Z.
using Vector = std::array<Real, 3>;

inline Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector operator*(const Real& k, const Vector& v) { return {k * v[0], k * v[1], k * v[2]}; }
inline Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Real length(const Vector& v) { return sqrt(dot(v, v)); }

}  // namespace toolcomp::judge::laws

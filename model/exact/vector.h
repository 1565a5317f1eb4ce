// SPDX-License-Identifier: Apache-2.0
// Vectors of exact numbers, in whatever frame and unit the caller states.
#pragma once

#include "model/exact/real.h"

namespace toolcomp::exact {

/// A vector or point of three components.
struct Vector3 {
  Real x;
  Real y;
  Real z;
};

inline Vector3 operator-(const Vector3& a) { return {-a.x, -a.y, -a.z}; }
inline Vector3 operator+(const Vector3& a, const Vector3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector3 operator-(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector3 operator*(const Real& s, const Vector3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Vector3 operator*(const Vector3& a, const Real& s) { return s * a; }
/// The divisor must not be zero; throws Undecided if that cannot be certified.
inline Vector3 operator/(const Vector3& a, const Real& s) { return {a.x / s, a.y / s, a.z / s}; }

/// The scalar product.
inline Real dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
/// The vector product, right-handed.
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Zero as known without further proof.
inline bool known_zero(const Vector3& a) { return known_zero(a.x) && known_zero(a.y) && known_zero(a.z); }
/// The square of the length.
inline Real squared_norm(const Vector3& a) { return square(a.x) + square(a.y) + square(a.z); }

/// Certified, component by component; throws Undecided.
inline bool operator==(const Vector3& a, const Vector3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
/// Whether every component is certified to be zero; throws Undecided.
inline bool is_zero(const Vector3& a) {
  return a.x.sign() == Sign::zero && a.y.sign() == Sign::zero && a.z.sign() == Sign::zero;
}

}  // namespace toolcomp::exact

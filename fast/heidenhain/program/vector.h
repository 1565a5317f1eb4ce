// SPDX-License-Identifier: Apache-2.0
// Vectors in space for blocks by the million: X and Y side by side in one register.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "fast/arithmetic/trigonometry.h"
#include "fast/geometry/vector3.h"

namespace toolcomp::fast::klartext {

struct Vector {
  DoublePair xy;
  double z;

  Vector() = default;
  Vector(double x, double y, double z_) : xy{x, y}, z(z_) {}
  Vector(DoublePair xy_, double z_) : xy(xy_), z(z_) {}
  explicit Vector(const Vector3<double>& v) : Vector(v.x, v.y, v.z) {}
  // By parts: a processor that copies all bytes at once waits where z has just been written.
  // NOLINTBEGIN(modernize-use-equals-default,cert-oop54-cpp): the default copies at once.
  Vector(const Vector& other) : xy(other.xy), z(other.z) {}
  Vector& operator=(const Vector& other) {
    xy = other.xy;
    z = other.z;
    return *this;
  }
  // NOLINTEND(modernize-use-equals-default,cert-oop54-cpp)
  [[nodiscard]] double x() const { return xy[0]; }
  [[nodiscard]] double y() const { return xy[1]; }
  [[nodiscard]] double operator[](std::size_t i) const { return i == 2 ? z : xy[i]; }
};

inline Vector zero_vector() { return {0, 0, 0}; }
inline Vector operator+(const Vector& a, const Vector& b) { return {a.xy + b.xy, a.z + b.z}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a.xy - b.xy, a.z - b.z}; }
inline Vector operator*(const Vector& a, double factor) { return {a.xy * factor, a.z * factor}; }
inline double dot(const Vector& a, const Vector& b) {
  const DoublePair product = a.xy * b.xy;
  return product[0] + product[1] + a.z * b.z;
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y() * b.z - a.z * b.y(), a.z * b.x() - a.x() * b.z, a.x() * b.y() - a.y() * b.x()};
}
// v / |v|, each component within a few ulps of 1.
inline Vector unit_of(const Vector& v) { return v * (1 / std::sqrt(dot(v, v))); }

inline void put(std::array<double, 3>& to, const Vector& v) {
  std::memcpy(to.data(), &v.xy, sizeof v.xy);
  to[2] = v.z;
}

}  // namespace toolcomp::fast::klartext

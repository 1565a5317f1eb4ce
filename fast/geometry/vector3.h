// SPDX-License-Identifier: Apache-2.0
// Vectors in space, over double or DoubleDouble.
#pragma once

#include <cmath>
#include <cstddef>

#include "fast/arithmetic/double_double.h"
#include "fast/geometry/vector2.h"

namespace toolcomp::fast {

template <class T>
struct Vector3 {
  T x{};
  T y{};
  T z{};
  [[nodiscard]] constexpr const T& operator[](std::size_t i) const { return i == 0 ? x : (i == 1 ? y : z); }
};

template <class T>
constexpr Vector3<T> operator+(const Vector3<T>& a, const Vector3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
constexpr Vector3<T> operator-(const Vector3<T>& a, const Vector3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
constexpr Vector3<T> operator*(const Vector3<T>& a, const T& factor) {
  return {a.x * factor, a.y * factor, a.z * factor};
}
template <class T>
constexpr T dot(const Vector3<T>& a, const Vector3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
constexpr Vector3<T> cross(const Vector3<T>& a, const Vector3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline bool is_zero(const Vector3<double>& a) { return a.x == 0 && a.y == 0 && a.z == 0; }
inline Vector3<double> nearest(const Vector3<DoubleDouble>& v) {
  return {to_double(v.x), to_double(v.y), to_double(v.z)};
}

}  // namespace toolcomp::fast

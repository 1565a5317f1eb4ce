// SPDX-License-Identifier: Apache-2.0
// Vectors in the compensation plane, over double or DoubleDouble.
#pragma once

#include <cmath>

#include "fast/arithmetic/double_double.h"

namespace toolcomp::fast {

template <class T>
struct Vector2 {
  T x{};
  T y{};
};

template <class T>
constexpr Vector2<T> operator+(const Vector2<T>& a, const Vector2<T>& b) {
  return {a.x + b.x, a.y + b.y};
}
template <class T>
constexpr Vector2<T> operator-(const Vector2<T>& a, const Vector2<T>& b) {
  return {a.x - b.x, a.y - b.y};
}
template <class T>
constexpr Vector2<T> operator-(const Vector2<T>& a) {
  return {-a.x, -a.y};
}
template <class T>
constexpr Vector2<T> operator*(const Vector2<T>& a, const T& factor) {
  return {a.x * factor, a.y * factor};
}
template <class T>
constexpr T dot(const Vector2<T>& a, const Vector2<T>& b) {
  return a.x * b.x + a.y * b.y;
}
template <class T>
constexpr T cross(const Vector2<T>& a, const Vector2<T>& b) {
  return a.x * b.y - a.y * b.x;
}
// The vector turned left by a right angle.
template <class T>
constexpr Vector2<T> left_of(const Vector2<T>& a) {
  return {-a.y, a.x};
}
inline bool is_zero(const Vector2<double>& a) { return a.x == 0 && a.y == 0; }
// At least the length, at most twice of it.
inline double extent(const Vector2<double>& a) { return std::abs(a.x) + std::abs(a.y); }
inline double length(const Vector2<double>& a) { return std::sqrt(dot(a, a)); }

// What templates over the number need beside + - * /.
template <class T>
constexpr T number(double value) {
  if constexpr (requires { T{}.hi; })
    return {value, 0};
  else
    return value;
}
constexpr double leading(double value) { return value; }
constexpr double leading(const DoubleDouble& value) { return value.hi; }
inline double root(double value) { return std::sqrt(value); }
inline DoubleDouble root(const DoubleDouble& value) { return sqrt(value); }

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
// Vectors in X, Y, Z over exact numbers.
#pragma once

#include <cstddef>

#include "model/exact/vector.h"
#include "spec/language/axes.h"

namespace toolcomp::model {

using exact::Rational;
using exact::Real;
using exact::Sign;

using Vector = exact::Vector3;

// Without its sign, which is certified.
inline Real magnitude(const Real& value) { return value.sign() == Sign::negative ? -value : value; }

// 0, 1, 2 for X, Y, Z.
inline Real& component(Vector& v, std::size_t i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; }
inline const Real& component(const Vector& v, std::size_t i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; }

// The component an axis letter names; X, Y or Z only.
constexpr bool is_space_axis(char letter) { return letter >= 'X' && letter <= 'Z'; }
constexpr std::size_t space_index(char letter) { return static_cast<std::size_t>(letter - 'X'); }

// X Y Z of what `of` gives for a controlled axis; a machine without one of them stands at 0 in it.
template <class Of>
Vector in_space(const spec::Axes& axes, const Of& of) {
  Vector result;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (const char letter = axes.letter(i); is_space_axis(letter)) component(result, space_index(letter)) = of(i);
  return result;
}

}  // namespace toolcomp::model

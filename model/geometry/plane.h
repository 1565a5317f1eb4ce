// SPDX-License-Identifier: Apache-2.0
// Planes of arcs and of cutter compensation: G17, G18, G19.
#pragma once

#include <array>
#include <cstddef>

#include "model/geometry/vector.h"
#include "spec/language/event.h"

namespace toolcomp::model {

// First and second axis of the plane: X Y, Z X or Y Z. Setup units.
using PlanePoint = std::array<Real, 2>;

// First and second axis letters of a plane, and their letters of the arc's centre.
struct PlaneLetters {
  char first, second, first_center, second_center;
};
constexpr PlaneLetters letters(spec::Plane plane) {
  switch (plane) {
    case spec::Plane::zx:
      return {'Z', 'X', 'K', 'I'};
    case spec::Plane::yz:
      return {'Y', 'Z', 'J', 'K'};
    case spec::Plane::xy:
      break;
  }
  return {'X', 'Y', 'I', 'J'};
}

// The axis at right angles to the plane.
constexpr char normal(spec::Plane plane) {
  return plane == spec::Plane::xy ? 'Z' : plane == spec::Plane::zx ? 'Y' : 'X';
}
// The same: 0, 1, 2 for X, Y, Z.
constexpr std::size_t normal_axis(spec::Plane plane) { return space_index(normal(plane)); }

// A vector of the plane among X Y Z.
inline Vector in_space(spec::Plane plane, const PlanePoint& vector) {
  Vector result;
  component(result, space_index(letters(plane).first)) = vector[0];
  component(result, space_index(letters(plane).second)) = vector[1];
  return result;
}

// The part of a vector of X Y Z in the plane.
inline PlanePoint in_plane_of(spec::Plane plane, const Vector& vector) {
  return {component(vector, space_index(letters(plane).first)), component(vector, space_index(letters(plane).second))};
}

}  // namespace toolcomp::model

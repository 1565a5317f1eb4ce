// SPDX-License-Identifier: Apache-2.0
// The conditions that place the head of a compensation vector in a plane: lines and circles at a distance from the
// paths.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace toolcomp::judge {

// A vector of a plane, in setup units; in double: an estimate.
using Flat = std::array<double, 2>;

// X Y Z in setup units, 0 if the setup has no such axis. In double: an estimate, and no part of a verdict by itself.
using Space = std::array<double, 3>;

// First and second axis of the planes X Y, Z X, Y Z.
inline constexpr std::array<std::array<std::size_t, 2>, 3> kInPlane = {{{0, 1}, {2, 0}, {1, 2}}};

inline Flat operator-(const Flat& a, const Flat& b) { return {a[0] - b[0], a[1] - b[1]}; }
inline Flat operator+(const Flat& a, const Flat& b) { return {a[0] + b[0], a[1] + b[1]}; }
inline double dot(const Flat& a, const Flat& b) { return a[0] * b[0] + a[1] * b[1]; }
inline double cross(const Flat& a, const Flat& b) { return a[0] * b[1] - a[1] * b[0]; }
double length(const Flat& a);
inline Flat left_of(const Flat& a) { return {-a[1], a[0]}; }

// A programmed movement, seen in a plane.
struct FlatPiece {
  Flat end{};
  Flat way{};  // from its start to its end
  std::optional<Flat> center;
  double weight = 1;  // error of its direction divided by the error of its inputs
};

// One of the two conditions that place a head: its distance from a line or a circle.
struct HeadCondition {
  Flat normal{};        // unit vector in which the distance grows
  double distance = 0;  // of the head from the path, unsigned
  double slide = 0;     // along the path
  double error = 0;     // of the distance, in addition to that of the slide: of centre and radius
  double size = 0;      // of its inputs
  double weight = 1;    // of the piece
  double reach = 0;     // of a circle: its radius

  // The error of its distance, in multiples of an error of one unit of its directions.
  [[nodiscard]] double off() const { return weight * (slide + error); }
};

// The condition by the path itself, and for an arc also by its tangent, because the vectors of an outside corner are
// made of tangents.
std::array<std::optional<HeadCondition>, 2> head_conditions(const FlatPiece& piece, const Flat& corner,
                                                            const Flat& vector);

// The error of the head of a vector of this length that one direction makes, as a perpendicular vector or as one
// prolonged by the same amount; 0 for others.
double alone(const HeadCondition& a, double length);

// The same for a head at the crossing of both conditions; 0 if it is not there.
double crossing(const HeadCondition& a, const HeadCondition& b, double length);

// A head in space that two conditions place. If they cross at a small angle, the head is badly determined along both,
// but well determined across either. So it is judged by the conditions themselves, as a mitre near a reversal is: on
// both offset lines.
struct HeadBand {
  Space normal{};        // unit
  double width = 0;      // largest error of a head in this direction, without the policy's k
  double curvature = 0;  // of a circle: for each square of its total error
};
// The band of a condition. `normal` is its normal in space.
HeadBand band_of(const HeadCondition& condition, const Space& normal);
struct Head {
  std::array<HeadBand, 2> bands;
  HeadBand across;   // of the plane in which they lie
  double reach = 0;  // largest total error, without k
};

// The heads by which a vector of this length may have been placed. A condition of weight w and error e per unit of its
// directions is off by w · e.
using Heads = std::vector<Head>;

}  // namespace toolcomp::judge

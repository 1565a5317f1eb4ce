// What places the head of a compensation vector in a plane: lines and circles at a distance from the paths.
#pragma once

#include <array>
#include <optional>

namespace toolcomp::fuzz {

// A vector of a plane, in setup units; in double: an estimate.
using Flat = std::array<double, 2>;

inline Flat operator-(const Flat& a, const Flat& b) { return {a[0] - b[0], a[1] - b[1]}; }
inline Flat operator+(const Flat& a, const Flat& b) { return {a[0] + b[0], a[1] + b[1]}; }
inline double dot(const Flat& a, const Flat& b) { return a[0] * b[0] + a[1] * b[1]; }
inline double cross(const Flat& a, const Flat& b) { return a[0] * b[1] - a[1] * b[0]; }
double length(const Flat& a);
inline Flat left_of(const Flat& a) { return {-a[1], a[0]}; }

// A movement seen in a plane, programmed.
struct FlatPiece {
  Flat start{};
  Flat end{};
  std::optional<Flat> center;
  double weight = 1;  // error of its direction over the error of what it is made of
};

// One of the two things that place a head: how far it is from a line or a circle.
struct HeadCondition {
  Flat normal{};        // unit, in which the distance grows
  double distance = 0;  // of the head from the path, unsigned
  double slide = 0;     // along the path
  double error = 0;     // of the distance, besides the slide's: of centre and radius
  double size = 0;      // of the numbers it is made of
  double weight = 1;    // of the piece
};

// By the path itself, and for an arc by its tangent too: the vectors of an outer corner are made of tangents.
std::array<std::optional<HeadCondition>, 2> head_conditions(const FlatPiece& piece, const Flat& corner,
                                                            const Flat& vector);

// The error of a head of a vector of this length that lies where the two cross; 0 where it does not.
double crossing(const HeadCondition& a, const HeadCondition& b, double length);

}  // namespace toolcomp::fuzz

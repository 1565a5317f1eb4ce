// SPDX-License-Identifier: Apache-2.0
// The compensation plane: at right angles to the tool (clauses fanuc.tool-side).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "fast/arithmetic/count.h"
#include "fast/arithmetic/double_double.h"
#include "fast/fanuc/tool_side_compensation/travel.h"
#include "fast/geometry/path.h"
#include "fast/geometry/vector3.h"
#include "fast/kinematics/kinematics.h"

namespace toolcomp::fast {

// How one straight travel turns into the next, seen along the tool: V the tool's unit vector, u the travel on the
// plane.
struct SpaceTurn {
  int cross = 0;  // the sign of V . (U1 x U2), +1 to the left
  int dot = 0;    // the sign of u1 . u2
  double c = 0;   // sine and cosine of the turn
  double k = 1;
  Vector3<double> left1;   // unit, V x u1
  Vector3<double> ahead1;  // unit, along u1
  double length1 = 0;      // |u1|, setup units
  bool ill = false;        // doubles lose more than a few bits: take the fine numbers
};

// What a tool sees of a travel, by doubles. Where it stands, one is enough for all it is asked about a path.
struct SeenTravel {
  Vector3<double> left;  // V x U, whole units
  double square = 0;     // |V x U|^2
  double norm = 0;       // |V x U|
  double inverse = 0;    // 1 / |V x U|
};

// A line, and what the tool sees of it.
struct SeenLine {
  const Travel& travel;
  const SeenTravel& seen;
};

// Double-double numbers of the turn.
struct FineTurn {
  Vector3<DoubleDouble> left1, ahead1, left2, ahead2;
  DoubleDouble c, k, length1;
};

// Decisions go through three levels, each used only where the one before cannot tell:
//  1. structure, and doubles with the bounds below;
//  2. whole numbers of 512 bits, where tool and travels are whole;
//  3. double-double, 2^-96 of the terms. What it cannot tell is taken for an exact tie: decimals of 15 digits come so
//     close only where an identity makes the tie exact, or made for it, inside the band where both outcomes are right.
//
// Level 1, u = 2^-53, v the rounded tool (|v_i - V_i| <= e), n the rounded U1 x U2 (relative error u, made of exact
// whole numbers), w = v x U rounded:
//   |v.n - V.(U1 x U2)| <= (e + 5u) (|n_x| + |n_y| + |n_z|);
//   each component of w is within (e + 4u)(|U_j| + |U_k|), so |w - V x U| <= sqrt 6 (e + 4u) |U|;
//   |w1.w2 - u1.u2| <= (2 sqrt 6 (e + 4u) + 5u) |U1||U2| (and a square below that), at most (5(e + 4u) + 8u) |U1||U2|;
//   |w1.U2 - V.(U1 x U2)| is below the same bound.
class ToolPlane {
 public:
  ToolPlane(const Kinematics& kinematics, const Direction& tool) : kinematics_(kinematics), tool_(tool) {}

  [[nodiscard]] SeenTravel see(const Travel& travel) const;
  // Whether a line moves in the plane: |u| > 0, and not below the limit (No. 19630; 0: none).
  [[nodiscard]] bool moves(const SeenLine& line, const Amount& limit) const;
  // The turn between two lines that move in the plane.
  void set_turn(const SeenLine& first, const SeenLine& second, SpaceTurn& turn) const;
  // Of a travel whose turn is not ill: the unit vectors to its left and along it.
  void set_leg(const Travel& travel, Vector3<double>& left, Vector3<double>& ahead) const {
    const Vector3<double> w = cross(unit(), travel.value);
    left = w * (1 / std::sqrt(dot(w, w)));
    ahead = cross(left, unit());
  }
  [[nodiscard]] FineTurn fine_turn(const Travel& first, const Travel& second) const;
  // Of one travel: left1, ahead1 and length1 (c = 0, k = 1).
  [[nodiscard]] SpaceTurn straight(const Travel& travel) const;

  // The sign of V . (axis i): the side from which the tool looks on the plane of the other two axes.
  [[nodiscard]] int facing(std::size_t axis) const {
    if ((tool_.zero >> axis & 1U) != 0) return 0;
    const double component = tool_.unit[static_cast<Eigen::Index>(axis)];
    return std::abs(component) > tool_.error ? sign_of(component) : facing_by_little(axis);
  }
  // The tool stands exactly along axis i.
  [[nodiscard]] bool along(std::size_t axis) const {
    return facing((axis + 1) % 3) == 0 && facing((axis + 2) % 3) == 0;
  }

  // Over |U1||U2| (level 1).
  [[nodiscard]] double square_bound() const { return 5 * (tool_.error + 4 * u) + 8 * u; }
  [[nodiscard]] const Direction& tool() const { return tool_; }
  [[nodiscard]] Vector3<double> unit() const { return {tool_.unit[0], tool_.unit[1], tool_.unit[2]}; }
  [[nodiscard]] Vector3<DoubleDouble> fine_unit() const {
    const FineVector& v = kinematics_.refine(tool_);
    return {v[0], v[1], v[2]};
  }
  // How far a component of fine_unit() may be from the truth.
  [[nodiscard]] double fine_error() const { return tool_.refined_error(); }

 private:
  static constexpr double u = 0x1p-53;
  // moves() where doubles cannot tell.
  [[nodiscard]] bool moves_by_little(const Travel& travel, const Amount& limit) const;
  // facing() where doubles cannot tell.
  [[nodiscard]] int facing_by_little(std::size_t axis) const;
  // The turn by doubles alone, for the usual corner. False where doubles cannot tell, or are not good enough.
  [[nodiscard]] bool set_quick_turn(const SeenLine& first, const SeenLine& second, SpaceTurn& turn) const;
  // The turn by levels 2 and 3.
  void set_fine_turn(const Travel& first, const Travel& second, SpaceTurn& turn) const;
  // Every product of unlike components is zero: the tool is at right angles to a vector.
  [[nodiscard]] bool is_across(const std::array<std::int64_t, 3>& normal) const;
  // u1 . u2 of narrow travels in whole units, where the tool is along an axis, or at right angles to one of them.
  [[nodiscard]] std::optional<std::int64_t> whole_dot(const Travel& first, const Travel& second) const;
  // The exact signs.
  [[nodiscard]] int cross_sign(const Travel& first, const Travel& second) const;
  [[nodiscard]] int dot_sign(const Travel& first, const Travel& second) const;
  // V x U in whole units, without cancellation.
  [[nodiscard]] Vector3<DoubleDouble> fine_left(const Travel& travel) const;

  const Kinematics& kinematics_;
  const Direction& tool_;
};

[[gnu::always_inline]] inline SeenTravel ToolPlane::see(const Travel& travel) const {
  SeenTravel seen;
  seen.left = cross(unit(), travel.value);
  seen.square = dot(seen.left, seen.left);
  seen.norm = std::sqrt(seen.square);
  seen.inverse = 1 / seen.norm;
  return seen;
}

// Every block asks, for each corner that waits for it.
inline bool ToolPlane::moves(const SeenLine& line, const Amount& limit) const {
  const Travel& travel = line.travel;
  if (travel.zero) return false;
  const double shortest = limit.nearest * travel.unit;
  const double over = line.seen.square - shortest * shortest;
  const double bound = square_bound() * travel.square + 4 * 0x1p-53 * shortest * shortest;
  if (travel.slack == 0 && std::abs(over) > bound) [[likely]]
    return over > 0;
  return moves_by_little(travel, limit);
}

[[gnu::always_inline]] inline bool ToolPlane::set_quick_turn(const SeenLine& first, const SeenLine& second,
                                                             SpaceTurn& turn) const {
  if (!first.travel.narrow || !second.travel.narrow) return false;
  // Nearer than 30 degrees to the tool the projection loses digits.
  if (4 * first.seen.square < first.travel.square || 4 * second.seen.square < second.travel.square) return false;
  const Vector3<double> v = unit();
  const std::array<std::int64_t, 3> a = first.travel.small();
  const std::array<std::int64_t, 3> b = second.travel.small();
  const std::array<std::int64_t, 3> n{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const Vector3<double> normal{static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2])};
  const double size = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
  double c = dot(v, normal);
  if (std::abs(c) > (tool_.error + 5 * u) * size) [[likely]] {
    turn.cross = c > 0 ? 1 : -1;
  } else {
    if (!is_across(n)) return false;
    turn.cross = 0;
    c = 0;
  }
  double k = dot(first.seen.left, second.seen.left);
  // |U1||U2| is at most 4 |w1||w2| here.
  if (std::abs(k) > 4 * square_bound() * first.seen.norm * second.seen.norm) [[likely]] {
    turn.dot = k > 0 ? 1 : -1;
  } else {
    const std::optional<std::int64_t> product = whole_dot(first.travel, second.travel);
    if (!product) return false;
    turn.dot = *product > 0 ? 1 : (*product < 0 ? -1 : 0);
    k = static_cast<double>(*product);
  }
  const double inverses = first.seen.inverse * second.seen.inverse;
  turn.c = c * inverses;
  turn.k = k * inverses;
  turn.left1 = first.seen.left * first.seen.inverse;
  turn.ahead1 = cross(turn.left1, v);
  constexpr double kOne = 1 / static_cast<double>(Count::kSmallPerOne);
  turn.length1 = first.seen.norm * kOne;
  turn.ill = false;
  return true;
}

[[gnu::always_inline]] inline void ToolPlane::set_turn(const SeenLine& first, const SeenLine& second,
                                                       SpaceTurn& turn) const {
  if (!set_quick_turn(first, second, turn)) [[unlikely]]
    set_fine_turn(first.travel, second.travel, turn);
}

// The sign of (V1 x U1) . (V2 x U2) of two tools.
int dot_sign(const Kinematics& kinematics, const Travel& first, const Direction& first_tool, const Travel& second,
             const Direction& second_tool);

}  // namespace toolcomp::fast

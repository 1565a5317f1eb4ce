// The compensation plane: at right angles to the tool (clauses fanuc.tool-side).
#pragma once

#include <cmath>
#include <cstddef>

#include "fast/arithmetic/count.h"
#include "fast/arithmetic/double_double.h"
#include "fast/fanuc/tool_side_compensation/travel.h"
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
  double length1 = 0;      // |u1|, |u2|, setup units
  double length2 = 0;
  bool ill = false;  // doubles lose more than a few bits: take the fine numbers
};

// Double-double numbers of the same.
struct FineTurn {
  Vector3<DoubleDouble> left1, ahead1, left2, ahead2;
  DoubleDouble c, k, length1, length2;
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

  // Whether a travel moves in the plane: |u| > 0, and not below the limit (No. 19630; 0 or less: none).
  [[nodiscard]] bool moves(const Travel& travel, const Count& limit) const;
  // The turn between two travels that move in the plane.
  void set_turn(const Travel& first, const Travel& second, SpaceTurn& turn) const;
  // Of a travel whose turn is not ill: the unit vectors to its left and along it.
  void set_leg(const Travel& travel, Vector3<double>& left, Vector3<double>& ahead) const {
    const Vector3<double> w = cross(unit(), travel.value);
    left = w * (1 / std::sqrt(dot(w, w)));
    ahead = cross(left, unit());
  }
  [[nodiscard]] FineTurn fine_turn(const Travel& first, const Travel& second) const;
  // Of one travel: left1, ahead1 and length1 (c = 0, k = 1, and length2 the same).
  [[nodiscard]] SpaceTurn straight(const Travel& travel) const;

  // The sign of V . (axis i): the side from which the tool looks on the plane of the other two axes.
  [[nodiscard]] int facing(std::size_t axis) const;
  // The tool stands exactly along axis i.
  [[nodiscard]] bool along(std::size_t axis) const;

  // Over |U1||U2| (level 1).
  [[nodiscard]] double square_bound() const {
    constexpr double u = 0x1p-53;
    return 5 * (tool_.error + 4 * u) + 8 * u;
  }
  [[nodiscard]] const Direction& tool() const { return tool_; }
  [[nodiscard]] Vector3<double> unit() const { return {tool_.unit[0], tool_.unit[1], tool_.unit[2]}; }
  [[nodiscard]] Vector3<DoubleDouble> fine_unit() const {
    const FineVector& v = kinematics_.refine(tool_);
    return {v[0], v[1], v[2]};
  }
  // How far a component of fine_unit() may be from the truth.
  [[nodiscard]] double fine_error() const { return tool_.refined_error(); }

 private:
  // moves() where doubles cannot tell.
  [[nodiscard]] bool moves_by_little(const Travel& travel, const Count& limit) const;
  // The turn by doubles alone, for the usual corner. False where doubles cannot tell, or are not good enough.
  [[nodiscard]] bool quick_turn(const Travel& first, const Travel& second, SpaceTurn& turn) const;
  // The exact signs.
  [[nodiscard]] int cross_sign(const Travel& first, const Travel& second) const;
  [[nodiscard]] int dot_sign(const Travel& first, const Travel& second) const;
  // V x U in whole units, without cancellation.
  [[nodiscard]] Vector3<DoubleDouble> fine_left(const Travel& travel) const;

  const Kinematics& kinematics_;
  const Direction& tool_;
};

// Every block asks, for each corner that waits for it.
inline bool ToolPlane::moves(const Travel& travel, const Count& limit) const {
  if (travel.zero) return false;
  const double shortest = Count() < limit ? limit.nearest() * travel.unit : 0;
  const Vector3<double> w = cross(unit(), travel.value);
  const double over = dot(w, w) - shortest * shortest;
  const double bound = square_bound() * travel.square + 4 * 0x1p-53 * shortest * shortest;
  if (travel.slack == 0 && std::abs(over) > bound) [[likely]]
    return over > 0;
  return moves_by_little(travel, limit);
}

// The sign of (V1 x U1) . (V2 x U2) of two tools.
int dot_sign(const Kinematics& kinematics, const Travel& first, const Direction& first_tool, const Travel& second,
             const Direction& second_tool);

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
// How well the head of a compensation vector is determined in the plane at right angles to the tool.
#pragma once

#include <array>
#include <deque>
#include <optional>
#include <span>

#include "judge/oracle/corner.h"
#include "judge/oracle/head.h"

namespace toolcomp::judge {

// Corners of tool side compensation (fanuc.tool-side.projection, -without-basis, -inner, -arc-in-the-plane).
//
// The tool direction T is made of sines and cosines: in double it carries an error e of a few ulps, the movement U
// none. The projected direction u = U - (U·T) T is |U| sin(U, T) long, and its normal T × U as well: an error of T
// turns either by e/sin(U, T) within the plane, and by e out of it. So every direction has the weight 1/sin(U, T). A
// vector made of one of them (perpendicular, or prolonged by r) has that condition; where two offset lines cross, n1·V
// = r and n2·V = r, an error of n moves the head by weight · slide along the other line over the sine of their angle:
// near 1 + c = 0 the slide is what makes the vector long, near |u| = 0 the weight grows. The same with the radius of an
// arc, from the projected centre, in the place of U; an arc by R has the weight of its centre in addition. A movement
// nearer to the tool than policy::kParallel has no direction in double; the model's decision on it is a near tie.
//
// It does not matter which blocks made a vector: the last two movements before it and the next ones are tried, and the
// worst one that fits counts.
class ToolPlane {
 public:
  // As Corners::error; `tool` is the unit direction with which the vector was made.
  [[nodiscard]] double error(std::span<const model::Event> window, const View& view, const Space& vector,
                             const Space& tool, Heads* heads = nullptr) const;
  // Takes the movement of `event`, which starts at `from`.
  void follow(const model::Event& event, const View& view, const Programmed& from);

 private:
  // A movement in space, programmed.
  struct Piece {
    Space start{};
    Space end{};
    Space way{};                  // from start to end
    std::optional<Space> center;  // of an arc; its coordinate across the arc's plane is not set
    std::size_t across = 0;       // that coordinate
    double weight = 1;            // of directions that start in the centre
  };
  static std::optional<Piece> piece(const model::Event& event, const View& view, const Programmed& from);

  std::deque<Piece> before_;  // the last two movements, the latest first
};

}  // namespace toolcomp::judge

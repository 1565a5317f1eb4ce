// SPDX-License-Identifier: Apache-2.0
// How well the head of a compensation vector in a plane is determined, from the exact events around it.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "judge/oracle/head.h"
#include "judge/oracle/radius_arc.h"
#include "model/basis/event.h"
#include "spec/language/setup.h"

namespace toolcomp::judge {

// A programmed position, exactly.
using Programmed = spec::AxisValues<model::Real>;

// How the events of a run are read.
struct View {
  std::array<std::size_t, 3> index;  // of X Y Z; Axes::kNone
  Space shift{};                     // of actual against programmed positions, if there is no vector
  Rounded rounded;
};

// The move that the compensation used: the event itself if it is a move, or the move that it replaces (Event::unmade).
const model::Event* movement(const model::Event& event);

// Corners of cutter compensation B and C.
//
// A head is determined by two conditions: its distance from the straight line of a block, or from the centre of an arc.
// An error e of each moves it by their sum over the sine of the angle at which the two offset curves cross. The
// distance from a line is wrong by the slide of the vector along the line times the error of the line's direction; the
// distance from a circle by an error of the centre and of the radius. So near a reversal (1 + k → 0) the error grows
// with the slide, which is what makes the vector long; near a tangent intersection (R'² - h² → 0) with R' over the
// root. Perpendicular vectors, and those prolonged by r, are determined by one direction, and are as good as that
// direction is; in an arc by R, as good as its centre is (radius_arc.h).
//
// It does not matter of which kind a head is, and in which plane it was made: every condition that fits counts, and of
// these the worst.
class Corners {
 public:
  // The error of the head that `window[0]` goes to, in multiples of an error of one unit in one unit of length, in
  // addition to that of the vector's own length. `vector` is its compensation vector, `window` as for Conditions::next.
  // `heads` gets what may place the head at the crossing of two conditions, in the same multiples; the error is then
  // that of everything else.
  [[nodiscard]] double error(std::span<const model::Event> window, const View& view, const Space& vector,
                             Heads* heads = nullptr) const;
  // Takes the movement of `event`, which starts at `from`.
  void follow(const model::Event& event, const View& view, const Programmed& from);

 private:
  static std::optional<FlatPiece> piece(const model::Event& event, const View& view, const Programmed& from,
                                        std::size_t plane);

  std::array<std::optional<FlatPiece>, 3> before_;  // the latest movement in each plane
};

// Of X Y Z in the values of an event.
Space space_of(const spec::AxisValues<model::Real>& values, const std::array<std::size_t, 3>& index);
// The way from one to the other, rounded once. The difference of rounded positions would have their errors, and far
// from the origin these are larger than the part across the tool of a movement along it.
Space way_of(const Programmed& from, const Programmed& to, const std::array<std::size_t, 3>& index);

}  // namespace toolcomp::judge

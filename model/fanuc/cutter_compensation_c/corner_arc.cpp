// SPDX-License-Identifier: Apache-2.0
// G39: an arc about the corner.
#include <utility>

#include "model/fanuc/cutter_compensation_c/cutter_compensation_c.h"
#include "model/geometry/arc.h"

namespace toolcomp::model {

void CutterCompensationC::take_corner_arc(Step& now) {
  ahead_.end_before(now);
  const CutterBlock& block = said(now);
  // fanuc.cutter-c.corner-arc-direction: The direction u of G39 is that of the letters of the plane among I J K. A
  // missing letter is 0, and the letter outside the plane means nothing. Without letters of the plane, u is the start
  // tangent of the next moving block. That block may also be the cancel block (its own line, whatever its I J K) or,
  // with CCN = 1, the way to the intermediate point.
  const bool has_direction =
      recorder().decide(Clause::fanuc_cutter_c_corner_arc_direction, block.direction.has_value());
  SpaceGroup group;
  if (has_direction) group = turn(now, heading(*block.direction), false);
  ahead_.hold(now, Held::Kind::corner_arc, ahead_.last_offset(), nullptr);
  if (has_direction) ahead_.pass(std::move(group));
}

// From the vector in force, which is square to its heading, to the one square to another.
SpaceGroup CutterCompensationC::turn(Step& arc, const Heading& to, bool next_is_square) {
  const Rational offset = ahead_.last_offset().left();
  if (offset == 0) {
    // fanuc.cutter-c.value-zero: If r = 0, the group is the zero vector alone, whatever the corner and No. 5010. There
    // are then no corner moves, not even before an arc of 180 degrees or more. A start-up and a cancel with r = 0 keep
    // their causes.
    recorder().reach(Clause::fanuc_cutter_c_value_zero);
    return ahead_.here();
  }
  const bool clockwise = offset > 0;
  const Real left_turn = cross(here_heading_.along, to.along);
  const Real cosine = dot(here_heading_.along, to.along);
  const Real sine = clockwise ? -left_turn : left_turn;
  // fanuc.cutter-c.corner-arc: With G39 while the mode is on, the block before ends with P1, and the tool runs an arc
  // about the corner from the vector V in force to V' = rho N(u). r and side are those of the moving block before,
  // whatever has changed since.
  const Sign side = recorder().decide(Clause::fanuc_cutter_c_corner_arc, sine, here_heading_.length * to.length);
  const CutterBlock& block = said(arc);
  PathEnd end;
  end.heading = to;
  end.offset = offset;
  here_heading_ = to;
  const bool stays = side == Sign::zero && cosine.sign() == Sign::positive;
  if (!stays) {
    if (arc.moves.empty()) arc.moves.push_back(arc.rest);
    Leg& leg = arc.moves.front().leg;
    leg.type = spec::MoveType::arc;
    leg.cause = spec::Cause::corner;
    spec::Arc<Real>& path = leg.arc.emplace();
    const PlaneLetters in_plane = letters(block.plane);
    path.center.set(axes_.index(in_plane.first), block.start[0]);
    path.center.set(axes_.index(in_plane.second), block.start[1]);
    path.plane = block.plane;
    path.direction = clockwise ? spec::ArcDirection::cw : spec::ArcDirection::ccw;
    path.sweep = swept_angle(sine, cosine, side);
  }
  return in_space(block.plane, {{perpendicular(end), Seat::off, next_is_square ? Seat::square : Seat::off}});
}

}  // namespace toolcomp::model

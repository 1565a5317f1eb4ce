// G39: an arc about the corner.
#include <utility>

#include "model/fanuc/cutter_compensation_c/cutter_compensation_c.h"
#include "model/geometry/arc.h"

namespace toolcomp::model {

void CutterCompensationC::take_corner_arc(Step& now) {
  ahead_.end_before(now);
  const CutterBlock& block = said(now);
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
    recorder().reach(Clause::fanuc_cutter_c_value_zero);
    return ahead_.here();
  }
  const bool clockwise = offset > 0;
  const Real left_turn = cross(here_heading_.along, to.along);
  const Real cosine = dot(here_heading_.along, to.along);
  const Real sine = clockwise ? -left_turn : left_turn;
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

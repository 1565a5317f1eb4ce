// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/cutter_compensation_b/rules.h"

#include "model/basis/alarm.h"
#include "model/geometry/arc.h"
#include "model/geometry/plane_vector.h"

namespace toolcomp::model {
namespace {

// Of this length to the left, at right angles to `direction`, which is not zero.
PlanePoint across(const Rational& length, const PlanePoint& direction) {
  return Real(length) / sqrt(squared_norm(direction)) * left(direction);
}

// The offset value to the left of the path, with its sign.
//
// fanuc.cutter-b.number-zero: Number 0 is a number of the value 0: vectors of length 0 are made with it, the start-up
// included. D0 does not cancel the mode.
// fanuc.cutter.side: G41 with a positive value and G42 with a negative value offset to the left of the movement, and
// the other two cases to the right. A negative value thus exchanges G41 and G42.
Rational to_the_left(Recorder& recorder, const CutterBlock& block) {
  recorder.decide(Clause::fanuc_cutter_b_number_zero, block.number == 0);
  const Rational length = block.side == CutterSide::left ? block.offset : -block.offset;
  recorder.decide(Clause::fanuc_cutter_side, length, abs(length));
  return length;
}

}  // namespace

// fanuc.cutter-b.vector: While the mode is on, a straight block (G00 or G01) with an axis word of the plane makes the
// vector at its end. The vector is as long as the offset value and at right angles to a direction, to the left of it
// under G41, to the right under G42. The direction is that of I J K if the block has them, otherwise that of its own
// travel in the plane.
std::optional<PlanePoint> vector_of_line(Recorder& recorder, const CutterBlock& block) {
  PlanePoint direction;
  bool kept = false;
  // fanuc.cutter-b.direction-words: In any straight block of the mode with an axis word of the plane, I J (G17), K I
  // (G18) or J K (G19) are the direction. Only the direction counts. A missing letter is 0, and the letter that is not
  // of the plane means nothing.
  if (recorder.decide(Clause::fanuc_cutter_b_direction_words, block.direction.has_value())) {
    direction = *block.direction;
    // fanuc.cutter-b.direction-zero: If the direction is given and is zero (letters of the plane that are 0), no vector
    // is made, and the one in force is kept.
    kept = recorder.decide(Clause::fanuc_cutter_b_direction_zero, is_zero(direction));
  } else {
    direction = block.end - block.start;
    // fanuc.cutter-b.no-travel: A block with an axis word of the plane, but without a direction and without travel in
    // the plane, makes no vector, and the one in force is kept.
    kept = recorder.decide(Clause::fanuc_cutter_b_no_travel, block.motion == PlaneMotion::zero_travel);
  }
  if (kept) return std::nullopt;
  recorder.reach(Clause::fanuc_cutter_b_vector);
  return across(to_the_left(recorder, block), direction);
}

// fanuc.cutter-b.arc-vector: The vector at the end of an arc is on the line of centre and end, to the left (G41) or
// right (G42) of the tool's movement there. The tool goes from the old head to the new one on an arc about the same
// centre in the same direction. If the block before does not join in a tangent, the two heads have different distances
// from the centre, and the tool's arc is a spiral.
// fanuc.cutter-b.arc-ends-in-center: An arc whose end is its centre has no direction there and raises PS0038.
PlanePoint vector_of_arc(Recorder& recorder, const CutterBlock& block) {
  const PlanePoint& to_end = block.arc->end;
  if (is_zero(to_end)) raise(recorder, Clause::fanuc_cutter_b_arc_ends_in_center, AlarmCause::arc_ends_in_center);
  recorder.reach(Clause::fanuc_cutter_b_arc_vector);
  return across(to_the_left(recorder, block), Real(block.arc->turn) * left(to_end));
}

// fanuc.cutter-b.arc-sweep: The sweep of the tool's arc (G39's arc included) is the angle from the old head to the new
// one about the centre, in the direction of the arc, over 0 and up to 360 degrees. If both heads are on one ray, it is
// a whole turn. The arc never makes more than one turn. If a head is in the centre, no sweep can be stated.
bool head_to_head(Recorder& recorder, spec::Arc<Real>& arc, const PlanePoint& from, const PlanePoint& to) {
  arc.sweep.reset();
  arc.radius.reset();
  bool one_head = false;
  const Real from2 = squared_norm(from);
  const Real to2 = squared_norm(to);
  const bool in_center = from2.sign() == Sign::zero || to2.sign() == Sign::zero;
  // fanuc.cutter-b.arc-head-in-center: If the old or the new head is in the centre (the offset value is the radius of
  // an arc that is cut inside), no sweep can be stated.
  if (!recorder.decide(Clause::fanuc_cutter_b_arc_head_in_center, in_center)) {
    const Real left_turn = cross(from, to);
    const Real sine = arc.direction == spec::ArcDirection::ccw ? left_turn : -left_turn;
    const Sign side = recorder.decide(Clause::fanuc_cutter_b_arc_sweep, sine, sqrt(from2 * to2));
    const Real cosine = dot(from, to);
    arc.sweep = swept_angle(sine, cosine, side);
    one_head = side == Sign::zero && cosine.sign() == Sign::positive;
  }
  // fanuc.cutter-b.arc-radii: If the heads have different distances from the centre, the radius of the tool's arc grows
  // or shrinks evenly with the angle, and the event holds both radii.
  if (recorder.decide(Clause::fanuc_cutter_b_arc_radii, to2 - from2, to2 + from2) != Sign::zero) {
    arc.radius = {sqrt(from2), sqrt(to2)};
    one_head = false;
  }
  return one_head;
}

// fanuc.cutter-b.cancel: G40 removes the vector at once. The block's own move goes from the old head to the programmed
// end, without a vector there, in rapid traverse under G00, otherwise straight, even if the block moves only outside
// the plane. If the start-up has been made, the cause of this move is cancel; before the start-up, and while the mode
// is off, it is programmed. I, J and K in the block mean nothing.
// fanuc.cutter-b.cancel-alone: G40 in a block without an axis word moves the tool back by the vector, in one move with
// the cause cancel. A zero vector makes no move. A length offset that changes in the block goes along; with a zero
// vector it has its own move, with the cause programmed. G92, G10 and G04 count as blocks without an axis word; with
// G92 the coordinates are those after the renaming.
Removal removal(Recorder& recorder, const CutterBlock& block, bool started, const PlanePoint& vector) {
  const bool has_started = recorder.decide(Clause::fanuc_cutter_b_cancel, started);
  const bool by_words = block.axis_word && (block.one_shot == OneShot::none || block.motion != PlaneMotion::none);
  if (by_words || block.motion == PlaneMotion::arc) return has_started ? Removal::in_own_move : Removal::none;
  return recorder.decide(Clause::fanuc_cutter_b_cancel_alone, !is_zero(vector)) ? Removal::alone : Removal::none;
}

// fanuc.cutter-b.corner-arc: G39 in the mode makes a new vector at right angles to a direction and takes the tool there
// on an arc about the programmed point, with the cause corner and the feed of the block. The programmed position stays.
// G39 is not modal, and the code of group 01 in force stays. That G39 also runs under G00 is our definition; the manual
// speaks of G01, G02 and G03. A length offset that changes in the block goes along with the arc. If there is no arc, it
// has its own move, with the cause programmed.
CornerArcOfB corner_arc_of_b(Recorder& recorder, const CutterBlock& block, const PlanePoint& before) {
  recorder.reach(Clause::fanuc_cutter_b_corner_arc);
  // fanuc.cutter-b.corner-arc-direction: The direction of G39 is that of I J (K I, J K); a missing letter is 0. Without
  // a letter of the plane it is that of the axis words: in G91 as written, in G90 from the programmed position to the
  // point named (a missing axis gives 0), both in the workpiece system in force after the codes of the block. If the
  // block has both, I J K count (our definition).
  recorder.decide(Clause::fanuc_cutter_b_corner_arc_direction, block.direction_letters);
  const Rational length = to_the_left(recorder, block);
  CornerArcOfB result;
  result.vector = across(length, *block.direction);
  // fanuc.cutter-b.corner-arc-sense: The arc of G39 runs clockwise under G41 and counter-clockwise under G42. A
  // negative offset value reverses the sense, and a value of 0 counts as not positive (both our definition).
  const bool clockwise = recorder.decide(Clause::fanuc_cutter_b_corner_arc_sense, length > 0);
  result.arc.direction = clockwise ? spec::ArcDirection::cw : spec::ArcDirection::ccw;
  const bool no_vector = is_zero(before) && is_zero(result.vector);
  const bool one_head = no_vector || head_to_head(recorder, result.arc, before, result.vector);
  // fanuc.cutter-b.corner-arc-none: If the new vector equals the old one, G39 makes no move, even if the block has axis
  // words. The vectors are equal only if both direction and length are: fanuc.cutter-b.arc-sweep and
  // fanuc.cutter-b.arc-radii are both ties and the heads are on one ray, or both vectors are zero.
  result.moves = !recorder.decide(Clause::fanuc_cutter_b_corner_arc_none, one_head);
  return result;
}

}  // namespace toolcomp::model

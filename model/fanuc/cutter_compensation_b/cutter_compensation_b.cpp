#include "model/fanuc/cutter_compensation_b/cutter_compensation_b.h"

#include <utility>

#include "model/basis/alarm.h"
#include "model/fanuc/corner/plane_vector.h"

namespace toolcomp::model {
namespace {

bool changes_number(const CutterBlock& words) { return words.number_given && words.number != words.number_before; }

Rational magnitude(const Rational& value) { return value < 0 ? Rational(-value) : value; }

}  // namespace

CutterCompensationB::CutterCompensationB(const Place& place) : CutterCompensation(place), axes_(place.setup.axes) {}

void CutterCompensationB::check(const CutterBlock& words) const {
  check_common(words);
  if (words.one_shot == OneShot::corner_arc) check_corner_arc(words);
  if (words.arc_words) check_arc(words);
}

void CutterCompensationB::check_corner_arc(const CutterBlock& words) const {
  const bool forbidden = words.code || changes_number(words) || words.axis_word_outside;
  if (!on() || !started_ || forbidden || !words.direction || is_zero(*words.direction))
    raise(recorder(), Clause::fanuc_cutter_b_corner_arc_format, "PS0035",
          "G39 outside the mode, with another code, number or axis, or without a direction");
}

void CutterCompensationB::check_arc(const CutterBlock& words) const {
  constexpr const char* kArc = "an arc in a block that starts, changes or cancels cutter compensation";
  const bool is_on = words.side != CutterSide::none;
  if (is_on && words.code) raise(recorder(), Clause::fanuc_cutter_b_arc_with_code, "PS0034", kArc);
  if (is_on && changes_number(words)) raise(recorder(), Clause::fanuc_cutter_b_arc_with_number, "PS0034", kArc);
  if (is_on && !started_) raise(recorder(), Clause::fanuc_cutter_b_arc_at_start_up, "PS0034", kArc);
  if (!is_on && on() && recorder().decide(Clause::fanuc_cutter_b_arc_at_cancel, !is_zero(vector_)))
    throw Alarm("PS0034", kArc);
}

void CutterCompensationB::take(const Step& step) {
  if (!has_words(step)) {
    hand_on(step);
    return;
  }
  Step out = step;
  run(out);
  side_ = said(step).side;
  out.clauses.add(recorder().take_clauses());
  hand_on(out);
}

void CutterCompensationB::run(Step& step) {
  const CutterBlock& block = said(step);
  if (block.side == CutterSide::none) {
    if (on()) cancel(step);
    return;
  }
  if (!on())
    recorder().reach(Clause::fanuc_cutter_b_mode);
  else if (block.code)
    recorder().decide(Clause::fanuc_cutter_b_switch, block.side != block.before);
  if (on() && block.number_given) recorder().decide(Clause::fanuc_cutter_b_number_changed, changes_number(block));
  if (block.one_shot == OneShot::corner_arc) {
    corner_arc(step);
    return;
  }
  switch (block.motion) {
    case PlaneMotion::none:
      recorder().reach(Clause::fanuc_cutter_b_kept);
      keep(step);
      break;
    case PlaneMotion::zero_travel:
    case PlaneMotion::line:
      line(step);
      break;
    case PlaneMotion::arc:
      arc(step);
      break;
    case PlaneMotion::machine_coordinates:
    case PlaneMotion::reference:
    case PlaneMotion::from_reference:
      machine_position(step);
      break;
  }
}

void CutterCompensationB::keep(Step& step) const {
  for (Move& move : step.moves) move.offset = in_space(said(step).plane, vector_);
}

// G40: the vector goes at once, in the block's own move or in one back to the programmed point.
void CutterCompensationB::cancel(Step& step) {
  const CutterBlock& block = said(step);
  const bool started = recorder().decide(Clause::fanuc_cutter_b_cancel, started_);
  bool cancels = started;
  const bool by_words = block.axis_word && (block.one_shot == OneShot::none || block.motion != PlaneMotion::none);
  if (!by_words && block.motion != PlaneMotion::arc) {
    cancels = recorder().decide(Clause::fanuc_cutter_b_cancel_alone, !is_zero(vector_));
    // Beside G92 the only move there can be is that of the length offset.
    if (cancels && (step.moves.empty() || block.one_shot == OneShot::shift)) step.moves = {step.rest};
  }
  vector_ = {};
  started_ = false;
  // Machine and reference positions keep the causes of their moves.
  const bool by_path = block.motion == PlaneMotion::none || block.motion == PlaneMotion::zero_travel ||
                       block.motion == PlaneMotion::line || block.motion == PlaneMotion::arc;
  if (cancels && by_path)
    for (Move& move : step.moves) move.leg.cause = spec::Cause::cancel;
}

Rational CutterCompensationB::to_the_left(const CutterBlock& block) {
  recorder().decide(Clause::fanuc_cutter_b_number_zero, block.number == 0);
  const Rational length = block.side == CutterSide::left ? block.offset : Rational(-block.offset);
  recorder().decide(Clause::fanuc_cutter_side, Real(length), Real(magnitude(length)));
  return length;
}

PlanePoint CutterCompensationB::across(const Rational& length, const PlanePoint& direction) {
  return Real(length) / sqrt(squared_norm(direction)) * left(direction);
}

void CutterCompensationB::line(Step& step) {
  const CutterBlock& block = said(step);
  PlanePoint direction;
  bool kept = false;
  if (recorder().decide(Clause::fanuc_cutter_b_direction_words, block.direction.has_value())) {
    direction = *block.direction;
    kept = recorder().decide(Clause::fanuc_cutter_b_direction_zero, is_zero(direction));
  } else {
    direction = block.end - block.start;
    kept = recorder().decide(Clause::fanuc_cutter_b_no_travel, block.motion == PlaneMotion::zero_travel);
  }
  if (!kept) {
    recorder().reach(Clause::fanuc_cutter_b_vector);
    vector_ = across(to_the_left(block), direction);
    if (!std::exchange(started_, true)) {
      recorder().reach(Clause::fanuc_cutter_b_start_up);
      step.moves.front().leg.cause = spec::Cause::start_up;
    }
  }
  keep(step);
}

void CutterCompensationB::arc(Step& step) {
  const CutterBlock& block = said(step);
  const PlanePoint& center = block.arc->center;
  const PlanePoint to_end = block.end - center;
  if (is_zero(to_end))
    raise(recorder(), Clause::fanuc_cutter_b_arc_ends_in_center, "PS0038", "an arc whose end is its centre");
  recorder().reach(Clause::fanuc_cutter_b_arc_vector);
  const PlanePoint from = block.start + vector_ - center;
  const PlanePoint tangent = block.arc_direction == spec::ArcDirection::ccw ? left(to_end) : -left(to_end);
  vector_ = across(to_the_left(block), tangent);
  keep(step);
  tool_arc(*step.moves.front().leg.arc, from, to_end + vector_);
}

bool CutterCompensationB::tool_arc(spec::Arc<Real>& arc, const PlanePoint& from, const PlanePoint& to) const {
  const Real from2 = squared_norm(from);
  const Real to2 = squared_norm(to);
  arc.sweep.reset();
  bool whole = false;
  const bool in_center = from2.sign() == Sign::zero || to2.sign() == Sign::zero;
  if (!recorder().decide(Clause::fanuc_cutter_b_arc_head_in_center, in_center)) {
    const Real left_turn = cross(from, to);
    const Real sine = arc.direction == spec::ArcDirection::ccw ? left_turn : -left_turn;
    const Sign side = recorder().decide(Clause::fanuc_cutter_b_arc_sweep, sine, sqrt(from2 * to2));
    const Real cosine = dot(from, to);
    arc.sweep = swept_angle(sine, cosine, side);
    whole = side == Sign::zero && cosine.sign() == Sign::positive;
  }
  arc.radius.reset();
  if (recorder().decide(Clause::fanuc_cutter_b_arc_radii, to2 - from2, to2 + from2) == Sign::zero) return whole;
  arc.radius = {sqrt(from2), sqrt(to2)};
  return false;
}

// G39: about the programmed point, on the side of the tool, from the old vector to the new one.
void CutterCompensationB::corner_arc(Step& step) {
  const CutterBlock& block = said(step);
  recorder().reach(Clause::fanuc_cutter_b_corner_arc);
  recorder().decide(Clause::fanuc_cutter_b_corner_arc_direction, block.direction_letters);
  const Rational length = to_the_left(block);
  const PlanePoint before = std::exchange(vector_, across(length, *block.direction));
  const bool clockwise = recorder().decide(Clause::fanuc_cutter_b_corner_arc_sense, length > 0);
  Move move = step.rest;
  move.leg.type = spec::MoveType::arc;
  move.leg.cause = spec::Cause::corner;
  spec::Arc<Real>& arc = move.leg.arc.emplace();
  arc.plane = block.plane;
  arc.direction = clockwise ? spec::ArcDirection::cw : spec::ArcDirection::ccw;
  const PlaneLetters in_plane = letters(block.plane);
  const Vector center = in_space(block.plane, block.start);
  for (const char letter : {in_plane.first, in_plane.second})
    arc.center.set(axes_.index(letter), component(center, space_index(letter)));
  const bool no_vector = is_zero(before) && is_zero(vector_);
  const bool stays = no_vector || tool_arc(arc, before, vector_);
  if (!recorder().decide(Clause::fanuc_cutter_b_corner_arc_none, stays)) step.moves = {std::move(move)};
  keep(step);
}

// G53, G28, G30, G29: the vector goes in the first move where an axis of the plane is named.
void CutterCompensationB::machine_position(Step& step) {
  if (recorder().decide(Clause::fanuc_cutter_b_machine_position, said(step).has_plane_word())) {
    vector_ = {};
    started_ = false;
  }
  keep(step);
}

}  // namespace toolcomp::model

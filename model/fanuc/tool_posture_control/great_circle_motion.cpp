// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_posture_control/great_circle_motion.h"

#include <utility>

#include "model/basis/event.h"
#include "model/kinematics/inverse.h"

namespace toolcomp::model {
namespace {

// The angle of (x, y), y not negative, degrees from 0 to 180. Only of y = 0 a sign is asked.
Real upper_angle(const Real& x, const Real& y) {
  if (known_zero(y)) return x.sign() == Sign::negative ? 180 : 0;
  return 90 - arctangent_degrees(x / y);
}

// (x + iy)^n.
struct Turned {
  Real x = 1;
  Real y = 0;
};
Turned power(const Turned& z, const Integer& n) {
  Turned result;
  for (Integer i = 0; i < n; ++i) result = {result.x * z.x - result.y * z.y, result.x * z.y + result.y * z.x};
  return result;
}

}  // namespace

GreatCircleMotion::GreatCircleMotion(ArcView view, GreatCircle arc, int side, bool in_plane, BranchPart part,
                                     std::optional<Crossing> crossing)
    : view_(std::move(view)),
      arc_(std::move(arc)),
      side_(side),
      in_plane_(in_plane),
      part_(std::move(part)),
      crossing_(std::move(crossing)) {
  along_ = dot(machine().tool_side().line, machine().heights().along);
  across_ = dot(machine().tool_side().line, machine().work_side().line);
}

Posture GreatCircleMotion::at(const Rational& t) const {
  const Vector tool = arc_.at(t);
  if (!crossing_) {
    if (const auto met = met_pole(tool)) return *met;
    return posture(part_, tool);
  }
  switch (beyond_pole(t)) {
    case Sign::negative:
      return posture(part_, tool);
    case Sign::zero:
      return {crossing_->behind.start, view_.in_frame(crossing_->pole)};
    case Sign::positive:
      break;
  }
  return posture(crossing_->behind, tool);
}

MotionForm GreatCircleMotion::form() const {
  const DirectionSwing in_table{view_.in_table(arc_.from().unit), view_.in_table(arc_.ahead()), arc_.degrees()};
  return LiftedSwing{in_table, part_.start, part_.branch, side_, is_level(), part_.pole};
}

GreatCircleMotion::Tilt GreatCircleMotion::tilt(const Real& along_work_axis) const {
  const Machine::Heights& heights = machine().heights();
  Tilt result;
  result.height = along_work_axis - heights.mean;
  const Real aside2 = heights.swing2 - square(result.height);
  if (aside2.sign() == Sign::negative) throw NotFinite();  // only a forced outcome leaves reach
  result.aside = sqrt(aside2);
  result.toward = along_ - across_ * along_work_axis;
  return result;
}

GreatCircleMotion::Angles GreatCircleMotion::angles(const Tilt& tilt, int branch) const {
  return {upper_angle(tilt.height, tilt.aside), -branch * upper_angle(tilt.toward, tilt.aside)};
}

GreatCircleMotion::Angles GreatCircleMotion::at_pole(int pole, int branch) {
  return {pole > 0 ? 0 : 180, -90 * branch};
}

GreatCircleMotion::Angles GreatCircleMotion::at_start(const BranchPart& part) const {
  if (part.pole != 0) return at_pole(part.pole, part.branch);
  const Tilt start = tilt(dot(view_.work_axis(), arc_.from().unit));
  return angles(start, part.branch);
}

bool GreatCircleMotion::is_level() const {
  const auto square_to_axis = [this](const Direction& direction) {
    return dot(view_.work_axis(), direction.vector).sign() == Sign::zero;
  };
  if (!level_) level_ = square_to_axis(arc_.from()) && square_to_axis(arc_.to());
  return *level_;
}

Real GreatCircleMotion::swung(const Vector& tool, const Real& along_work_axis) const {
  const Vector& from = arc_.from().unit;
  const Vector& axis = view_.work_axis();
  // Where the axis lies in the plane after all, only a forced outcome says that it does not.
  const Real to_the_left = in_plane_ ? Real() : side_ * dot(axis, cross(from, tool));
  return side_ * upper_angle(dot(from, tool) - dot(axis, from) * along_work_axis, to_the_left);
}

// fanuc.tool-posture.lift: The rotary axes follow the great circle without a jump from their actual positions at the
// start. The tool-side axis stays on its branch, and the work-side axis turns by the azimuth of the tool less that of
// the tool side.
//
// ω = ω0 + σ ([az V - az V0] - [az c - az c0]); τ' stands by the angle of C from its extreme.
Posture GreatCircleMotion::posture(const BranchPart& part, const Vector& tool) const {
  // On machines whose edge of reach is there its height has to be known.
  const Real along = is_level() ? Real() : dot(view_.work_axis(), tool);
  const Angles before = at_start(part);
  const Angles here = angles(tilt(along), part.branch);
  const bool meridian = side_ == 0 || part.pole != 0;
  const Real swing = (meridian ? Real(0) : swung(tool, along)) - (here.work - before.work);
  const Real tilt = part.branch * (here.tool - before.tool);

  const PoseCosines at = on_branch(machine(), view_.in_table(tool), along, part.branch);
  return {{Angle::known(at.tool_cosine, at.tool_sine, part.start.tool.degrees() + machine().tool_side().sense * tilt),
           Angle::known(at.work_cosine, at.work_sine, part.start.work.degrees() + machine().work_side().sense * swing)},
          view_.in_frame(tool)};
}

// There the directions have swung by 90 degrees.
std::optional<Posture> GreatCircleMotion::met_pole(const Vector& tool) const {
  if (!in_plane_ || side_ == 0) return std::nullopt;
  if (squared_norm(cross(view_.work_axis(), tool)).sign() != Sign::zero) return std::nullopt;
  const int pole = dot(view_.work_axis(), tool).sign() == Sign::positive ? 1 : -1;
  const Angles before = at_start(part_);
  const Angles here = at_pole(pole, part_.branch);
  const auto moved = [](const Turn& turn, const Angle& from, const Real& by) {
    const Real degrees = from.degrees() + turn.sense * by;
    return Angle::known(exact::cos_real_degrees(degrees), exact::sin_real_degrees(degrees), degrees);
  };
  return Posture{{moved(machine().tool_side(), part_.start.tool, part_.branch * (here.tool - before.tool)),
                  moved(machine().work_side(), part_.start.work, side_ * 90 - (here.work - before.work))},
                 view_.in_frame(tool)};
}

// Where the enclosures do not tell the angles apart they may be equal: with t = p/q then q times the angle of the pole
// is p times the whole.
Sign GreatCircleMotion::beyond_pole(const Rational& t) const {
  const Vector& from = arc_.from().vector;
  const Real length = sqrt(arc_.from().norm2);
  const Turned to_pole{dot(from, crossing_->pole) / length, sqrt(squared_norm(cross(from, crossing_->pole))) / length};
  const Real difference = arc_.swept(t) - Angle::of_unit(to_pole.x, to_pole.y).degrees();
  const exact::Enclosure bounds = difference.enclosure();
  if (bounds.lower > 0) return Sign::positive;
  if (bounds.upper < 0) return Sign::negative;
  constexpr int most_parts = 64;
  if (denominator(t) <= most_parts) {
    const Real norms = sqrt(arc_.from().norm2 * arc_.to().norm2);
    const Turned whole{dot(from, arc_.to().vector) / norms, sqrt(arc_.normal2()) / norms};
    const Turned a = power(to_pole, denominator(t));
    const Turned b = power(whole, numerator(t));
    if ((a.y * b.x - a.x * b.y).sign() == Sign::zero) return Sign::zero;
  }
  return difference.sign();
}

}  // namespace toolcomp::model

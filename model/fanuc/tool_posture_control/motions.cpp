// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/tool_posture_control/motions.h"

#include <memory>
#include <utility>

#include "model/basis/event.h"
#include "model/kinematics/inverse.h"

namespace toolcomp::model {
namespace {

Angle of_degrees(const Real& degrees) {
  return Angle::known(exact::cos_real_degrees(degrees), exact::sin_real_degrees(degrees), degrees);
}

// The position at the fraction t of an even way.
Angle between(const Angle& start, const Angle& end, const Rational& t) {
  // A rational way keeps the position exact, whatever it starts from.
  if (const Angle way = end - start; way.is_rational()) return start + Angle(Rational(t * way.rational()));
  return of_degrees(Real(Rational(1 - t)) * start.degrees() + t * end.degrees());
}

// fanuc.tool-center-point.conventional: Under conventional control each rotary axis goes by itself, evenly, from the
// start pair to the end pair, while the tip runs along its path. The manual says that the rotary axes are not coupled.
// That they go evenly with the path is our reading.
// fanuc.tool-posture.passing: A block with a changed end passes the singular posture while the rotary axes run evenly
// with t and the work side stands. With orthogonal axes this is the great circle to the changed end.
class EvenMotion : public PostureMotion {
 public:
  EvenMotion(SharedFrame frame, EvenTurns turns) : frame_(std::move(frame)), turns_(std::move(turns)) {}

  [[nodiscard]] Posture at(const Rational& t) const override {
    const auto& [start, end] = turns_;
    const Pose pose{between(start.tool, end.tool, t), between(start.work, end.work, t)};
    return {pose, frame_->frame.direction(pose)};
  }
  [[nodiscard]] MotionForm form() const override { return turns_; }

 private:
  SharedFrame frame_;
  EvenTurns turns_;
};

// fanuc.tool-center-point.without-kinematics: With 19680 = 0 G43.4 raises PS5459. G43.5 then takes I J K, leaned by Q
// as on any machine, for the direction itself. Nothing is turned, reached or chosen, no posture is singular, WKP does
// not count, and P makes no difference. Inside a block the direction goes evenly along the great circle. Between
// opposite directions there is no great circle, and the direction stays the first one until the end.
class DirectionMotion : public PostureMotion {
 public:
  DirectionMotion(const Direction& from, const Direction& to) : first_(from.unit) {
    if (!is_zero(cross(from.vector, to.vector))) arc_.emplace(from, to);
  }

  [[nodiscard]] Posture at(const Rational& t) const override { return {Pose(), arc_ ? arc_->at(t) : first_}; }
  [[nodiscard]] MotionForm form() const override { return arc_ ? arc_->swing() : DirectionSwing{first_, Vector(), 0}; }

 private:
  Vector first_;
  std::optional<GreatCircle> arc_;
};

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

class GreatCircleMotion : public PostureMotion {
 public:
  GreatCircleMotion(ArcView view, GreatCircle arc, int side, bool in_plane, BranchPart part,
                    std::optional<BranchPart> behind)
      : view_(std::move(view)),
        arc_(std::move(arc)),
        side_(side),
        in_plane_(in_plane),
        part_(std::move(part)),
        behind_(std::move(behind)) {}

  [[nodiscard]] Posture at(const Rational& t) const override {
    const Vector tool = arc_.at(t);
    if (!behind_) {
      const bool meets_pole =
          in_plane_ && side_ != 0 && squared_norm(cross(view_.work_axis(), tool)).sign() == Sign::zero;
      return meets_pole ? at_met_pole(tool) : posture(part_, tool);
    }
    switch (beyond_pole(t)) {
      case Sign::negative:
        return posture(part_, tool);
      case Sign::zero:
        return {behind_->start, view_.in_frame(pole())};
      case Sign::positive:
        break;
    }
    return posture(*behind_, tool);
  }

  [[nodiscard]] MotionForm form() const override {
    const DirectionSwing& swing = arc_.swing();
    const DirectionSwing in_table{view_.in_table(swing.from), view_.in_table(swing.ahead), swing.degrees};
    return LiftedSwing{in_table, part_.start, part_.branch, side_, is_level(), part_.pole};
  }

 private:
  // Degrees of a part, at its beginning or inside.
  struct Angles {
    Real tool;  // from the extreme angle, 0 to 180
    Real work;  // azimuth of the tilted direction, from that of u_t
  };

  // Of a direction of this height along the work-side axis.
  [[nodiscard]] Angles angles(const Real& along_work_axis, int branch) const {
    const Machine::Heights& heights = machine().heights();
    const Vector& tool_axis = machine().tool_side().line;
    const Real height = along_work_axis - heights.mean;  // C
    const Real aside2 = heights.swing2 - square(height);
    if (aside2.sign() == Sign::negative) throw NotFinite();  // only a forced outcome leaves reach
    const Real aside = sqrt(aside2);
    // Along u_t of the tilted direction seen along u_w.
    const Real toward = dot(tool_axis, heights.along) - dot(tool_axis, machine().work_side().line) * along_work_axis;
    return {upper_angle(height, aside), -branch * upper_angle(toward, aside)};
  }
  [[nodiscard]] static Angles at_pole(int pole, int branch) { return {pole > 0 ? 0 : 180, -90 * branch}; }
  [[nodiscard]] Angles at_start(const BranchPart& part) const {
    if (part.pole != 0) return at_pole(part.pole, part.branch);
    return angles(dot(view_.work_axis(), arc_.from().unit), part.branch);
  }

  // All directions of the arc are at right angles to the work-side axis.
  [[nodiscard]] bool is_level() const {
    const auto square_to_axis = [this](const Direction& direction) {
      return dot(view_.work_axis(), direction.vector).sign() == Sign::zero;
    };
    if (!level_) level_ = square_to_axis(arc_.from()) && square_to_axis(arc_.to());
    return *level_;
  }

  // The azimuth that the tool has swung about the work-side axis, degrees.
  [[nodiscard]] Real swung(const Vector& tool, const Real& along_work_axis) const {
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
  [[nodiscard]] Posture posture(const BranchPart& part, const Vector& tool) const {
    // On machines whose edge of reach is there its height has to be known.
    const Real along = is_level() ? Real() : dot(view_.work_axis(), tool);
    const Angles before = at_start(part);
    const Angles here = angles(along, part.branch);
    const bool meridian = side_ == 0 || part.pole != 0;
    const Real swing = (meridian ? Real(0) : swung(tool, along)) - (here.work - before.work);
    const Real tilt = part.branch * (here.tool - before.tool);

    const PoseCosines at = on_branch(machine(), view_.in_table(tool), along, part.branch);
    const Pose& start = part.start;
    return {{Angle::known(at.tool_cosine, at.tool_sine, start.tool.degrees() + machine().tool_side().sense * tilt),
             Angle::known(at.work_cosine, at.work_sine, start.work.degrees() + machine().work_side().sense * swing)},
            view_.in_frame(tool)};
  }

  // An arc beside a pole meets it after all: only a forced outcome says that it does not. There the directions have
  // swung by 90 degrees.
  [[nodiscard]] Posture at_met_pole(const Vector& tool) const {
    const int pole = dot(view_.work_axis(), tool).sign() == Sign::positive ? 1 : -1;
    const Angles before = at_start(part_);
    const Angles here = at_pole(pole, part_.branch);
    const auto moved = [](const Turn& turn, const Angle& from, const Real& by) {
      return of_degrees(from.degrees() + turn.sense * by);
    };
    return {{moved(machine().tool_side(), part_.start.tool, part_.branch * (here.tool - before.tool)),
             moved(machine().work_side(), part_.start.work, side_ * 90 - (here.work - before.work))},
            view_.in_frame(tool)};
  }

  // Of the angle at t against that of the pole. Where the enclosures do not tell the angles apart they may be equal:
  // with t = p/q then q times the angle of the pole is p times the whole.
  [[nodiscard]] Sign beyond_pole(const Rational& t) const {
    const Vector& from = arc_.from().vector;
    const Real length = sqrt(arc_.from().norm2);
    const Turned to_pole{dot(from, pole()) / length, sqrt(squared_norm(cross(from, pole()))) / length};
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

  [[nodiscard]] const Machine& machine() const { return view_.frame->machine; }
  // Unit, in the view: the pole that the arc goes through.
  [[nodiscard]] Vector pole() const { return Real(behind_->pole) * view_.work_axis(); }

  ArcView view_;
  GreatCircle arc_;
  int side_;
  bool in_plane_;
  mutable std::optional<bool> level_;  // decided when it is asked for
  BranchPart part_;
  std::optional<BranchPart> behind_;
};

}  // namespace

SharedMotion even_motion(const SharedFrame& frame, const Pose& start, const Pose& end) {
  return std::make_shared<EvenMotion>(frame, EvenTurns{start, end});
}

SharedMotion direction_motion(const Direction& from, const Direction& to) {
  return std::make_shared<DirectionMotion>(from, to);
}

SharedMotion great_circle_motion(const ArcView& view, const GreatCircle& arc, int side, bool in_plane,
                                 const BranchPart& part, const std::optional<BranchPart>& behind) {
  return std::make_shared<GreatCircleMotion>(view, arc, side, in_plane, part, behind);
}

}  // namespace toolcomp::model

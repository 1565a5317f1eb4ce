// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/corner/tool_arc.h"

#include "model/geometry/arc.h"

namespace toolcomp::model {
namespace {

PlanePoint from_center(const PathEnd& end, const PlanePoint& vector) { return vector - end.to_center(); }

// The distance of a head from the centre. |R'| where it lies on the offset circle.
Real distance(bool on, const PathEnd& end, const Real& square, Sign sign) {
  if (!on) return sqrt(square);
  return sign == Sign::negative ? -end.radius() : end.radius();
}

}  // namespace

ToolArcRun::ToolArcRun(Recorder& recorder, OffsetPath path, const CornerVector& from, const CornerVector& to,
                       HeadPair heads)
    : recorder_(recorder),
      path_(std::move(path)),
      start_(from_center(path_.start, from.vector)),
      end_(from_center(path_.end, to.vector)),
      start_on_(from.latter != Seat::off),
      end_on_(to.former != Seat::off),
      start2_(start_on_ ? path_.start.radius2() : squared_norm(start_)),
      end2_(end_on_ ? path_.end.radius2() : squared_norm(end_)),
      start_sign_(start_on_ ? offset_radius(path_.start) : start2_.sign()),
      end_sign_(end_on_ ? offset_radius(path_.end) : end2_.sign()),
      as_programmed_(from.latter == Seat::square && to.former == Seat::square && start_sign_ == end_sign_),
      heads_(heads) {}

Sweep ToolArcRun::programmed() const {
  const PlanePoint& from = path_.start.heading.along;
  const PlanePoint& to = path_.end.heading.along;
  Sweep sweep{Real(path_.start.turn) * cross(from, to), dot(from, to), {}};
  sweep.side = sweep.sine.sign();
  return sweep;
}

Real ToolArcRun::radii() const { return path_.start.heading.length * path_.end.heading.length * sqrt(start2_ * end2_); }

const Sweep& ToolArcRun::sweep() {
  if (sweep_) return *sweep_;
  Real scale;
  if (as_programmed_) {
    sweep_ = programmed();
    scale = path_.start.heading.length * path_.end.heading.length;
  } else if (heads_ != HeadPair::any) {
    sweep_ = Sweep{0, heads_ == HeadPair::same ? start2_ : -start2_, {}};
    scale = start2_;
  } else {
    sweep_ = Sweep{Real(path_.start.turn) * cross(start_, end_), dot(start_, end_), {}};
    scale = sqrt(start2_ * end2_);
  }
  // fanuc.cutter-c.arc-sweep: The tool runs an arc block about the programmed centre, in the programmed direction, from
  // the head at its start to the head at its end. The sweep is over 0 and up to 360 degrees. If the heads are on one
  // ray from the centre, it is a whole turn. If a head is in the centre, no sweep is stated.
  sweep_->side = recorder_.decide(Clause::fanuc_cutter_c_arc_sweep, sweep_->sine, scale);
  return *sweep_;
}

void ToolArcRun::report(spec::Arc<Real>& arc) {
  arc.sweep.reset();
  arc.radius.reset();
  // On one circle the squares are one number, which needs no proof; of such heads too.
  const bool one_circle = start_on_ && end_on_ && path_.one_radius && path_.start.offset == path_.end.offset;
  const Real growth = one_circle || heads_ != HeadPair::any ? Real(0) : end2_ - start2_;
  // fanuc.cutter-c.arc-radii: If the heads of an arc block have different distances from the centre, the tool runs a
  // spiral whose radius changes evenly with the angle. This happens with programmed arcs of two radii, with heads that
  // are not on the offset circle, and with another value at the end than at the start.
  if (recorder_.decide(Clause::fanuc_cutter_c_arc_radii, growth, end2_ + start2_) != Sign::zero)
    arc.radius = {distance(start_on_, path_.start, start2_, start_sign_),
                  distance(end_on_, path_.end, end2_, end_sign_)};
  if (in_center()) return;
  const Sweep& turned = sweep();
  arc.sweep = swept_angle(turned.sine, turned.cosine, turned.side);
}

}  // namespace toolcomp::model

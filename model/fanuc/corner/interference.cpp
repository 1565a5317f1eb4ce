// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/corner/interference.h"

#include <algorithm>
#include <utility>

#include "model/geometry/arc.h"

namespace toolcomp::model {
namespace {

// Not less than the length, and cheap.
Real bound(const PlanePoint& vector) {
  Real sum;
  for (const Real& component : vector) sum += component.sign() == Sign::negative ? -component : component;
  return sum;
}

bool arc_interferes(Recorder& recorder, const CheckedPath& path, ToolArcRun& run) {
  // fanuc.cutter-c.interference-radius: An arc block interferes, in the pair q = 0, if the offset is larger than its
  // radius at either end. At the start this is R' < 0 with |P - O| and the rho of the corner there; at the end it is R'
  // < 0 with |Q - O| and the rho of the block's own end. The start is asked first.
  const Clause radius = Clause::fanuc_cutter_c_interference_radius;
  const Sign at_start = decide_offset_radius(recorder, radius, path.start);
  if (at_start == Sign::negative) return true;
  const Sign at_end = decide_offset_radius(recorder, radius, path.end);
  if (at_end == Sign::negative) return true;
  return at_start != Sign::zero && at_end != Sign::zero && run.sweeps_far_apart();
}

// By how much the offset is larger than the radius: at the start, or where it is not, at the end; 0: at neither.
Real excess(const CheckedPath& path) {
  for (const PathEnd* at : {&path.start, &path.end})
    if (offset_radius(*at) == Sign::negative) return -at->radius();
  return {};
}

}  // namespace

ToolArcRun::Head::Head(const PathEnd& end, const PlanePoint& vector, Seat seat)
    : on(seat != Seat::off),
      from_center(vector - end.to_center()),
      distance2(on ? end.radius2() : squared_norm(from_center)),
      sign(on ? offset_radius(end) : distance2.sign()) {}

// |R'| where it lies on the offset circle.
Real ToolArcRun::Head::distance(const PathEnd& end) const {
  if (!on) return sqrt(distance2);
  return sign == Sign::negative ? -end.radius() : end.radius();
}

ToolArcRun::ToolArcRun(Recorder& recorder, OffsetPath path, const CornerVector& from, const CornerVector& to,
                       HeadPair heads)
    : recorder_(recorder),
      path_(std::move(path)),
      start_(path_.start, from.vector, from.latter),
      end_(path_.end, to.vector, to.former),
      as_programmed_(from.latter == Seat::square && to.former == Seat::square && start_.sign == end_.sign),
      heads_(heads) {}

Sweep ToolArcRun::programmed() const {
  const PlanePoint& from = path_.start.heading.along;
  const PlanePoint& to = path_.end.heading.along;
  Sweep sweep{Real(path_.start.turn) * cross(from, to), dot(from, to), {}};
  sweep.side = sweep.sine.sign();
  return sweep;
}

const Sweep& ToolArcRun::sweep() {
  if (sweep_) return *sweep_;
  Real scale;
  if (as_programmed_) {
    sweep_ = programmed();
    scale = path_.start.heading.length * path_.end.heading.length;
  } else if (heads_ != HeadPair::any) {
    sweep_ = Sweep{0, heads_ == HeadPair::same ? start_.distance2 : -start_.distance2, {}};
    scale = start_.distance2;
  } else {
    sweep_ = Sweep{Real(path_.start.turn) * cross(start_.from_center, end_.from_center),
                   dot(start_.from_center, end_.from_center),
                   {}};
    scale = sqrt(start_.distance2 * end_.distance2);
  }
  // fanuc.cutter-c.arc-sweep: The tool runs an arc block about the programmed centre, in the programmed direction, from
  // the head at its start to the head at its end. The sweep is over 0 and up to 360 degrees. If the heads are on one
  // ray from the centre, it is a whole turn. If a head is in the centre, no sweep is stated.
  sweep_->side = recorder_.decide(Clause::fanuc_cutter_c_arc_sweep, sweep_->sine, scale);
  return *sweep_;
}

// Sweeps of up to 360° differ by more than 180° only if one is over a half circle and the other is not: L - S > 180
// where sin(S - L) is positive.
bool ToolArcRun::sweeps_far_apart() {
  if (in_center() || as_programmed_) return false;
  const Sweep by_program = programmed();
  const Sweep& tool = sweep();
  if (by_program.up_to_half() == tool.up_to_half()) return false;
  const Real gain = tool.sine * by_program.cosine - tool.cosine * by_program.sine;
  const Real radii = path_.start.heading.length * path_.end.heading.length * sqrt(start_.distance2 * end_.distance2);
  // fanuc.cutter-c.interference-sweep: An arc block that fanuc.cutter-c.interference-radius does not decide interferes,
  // in the pair q = 0, if the sweep of the tool's arc (fanuc.cutter-c.arc-sweep) differs from the programmed one by
  // more than 180 degrees.
  return recorder_.decide(Clause::fanuc_cutter_c_interference_sweep, by_program.up_to_half() ? -gain : gain, radii) ==
         Sign::positive;
}

void ToolArcRun::report(spec::Arc<Real>& arc) {
  arc.sweep.reset();
  arc.radius.reset();
  // On one circle the squares are one number, which needs no proof; of such heads too.
  const bool one_circle = start_.on && end_.on && path_.one_radius && path_.start.offset == path_.end.offset;
  const Real growth = one_circle || heads_ != HeadPair::any ? Real(0) : end_.distance2 - start_.distance2;
  // fanuc.cutter-c.arc-radii: If the heads of an arc block have different distances from the centre, the tool runs a
  // spiral whose radius changes evenly with the angle. This happens with programmed arcs of two radii, with heads that
  // are not on the offset circle, and with another value at the end than at the start.
  if (recorder_.decide(Clause::fanuc_cutter_c_arc_radii, growth, end_.distance2 + start_.distance2) != Sign::zero)
    arc.radius = {start_.distance(path_.start), end_.distance(path_.end)};
  if (in_center()) return;
  const Sweep& turned = sweep();
  arc.sweep = swept_angle(turned.sine, turned.cosine, turned.side);
}

// The tool's path against the programmed one.
CheckedPath between_vectors(spec::Plane plane, const OffsetPath& path) {
  return {path.start, path.end, [&path, plane](const Vector& at_start, const Vector& at_end) -> WayAlong {
            const Heading chord = path.is_arc() ? heading(path.travel) : path.start.heading;
            const PlanePoint from = in_plane_of(plane, at_start);
            const PlanePoint to = in_plane_of(plane, at_end);
            return {chord.length2 + dot(path.travel, to - from),
                    chord.length * (chord.length + bound(from) + bound(to)), chord.length2};
          }};
}

// fanuc.cutter-c.interference-at-once: With No. 5008 bit 3, CNV, at 1, cutter compensation C on series 30i drops no
// vector. The first pair with interference is then the last one, so PS0041 comes at once. On series 16i the bit means
// nothing.
// fanuc.cutter-c.interference-without-alarm: With No. 5008 bit 1, CNC, at 1, cutter compensation C raises no alarm if
// the last pair interferes because the directions differ by 90 to 270 degrees (fanuc.cutter-c.interference-direction).
// The block then runs between the vectors that are left.
// fanuc.cutter-c.interference-straightened: An arc block that has interfered in its first pair is a straight block from
// then on. The next pairs are tested as for a line from P to Q. The block's own move is linear, from the last vector
// left at its start to the first vector left at its end, with the block's feed; the cause is programmed.
Checked check_interference(Recorder& recorder, const spec::Setup* setup, const CheckedPath& path, SpaceGroup& at_start,
                           SpaceGroup& at_end, ToolArcRun* run) {
  const bool keeps_vectors = setup != nullptr && setup->series == spec::Series::series_30i && setup->bit(5008, 3);
  const std::size_t pairs = keeps_vectors ? 1 : std::max(at_start.size(), at_end.size());
  std::size_t q = 0;
  std::size_t from = 0;
  std::size_t to = 0;
  for (;; ++q) {
    from = at_start.size() - std::min(q + 1, at_start.size());
    to = std::min(q, at_end.size() - 1);
    std::optional<WayAlong> way;  // not of an arc in the first pair
    if (q > 0 || run == nullptr) way = path.along(at_start[from].vector, at_end[to].vector);
    // fanuc.cutter-c.interference-direction: A straight block interferes if the tool's direction differs from the
    // programmed one by more than 90 degrees. Exactly 90 degrees, and a tool that does not move, are no interference
    // (ours).
    const Clause direction = Clause::fanuc_cutter_c_interference_direction;
    const bool found = way ? recorder.decide(direction, way->product, way->scale) == Sign::negative
                           : arc_interferes(recorder, path, *run);
    if (q == 0 && found && setup != nullptr)
      recorder.decide(Clause::fanuc_cutter_c_interference_at_once, keeps_vectors);
    // fanuc.cutter-c.interference-pairs: The check tests pairs of a vector at the start and a vector at the end of the
    // block, from the innermost pair outward. For q = 0, 1, …, max(m, n) - 1 the pair is number max(m - q, 1) of V and
    // number min(1 + q, n) of W, with m and n as at the beginning. The first pair without interference ends the check.
    if (!recorder.decide(Clause::fanuc_cutter_c_interference_pairs, found)) break;
    if (q + 1 == pairs) {
      if (way && setup != nullptr &&
          recorder.decide(Clause::fanuc_cutter_c_interference_without_alarm, setup->bit(5008, 1)))
        break;
      return {Passage::blocked, way ? -way->product / sqrt(way->length2) : excess(path)};
    }
  }
  if (q == 0) return {};
  recorder.decide(Clause::fanuc_cutter_c_interference_straightened, run != nullptr);
  at_start.resize(from + 1);
  at_end.erase(at_end.begin(), at_end.begin() + static_cast<std::ptrdiff_t>(to));
  return {Passage::shortened, {}};
}

}  // namespace toolcomp::model

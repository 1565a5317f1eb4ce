// SPDX-License-Identifier: Apache-2.0
// What cutter compensation C lends to its short cuts, and takes back.
#include <array>
#include <cstddef>
#include <cstdint>

#include "fast/arithmetic/count.h"
#include "fast/fanuc/cutter_compensation_c/cutter_compensation_c.h"
#include "fast/fanuc/cutter_compensation_c/usual_line.h"
#include "fast/fanuc/cutter_compensation_c/usual_path.h"

namespace toolcomp::fast {

bool CutterCompensationC::awaits_usual() const {
  return mode_ == Mode::on && held_ == Held::path && checked_ && count_ == 1 && last_->offset.nearest != 0 &&
         last_ == &paths_[path_] && !ring_[first_].sets && !repeated_ &&
         !fault(Fault::c_perpendicular_for_intersection) && !fault(Fault::c_offset_one_corner_late);
}

// Behind two lines: where lines and arcs take turns, it is for awaits_paths().
bool CutterCompensationC::awaits_lines() const {
  return awaits_usual() && !last_->flat.arc && start_->size == 1 && !start_->corner.first->arc &&
         last_->flat.start.narrow;
}

void CutterCompensationC::lend(UsualLine& line) {
  const Heading& heading = last_->flat.start;
  line.event = &ring_[first_].event;
  line.sink = sink_;
  line.radius = last_->offset.nearest;
  line.offset = last_->side * line.radius;
  line.limit = parameters_.limit_value;
  line.start = UsualLine::Start::lent;
  line.way = {static_cast<std::int64_t>(heading.whole[0]), static_cast<std::int64_t>(heading.whole[1])};
  line.unit = DoublePair{heading.unit.x, heading.unit.y};
  line.norm = heading.norm;
  const Vector2<double>& vector = at_start().front().vector;
  line.vector = DoublePair{vector.x, vector.y};
}

void CutterCompensationC::take_back(const UsualLine& line, const std::array<std::int64_t, 2>& end) {
  // Of the path that was lent: what stands there but the way.
  CutterPath& to = paths_[path_];
  CutterPath& from = paths_[before(path_)];
  from.side = to.side;
  from.offset = to.offset;
  from.flat.arc = false;
  from.flat.fine_units = false;
  set_narrow_heading(from.flat.start, line.before[0], line.before[1]);
  set_narrow_heading(to.flat.start, line.way[0], line.way[1], line.norm);
  start_side_ = to.side;
  start_offset_ = &from.offset;

  CutterGroup& start = at_start();
  const Turn turned = turn_of_narrow(from.flat.start, to.flat.start);
  start.cleared = 0;
  start.corner = {&from.flat, &to.flat, &from.flat.start, &to.flat.start, to.side, to.side, &from.offset, turned};
  if (line.start == UsualLine::Start::one_vector) {
    make_.set(start, turned.c == 0 ? HeadKind::first_normal : HeadKind::tangents_meet);
    return;
  }
  make_.set(start, HeadKind::first_extended);
  make_.add(start, HeadKind::second_extended);
  // The move from one to the other starts where the line does.
  Event& move = corner_move(start);
  move = *line.event;
  for (std::size_t i = 0; i < 2; ++i) {
    const double position = Count::nearest_small(end[i] - line.way[i]);
    move.programmed.value[axis_[i]] = position;
    move.point.value[axis_[i]] = position;
    move.axes.value[axis_[i]] = position;
  }
  move.cause = spec::Cause::corner;
}

namespace {

WholePair whole_pair(const std::array<Int128, 2>& whole) {
  return {static_cast<std::int64_t>(whole[0]), static_cast<std::int64_t>(whole[1])};
}

// False: it is no usual one.
bool set_usual_path(UsualPath& to, const PlanePath& path) {
  if (path.fine_units || path.seen) return false;
  if (path.arc && path.ends_in_center) return false;
  if (path.arc && path.by_radius) {
    constexpr Int128 kMost = Int128{1} << 30U;
    const auto is_usual = [](const Int128& x) { return x < kMost && x > -kMost; };
    if (!is_usual(path.whole[0]) || !is_usual(path.whole[1]) || !is_usual(path.radius_whole)) return false;
    const auto radius = static_cast<std::int64_t>(path.radius_whole);
    return set_usual_arc_by_radius(to, whole_pair(path.whole), path.over_half ? -radius : radius, path.sigma);
  }
  if (!path.start.narrow || !path.end().narrow) return false;
  if (path.arc) {
    const auto from_center = [&](const Heading& tangent) {
      const WholePair whole = whole_pair(tangent.whole);
      return WholePair{path.sigma * whole[1], -path.sigma * whole[0]};
    };
    return set_usual_arc(to, from_center(path.start), from_center(path.arc_end), path.sigma);
  }
  set_usual_line(to, whole_pair(path.start.whole));
  return true;
}

void set_plane_path(PlanePath& to, const UsualPath& path) {
  const auto count = [](std::int64_t small) {
    Count value;
    value.set_small(small);
    return value;
  };
  to.fine_units = false;
  if (!path.is_arc()) {
    to.arc = false;
    set_narrow_heading(to.start, path.start.whole[0], path.start.whole[1]);
  } else if (path.by_radius != 0) {
    const WholePair way = path.way();
    set_arc_by_radius(to, {}, {count(way[0]), count(way[1])}, count(path.by_radius), path.sigma < 0);
  } else {
    to.arc = true;
    to.sigma = path.sigma;
    to.by_radius = false;
    to.ends_in_center = false;
    set_narrow_arc(to, path.whole_start(), path.whole_end());
  }
}

}  // namespace

bool CutterCompensationC::awaits_paths() const {
  return awaits_usual() && (last_->flat.arc || start_->corner.first->arc) && !fault(Fault::c_small_movement_one_axis) &&
         !fault(Fault::c_spiral_as_circle);
}

bool CutterCompensationC::lend(UsualLoan& loan) {
  const CutterGroup& start = at_start();
  loan.event = &ring_[first_].event;
  loan.sink = sink_;
  loan.offset.radius = last_->offset.nearest;
  loan.offset.left = last_->side * last_->offset.nearest;
  loan.offset.limit = parameters_.limit_value;
  loan.offset.keeps_all = parameters_.keeps_all;
  if (start.cleared != 0 || !set_usual_path(loan.path, last_->flat)) return false;
  if (last_->flat.arc && !(starts_on_circle() && has_offset_path(loan.path, loan.offset))) return false;
  loan.start.size = 0;
  for (std::size_t i = 0; i < start.size; ++i)
    loan.start.add(start.head[i].kind, DoublePair{start.head[i].vector.x, start.head[i].vector.y});
  return start.size == 1 || moves_in_plane_only();
}

// Of an arc: the vector at its start is one of its own offset circle.
bool CutterCompensationC::starts_on_circle() const {
  if (start_side_ != last_->side || !(start_offset_->exact == last_->offset.exact)) return false;
  const HeadKind kind = start_->back().kind;
  const Corner& corner = start_->corner;
  const bool straight = corner.second == &last_->flat && corner.turn.c == 0 && corner.turn.k > 0;
  return kind == HeadKind::paths_meet || kind == HeadKind::second_normal ||
         (kind == HeadKind::first_normal && straight);
}

// Beside the move at the corner at its start, the other axes stay.
bool CutterCompensationC::moves_in_plane_only() {
  const Event& before = corner_move(at_start());
  const Event& event = ring_[first_].event;
  const unsigned others = event.axes.present & ~(1U << axis_[0] | 1U << axis_[1]);
  for (unsigned rest = others; rest != 0; rest &= rest - 1) {
    const auto axis = static_cast<std::size_t>(__builtin_ctz(rest));
    if (before.axes.value[axis] != event.axes.value[axis]) return false;
  }
  return true;
}

void CutterCompensationC::take_back(const UsualReturn& usual) {
  CutterPath& to = paths_[path_];
  CutterPath& from = paths_[before(path_)];
  from.side = to.side;
  from.offset = to.offset;
  set_plane_path(from.flat, usual.before);
  set_plane_path(to.flat, usual.path);
  start_side_ = to.side;
  start_offset_ = &from.offset;
  // What the centre of an arc by radius is counted from.
  CutterBlock& block = ring_[first_];
  block.by_radius = usual.path.by_radius != 0;
  for (std::size_t i = 0; i < 2; ++i) block.start[i].set_small(usual.at[i]);

  CutterGroup& start = at_start();
  const Turn turned = turn(from.flat.end(), to.flat.start);
  start.cleared = 0;
  start.corner = {&from.flat, &to.flat, &from.flat.end(), &to.flat.start, to.side, to.side, &from.offset, turned};
  start.size = usual.corner.size;
  for (std::size_t i = 0; i < start.size; ++i)
    start.head[i] = {to_vector(usual.corner.vector[i]), usual.corner.kind[i]};
  if (start.size > 1) corner_move(start) = usual.corner_move;
}

}  // namespace toolcomp::fast

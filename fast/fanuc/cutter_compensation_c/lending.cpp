// SPDX-License-Identifier: Apache-2.0
// What cutter compensation C lends to its short cuts, and takes back.
#include <array>
#include <cstddef>
#include <cstdint>

#include "fast/arithmetic/count.h"
#include "fast/basis/short_cut.h"
#include "fast/fanuc/corner/lent_path.h"
#include "fast/fanuc/cutter_compensation_c/cutter_compensation_c.h"
#include "fast/fanuc/cutter_compensation_c/usual_line.h"

namespace toolcomp::fast {

bool CutterCompensationC::awaits_usual() const {
  return mode_ == Mode::on && held_ == Held::path && checked_ && count_ == 1 && last_->offset.nearest != 0 &&
         last_ == &paths_[path_] && !ring_[first_].sets && !repeated_;
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

bool CutterCompensationC::awaits_paths() const {
  return awaits_usual() && (last_->flat.arc || start_->corner.first->arc);
}

bool CutterCompensationC::lend(UsualLoan& loan) {
  if (!is_open(ShortCut::cutter_path)) return false;
  const CutterGroup& start = at_start();
  loan.event = &ring_[first_].event;
  loan.sink = sink_;
  loan.offset.radius = last_->offset.nearest;
  loan.offset.left = last_->side * last_->offset.nearest;
  loan.offset.limit = parameters_.limit_value;
  loan.offset.keeps_all = parameters_.keeps_all;
  loan.corner_move = &corner_move(start);
  if (!set_usual_path(loan.path, last_->flat)) return false;
  if (last_->flat.arc && !(starts_on_circle() && has_offset_path(loan.path, loan.offset))) return false;
  loan.start.size = 0;
  for (std::size_t i = 0; i < start.size; ++i)
    loan.start.add(start.head[i].kind, DoublePair{start.head[i].vector.x, start.head[i].vector.y});
  return start.size == 1 || moves_in_plane_only(axis_, *loan.corner_move, *loan.event);
}

bool CutterCompensationC::starts_on_circle() const {
  return start_side_ == last_->side && start_offset_->exact == last_->offset.exact &&
         is_on_circle(last_->flat, start_->corner, start_->back().kind);
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
  start.corner = {&from.flat, &to.flat, &from.flat.end(), &to.flat.start, to.side, to.side, &from.offset, turned};
  start.size = usual.corner.size;
  for (std::size_t i = 0; i < start.size; ++i)
    start.head[i] = {to_vector(usual.corner.vector[i]), usual.corner.kind[i]};
  if (start.size > 1) corner_move(start) = usual.corner_move;
}

}  // namespace toolcomp::fast

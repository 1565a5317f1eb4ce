// The usual line of cutter compensation C: what block() does with it, without the detours.
#pragma once

#include <cmath>

#include "fast/basis/fault.h"
#include "fast/basis/short_cut.h"
#include "fast/fanuc/cutter_compensation_c/cutter_compensation_c.h"

namespace toolcomp::fast {

[[gnu::always_inline]] inline bool CutterCompensationC::usual_line(CutterBlock& block) {
  CutterPath& to = paths_[path_];
  const Heading& next = to.flat.start;
  const bool usual = is_open(ShortCut::cutter_line) && plain_ && held_ == Held::path && !repeated_ &&
                     block.offset == value_ && next.narrow && side_of(block) == last_->side &&
                     !fault(Fault::c_perpendicular_for_intersection) && !fault(Fault::c_offset_one_corner_late);
  if (!usual) [[unlikely]]
    return false;
  const Heading& last = last_->flat.start;
  const int side = last_->side;
  const Turn turned = turn_of_narrow(last, next);
  // An inner or an obtuse corner.
  // Which way the path turns follows no pattern; that it turns by less than 90 degrees, does.
  const bool acute = turned.k <= 0 && side * turned.c < 0 && !fault(Fault::usual_line_acute);
  if (turned.c == 0 || acute) [[unlikely]]
    return false;
  const Vector2<double> vector = where_tangents_meet(last, turned, side * amount_.nearest);
  const Vector2<double>& from = at_start().front().vector;
  const double length = last.norm / per_one(last_->flat);
  const double product = length + dot(last.unit, vector - from);
  const double extent = std::abs(vector.x) + std::abs(vector.y) + std::abs(from.x) + std::abs(from.y);
  if (product <= 0x1p-46 * (length + extent) && !fault(Fault::usual_line_unchecked)) [[unlikely]]
    return false;

  to.side = side;
  to.offset = amount_;
  CutterGroup& end = at_end();
  end.clear();
  end.head[0] = {vector, HeadKind::tangents_meet};
  end.corner = {&last_->flat, &to.flat, &last, &next, side, side, &last_->offset, turned};
  std::swap(start_, end_);
  start_side_ = side;
  start_offset_ = &last_->offset;
  last_ = &to;
  CutterBlock& held = ring_[first_];
  add(held.event, vector);
  sink_->on(held.event);
  if (held.sets) [[unlikely]]
    send_setting(held);
  if (count_ > 1) [[unlikely]] {
    free_first();
    send_held(vector);
  }
  count_ = 0;
  hold();
  still_ = 0;
  return true;
}

}  // namespace toolcomp::fast

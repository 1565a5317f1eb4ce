// SPDX-License-Identifier: Apache-2.0
// Usual lines of cutter compensation C as arrays.
#include "fast/arithmetic/count.h"
#include "fast/arrays/line_moves.h"
#include "fast/fanuc/cutter_compensation_c/cutter_compensation_c.h"
#include "fast/geometry/heading.h"

namespace toolcomp::fast {
namespace {

std::array<std::int64_t, 2> whole(DoublePair pair) {
  return {static_cast<std::int64_t>(pair[0]), static_cast<std::int64_t>(pair[1])};
}

}  // namespace

bool CutterCompensationC::awaits_lines() const {
  return mode_ == Mode::on && held_ == Held::path && checked_ && count_ == 1 && last_->offset.nearest != 0 &&
         last_ == &paths_[path_] && !ring_[first_].sets && !repeated_ && !last_->flat.arc && start_->size == 1 &&
         last_->flat.start.narrow;
}

std::size_t CutterCompensationC::lines(const LineChunk& chunk, CutterLines& lines) {
  if (!awaits_lines()) return 0;
  const Heading& heading = last_->flat.start;
  const Vector2<double>& vector = at_start().front().vector;
  CutterLineStart start;
  start.at = DoublePair{static_cast<double>(lines.at[0]), static_cast<double>(lines.at[1])};
  start.line = {DoublePair{static_cast<double>(heading.whole[0]), static_cast<double>(heading.whole[1])},
                DoublePair{heading.unit.x, heading.unit.y}, heading.norm};
  start.vector = DoublePair{vector.x, vector.y};
  start.offset = last_->side * last_->offset.nearest;
  start.word = lines.word;
  start.axis = axis_;
  const CutterLineEnd end = take_cutter_lines(chunk, start);
  if (end.taken == 0) return 0;
  Event& event = held(0).event;
  if (chunk.made != nullptr) chunk.made->set_held(event, static_cast<Mask>(1U << axis_[0] | 1U << axis_[1]));
  Moves& moves = *chunk.moves;
  for (std::size_t axis = 0; axis < moves.axes(); ++axis)
    if (axis != axis_[0] && axis != axis_[1]) moves.set_axis(axis, end.taken, event.axes.value[axis]);
  *moves.next_block() = event.line;
  moves.append(1);
  moves.append_lines(end.taken - 1, chunk.line);
  const std::size_t last = end.taken - 1;
  for (std::size_t i = 0; i < 2; ++i)
    if (const double* const words = chunk.word(lines.word[i])) lines.at[i] = static_cast<std::int64_t>(words[last]);
  event.line = chunk.line + last;
  event.n = chunk.number(last);
  hold_last(end, lines.at);
  return end.taken;
}

void CutterCompensationC::hold_last(const CutterLineEnd& end, const std::array<std::int64_t, 2>& at) {
  Event& event = held(0).event;
  for (std::size_t i = 0; i < 2; ++i) {
    const double position = Count::nearest_small(at[i]);
    event.programmed.value[axis_[i]] = position;
    event.point.value[axis_[i]] = position;
    event.axes.value[axis_[i]] = position;
  }
  CutterPath& to = paths_[path_];
  CutterPath& from = paths_[before(path_)];
  from.side = to.side;
  from.offset = to.offset;
  from.flat.arc = false;
  from.flat.fine_units = false;
  const std::array<std::int64_t, 2> before_last = whole(end.before);
  const std::array<std::int64_t, 2> last = whole(end.last.way);
  set_narrow_heading(from.flat.start, before_last[0], before_last[1]);
  set_narrow_heading(to.flat.start, last[0], last[1], end.last.norm);
  start_side_ = to.side;
  start_offset_ = &from.offset;
  CutterGroup& start = at_start();
  const Turn turned = turn_of_narrow(from.flat.start, to.flat.start);
  start.corner = {&from.flat, &to.flat, &from.flat.start, &to.flat.start, to.side, to.side, &from.offset, turned};
  make_.set(start, turned.c == 0 ? HeadKind::first_normal : HeadKind::tangents_meet);
}

}  // namespace toolcomp::fast

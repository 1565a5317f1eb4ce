// SPDX-License-Identifier: Apache-2.0
// Usual lines of cutter compensation C as arrays: from the words of the blocks to the moves.
#include "fast/fanuc/corner/usual_corner.h"
#include "fast/fanuc/cutter_compensation_c/cutter_line_arrays.h"
#include "fast/fanuc/cutter_compensation_c/usual_line.h"

namespace toolcomp::fast {
namespace {

std::array<std::int64_t, 2> whole(DoublePair pair) {
  return {static_cast<std::int64_t>(pair[0]), static_cast<std::int64_t>(pair[1])};
}

}  // namespace

std::size_t UsualCutterLines::lines(const LineChunk& chunk) {
  const std::uint32_t plane = std::uint32_t{1} << letter_[0] | std::uint32_t{1} << letter_[1];
  if (line_.start != UsualLine::Start::one_vector || (chunk.words << 1U & ~plane) != 0 || control_.modal.incremental())
    return 0;
  CutterLineStart start;
  start.at = at_value_;
  start.line = {to_doubles(line_.way), line_.unit, line_.norm};
  start.vector = line_.vector;
  start.offset = line_.offset;
  start.word = {letter_[0] - 1, letter_[1] - 1};
  start.axis = axis_;
  const CutterLineEnd end = take_cutter_lines(chunk, start);
  if (end.taken == 0) return 0;
  Event& event = *line_.event;
  Moves& moves = *chunk.moves;
  for (std::size_t axis = 0; axis < moves.axes(); ++axis)
    if (axis != axis_[0] && axis != axis_[1]) moves.set_axis(axis, end.taken, event.axes.value[axis]);
  *moves.next_block() = event.line;
  moves.append(1);
  moves.append_lines(end.taken - 1, chunk.line);

  line_.before = whole(end.before);
  line_.way = whole(end.last.way);
  line_.unit = end.last.unit;
  line_.norm = end.last.norm;
  line_.vector = end.vector;
  const std::size_t last = end.taken - 1;
  for (std::size_t i = 0; i < 2; ++i)
    if (const double* const words = chunk.word(letter_[i] - 1)) at_[i] = static_cast<std::int64_t>(words[last]);
  at_value_ = to_doubles(at_);
  event.line = chunk.line + last;
  event.n.reset();
  return end.taken;
}

}  // namespace toolcomp::fast

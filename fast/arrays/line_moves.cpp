// SPDX-License-Identifier: Apache-2.0
#include "fast/arrays/line_moves.h"

#include <cmath>

#include "fast/arithmetic/count.h"

namespace toolcomp::fast {
namespace {

void set_line(LineMoves& moves, std::size_t line) {
  Event& event = moves.event;
  event.line = moves.chunk.line + line;
  event.n = moves.chunk.number(line);
  visit_axes(moves.moving, [&](std::size_t axis) {
    if (const double* const word = moves.word[axis])
      event.programmed.value[axis] = word[line] / static_cast<double>(Count::kSmallPerOne);
  });
  if (moves.tool[0] != nullptr && event.tool_axis) {
    const double x = moves.tool[0][line];
    const double y = moves.tool[1][line];
    const double z = moves.tool[2][line];
    const double norm = std::sqrt(x * x + y * y + z * z);
    *event.tool_axis = {x / norm + 0.0, y / norm + 0.0, z / norm + 0.0};
  }
}

}  // namespace

LineMaker::LineMaker(const spec::Axes& axes) : axes_(axes), moves_(axes.size()) {
  moves_.reserve(LineChunk::kMost + 1);
}

LineChunk LineMaker::begin(const spec::LineColumns& lines) {
  moves_.clear();
  LineChunk chunk;
  chunk.size = lines.size;
  chunk.words = lines.words;
  chunk.columns = &lines.columns;
  chunk.line = lines.line;
  chunk.instructions = instructions_;
  chunk.moves = &moves_;
  if (lines.numbered) chunk.n = lines.n.data();
  chunk.made = &made_;
  return chunk;
}

LineMoves& LineMaker::end(const LineChunk& chunk, std::size_t count) {
  made_.chunk = chunk;
  made_.size = count;
  visit_axes(made_.moving, [&](std::size_t axis) {
    made_.word[axis] = chunk.word(word_place(axes_.letter(axis)));
    made_.sent[axis] = moves_.axis(axis).data();
  });
  made_.tool = {chunk.word(word_place('I')), chunk.word(word_place('J')), chunk.word(word_place('K'))};
  return made_;
}

const Event& LineMoves::at(std::size_t i) {
  if (!is_of_held(i)) set_line(*this, line_of(i));
  visit_axes(moving, [&](std::size_t axis) {
    const double to = sent[axis][i];
    event.axes.value[axis] = to;
    event.point.value[axis] = by_vector ? to : event.programmed.value[axis];
    event.machine.value[axis] = to;  // where it is present, nothing lies between
  });
  return event;
}

}  // namespace toolcomp::fast

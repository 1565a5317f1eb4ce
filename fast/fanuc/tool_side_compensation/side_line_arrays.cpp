// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_side_compensation/side_line_arrays.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "fast/arithmetic/count.h"
#include "fast/arrays/position_arrays.h"

namespace toolcomp::fast {
namespace {

using Column = LineChunk::Column;
struct Columns3 {
  Column x, y, z;
};

// Element 0 is the line that is held.
struct Lines {
  Columns3 at, travel, tool, vector;
  Column square;
  // Of the corner at the end of each line: by how much the vector may move along it, 0 where the line behind is no
  // usual one; and whether it is refused.
  Column longest_shift;
  std::array<std::int64_t, LineChunk::kMost> refused;
};

void begin(Columns3& columns, const Vector3<double>& value) {
  columns.x[0] = value.x;
  columns.y[0] = value.y;
  columns.z[0] = value.z;
}

struct Travels {
  [[gnu::always_inline]] static void run(Lines* lines, std::size_t size) {
    const Columns3& at = lines->at;
    Columns3& travel = lines->travel;
    for (std::size_t i = 1; i <= size; ++i) {
      const double x = at.x[i] - at.x[i - 1];
      const double y = at.y[i] - at.y[i - 1];
      const double z = at.z[i] - at.z[i - 1];
      travel.x[i] = x;
      travel.y[i] = y;
      travel.z[i] = z;
      lines->square[i] = x * x + y * y + z * z;
    }
  }
};

// As set_small_direction(): along an axis the quotients are 0 and 1.
struct Tools {
  [[gnu::always_inline]] static void run(Lines* lines, const double* x, const double* y, const double* z,
                                         std::size_t size) {
    Columns3& tool = lines->tool;
    for (std::size_t i = 0; i < size; ++i) {
      const double norm = std::sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
      tool.x[i + 1] = x[i] / norm;
      tool.y[i + 1] = y[i] / norm;
      tool.z[i + 1] = z[i] / norm;
    }
  }
};

// The corner at the end of line i, before line i + 1, as ToolSideCompensation::make_corner_in_doubles().
struct Corners {
  [[gnu::always_inline]] static void run(Lines* lines, std::size_t size, double radius, double shortest) {
    constexpr double kMostSquare = 0x1p60;
    constexpr double kUncertain = 0x1p-38;
    constexpr double kMost = (1 - 0x1p-30) / static_cast<double>(Count::kSmallPerOne);
    const Columns3& travel = lines->travel;
    const Columns3& tool = lines->tool;
    Columns3& vector = lines->vector;
    for (std::size_t i = 0; i < size; ++i) {
      const Vector3<double> first{travel.x[i], travel.y[i], travel.z[i]};
      const Vector3<double> way{travel.x[i + 1], travel.y[i + 1], travel.z[i + 1]};
      const Vector3<double> v{tool.x[i], tool.y[i], tool.z[i]};
      const double square_of_first = lines->square[i];
      const double square = lines->square[i + 1];
      const double along1 = dot(v, first);
      const double along2 = dot(v, way);
      const double square1 = square_of_first - along1 * along1;
      const double square2 = square - along2 * along2;
      const double length1 = std::sqrt(square1);
      const double length2 = std::sqrt(square2);
      const double product = dot(first, way) - along1 * along2;
      const double lengths = length1 * length2;
      const double scale = radius / (lengths + product);
      const Vector3<double> at_end = cross(v, first * length2 + way * length1) * scale;
      vector.x[i + 1] = at_end.x;
      vector.y[i + 1] = at_end.y;
      vector.z[i + 1] = at_end.z;
      // A number that is none refuses too. Without a branch, for vector code.
      const int usual = static_cast<int>(4 * square1 >= square_of_first) & static_cast<int>(4 * square2 >= square) &
                        static_cast<int>(square <= kMostSquare) & static_cast<int>(product > kUncertain * lengths) &
                        static_cast<int>(length2 > shortest) & static_cast<int>(length1 > shortest);
      lines->longest_shift[i] = usual != 0 ? kMost * length1 : 0;
    }
  }
};

// The tool goes forward for certain: the vector moves by less than the line is long.
struct Forward {
  [[gnu::always_inline]] static std::int64_t run(Lines* lines, std::size_t size) {
    const Columns3& vector = lines->vector;
    std::int64_t any = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const double shift = std::abs(vector.x[i + 1] - vector.x[i]) + std::abs(vector.y[i + 1] - vector.y[i]) +
                           std::abs(vector.z[i + 1] - vector.z[i]);
      const std::int64_t refused = shift < lines->longest_shift[i] ? 0 : 1;
      lines->refused[i] = refused;
      any |= refused;
    }
    return any;
  }
};

}  // namespace

SideLineEnd take_side_lines(const LineChunk& chunk, const SideLineStart& start) {
  const Instructions by = chunk.instructions;
  const std::size_t size = chunk.size;
  Lines lines;  // NOLINT(cppcoreguidelines-pro-type-member-init): what is read has been written
  begin(lines.at, start.at);
  begin(lines.travel, start.travel);
  begin(lines.tool, start.tool);
  begin(lines.vector, start.vector);
  lines.square[0] = start.square;
  chunk.go_on(word_place('X'), lines.at.x);
  chunk.go_on(word_place('Y'), lines.at.y);
  chunk.go_on(word_place('Z'), lines.at.z);
  run_by<Travels>(by, &lines, size);
  const double* const i = chunk.word(word_place('I'));
  if (i != nullptr) {
    run_by<Tools>(by, &lines, i, chunk.word(word_place('J')), chunk.word(word_place('K')), size);
  } else {
    std::fill_n(lines.tool.x.begin() + 1, size, start.tool.x);
    std::fill_n(lines.tool.y.begin() + 1, size, start.tool.y);
    std::fill_n(lines.tool.z.begin() + 1, size, start.tool.z);
  }
  run_by<Corners>(by, &lines, size, start.radius, start.shortest);
  std::size_t taken = size;
  if (run_by<Forward>(by, &lines, size) != 0)
    taken = static_cast<std::size_t>(std::ranges::find(lines.refused, 1) - lines.refused.begin());
  Moves& moves = *chunk.moves;
  write_positions(by, lines.at.x.data(), lines.vector.x.data() + 1, moves.next_of(0), taken);
  write_positions(by, lines.at.y.data(), lines.vector.y.data() + 1, moves.next_of(1), taken);
  write_positions(by, lines.at.z.data(), lines.vector.z.data() + 1, moves.next_of(2), taken);
  return {taken, {lines.vector.x[taken], lines.vector.y[taken], lines.vector.z[taken]}};
}

}  // namespace toolcomp::fast

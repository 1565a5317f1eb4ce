// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/cutter_compensation_c/cutter_line_arrays.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "fast/arithmetic/count.h"
#include "fast/arrays/position_arrays.h"
#include "fast/arrays/whole_numbers.h"

namespace toolcomp::fast {
namespace {

using Column = LineChunk::Column;

// Element 0 is the line that is held.
struct Lines {
  Column at_x, at_y;
  Column way_x, way_y, unit_x, unit_y, norm;
  Column vector_x, vector_y;  // at its start; element 1 at the end of the line that is held
  // Of the corner at the end of each line: by how much the vector may move along it, 0 where the line behind is no
  // usual one; and whether it is refused.
  Column longest_shift;
  std::array<std::int64_t, LineChunk::kMost> refused;
};

// Whether one of them is 2^26 or more.
struct Ways {
  [[gnu::always_inline]] static std::int64_t run(Lines* lines, std::size_t size) {
    constexpr double kLong = 0x1p26;
    std::int64_t any = 0;
    for (std::size_t i = 1; i <= size; ++i) {
      const double x = lines->at_x[i] - lines->at_x[i - 1];
      const double y = lines->at_y[i] - lines->at_y[i - 1];
      const double norm = std::sqrt(x * x + y * y);
      lines->way_x[i] = x;
      lines->way_y[i] = y;
      lines->norm[i] = norm;
      lines->unit_x[i] = x / norm;
      lines->unit_y[i] = y / norm;
      any |= norm < kLong ? 0 : 1;
    }
    return any;
  }
};

// Sine and cosine of the turn, times both lengths, rounded once: below 2^26 products are exact as they are.
struct Turned {
  double c, k;
};
template <bool kLong>
[[gnu::always_inline]] inline Turned turn_of(double x1, double y1, double x2, double y2) {
  if constexpr (!kLong) {
    return {x1 * y2 - y1 * x2, x1 * x2 + y1 * y2};
  } else {
    const Parts first_x = parts_of(x1);
    const Parts first_y = parts_of(y1);
    const Parts second_x = parts_of(x2);
    const Parts second_y = parts_of(y2);
    return {difference(first_x, second_y, first_y, second_x), sum(first_x, second_x, first_y, second_y)};
  }
}

// The corner between line i and line i + 1: the vector where the offset tangents meet. `side`: +1 to the left.
template <bool kLong>
struct Corners {
  [[gnu::always_inline]] static void run(Lines* lines, std::size_t size, double offset, double side) {
    constexpr double kMostWay = 0x1p30;
    constexpr double kMost = (1 - 0x1p-30) / static_cast<double>(Count::kSmallPerOne);
    for (std::size_t i = 0; i < size; ++i) {
      const double x = lines->unit_x[i];
      const double y = lines->unit_y[i];
      const auto [c, k] = turn_of<kLong>(lines->way_x[i], lines->way_y[i], lines->way_x[i + 1], lines->way_y[i + 1]);
      const double norms = lines->norm[i] * lines->norm[i + 1];
      // The tangent of half the angle: one quotient of two.
      const bool ahead = k >= 0;
      const double half = (ahead ? c : norms - k) / (ahead ? norms + k : c);
      lines->vector_x[i + 1] = (-y - x * half) * offset;
      lines->vector_y[i + 1] = (x - y * half) * offset;
      // No way or straight back, a long way, an acute corner.
      const int usual = (static_cast<int>(c != 0) | static_cast<int>(k > 0)) &
                        static_cast<int>(std::abs(lines->way_x[i + 1]) < kMostWay) &
                        static_cast<int>(std::abs(lines->way_y[i + 1]) < kMostWay) &
                        (static_cast<int>(k >= 0) | static_cast<int>(c * side >= 0));
      lines->longest_shift[i] = usual != 0 ? kMost * lines->norm[i] : 0;
    }
  }
};

// The tool goes forward for certain: the vector moves by less than the line is long.
struct Forward {
  [[gnu::always_inline]] static std::int64_t run(Lines* lines, std::size_t size) {
    std::int64_t any = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const double shift =
          std::abs(lines->vector_x[i + 1] - lines->vector_x[i]) + std::abs(lines->vector_y[i + 1] - lines->vector_y[i]);
      const std::int64_t refused = shift < lines->longest_shift[i] ? 0 : 1;
      lines->refused[i] = refused;
      any |= refused;
    }
    return any;
  }
};

}  // namespace

CutterLineEnd take_cutter_lines(const LineChunk& chunk, const CutterLineStart& start) {
  const Instructions by = chunk.instructions;
  const std::size_t size = chunk.size;
  Lines lines;  // NOLINT(cppcoreguidelines-pro-type-member-init): what is read has been written
  lines.at_x[0] = start.at[0];
  lines.at_y[0] = start.at[1];
  lines.way_x[0] = start.line.way[0];
  lines.way_y[0] = start.line.way[1];
  lines.unit_x[0] = start.line.unit[0];
  lines.unit_y[0] = start.line.unit[1];
  lines.norm[0] = start.line.norm;
  lines.vector_x[0] = start.vector[0];
  lines.vector_y[0] = start.vector[1];
  chunk.go_on(start.word[0], lines.at_x);
  chunk.go_on(start.word[1], lines.at_y);
  const bool some_long = run_by<Ways>(by, &lines, size) != 0 || start.line.norm >= 0x1p26;
  const double side = start.offset > 0 ? 1 : -1;
  if (some_long)
    run_by<Corners<true>>(by, &lines, size, start.offset, side);
  else
    run_by<Corners<false>>(by, &lines, size, start.offset, side);
  std::size_t taken = size;
  if (run_by<Forward>(by, &lines, size) != 0)
    taken = static_cast<std::size_t>(std::ranges::find(lines.refused, 1) - lines.refused.begin());
  Moves& moves = *chunk.moves;
  write_positions(by, lines.at_x.data(), lines.vector_x.data() + 1, moves.next_of(start.axis[0]), taken);
  write_positions(by, lines.at_y.data(), lines.vector_y.data() + 1, moves.next_of(start.axis[1]), taken);
  CutterLineEnd end;
  end.taken = taken;
  end.last = {DoublePair{lines.way_x[taken], lines.way_y[taken]}, DoublePair{lines.unit_x[taken], lines.unit_y[taken]},
              lines.norm[taken]};
  if (taken > 0) end.before = DoublePair{lines.way_x[taken - 1], lines.way_y[taken - 1]};
  end.vector = DoublePair{lines.vector_x[taken], lines.vector_y[taken]};
  return end;
}

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
#include "fast/heidenhain/face_milling/face_line_arrays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "fast/arrays/position_arrays.h"
#include "fast/arrays/whole_numbers.h"
#include "fast/geometry/vector3.h"
#include "fast/heidenhain/program/whole_vector.h"

namespace toolcomp::fast::klartext {
namespace {

using Column = LineChunk::Column;
struct Columns3 {
  Column x, y, z;
};
using Flags = std::array<std::int64_t, LineChunk::kMost + 1>;

// Of block i at i + 1; 0 is the block before.
struct Blocks {
  Columns3 normal, tool, u, tip;
  Flags flat;     // 1: the normal is along the tool
  Flags refused;  // not 0: no usual block
};

// x² + y² + z² - 10^16: exact where it is below 2^53. All but the last sum are multiples of 2^15.
[[gnu::always_inline]] inline double excess(const Parts& x, const Parts& y, const Parts& z) {
  const double high = x.high * x.high + y.high * y.high + z.high * z.high;
  const double middle = 2 * (x.high * x.low + y.high * y.low + z.high * z.low);
  const double low = x.low * x.low + y.low * y.low + z.low * z.low;
  return ((high * (kPart * kPart) - static_cast<double>(kNormalizedSquare)) + middle * kPart) + low;
}

// Unit vectors, as unit_of().
struct Units {
  [[gnu::always_inline]] static void run(const double* x, const double* y, const double* z, Columns3* unit,
                                         Flags* refused, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
      const double over = excess(parts_of(x[i]), parts_of(y[i]), parts_of(z[i]));
      const double scale = inverse_length(over);
      unit->x[i + 1] = x[i] * scale;
      unit->y[i + 1] = y[i] * scale;
      unit->z[i + 1] = z[i] * scale;
      (*refused)[i + 1] |= std::abs(over) <= static_cast<double>(kMostExcess) ? 0 : 1;
    }
  }
};

// u and whether the contact is flat, as FaceMilling::meet(); `ring`: 1, or 0 where the tool has none. Normals that
// point below are refused.
struct Meetings {
  [[gnu::always_inline]] static void run(const double* nx, const double* ny, const double* nz, const double* tx,
                                         const double* ty, const double* tz, Blocks* blocks, std::size_t size,
                                         bool ring) {
    constexpr double kSurelyAbove = -0.0002 + 0x1p-48;
    for (std::size_t i = 0; i < size; ++i) {
      const Vector3<double> n{blocks->normal.x[i + 1], blocks->normal.y[i + 1], blocks->normal.z[i + 1]};
      const Vector3<double> t{blocks->tool.x[i + 1], blocks->tool.y[i + 1], blocks->tool.z[i + 1]};
      const Parts x1 = parts_of(nx[i]);
      const Parts y1 = parts_of(ny[i]);
      const Parts z1 = parts_of(nz[i]);
      const Parts x2 = parts_of(tx[i]);
      const Parts y2 = parts_of(ty[i]);
      const Parts z2 = parts_of(tz[i]);
      const Vector3<double> c{difference(y1, z2, z1, y2), difference(z1, x2, x1, z2), difference(x1, y2, y1, x2)};
      const double square = dot(c, c);
      const double factor = std::sqrt(square) * (1 / square);
      const Vector3<double> u = cross(t, c) * factor;
      const bool some = square != 0;
      const bool has = some && ring;
      blocks->u.x[i + 1] = has ? u.x : 0;
      blocks->u.y[i + 1] = has ? u.y : 0;
      blocks->u.z[i + 1] = has ? u.z : 0;
      blocks->flat[i + 1] = some ? 0 : 1;
      blocks->refused[i + 1] |= dot(n, t) > kSurelyAbove ? 0 : 1;
    }
  }
};

// The contact jumps, as FaceMilling::jump(), or may.
struct Jumps {
  [[gnu::always_inline]] static void run(Blocks* blocks, std::size_t size) {
    constexpr double kSure = 0x1p-46;
    const Columns3& u = blocks->u;
    for (std::size_t i = 0; i < size; ++i) {
      const double product = u.x[i + 1] * u.x[i] + u.y[i + 1] * u.y[i] + u.z[i + 1] * u.z[i];
      const std::int64_t other = blocks->flat[i + 1] ^ blocks->flat[i];
      const std::int64_t turned = product > kSure ? 0 : 1;
      blocks->refused[i + 1] |= other | (turned & (blocks->flat[i + 1] ^ 1));
    }
  }
};

// What the tip is shifted by, as FaceMilling::mill() and EventWriter::send().
struct Tips {
  double lean;   // along n - t
  double ring;   // along u
  double below;  // the nominal tip, along the tool
  double longer;
  bool contour;
  [[gnu::always_inline]] static void run(Blocks* blocks, const Tips* tool, std::size_t size) {
    const Tips by = *tool;
    const auto tip = [&](const Column& n, const Column& t, const Column& u, Column& to) {
      for (std::size_t i = 1; i <= size; ++i) {
        const double shift = (n[i] - t[i]) * by.lean + u[i] * by.ring;
        const double placed = by.contour ? shift - t[i] * by.below : (by.below != 0 ? shift + t[i] * -by.below : shift);
        to[i] = placed + t[i] * by.longer;
      }
    };
    tip(blocks->normal.x, blocks->tool.x, blocks->u.x, blocks->tip.x);
    tip(blocks->normal.y, blocks->tool.y, blocks->u.y, blocks->tip.y);
    tip(blocks->normal.z, blocks->tool.z, blocks->u.z, blocks->tip.z);
  }
};

Vector element(const Columns3& columns, std::size_t i) { return {columns.x[i], columns.y[i], columns.z[i]}; }
void fill(Columns3& columns, const Vector& value, std::size_t from, std::size_t size) {
  std::fill_n(columns.x.begin() + static_cast<std::ptrdiff_t>(from), size, value.x());
  std::fill_n(columns.y.begin() + static_cast<std::ptrdiff_t>(from), size, value.y());
  std::fill_n(columns.z.begin() + static_cast<std::ptrdiff_t>(from), size, value.z);
}

}  // namespace

FaceLineEnd take_face_lines(const LineChunk& chunk, const FaceLineStart& start,
                            const std::array<std::size_t, 3>& axes) {
  const Instructions by = chunk.instructions;
  const std::size_t size = chunk.size;
  const ToolValues& values = *start.values;
  Blocks blocks;  // NOLINT(cppcoreguidelines-pro-type-member-init): what is read has been written
  blocks.refused.fill(0);
  fill(blocks.u, start.u, 0, 1);
  blocks.flat[0] = start.flat ? 1 : 0;
  const std::array<const double*, 3> n{chunk.word(kNormalPlace), chunk.word(kNormalPlace + 1),
                                       chunk.word(kNormalPlace + 2)};
  const std::array<const double*, 3> t{chunk.word(kToolVectorPlace), chunk.word(kToolVectorPlace + 1),
                                       chunk.word(kToolVectorPlace + 2)};
  run_by<Units>(by, n[0], n[1], n[2], &blocks.normal, &blocks.refused, size);
  if (start.along) {
    blocks.tool = blocks.normal;
    fill(blocks.u, zero_vector(), 1, size);
    std::fill_n(blocks.flat.begin() + 1, size, 1);
  } else if (t[0] != nullptr) {
    run_by<Units>(by, t[0], t[1], t[2], &blocks.tool, &blocks.refused, size);
    run_by<Meetings>(by, n[0], n[1], n[2], t[0], t[1], t[2], &blocks, size, values.has_ring);
  } else {
    fill(blocks.tool, start.tool, 1, size);
    Columns3 whole;  // NOLINT(cppcoreguidelines-pro-type-member-init)
    fill(whole, start.whole_tool, 0, size);
    run_by<Meetings>(by, n[0], n[1], n[2], whole.x.data(), whole.y.data(), whole.z.data(), &blocks, size,
                     values.has_ring);
  }
  if (values.effective_ring > 0) run_by<Jumps>(by, &blocks, size);
  const Tips tips{start.contour ? values.effective_corner : values.corner_delta,
                  start.contour ? values.effective_ring : values.ring_delta, start.tip_below, values.length_delta,
                  start.contour};
  run_by<Tips>(by, &blocks, &tips, size);
  const auto* const first = blocks.refused.data() + 1;
  const auto taken = static_cast<std::size_t>(std::find_if(first, first + size, [](auto r) { return r != 0; }) - first);
  Moves& moves = *chunk.moves;
  const std::array<const Column*, 3> tip{&blocks.tip.x, &blocks.tip.y, &blocks.tip.z};
  for (std::size_t i = 0; i < 3; ++i)
    write_positions(by, chunk.word(word_place('X') + i), tip[i]->data() + 1, moves.next_of(axes[i]), taken);
  return {taken, blocks.flat[taken] != 0, element(blocks.u, taken)};
}

}  // namespace toolcomp::fast::klartext

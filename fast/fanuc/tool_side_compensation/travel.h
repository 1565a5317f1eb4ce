// SPDX-License-Identifier: Apache-2.0
// The movement of a block in X, Y, Z, exactly, with its length.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fast/arithmetic/count.h"
#include "fast/geometry/vector3.h"

namespace toolcomp::fast {

struct Travel {
  Vector3<double> value;  // the doubles nearest to whole(): where `narrow` they are exact
  double square = 0;      // |value|^2
  // Components up to 2^30 in 10^-6 of a setup unit: products of two, and sums of three of them, fit into 64 bits.
  bool narrow = false;
  bool zero = true;
  bool fine_units = false;
  double unit = static_cast<double>(Count::kSmallPerOne);  // whole numbers in a setup unit
  // How far each of whole() may be from the truth: not 0 only after a G49 that ended G43.5 at an irrational position.
  double slack = 0;
  std::array<Int128, 3> wide{};  // not narrow: whole()

  // In 10^-6 where all positions are, else in 1 / (127 * 10^18), of a setup unit.
  [[nodiscard]] std::array<Int128, 3> whole() const {
    if (!narrow) return wide;
    const std::array<std::int64_t, 3> w = small();
    return {w[0], w[1], w[2]};
  }
  // The same of a narrow one.
  [[nodiscard]] std::array<std::int64_t, 3> small() const {
    return {static_cast<std::int64_t>(value.x), static_cast<std::int64_t>(value.y), static_cast<std::int64_t>(value.z)};
  }
};

// By 10^-6 of a setup unit.
inline void set_travel(Travel& travel, std::int64_t dx, std::int64_t dy, std::int64_t dz) {
  constexpr int kNarrowBits = 30;
  const auto over = [](std::int64_t x) { return static_cast<std::uint64_t>(x) + (std::uint64_t{1} << kNarrowBits); };
  travel.slack = 0;
  travel.fine_units = false;
  travel.unit = static_cast<double>(Count::kSmallPerOne);
  travel.narrow = ((over(dx) | over(dy) | over(dz)) >> (kNarrowBits + 1)) == 0;
  if (!travel.narrow) [[unlikely]]
    travel.wide = {dx, dy, dz};
  const auto x = static_cast<double>(dx);
  const auto y = static_cast<double>(dy);
  const auto z = static_cast<double>(dz);
  travel.value.x = x;
  travel.value.y = y;
  travel.value.z = z;
  travel.square = x * x + y * y + z * z;
  travel.zero = (dx | dy | dz) == 0;
}

// From `from` to `to` (X, Y, Z).
inline void set_travel(Travel& travel, const std::array<Count, 3>& from, const std::array<Count, 3>& to, double slack) {
  bool small = slack == 0;
  for (std::size_t i = 0; i < 3; ++i) small = small && from[i].is_small() && to[i].is_small();
  if (small) {
    set_travel(travel, to[0].small() - from[0].small(), to[1].small() - from[1].small(),
               to[2].small() - from[2].small());
    return;
  }
  travel.slack = slack;
  travel.fine_units = true;
  travel.narrow = false;
  for (std::size_t i = 0; i < 3; ++i) travel.wide[i] = to[i].units() - from[i].units();
  travel.value = {static_cast<double>(travel.wide[0]), static_cast<double>(travel.wide[1]),
                  static_cast<double>(travel.wide[2])};
  travel.square = dot(travel.value, travel.value);
  travel.unit = static_cast<double>(Count::kRestPerOne);
  travel.zero = true;
  for (std::size_t i = 0; i < 3; ++i)
    if (travel.value[i] > slack || travel.value[i] < -slack) travel.zero = false;
}

}  // namespace toolcomp::fast

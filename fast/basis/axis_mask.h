// SPDX-License-Identifier: Apache-2.0
// Sets of axes.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace toolcomp::fast {

using Mask = std::uint16_t;  // bit i: axis i

// The mask of one axis.
constexpr Mask bit(std::size_t axis) { return static_cast<Mask>(1U << axis); }

// Runs visit(axis) for each of them.
template <class Visit>
void visit_axes(Mask axes, const Visit& visit) {
  for (unsigned rest = axes; rest != 0; rest &= rest - 1) visit(static_cast<std::size_t>(std::countr_zero(rest)));
}

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
// Sets of axes.
#pragma once

#include <cstddef>
#include <cstdint>

namespace toolcomp::fast {

using Mask = std::uint16_t;  // bit i: axis i

// The mask of one axis.
constexpr Mask bit(std::size_t axis) { return static_cast<Mask>(1U << axis); }

}  // namespace toolcomp::fast

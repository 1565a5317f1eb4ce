// SPDX-License-Identifier: Apache-2.0
// The proof that an expression is zero, if no enclosure can decide it.
#pragma once

#include <cstdint>

#include "model/exact/node.h"

namespace toolcomp::exact {

enum class ZeroProof : std::uint8_t { zero, nonzero, none };

/// Decides whether `node` is zero. Complete for field operations, square roots, and sines and cosines of rational
/// degrees, as far as `units` of work are enough; otherwise the result is `none`. Pi, arc tangents, and functions of
/// other degrees are treated as indeterminates: `zero` is proven for them too, and `nonzero` means that no identity
/// makes it zero.
ZeroProof prove_zero(Node& node, std::int64_t units);

}  // namespace toolcomp::exact

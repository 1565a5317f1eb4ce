// SPDX-License-Identifier: Apache-2.0
// The proof that an expression is zero, where no enclosure can tell.
#pragma once

#include <cstdint>

#include "model/exact/node.h"

namespace toolcomp::exact {

enum class ZeroProof : std::uint8_t { zero, nonzero, none };

/// Decides whether `node` is zero. Complete for field operations, square roots, and sines and cosines of rational
/// degrees, as far as `units` of work reach; none: it does not reach. Pi, arc tangents, and functions of other degrees
/// are taken for indeterminates: `zero` is proven there too, `nonzero` says that no identity makes it zero.
ZeroProof prove_zero(Node& node, std::int64_t units);

}  // namespace toolcomp::exact

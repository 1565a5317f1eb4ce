// SPDX-License-Identifier: Apache-2.0
// Certified signs.
#pragma once

#include <optional>

#include "model/exact/node.h"

namespace toolcomp::exact {

/// The sign that an available enclosure shows, in double or at base_precision.
std::optional<Sign> enclosed_sign(Node& node);

/// The sign, or std::nullopt if neither an enclosure nor a proof of zero gives it within the budget. The result is kept
/// in the node; a node that is zero becomes a rational.
std::optional<Sign> try_decide(Node& node);

/// The same; throws Undecided if there is none.
Sign decide(Node& node);

}  // namespace toolcomp::exact

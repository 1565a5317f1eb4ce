// SPDX-License-Identifier: Apache-2.0
// Certified signs.
#pragma once

#include <optional>

#include "model/exact/node.h"

namespace toolcomp::exact {

/// The sign that an enclosure at hand tells, in double or at base_precision.
std::optional<Sign> enclosed_sign(Node& node);

/// The sign, or none where neither an enclosure nor a proof of zero tells it within the budget. What was found is kept
/// in the node; one that is zero becomes a rational.
std::optional<Sign> try_decide(Node& node);

/// The same; throws Undecided where there is none.
Sign decide(Node& node);

}  // namespace toolcomp::exact

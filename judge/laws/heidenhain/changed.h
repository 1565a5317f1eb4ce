// SPDX-License-Identifier: Apache-2.0
// Klartext programs changed in a way whose effect geometry knows. What the law says: changed_program.h.
#pragma once

#include "judge/laws/changed_program.h"

namespace toolcomp::judge::laws {

// value-zero: every delta is zero.
void no_deltas(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding);

}  // namespace toolcomp::judge::laws

// SPDX-License-Identifier: Apache-2.0
// Programs under G43.4 and G43.5, for both sections.
#pragma once

#include "fuzz/gen/choices.h"
#include "spec/language/case.h"

namespace toolcomp::fuzz {

// `posture`: mostly P1, and turns through and around singular postures.
spec::Case rotary_case(Choices& choose, std::uint32_t blocks, bool posture);

}  // namespace toolcomp::fuzz

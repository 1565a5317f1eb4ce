// SPDX-License-Identifier: Apache-2.0
// P1 programs: great circles past, through, from and to singular postures.
#include "fuzz/gen/fanuc/rotary_program.h"
#include "fuzz/gen/sections.h"

namespace toolcomp::fuzz {

spec::Case tool_posture_control(Choices& choose, std::uint32_t blocks) { return rotary_case(choose, blocks, true); }

}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
// G43.4 and G43.5 programs: frames, lengths, arcs and what the mode combines with.
#include "fuzz/gen/fanuc/rotary_program.h"
#include "fuzz/gen/sections.h"

namespace toolcomp::fuzz {

spec::Case tool_center_point_control(Choices& choose, std::uint32_t blocks) {
  return rotary_case(choose, blocks, false);
}

}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
// One generator a section: directed cases.
#pragma once

#include "fuzz/gen/choices.h"

namespace toolcomp::fuzz {

// Setup and program of a mostly valid case with `blocks` blocks or a few fewer.
spec::Case tool_length_offset(Choices& choose, std::uint32_t blocks);
spec::Case tool_length_measurement(Choices& choose, std::uint32_t blocks);
spec::Case tool_offset(Choices& choose, std::uint32_t blocks);
spec::Case canned_cycle(Choices& choose, std::uint32_t blocks);
spec::Case cutter_compensation_b(Choices& choose, std::uint32_t blocks);
spec::Case cutter_compensation_c(Choices& choose, std::uint32_t blocks);
spec::Case tool_side_compensation(Choices& choose, std::uint32_t blocks);
spec::Case leading_edge_offset(Choices& choose, std::uint32_t blocks);
spec::Case tool_center_point_control(Choices& choose, std::uint32_t blocks);
spec::Case tool_posture_control(Choices& choose, std::uint32_t blocks);
spec::Case face_milling(Choices& choose, std::uint32_t blocks);
spec::Case peripheral_milling(Choices& choose, std::uint32_t blocks);
spec::Case programmed_contour(Choices& choose, std::uint32_t blocks);

// Any words over any setup of the section: valid programs with damage, words at random, look-alike text.
spec::Case unrestricted(Choices& choose, spec::Case directed, std::uint32_t blocks);

// One word of the program changed, moved or left out.
void slip(Choices& choose, spec::Case& c);

}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
// RL and RR under TCPM: contours with corners, reversals and stops, tools turned by rotary words and by vectors; LN
// with a normal at right angles to the tool.
#include "fuzz/gen/heidenhain/klartext_program.h"
#include "fuzz/gen/heidenhain/tool_tables.h"
#include "fuzz/gen/sections.h"

namespace toolcomp::fuzz {

spec::Case peripheral_milling(Choices& choose, std::uint32_t blocks) {
  spec::Case c;
  c.dialect = "klartext";
  c.setup = random_heidenhain_setup(choose);
  c.program = KlartextProgram(choose, c.setup, {10, 56, 14, 14, 8}).text(blocks);
  return c;
}

}  // namespace toolcomp::fuzz

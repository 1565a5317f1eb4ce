// SPDX-License-Identifier: Apache-2.0
// LN programs with surface normals: every tool, orientation and reference, with and without TCPM.
#include "fuzz/gen/heidenhain/klartext_program.h"
#include "fuzz/gen/heidenhain/tool_tables.h"
#include "fuzz/gen/sections.h"

namespace toolcomp::fuzz {

spec::Case face_milling(Choices& choose, std::uint32_t blocks) {
  spec::Case c;
  c.dialect = "klartext";
  c.setup = random_heidenhain_setup(choose);
  c.program = KlartextProgram(choose, c.setup, {66, 4, 8, 20, 8}).text(blocks);
  return c;
}

}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
// FUNCTION PROG PATH IS CONTOUR: blocks with normals and blocks beside the path by the full radii.
#include "fuzz/gen/heidenhain/klartext_program.h"
#include "fuzz/gen/heidenhain/tool_tables.h"
#include "fuzz/gen/sections.h"

namespace toolcomp::fuzz {

spec::Case programmed_contour(Choices& choose, std::uint32_t blocks) {
  spec::Case c;
  c.dialect = "klartext";
  c.setup = random_heidenhain_setup(choose);
  c.program = KlartextProgram(choose, c.setup, {36, 28, 10, 18, 88}).text(blocks);
  return c;
}

}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/mutate.h"

#include <string>
#include <vector>

#include "fuzz/gen/choices.h"
#include "fuzz/gen/fanuc/mutate_program.h"
#include "fuzz/gen/heidenhain/mutate_klartext.h"
#include "fuzz/gen/program_text.h"

namespace toolcomp::fuzz {

void mutate(spec::Case& c, Mode mode, ChoiceSource& source) {
  Choices choose(source);
  const std::size_t most = mode == Mode::directed ? 2 : 4;
  const bool sampled = c.section == "fanuc/tool-center-point-control" || c.section == "fanuc/tool-posture-control";
  if (sampled && choose.chance(5)) c.samples = static_cast<std::uint32_t>(choose.below(5));
  const bool klartext = c.setup.control == spec::Control::heidenhain;
  for (std::size_t n = choose.below(most) + 1; n > 0; --n) {
    const bool setup = choose.chance(20);
    if (klartext)
      setup ? change_tool_tables(choose, c.setup, mode) : change_klartext(choose, c, mode);
    else
      setup ? change_setup(choose, c.setup, mode) : change_program(choose, c, mode);
  }
}

spec::Case splice(const spec::Case& a, const spec::Case& b, ChoiceSource& source) {
  Choices choose(source);
  std::vector<std::string> first = lines(a.program);
  const std::vector<std::string> second = lines(b.program);
  // At least half of it stays: its first blocks fit its setup, those of the other case need not.
  first.resize(first.size() - choose.below(first.size() / 2 + 1));
  const std::size_t from = choose.below(second.size() + 1);
  first.insert(first.end(), second.begin() + static_cast<std::ptrdiff_t>(from), second.end());
  if (first.size() > kMostLines) first.resize(kMostLines);
  spec::Case c = a;
  c.program = joined(first);
  return c;
}

}  // namespace toolcomp::fuzz

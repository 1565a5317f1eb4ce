// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/fanuc/vocabulary.h"
#include "fuzz/gen/heidenhain/klartext_vocabulary.h"
#include "fuzz/gen/mutate.h"
#include "fuzz/gen/program_text.h"
#include "fuzz/gen/sections.h"

namespace toolcomp::fuzz {
namespace {

std::string random_line(Choices& choose, const spec::Case& c) {
  if (c.setup.control == spec::Control::heidenhain) return any_klartext_statement(choose, c.setup);
  if (choose.chance(6))
    return choose.one_of({"%",       "O0001",     "(COMMENT)", "(OPEN",    "/G01 X1.", ";",      "  ",
                          "g01 x1.", "N1",        "N1 N2 X1.", "G1X1Y1Z1", "X1. X2.",  "G90G91", "G 01 X 1.",
                          "*",       "X1.(C)Y2.", "NAN",       "INF",      "X+1.",     "1X"});
  WordTexts line;
  for (std::size_t n = choose.below(5) + 1; n > 0; --n)
    line.push_back(choose.chance(8) ? odd_word(choose) : any_word(choose, c.setup, c.section));
  return joined_words(line);
}

}  // namespace

spec::Case unrestricted(Choices& choose, spec::Case directed, std::uint32_t blocks) {
  switch (choose.weighted({60, 40})) {
    case 0:
      mutate(directed, Mode::unrestricted, choose.source());
      break;
    default: {
      std::vector<std::string> text;
      while (text.size() < blocks) text.push_back(random_line(choose, directed));
      directed.program = joined(text);
      break;
    }
  }
  return directed;
}

}  // namespace toolcomp::fuzz

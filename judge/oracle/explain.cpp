// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "judge/oracle/verdict.h"

namespace toolcomp::judge {

std::string explain(const Difference& difference) {
  std::string text = difference.line > 0 ? fmt::format("line {}, ", difference.line) : std::string();
  text += difference.kind;
  if (!difference.field.empty() && difference.field != difference.kind) text += " " + difference.field;
  text += fmt::format(": {} expected, {} given", difference.expected, difference.actual);
  if (difference.deviation_um > 0) text += fmt::format(", {:.3g} um off", difference.deviation_um);
  if (difference.clause) text += fmt::format(" ({})", spec::info(*difference.clause).id);
  return text;
}

}  // namespace toolcomp::judge

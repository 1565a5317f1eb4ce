// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <string>

#include "judge/laws/heidenhain/changed.h"
#include "judge/laws/heidenhain/klartext_program.h"
#include "judge/laws/numbers.h"

namespace toolcomp::judge::laws {

void no_deltas(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding) {
  std::string text = c.program;
  std::ranges::transform(text, text.begin(), [](unsigned char ch) { return static_cast<char>(std::toupper(ch)); });
  for (const std::string_view word : {"CONTOUR", "DL", "DR"})
    if (text.find(word) != std::string::npos) return;
  spec::Case changed = c;
  for (spec::ToolRow& tool : changed.setup.tools) {
    tool.dl = tool.dr = tool.dr2 = {};
    tool.dr2_table.clear();
  }
  for (auto& [number, row] : changed.setup.tcs) row = {};
  const std::vector<model::Event> other = run(changed);
  const KlartextProgram program(changed);
  for (std::size_t i = 0; i < other.size(); ++i) {
    const model::Event& event = other[i];
    if (program.block(event.line) == nullptr) continue;
    // Of the given events the place is named, where there is one.
    const std::size_t place = std::min(i, events.size() - 1);
    if (event.hole && event.axes.has(event.hole->axis))
      holding.zero(event.axes[event.hole->axis] - event.hole->level, place,
                   "tool axis after a hole, less the level of return, with deltas of zero");
    if (event.kind != spec::EventKind::move || !event.space) continue;
    const auto point = xyz(c.setup.axes, event.point);
    const auto axes = xyz(c.setup.axes, event.axes);
    if (!xyz(c.setup.axes, event.programmed) || !point || !axes) continue;
    holding.zero(event.space->shift, place, "shift with deltas of zero");
    holding.zero(*axes - *point, place, "axes, less the tip, with deltas of zero");
  }
}

}  // namespace toolcomp::judge::laws

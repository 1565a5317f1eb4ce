// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "judge/laws/fanuc/changed.h"
#include "judge/laws/fanuc/scene.h"
#include "judge/laws/numbers.h"

namespace toolcomp::judge::laws {
namespace {

void ask_hole(const spec::Axes& axes, const model::Event& event, std::size_t place, Holding& holding) {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!event.axes.has(i)) continue;
    if (i == event.hole->axis)
      holding.zero(event.axes[i] - event.hole->level, place, "drilling axis, less the level, with offsets of zero");
    else if (event.point.has(i))
      holding.zero(event.axes[i] - event.point[i], place,
                   "axis other than the drilling axis, less the position of the hole, with offsets of zero");
  }
}

}  // namespace

void no_offsets(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding) {
  const FanucProgram program(c);
  if (program.has_code({kG10, kG37})) return;
  const bool asks_holes = !program.has_code({kG43_4, kG43_5});
  spec::Case changed = c;
  for (auto* offsets : {&changed.setup.h, &changed.setup.d})
    for (auto& [number, entry] : *offsets) entry = {};
  changed.setup.parameters.erase({19666, -1});
  const std::vector<model::Event> other = run(changed);
  const FanucScene scene(changed, other);
  for (std::size_t i = 0; i < other.size(); ++i) {
    const model::Event& event = other[i];
    if (event.hole && asks_holes) ask_hole(c.setup.axes, event, std::min(i, events.size() - 1), holding);
    if (event.kind != spec::EventKind::move || event.cause == spec::Cause::pre_turn) continue;
    // A turn still to come takes the point along (19696#5 = 1).
    if (i + 1 < other.size() && other[i + 1].cause == spec::Cause::post_turn) continue;
    // Of the given events the place is named, where there is one.
    const std::size_t place = std::min(i, events.size() - 1);
    const auto programmed = xyz(c.setup.axes, event.programmed);
    const auto point = xyz(c.setup.axes, event.point);
    const auto axes = xyz(c.setup.axes, event.axes);
    if (!programmed || !point || !axes) continue;
    if (!scene.names_other_points())
      holding.zero(*point - *programmed, place, "point, less the programmed one, with offsets of zero");
    const std::size_t index = scene.program.index(event.line);
    if (index == scene.program.blocks().size()) continue;
    const int length = scene.program.blocks()[index].length;
    if (length != kG43_4 && length != kG43_5)
      holding.zero(*axes - *point, place, "axes, less the point, with offsets of zero");
  }
}

}  // namespace toolcomp::judge::laws

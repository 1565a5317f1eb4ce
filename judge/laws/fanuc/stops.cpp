// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/fanuc/stops.h"

#include <string_view>

#include "judge/laws/numbers.h"

namespace toolcomp::judge::laws {

std::vector<Stop> stops_of(const spec::Axes& axes, const FanucProgram& program, std::span<const model::Event> events) {
  std::vector<Stop> stops;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const model::Event& event = events[i];
    if (event.kind != spec::EventKind::move) continue;
    const std::size_t block = program.index(event.line);
    const auto programmed = xyz(axes, event.programmed);
    const auto point = xyz(axes, event.point);
    if (!programmed || !point || block == program.blocks().size()) break;
    const Head head{*point - *programmed, i};
    if (event.cause == spec::Cause::corner && !stops.empty()) {
      stops.back().heads.push_back(head);
      continue;
    }
    if (event.cause == spec::Cause::pre_turn) continue;
    if (event.cause == spec::Cause::post_turn) {
      // The block ends where its turn ends.
      if (!stops.empty() && stops.back().block == block) stops.back().heads = {head};
      continue;
    }
    Stop stop;
    stop.own = &event;
    stop.event = i;
    stop.block = block;
    stop.programmed = *programmed;
    if (!stops.empty() && !program.renames(stops.back().block, block))
      stop.displacement = *programmed - stops.back().programmed;
    stop.heads.push_back(head);
    stops.push_back(std::move(stop));
  }
  return stops;
}

}  // namespace toolcomp::judge::laws

// SPDX-License-Identifier: Apache-2.0
// What every law of FANUC programs is given: the case, the events, and what is read from both once.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "judge/laws/fanuc/poses.h"
#include "judge/laws/fanuc/stops.h"
#include "judge/laws/holding.h"
#include "spec/language/case.h"

namespace toolcomp::judge::laws {

struct FanucScene {
  const spec::Case& c;
  std::span<const model::Event> events;
  FanucProgram program;
  std::vector<Stop> stops;
  std::optional<Machine> machine;
  std::vector<Run> runs;  // under tool center point control, on this machine

  FanucScene(const spec::Case& made, std::span<const model::Event> given);
  // Points programmed in the workpiece system (19696#5) are those for which a block ends; before and behind a turn of
  // its own the tip is elsewhere.
  [[nodiscard]] bool names_other_points() const { return c.setup.bit(19696, 5) && program.has_code({kG43_4}); }
  [[nodiscard]] const FanucBlock& block(const Stop& stop) const { return program.blocks()[stop.block]; }
};

}  // namespace toolcomp::judge::laws

// What every law is given: the case, the events, and what is read from both once.
#pragma once

#include <span>
#include <vector>

#include "fuzz/laws/holding.h"
#include "fuzz/laws/klartext_program.h"
#include "fuzz/laws/stops.h"
#include "spec/language/case.h"

namespace toolcomp::fuzz::laws {

struct Scene {
  const spec::Case& c;
  std::span<const model::Event> events;
  FanucProgram program;      // FANUC; empty for other controls
  KlartextProgram klartext;  // the same of Klartext
  std::vector<Stop> stops;   // of FANUC programs

  Scene(const spec::Case& made, std::span<const model::Event> given);
  [[nodiscard]] const FanucBlock& block(const Stop& stop) const { return program.blocks()[stop.block]; }
};

}  // namespace toolcomp::fuzz::laws

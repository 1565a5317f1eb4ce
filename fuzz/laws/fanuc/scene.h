// What every law is given: the case, the events, and what is read from both once.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fuzz/laws/holding.h"
#include "fuzz/laws/klartext_program.h"
#include "fuzz/laws/poses.h"
#include "fuzz/laws/stops.h"
#include "spec/language/case.h"

namespace toolcomp::fuzz::laws {

// A move of a Klartext program with what its block says.
struct SpaceMove {
  const model::Event* event = nullptr;
  std::size_t index = 0;
  const KlartextBlock* block = nullptr;
  Vector programmed;
  Vector tip;
  Vector tool;
  Vector side;  // normal × tool, where there is a contact
};

struct Scene {
  const spec::Case& c;
  std::span<const model::Event> events;
  FanucProgram program;      // FANUC; empty for other controls
  KlartextProgram klartext;  // the same of Klartext
  std::vector<Stop> stops;   // of FANUC programs
  std::vector<SpaceMove> moves;
  std::optional<Machine> machine;
  std::vector<Run> runs;  // under tool center point control, on this machine

  Scene(const spec::Case& made, std::span<const model::Event> given);
  // Points programmed in the workpiece system (19696#5) are those for which a block ends; before and behind a turn of
  // its own the tip is elsewhere.
  [[nodiscard]] bool names_other_points() const { return c.setup.bit(19696, 5) && program.has_code({434}); }
  [[nodiscard]] const FanucBlock& block(const Stop& stop) const { return program.blocks()[stop.block]; }
};

}  // namespace toolcomp::fuzz::laws

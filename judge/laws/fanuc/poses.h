// SPDX-License-Identifier: Apache-2.0
// The moves and samples run under tool center point control, with where tool and table stand.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "judge/laws/fanuc/fanuc_program.h"
#include "judge/laws/fanuc/machine.h"
#include "model/basis/event.h"
#include "spec/language/setup.h"

namespace toolcomp::judge::laws {

// The control once tool center point control began: what its block left behind.
struct Mode {
  std::size_t block = 0;  // of G43.4 or G43.5
  std::array<Turn, 2> turns;
  Vector origin;           // of the workpiece, machine coordinates
  bool by_machine = true;  // machine coordinates of the rotary axes are their angles, else the programmed ones
  std::array<Real, 2> rotary_zeros;  // of their angles
  std::optional<Real> length;
};

// A move or a sample under the mode.
struct Pose {
  const model::Event* event = nullptr;
  std::size_t index = 0;
  std::size_t block = 0;
  std::array<Real, 2> degrees;  // angles
  std::array<Turn, 2> turns;
  Vector control_point;  // machine coordinates

  [[nodiscard]] bool is_sample() const { return event->kind == spec::EventKind::sample; }
};

// The moves and samples under tool center point control, up to its end, a second G43.4 or G43.5, or a hole.
struct Run {
  Mode mode;
  std::vector<Pose> poses;  // the first is that of the mode's own block
};

// Nothing where frames or lengths change on the way: G10, G37, G92, G53, G28 to G30, workpiece systems.
std::vector<Run> runs_of(const spec::Setup& setup, const FanucProgram& program, std::span<const model::Event> events,
                         const Machine& machine);

}  // namespace toolcomp::judge::laws

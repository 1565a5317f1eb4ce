// SPDX-License-Identifier: Apache-2.0
#include "model/heidenhain/program/position.h"

namespace toolcomp::model::klartext {

using spec::klartext::kAxisLetters;

void ProgrammedPosition::start(const spec::Setup& setup) {
  for (const auto& [letter, value] : setup.position)
    if (spec::is_linear_axis(letter)) at_.at(kAxisLetters.find(letter)) = values_.of_setup(value);
}

void ProgrammedPosition::move(const spec::klartext::Block& block, bool machine_coordinates) {
  // heidenhain.program.machine-coordinates: In a block with M91 or M92 the datum shift does not count. The preset is
  // taken as the machine datum, because the setup has no other.
  const bool from_datum = !recorder_.decide(Clause::heidenhain_program_machine_coordinates, machine_coordinates);
  for (std::size_t slot = 0; slot < kAxisLetters.size(); ++slot) {
    if (!block.has_axis(slot)) continue;
    const Real word = values_.word(block.axis.at(slot));
    // heidenhain.program.incremental: A word with I is a travel from the programmed position; in cycle 7 it adds to the
    // shift (heidenhain.program.datum-shift). A word without I is the end position.
    if (recorder_.decide(Clause::heidenhain_program_incremental, block.is_incremental(slot)))
      at_.at(slot) += word;
    else
      at_.at(slot) = from_datum ? word + datum_.at(slot) : word;
    unknown_ &= ~(1U << slot);
  }
}

// heidenhain.program.retraction: M140 MB n moves the tool by n along its own direction, away from the workpiece. This
// is a motion of its own, like L to that point, and rapid if its block has no F. That point is then the programmed
// position. M140 MB MAX goes on to the limit of travel, which is not known here. The positions of those of X, Y and Z
// along which the tool has a component are then unknown.
void ProgrammedPosition::retract(const Real& by, const Vector& tool) {
  recorder_.decide(Clause::heidenhain_program_retraction, false);
  for (std::size_t slot = 0; slot < kFirstRotarySlot; ++slot) at_.at(slot) += by * component(tool, slot);
}

void ProgrammedPosition::retract_to_limit(const Vector& tool) {
  recorder_.decide(Clause::heidenhain_program_retraction, true);
  for (std::size_t slot = 0; slot < kFirstRotarySlot; ++slot)
    if (component(tool, slot).sign() != exact::Sign::zero) unknown_ |= 1U << slot;
}

void ProgrammedPosition::depart(const Vector& tool) {
  for (std::size_t slot = 0; slot < kFirstRotarySlot; ++slot)
    if (component(tool, slot).sign() == exact::Sign::zero) unknown_ |= 1U << slot;
}

std::optional<HoleLevels> ProgrammedPosition::drill(std::size_t slot) {
  using spec::klartext::Parameter;
  const auto value = [this](const Parameter& parameter) { return values_.word({{}, parameter}); };
  const Real depth = value(spec::klartext::kDepth);
  // heidenhain.program.cycle-call: CYCL CALL, and M99 at the end of its block, run the drilling cycle defined last at
  // the place where the linear axes are. The cycle makes one hole along the tool axis, with the values that Q200
  // (set-up clearance), Q201 (depth), Q203 (surface) and Q204 (second set-up clearance) have at the call. The hole
  // begins at Q203 + Q200 and goes down to Q203 + Q201, both from the shifted datum. With Q201 = 0 the cycle does
  // nothing. For all other rules a hole is a motion of L under R0.
  if (!recorder_.decide(Clause::heidenhain_program_cycle_call, depth.sign() != exact::Sign::zero)) return std::nullopt;
  const Real surface = datum_.at(slot) + value(spec::klartext::kSurface);
  const Real clearance = value(spec::klartext::kSetUpClearance);
  const Real second = value(spec::klartext::kSecondClearance);
  // heidenhain.program.cycle-return: After a hole the tool is at Q203 + Q204 if Q204 is greater than Q200, and
  // otherwise at Q203 + Q200. This level is then the programmed position of the tool axis. It is known even if the
  // position of the tool axis was unknown before.
  const bool higher = recorder_.decide(Clause::heidenhain_program_cycle_return, second > clearance);
  at_.at(slot) = surface + (higher ? second : clearance);
  unknown_ &= ~(1U << slot);
  return HoleLevels{surface + clearance, surface + depth, at_.at(slot)};
}

void ProgrammedPosition::shift_datum(const spec::klartext::Block& block) {
  if (block.axes == 0) return;
  // heidenhain.program.datum-shift: CYCL DEF 7.n sets the shift of the axes that it names, and a word with I adds to
  // the shift. The shift acts from that block on. Programmed positions count from the shifted datum, positions in
  // events from the preset.
  recorder_.reach(Clause::heidenhain_program_datum_shift);
  for (std::size_t slot = 0; slot < kAxisLetters.size(); ++slot) {
    if (!block.has_axis(slot)) continue;
    const Real word = values_.word(block.axis.at(slot));
    if (recorder_.decide(Clause::heidenhain_program_incremental, block.is_incremental(slot)))
      datum_.at(slot) += word;
    else
      datum_.at(slot) = word;
  }
}

}  // namespace toolcomp::model::klartext

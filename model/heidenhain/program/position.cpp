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
  // taken as the machine datum: the setup knows no other.
  const bool from_datum = !recorder_.decide(Clause::heidenhain_program_machine_coordinates, machine_coordinates);
  for (std::size_t slot = 0; slot < kAxisLetters.size(); ++slot) {
    if (!block.has_axis(slot)) continue;
    const Real word = values_.word(block.axis.at(slot));
    // heidenhain.program.incremental: A word with I is a travel from the programmed position, in L and in cycle 7; a
    // word without it is the end position.
    if (recorder_.decide(Clause::heidenhain_program_incremental, block.is_incremental(slot)))
      at_.at(slot) += word;
    else
      at_.at(slot) = from_datum ? word + datum_.at(slot) : word;
  }
}

void ProgrammedPosition::shift_datum(const spec::klartext::Block& block) {
  if (block.axes == 0) return;
  // heidenhain.program.datum-shift: CYCL DEF 7.n sets the shift of the axes it names, with I it adds to it, from there
  // on; positions that are programmed count from the shifted datum, events from the preset.
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

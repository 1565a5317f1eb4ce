#include "model/heidenhain/program/position.h"

namespace toolcomp::model::klartext {

using spec::klartext::kAxisLetters;

void ProgrammedPosition::start(const spec::Setup& setup) {
  for (const auto& [letter, value] : setup.position)
    if (spec::is_linear_axis(letter)) at_.at(kAxisLetters.find(letter)) = values_.of_setup(value);
}

void ProgrammedPosition::move(const spec::klartext::Block& block, bool machine_coordinates) {
  const bool from_datum = !recorder_.decide(Clause::heidenhain_program_machine_coordinates, machine_coordinates);
  for (std::size_t slot = 0; slot < kAxisLetters.size(); ++slot) {
    if (!block.has_axis(slot)) continue;
    const Real word = values_.word(block.axis.at(slot));
    if (recorder_.decide(Clause::heidenhain_program_incremental, block.is_incremental(slot)))
      at_.at(slot) += word;
    else
      at_.at(slot) = from_datum ? word + datum_.at(slot) : word;
  }
}

void ProgrammedPosition::shift_datum(const spec::klartext::Block& block) {
  if (block.axes == 0) return;
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

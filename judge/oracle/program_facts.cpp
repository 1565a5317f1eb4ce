// SPDX-License-Identifier: Apache-2.0
#include "judge/oracle/program_facts.h"

#include <algorithm>
#include <iterator>
#include <memory>

#include "judge/oracle/control.h"
#include "judge/oracle/number.h"
#include "spec/language/input_error.h"

namespace toolcomp::judge {
ProgramFacts ProgramFacts::of(const spec::Case& c) {
  return with_control(c.setup, [&c]<class Control>(Control) {
    ProgramFacts facts;
    try {
      typename Control::Reader reader = Control::reader(spec::text_source(c.program), c.setup, "program");
      const auto block = std::make_unique<typename Control::Block>();
      while (reader.next(*block)) facts.read(*block);
    } catch (const spec::InputError&) {  // NOLINT(bugprone-empty-catch)
      // Where a run comes so far it is reported there; it may have ended before.
    }
    return facts;
  });
}

void ProgramFacts::read(const spec::Block& block) {
  constexpr double by_positions = 43.4;
  constexpr double by_direction = 43.5;
  constexpr double end = 49;
  std::optional<double> code;
  double lean = 0;
  for (const spec::Word& word : block.words()) {
    const double value = approximate(word.value);
    if (word.address == 'G' && (value == by_positions || value == by_direction || value == end)) code = value;
    if (word.address == 'Q') lean = value;
  }
  if (code) modes_.push_back({block.line, *code == by_direction, *code == by_direction ? lean : 0});
}

const ProgramFacts::Mode* ProgramFacts::mode(std::uint64_t line) const {
  const auto later = std::ranges::upper_bound(modes_, line, {}, &Mode::line);
  return later == modes_.begin() ? nullptr : &*std::prev(later);
}

bool ProgramFacts::directed(std::uint64_t line) const {
  const Mode* const in_force = mode(line);
  return in_force != nullptr && in_force->directed;
}

double ProgramFacts::lean(std::uint64_t line) const {
  const Mode* const in_force = mode(line);
  return in_force != nullptr ? in_force->lean : 0;
}

void ProgramFacts::read(const spec::klartext::Block& block) {
  if (block.statement == spec::klartext::Statement::begin_program && !block.alarm) units_ = block.unit;
}

}  // namespace toolcomp::judge

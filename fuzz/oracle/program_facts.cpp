#include "fuzz/oracle/program_facts.h"

#include <algorithm>
#include <memory>

#include "fuzz/oracle/control.h"
#include "fuzz/oracle/number.h"
#include "spec/language/input_error.h"

namespace toolcomp::fuzz {
ProgramFacts ProgramFacts::of(const spec::Case& c) {
  return with_control(c.setup, [&c]<class Control>(Control) {
    ProgramFacts facts;
    try {
      typename Control::Reader reader = Control::reader(spec::text_source(c.program), c.setup, "program");
      const auto block = std::make_unique<typename Control::Block>();
      while (reader.next(*block)) facts.read(*block);
    } catch (const spec::InputError&) {
      // Where a run comes so far it is reported there; it may have ended before.
    }
    return facts;
  });
}

void ProgramFacts::read(const spec::Block& block) {
  constexpr double by_direction = 43.5;
  for (const spec::Word& word : block.words()) {
    if (word.address == 'G' && approximate(word.value) == by_direction) first_ = std::min(first_, block.line);
    if (word.address != 'Q') continue;
    const double degrees = approximate(word.value);
    const auto known = [degrees](const Lean& lean) { return lean.degrees == degrees; };
    if (degrees != 0 && std::none_of(leans_.begin(), leans_.end(), known)) leans_.push_back({block.line, degrees});
  }
}

void ProgramFacts::read(const spec::klartext::Block& block) {
  if (block.statement == spec::klartext::Statement::begin_program && !block.alarm) units_ = block.unit;
}

}  // namespace toolcomp::fuzz

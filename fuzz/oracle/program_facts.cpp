#include "fuzz/oracle/program_facts.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "fuzz/oracle/control.h"
#include "spec/language/input_error.h"

namespace toolcomp::fuzz {
namespace {

double value(const spec::Word& word) {
  const double magnitude = static_cast<double>(word.value.digits) / std::pow(10.0, word.value.decimals);
  return word.value.negative ? -magnitude : magnitude;
}

}  // namespace

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
    if (word.address == 'G' && value(word) == by_direction) first_ = std::min(first_, block.line);
    if (word.address != 'Q') continue;
    const double degrees = value(word);
    const auto known = [degrees](const Lean& lean) { return lean.degrees == degrees; };
    if (degrees != 0 && std::none_of(leans_.begin(), leans_.end(), known)) leans_.push_back({block.line, degrees});
  }
}

void ProgramFacts::read(const spec::klartext::Block& block) {
  if (const auto units = units_of(block)) units_ = units;
}

}  // namespace toolcomp::fuzz

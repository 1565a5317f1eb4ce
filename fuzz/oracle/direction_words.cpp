#include "fuzz/oracle/direction_words.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "spec/language/program_reader.h"

namespace toolcomp::fuzz {
namespace {

double value(const spec::Word& word) {
  const double magnitude = static_cast<double>(word.value.digits) / std::pow(10.0, word.value.decimals);
  return word.value.negative ? -magnitude : magnitude;
}

}  // namespace

DirectionWords DirectionWords::of(const spec::Case& c) {
  DirectionWords words;
  spec::ProgramReader reader(spec::text_source(c.program), c.setup.axes, {"program", c.setup.block_skip});
  const auto block = std::make_unique<spec::Block>();
  while (reader.next(*block)) words.read(*block);
  return words;
}

void DirectionWords::read(const spec::Block& block) {
  constexpr double by_direction = 43.5;
  for (const spec::Word& word : block.words()) {
    if (word.address == 'G' && value(word) == by_direction) first_ = std::min(first_, block.line);
    if (word.address != 'Q') continue;
    const double degrees = value(word);
    const auto known = [degrees](const Lean& lean) { return lean.degrees == degrees; };
    if (degrees != 0 && std::none_of(leans_.begin(), leans_.end(), known)) leans_.push_back({block.line, degrees});
  }
}

}  // namespace toolcomp::fuzz

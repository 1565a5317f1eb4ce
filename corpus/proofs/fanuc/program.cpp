#include "corpus/proofs/fanuc/program.h"

#include <algorithm>

#include "spec/language/fanuc/program_reader.h"

namespace toolcomp::corpus {

Rational offset_of(const spec::Setup& setup, char address, std::uint64_t number) {
  const auto& own = address == 'H' ? setup.h : setup.d;
  const auto& other = address == 'H' ? setup.d : setup.h;
  const auto key = static_cast<std::uint32_t>(number);
  auto found = own.find(key);
  if (found == own.end()) {
    // In memory A and B a number given in one table counts for both addresses.
    if (setup.memory == spec::OffsetMemory::c) return 0;
    found = other.find(key);
    if (found == other.end()) return 0;
  }
  const Rational geometry = value_of(found->second.geometry);
  return setup.memory == spec::OffsetMemory::a ? geometry : Rational(geometry + value_of(found->second.wear));
}

std::optional<Blocks> blocks_of(const spec::Case& c) {
  if (!c.setup.bit(3401, 0, true)) return std::nullopt;  // numbers without a point are increments
  spec::ProgramReader reader(spec::text_source(c.program), c.setup.axes);
  Blocks blocks;
  for (spec::Block block; reader.next(block);) {
    if (block.alarm || has(block, "G20") || has(block, "G21")) return std::nullopt;
    blocks[block.line] = block;
  }
  return blocks;
}

bool has(const spec::Block& block, std::string_view word) {
  const std::optional<spec::Decimal> wanted = spec::parse_decimal(word.substr(1));
  return std::ranges::any_of(block.words(), [&](const spec::Word& w) {
    return w.address == word[0] && wanted && value_of(w.value) == value_of(*wanted);
  });
}

std::optional<spec::Decimal> word(const spec::Block& block, char address) {
  std::optional<spec::Decimal> found;
  for (const spec::Word& w : block.words())
    if (w.address == address) found = w.value;
  return found;
}

}  // namespace toolcomp::corpus

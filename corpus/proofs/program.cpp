#include "corpus/proofs/program.h"

#include <fmt/format.h>

#include <algorithm>

#include "spec/language/fanuc/program_reader.h"

namespace toolcomp::corpus {

Rational value_of(const spec::Decimal& decimal) {
  exact::Integer unit = 1;
  for (int i = 0; i < decimal.decimals; ++i) unit *= 10;
  const Rational value(exact::Integer(decimal.digits), unit);
  return decimal.negative ? Rational(-value) : value;
}

std::string coq(const Rational& value) {
  const exact::Integer above = numerator(value);
  const exact::Integer below = denominator(value);
  return below == 1 ? fmt::format("({})", above.str()) : fmt::format("({} / {})", above.str(), below.str());
}

std::string coq(const spec::Decimal& decimal) { return coq(value_of(decimal)); }

std::optional<Rational> fraction_of(const spec::NumberText& number) {
  if (number.q.empty()) return std::nullopt;
  return Rational(number.q);
}

// -12.5, or 5e-16.
std::string coq_decimal(std::string_view text) {
  const std::size_t e = text.find('e');
  if (e == std::string_view::npos) return fmt::format("({})", text);
  return fmt::format("({} / 10 ^ {})", text.substr(0, e), text.substr(e + 2));
}

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

std::optional<std::map<std::uint64_t, spec::Block>> blocks_of(const spec::Case& c) {
  if (!c.setup.bit(3401, 0, true)) return std::nullopt;  // numbers without a point are increments
  spec::ProgramReader reader(spec::text_source(c.program), c.setup.axes);
  std::map<std::uint64_t, spec::Block> blocks;
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

std::string identifier(std::string_view id) {
  std::string name(id);
  std::ranges::replace_if(name, [](char c) { return c == '.' || c == '-'; }, '_');
  return name;
}

}  // namespace toolcomp::corpus

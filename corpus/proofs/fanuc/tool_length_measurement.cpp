// Lemmas about measurements: where the motion ends, and the value that is written.
#include <fmt/format.h>

#include <algorithm>

#include "corpus/proofs/fanuc/program.h"
#include "corpus/proofs/proofs.h"

namespace toolcomp::corpus {
namespace {

// Nothing that shifts coordinates or changes offsets besides G37 itself.
bool is_covered(const spec::Block& block) {
  return std::ranges::all_of(block.words(), [](const spec::Word& w) {
    const Rational code = value_of(w.value);
    if (w.address == 'M') return code == 30;
    return w.address != 'G' || code == 0 || code == 1 || code == 37 || code == 90 || code == 91;
  });
}

std::optional<Rational> parameter(const spec::Setup& setup, std::uint32_t number) {
  const auto found = setup.parameters.find({number, -1});
  if (found == setup.parameters.end()) return std::nullopt;
  return value_of(found->second);
}

// What stood in the memory that the setting names ("H1", "H1.wear").
Rational before(const spec::Setup& setup, std::string_view name, std::uint64_t number) {
  const auto found = setup.h.find(static_cast<std::uint32_t>(number));
  if (name.ends_with(".wear")) return found == setup.h.end() ? Rational(0) : value_of(found->second.wear);
  return offset_of(setup, 'H', number);
}

}  // namespace

std::vector<Lemma> length_measurement_lemmas(const spec::Case& c) {
  std::vector<Lemma> lemmas;
  const auto blocks = blocks_of(c);
  const auto distance = parameter(c.setup, 6251);
  const auto range = parameter(c.setup, 6254);
  if (!blocks || !distance || !range) return lemmas;
  for (const auto& [line, block] : *blocks)
    if (!is_covered(block)) return lemmas;
  // The first measurement only: what it writes would be needed for the next.
  const auto measuring = [&](const spec::TextEvent& e) {
    const auto block = blocks->find(e.line);
    return block != blocks->end() && has(block->second, "G37");
  };
  std::size_t first = 0;
  while (first < c.expect.size() && !measuring(c.expect[first])) ++first;
  if (first == c.expect.size() || c.expect[first].kind != spec::EventKind::move) return lemmas;
  std::size_t last = first;
  while (last + 1 < c.expect.size() && measuring(c.expect[last + 1])) ++last;
  const spec::TextEvent& end = c.expect[last];
  const spec::TextEvent& move = c.expect[last - 1];
  if (last == first || move.kind != spec::EventKind::move) return lemmas;
  const spec::Block& block = blocks->at(end.line);
  for (const char letter : {'X', 'Y', 'Z'}) {
    const auto commanded = word(block, letter);
    if (!commanded) continue;
    const std::size_t axis = c.setup.axes.index(letter);
    const auto start_given = c.setup.position.find(letter);
    std::optional<Rational> start = first > 0 ? fraction_of(c.expect[first - 1].programmed[axis])
                                    : start_given == c.setup.position.end()
                                        ? std::optional<Rational>(0)
                                        : std::optional<Rational>(value_of(start_given->second));
    const auto touch = c.setup.measurement.find(letter);
    const auto reached = fraction_of(move.point[axis]);
    if (!start || !reached || touch == c.setup.measurement.end()) return lemmas;
    const Rational d = value_of(*commanded);
    const std::string run = fmt::format("ToolLengthMeasurement.measure {} {} {} {} {}", coq(*distance), coq(*range),
                                        coq(*start), coq(d), coq(touch->second));
    const bool failed = end.kind == spec::EventKind::alarm;
    if (failed ? end.number != spec::Name("PS0080") : end.kind != spec::EventKind::setting) return lemmas;
    Lemma lemma;
    lemma.name = identifier(c.id);
    lemma.text = fmt::format("Lemma {} :\n  {} =\n  ToolLengthMeasurement.{} {}", lemma.name, run,
                             failed ? "Failed" : "Measured", coq(*reached));
    if (failed) {
      lemma.text += ".\nProof. by_measuring. Qed.\n";
    } else {
      const auto value = fraction_of(end.value);
      if (!value) return lemmas;
      const std::string_view name = end.setting.view();
      const std::uint64_t number = std::stoull(std::string(name.substr(1)));
      lemma.text += fmt::format(
          " /\\\n  ToolLengthMeasurement.measured {} {} {} = {}.\nProof. split; [by_measuring | by_adding]. Qed.\n",
          coq(before(c.setup, name, number)), coq(*reached), coq(d), coq(*value));
    }
    lemmas.push_back(std::move(lemma));
  }
  return lemmas;
}

}  // namespace toolcomp::corpus

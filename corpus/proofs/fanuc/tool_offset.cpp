// Lemmas about single blocks of tool offset: what G45 to G48 make of a travel on one axis.
#include <fmt/format.h>

#include <algorithm>

#include "corpus/proofs/fanuc/program.h"
#include "corpus/proofs/proofs.h"

namespace toolcomp::corpus {
namespace {

// The words the formal file knows, in a program without length offset and cutter compensation.
bool is_covered(const spec::Block& block) {
  return std::ranges::all_of(block.words(), [](const spec::Word& w) {
    if (w.address == 'X' || w.address == 'Y' || w.address == 'Z' || w.address == 'D' || w.address == 'F') return true;
    if (w.address != 'G') return false;
    const Rational g = value_of(w.value);
    return g == 0 || g == 1 || g == 17 || g == 90 || g == 91 || (g >= 45 && g <= 48);
  });
}

// G45 to G48 of the block, or 0 (none, or more than one).
int code_of(const spec::Block& block) {
  int code = 0;
  for (int g = 45; g <= 48; ++g)
    if (has(block, fmt::format("G{}", g))) code = code == 0 ? g : -1;
  return code;
}

}  // namespace

std::vector<Lemma> tool_offset_lemmas(const spec::Case& c) {
  std::vector<Lemma> lemmas;
  const auto blocks = blocks_of(c);
  // The number from H (OFH, TPH) and values that change are beyond this.
  if (!blocks || c.setup.bit(5001, 2) || c.setup.bit(5001, 5)) return lemmas;
  for (const auto& [line, block] : *blocks)
    if (!is_covered(block) || code_of(block) < 0) return lemmas;
  bool incremental = false;
  std::uint64_t number = 0;
  std::size_t event = 0;
  for (const auto& [line, block] : *blocks) {
    if (has(block, "G90")) incremental = false;
    if (has(block, "G91")) incremental = true;
    if (const auto d = word(block, 'D')) number = d->digits;
    if (event >= c.expect.size() || c.expect[event].line != line || c.expect[event].kind != spec::EventKind::move)
      continue;
    const spec::TextEvent& now = c.expect[event];
    const spec::TextEvent* before = event == 0 ? nullptr : &c.expect[event - 1];
    ++event;
    const int code = code_of(block);
    if (code == 0 || before == nullptr) continue;
    for (const char letter : {'X', 'Y', 'Z'}) {
      const auto w = word(block, letter);
      if (!w) continue;
      const std::size_t axis = c.setup.axes.index(letter);
      const auto p = fraction_of(before->programmed[axis]);
      const auto a = fraction_of(before->point[axis]);
      const auto q = fraction_of(now.programmed[axis]);
      const auto b = fraction_of(now.point[axis]);
      if (!p || !a || !q || !b) continue;
      const std::string travel = !incremental                  ? "Absolute " + coq(*w)
                                 : w->negative && w->is_zero() ? "MinusZero"
                                                               : "Incremental " + coq(*w);
      Lemma lemma;
      lemma.name = fmt::format("{}_line_{}_{}", identifier(c.id), line, letter);
      lemma.text = fmt::format(
          "Lemma {} :\n  ToolOffset.step (ToolOffset.State {} {})\n    (ToolOffset.Offset ToolOffset.G{} {} "
          "(ToolOffset.{})) =\n  ToolOffset.State {} {}.\nProof. by_offset_step. Qed.\n",
          lemma.name, coq(*p), coq(*a), code, coq(offset_of(c.setup, 'D', number)), travel, coq(*q), coq(*b));
      lemmas.push_back(std::move(lemma));
    }
  }
  return lemmas;
}

}  // namespace toolcomp::corpus

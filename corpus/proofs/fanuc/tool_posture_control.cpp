// Lemmas about the direction half way through a block with P1.
#include <fmt/format.h>

#include "corpus/proofs/fanuc/pose.h"
#include "corpus/proofs/proofs.h"

namespace toolcomp::corpus {
namespace {

// The recorded direction of the sample in the middle of a block between two directions.
struct Middle {
  std::uint64_t line = 0;
  Exact3 from, to, tool;
};

bool has_posture_control(const spec::Case& c, const Blocks& blocks) {
  bool on = false;
  for (const auto& [line, block] : blocks) {
    if (!has(block, "G43.5")) continue;
    on = word(block, 'P') ? has(block, "P1") : c.setup.bit(19604, 0);
    if (!on) return false;
  }
  return on;
}

// The directions at both ends are those of I J K in this block and in the move before it.
std::optional<Middle> middle_at(const spec::Case& c, const Blocks& blocks, std::size_t sample, std::uint64_t before) {
  const spec::TextEvent& event = c.expect[sample];
  const auto from = commanded_direction(c, blocks, before);
  const auto to = commanded_direction(c, blocks, event.line);
  if (!from || !to || !event.tool_axis || cross(*from, *to) == Exact3{}) return std::nullopt;
  return Middle{event.line, *from, *to, decimal_of(*event.tool_axis)};
}

Lemma in_plane(const spec::Case& c, const Middle& middle) {
  const Exact3 normal = cross(middle.from, middle.to);
  const Rational size = abs(normal[0]) + abs(normal[1]) + abs(normal[2]);
  Lemma lemma;
  lemma.name = fmt::format("{}_line_{}", identifier(c.id), middle.line);
  lemma.text = fmt::format("Lemma {} : within ({} / 10 ^ 15) (dot (cross {} {}) {}) 0.\nProof. by_decimals. Qed.\n",
                           lemma.name, coq(size), coq(middle.from), coq(middle.to), coq(middle.tool));
  return lemma;
}

Lemma half_way(const spec::Case& c, const Middle& middle) {
  Lemma lemma;
  lemma.name = fmt::format("{}_line_{}_half_way", identifier(c.id), middle.line);
  lemma.by_intervals = true;
  lemma.text = fmt::format(
      "Lemma {} : within_vec (1 / 10 ^ 15)\n  (ToolPostureControl.great_circle (unit {}) (unit {}) (1/2)) {}.\n"
      "Proof. by_half_way. Qed.\n",
      lemma.name, coq(middle.from), coq(middle.to), coq(middle.tool));
  return lemma;
}

}  // namespace

// Blocks with P1 that are divided into an even number of parts, between directions by I J K.
std::vector<Lemma> tool_posture_lemmas(const spec::Case& c) {
  std::vector<Lemma> lemmas;
  const auto blocks = blocks_of(c);
  if (!blocks || !has_posture_control(c, *blocks)) return lemmas;
  std::uint64_t before = 0;  // line of the move before
  for (std::size_t i = 0; i < c.expect.size(); ++i) {
    const spec::TextEvent& event = c.expect[i];
    if (event.kind == spec::EventKind::move && event.cause != spec::Cause::pre_turn) before = event.line;
    if (event.kind != spec::EventKind::sample || event.t_numerator * 2 != event.t_denominator) continue;
    const auto middle = middle_at(c, *blocks, i, before);
    if (!middle) continue;
    lemmas.push_back(in_plane(c, *middle));
    lemmas.push_back(half_way(c, *middle));
  }
  return lemmas;
}

}  // namespace toolcomp::corpus

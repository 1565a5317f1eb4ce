// Lemmas about corners of two lines in cutter compensation C.
#include <fmt/format.h>

#include <array>

#include "corpus/proofs/fanuc/corner.h"
#include "corpus/proofs/fanuc/tool.h"
#include "corpus/proofs/proofs.h"

namespace toolcomp::corpus {
namespace {

using Exact2 = std::array<Rational, 2>;

Rational dot_in_plane(const Exact2& a, const Exact2& b) { return a[0] * b[0] + a[1] * b[1]; }
Rational turn(const Exact2& a, const Exact2& b) { return a[0] * b[1] - a[1] * b[0]; }
Exact2 difference_in_plane(const Exact2& to, const Exact2& from) { return {to[0] - from[0], to[1] - from[1]}; }
std::string coq_in_plane(const Exact2& v) { return fmt::format("(Vec {} {} 0)", coq(v[0]), coq(v[1])); }

// The corner at the end of one line: its travel, that of the next line, and the recorded heads in between.
struct Corner {
  std::uint64_t line = 0;
  Exact2 place, former, latter;
  Rational rho;
  std::vector<const spec::TextEvent*> heads;
};

// The corner at the end of the event with this index, where both blocks are lines of the offset mode and the group at
// the corner is whole.
std::optional<Corner> corner_at(const spec::Case& c, const Blocks& blocks, std::size_t index) {
  const spec::TextEvent& event = c.expect[index];
  const bool classed = rests_on(event, "fanuc.cutter-c.inner-lines") ||
                       rests_on(event, "fanuc.cutter-c.outer-obtuse") || rests_on(event, "fanuc.cutter-c.outer-acute");
  if (index == 0 || !classed || event.cause != spec::Cause::programmed) return std::nullopt;
  const auto from = programmed_point<2>(c, c.expect[index - 1]);
  const auto here = programmed_point<2>(c, event);
  if (!from || !here) return std::nullopt;
  Corner corner;
  corner.line = event.line;
  corner.place = *here;
  corner.heads.push_back(&event);
  std::size_t next = index + 1;
  for (; next < c.expect.size() && c.expect[next].cause == spec::Cause::corner; ++next)
    corner.heads.push_back(&c.expect[next]);
  if (next == c.expect.size() || c.expect[next].cause != spec::Cause::programmed) return std::nullopt;
  const auto there = programmed_point<2>(c, c.expect[next]);
  const auto modal_at_line = [&](std::uint64_t line) { return modal_at(c, blocks, line, {"G41"}, {"G42"}); };
  const Modal modal = modal_at_line(event.line);
  if (!there || !modal.straight || !modal_at_line(c.expect[next].line).straight) return std::nullopt;
  corner.former = difference_in_plane(*here, *from);
  corner.latter = difference_in_plane(*there, *here);
  corner.rho = modal.side * modal.value;
  if (corner.rho == 0 || corner.former == Exact2{} || corner.latter == Exact2{}) return std::nullopt;
  return corner;
}

std::optional<Lemma> lemma_of(const spec::Case& c, const Corner& corner) {
  const bool acute =
      corner.rho * turn(corner.former, corner.latter) <= 0 && dot_in_plane(corner.former, corner.latter) < 0;
  if (corner.heads.size() != (acute ? 2U : 1U)) return std::nullopt;
  const std::string a = coq_in_plane(corner.former);
  const std::string b = coq_in_plane(corner.latter);
  const auto first = square_root(dot_in_plane(corner.former, corner.former));
  const auto second = square_root(dot_in_plane(corner.latter, corner.latter));
  const std::string rho = coq(corner.rho);
  Lemma lemma;
  lemma.name = fmt::format("{}_line_{}", identifier(c.id), corner.line);
  lemma.by_intervals = !first || !second;
  std::string says;
  for (std::size_t i = 0; i < corner.heads.size(); ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      const spec::NumberText& value = corner.heads[i]->point[c.setup.axes.index("XY"[j])];
      const auto exactly = fraction_of(value);
      const std::string is = fmt::format("{} + v{} {}", coq(corner.place[j]), "xy"[j], "vw"[i]);
      // Where the lengths are rational the heads are, and where they are not intervals have to do.
      if (exactly.has_value() == lemma.by_intervals) return std::nullopt;
      if (exactly)
        says += fmt::format(" /\\\n  {} = {}", is, coq(*exactly));
      else
        says += fmt::format(" /\\\n  recorded ({}) {} {}", is, coq_decimal(value.v), coq_decimal(value.r));
    }
  const std::string heads = acute ? fmt::format(
                                        "let v := CutterCompensationC.Q1 {0} (unit a) in\n"
                                        "  let w := CutterCompensationC.Q2 {0} (unit b) in",
                                        rho)
                                  : fmt::format("let v := CutterCompensationC.M {} (unit a) (unit b) in", rho);
  const std::string proof =
      lemma.by_intervals ? "head_by_intervals" : fmt::format("by_lengths {} {} {} {}", a, coq(*first), b, coq(*second));
  lemma.text = fmt::format(
      "Lemma {} :\n  let a := {} in\n  let b := {} in\n  {}\n  corner {} a b = [{}]{}.\n"
      "Proof. cbv zeta; split; [{} |]; repeat split; {}. Qed.\n",
      lemma.name, a, b, heads, rho, acute ? "v; w" : "v", says, acute ? "acute" : "meets", proof);
  return lemma;
}

}  // namespace

// XY plane, number by D, values that stay as the setup gives them.
std::vector<Lemma> cutter_compensation_c_lemmas(const spec::Case& c) {
  std::vector<Lemma> lemmas;
  const auto blocks = blocks_of(c);
  if (!blocks || c.setup.bit(5001, 2) || is_beyond_corners(*blocks, {"G18", "G19", "G39"})) return lemmas;
  for (std::size_t i = 0; i < c.expect.size(); ++i) {
    const auto corner = corner_at(c, *blocks, i);
    if (!corner) continue;
    if (auto lemma = lemma_of(c, *corner)) lemmas.push_back(std::move(*lemma));
  }
  return lemmas;
}

}  // namespace toolcomp::corpus

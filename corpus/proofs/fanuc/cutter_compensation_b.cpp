// Lemmas about the vectors of cutter compensation B at the ends of straight blocks.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "corpus/proofs/fanuc/program.h"
#include "corpus/proofs/proofs.h"

namespace toolcomp::corpus {
namespace {

// The codes the formal file knows; only the plane of G17 is translated.
bool is_covered(const spec::Block& block) {
  constexpr std::array kKnown{0, 1, 2, 3, 17, 39, 40, 41, 42, 90, 91};
  return std::ranges::all_of(block.words(), [&](const spec::Word& w) {
    return w.address != 'G' || std::ranges::any_of(kKnown, [&](int known) { return value_of(w.value) == known; });
  });
}

// The root of a square of a fraction, or nothing.
std::optional<Rational> root(const Rational& square) {
  const exact::Integer above = sqrt(exact::Integer(numerator(square)));
  const exact::Integer below = sqrt(exact::Integer(denominator(square)));
  if (above * above != numerator(square) || below * below != denominator(square)) return std::nullopt;
  return Rational(above, below);
}

// The offset in force: its side (G40, G41, G42) and where its number stands.
struct Offset {
  int side = 40;
  char letter = 'D';
  std::uint64_t number = 0;

  void follow(const spec::Block& block, const spec::Setup& setup) {
    for (const int code : {40, 41, 42})
      if (has(block, fmt::format("G{}", code))) side = code;
    for (const char address : {'H', 'D'})
      if (const auto value = word(block, address); value && (address == 'D' || setup.bit(5001, 2))) {
        letter = address;
        number = value->digits;
      }
  }
};

// The point is `at` and the offset across u: exactly where u has a rational length; nothing where the vector says
// otherwise.
std::optional<Lemma> lemma(const spec::Case& c, const spec::TextEvent& move, const std::array<Rational, 2>& at,
                           const std::array<Rational, 2>& u, const Offset& offset) {
  const auto length = root(u[0] * u[0] + u[1] * u[1]);
  std::string statement;
  for (std::size_t k = 0; k < 2; ++k) {
    const spec::NumberText& point = move.point[c.setup.axes.index("XY"[k])];
    const std::string value = fmt::format("{} + v{} v", coq(at.at(k)), "xy"[k]);
    const auto exactly = fraction_of(point);
    if (static_cast<bool>(exactly) != static_cast<bool>(length)) return std::nullopt;
    statement += k == 0 ? "\n  " : " /\\\n  ";
    statement += exactly ? fmt::format("{} = {}", value, coq(*exactly))
                         : fmt::format("recorded ({}) {} {}", value, coq_decimal(point.v), coq_decimal(point.r));
  }
  Lemma lemma;
  lemma.name = fmt::format("{}_line_{}", identifier(c.id), move.line);
  lemma.by_intervals = !length;
  lemma.text = fmt::format(
      "Lemma {} :\n  let v := CutterCompensationB.V (CutterCompensationB.side_offset CutterCompensationB.G{} {}) "
      "(Vec {} {} 0) in{}.\nProof. cbv zeta; split; {}. Qed.\n",
      lemma.name, offset.side, coq(offset_of(c.setup, offset.letter, offset.number)), coq(u[0]), coq(u[1]), statement,
      length ? "by_length " + coq(*length) : "by_root");
  return lemma;
}

}  // namespace

std::vector<Lemma> cutter_b_lemmas(const spec::Case& c) {
  std::vector<Lemma> lemmas;
  const auto blocks = blocks_of(c);
  const bool b = c.setup.cutter_compensation == spec::CutterCompensationType::b;
  // Numbers by H (OFH) count like those by D where the block has one of them; edited values (EVR) do not occur.
  if (!blocks || !b || !c.setup.axes.has('X') || !c.setup.axes.has('Y')) return lemmas;
  for (const auto& [line, block] : *blocks)
    if (!is_covered(block)) return lemmas;
  const std::size_t x = c.setup.axes.index('X');
  const std::size_t y = c.setup.axes.index('Y');
  Offset offset;
  std::array<Rational, 2> at{0, 0};
  for (std::size_t i = 0; i < 2; ++i)
    if (const auto start = c.setup.position.find("XY"[i]); start != c.setup.position.end())
      at[i] = value_of(start->second);
  std::size_t event = 0;
  for (const auto& [line, block] : *blocks) {
    offset.follow(block, c.setup);
    for (; event < c.expect.size() && c.expect[event].line == line; ++event) {
      const spec::TextEvent& now = c.expect[event];
      if (now.kind != spec::EventKind::move) return lemmas;
      const std::array<std::optional<Rational>, 2> end{fraction_of(now.programmed[x]), fraction_of(now.programmed[y])};
      if (!end[0] || !end[1]) return lemmas;
      std::array<Rational, 2> u{*end[0] - at[0], *end[1] - at[1]};
      at = {*end[0], *end[1]};
      const bool straight = !now.arc && !has(block, "G39") &&
                            (now.cause == spec::Cause::programmed || now.cause == spec::Cause::start_up);
      if (offset.side == 40 || !straight || (u[0] == 0 && u[1] == 0)) continue;
      const auto i = word(block, 'I');
      const auto j = word(block, 'J');
      if (i || j) {
        u = {i ? value_of(*i) : Rational(0), j ? value_of(*j) : Rational(0)};
        if (u[0] == 0 && u[1] == 0) continue;
      }
      if (auto found = lemma(c, now, at, u, offset)) lemmas.push_back(*std::move(found));
    }
  }
  return lemmas;
}

}  // namespace toolcomp::corpus

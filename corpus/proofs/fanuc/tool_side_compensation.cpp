// Lemmas about corners of two lines in tool side compensation.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "corpus/proofs/fanuc/corner.h"
#include "corpus/proofs/fanuc/tool.h"
#include "corpus/proofs/proofs.h"

namespace toolcomp::corpus {
namespace {

enum class Class : std::uint8_t { inner, obtuse, acute };

// The corner at the end of one line: its displacement and that of the next line, the tool there, and the recorded
// heads.
struct Corner {
  std::uint64_t line = 0;
  Exact3 place, former, latter;
  Tool tool;
  Rational radius;
  int side = 1;
  std::vector<const spec::TextEvent*> heads;
};

// The corner at the end of the event with this index, where both blocks are lines of the mode and the group at the
// corner is whole.
std::optional<Corner> corner_at(const spec::Case& c, const Blocks& blocks, std::size_t index) {
  const spec::TextEvent& event = c.expect[index];
  const auto rests = [&](const char* rule) { return rests_on(event, std::string("fanuc.tool-side.") + rule); };
  const bool classed = rests("inner") || rests("outer-obtuse") || rests("outer-acute");
  if (index == 0 || !classed || event.cause != spec::Cause::programmed || event.arc) return std::nullopt;
  Corner corner;
  corner.line = event.line;
  corner.heads.push_back(&event);
  const auto from = programmed_point<3>(c, c.expect[index - 1]);
  const auto here = programmed_point<3>(c, event);
  // Up to the next block that travels: corner moves, and the move of a block that only turns the tool.
  std::size_t next = index + 1;
  for (; next < c.expect.size(); ++next) {
    if (c.expect[next].cause == spec::Cause::corner)
      corner.heads.push_back(&c.expect[next]);
    else if (programmed_point<3>(c, c.expect[next]) != here)
      break;
  }
  if (next == c.expect.size() || c.expect[next].cause != spec::Cause::programmed) return std::nullopt;
  const auto there = programmed_point<3>(c, c.expect[next]);
  auto tool = tool_of(c, blocks, event);
  const auto modal_at_line = [&](std::uint64_t line) {
    return modal_at(c, blocks, line, {"G41.2", "G41.6"}, {"G42.2", "G42.6"});
  };
  const Modal modal = modal_at_line(event.line);
  const Modal after = modal_at_line(c.expect[next].line);
  if (!from || !here || !there || !tool || !modal.straight || !after.straight) return std::nullopt;
  corner.place = *here;
  corner.former = difference(*here, *from);
  corner.latter = difference(*there, *here);
  corner.tool = *std::move(tool);
  corner.side = modal.value < 0 ? -modal.side : modal.side;
  corner.radius = abs(modal.value);
  if (corner.radius == 0 || corner.side == 0) return std::nullopt;
  return corner;
}

// The class by signs: exactly, or nothing where it is too near another one for doubles.
std::optional<Class> class_of(const Corner& corner) {
  if (corner.tool.exactly) {
    const Exact3 a = cross(*corner.tool.exactly, corner.former);
    const Exact3 b = cross(*corner.tool.exactly, corner.latter);
    if (a == Exact3{} || b == Exact3{}) return std::nullopt;
    if (corner.side * dot(*corner.tool.exactly, cross(corner.former, corner.latter)) > 0) return Class::inner;
    return dot(a, b) >= 0 ? Class::obtuse : Class::acute;
  }
  const Vector3 former = approximate(corner.former);
  const Vector3 latter = approximate(corner.latter);
  const Vector3 a = cross(corner.tool.about, former);
  const Vector3 b = cross(corner.tool.about, latter);
  const double scale = std::sqrt(dot(former, former) * dot(latter, latter));
  const double near = 1e-9 * scale;
  if (dot(a, a) <= near || dot(b, b) <= near) return std::nullopt;
  const double turn = corner.side * dot(corner.tool.about, cross(former, latter));
  if (turn > near) return Class::inner;
  if (dot(a, b) > near) return Class::obtuse;
  if (turn < -near && dot(a, b) < -near) return Class::acute;
  return std::nullopt;
}

// How the heads are computed where the lengths are rational, for Golden.v: |VT x U1|, |VT x U2|, and of two heads |VT|,
// by whose products nothing is left to divide.
std::optional<std::string> computation(const Corner& corner, Class found) {
  if (!corner.tool.exactly) return std::nullopt;
  const Exact3& tool = *corner.tool.exactly;
  const Exact3 a = cross(tool, corner.former);
  const Exact3 b = cross(tool, corner.latter);
  const auto m = square_root(dot(a, a));
  const auto k = square_root(dot(b, b));
  if (!m || !k) return std::nullopt;
  const auto text = [](const Rational& value) { return corpus::coq(value); };
  if (found != Class::acute) {
    const Rational sum = *m * *k + dot(a, b);
    return fmt::format("side_meets {} {} {}", text(*m), text(*k), text(corner.radius / sum));
  }
  const auto l = square_root(dot(tool, tool));
  if (!l) return std::nullopt;
  return fmt::format("side_passes {} {} {} {} {}", text(*m), text(*k), text(*l), text(1 / (*m * *l)),
                     text(1 / (*k * *l)));
}

std::optional<Lemma> lemma_of(const spec::Case& c, const Corner& corner) {
  const auto found = class_of(corner);
  if (!found || corner.heads.size() != (found == Class::acute ? 2U : 1U)) return std::nullopt;
  const auto computed = computation(corner, *found);
  const std::string offset = fmt::format("{} ({})", corpus::coq(corner.radius), corner.side);
  Lemma lemma;
  lemma.name = fmt::format("{}_line_{}", identifier(c.id), corner.line);
  lemma.by_intervals = !computed;
  std::string says;
  for (std::size_t i = 0; i < corner.heads.size(); ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const spec::NumberText& value = corner.heads[i]->point[c.setup.axes.index("XYZ"[j])];
      const auto exactly = fraction_of(value);
      const std::string is = fmt::format("{} + v{} {}", corpus::coq(corner.place[j]), "xyz"[j], "vw"[i]);
      if (computed && !exactly) return std::nullopt;  // rational lengths have rational heads
      // An exact value beside roots is proved to 18 decimals.
      if (computed)
        says += fmt::format(" /\\\n  {} = {}", is, corpus::coq(*exactly));
      else if (exactly)
        says += fmt::format(" /\\\n  recorded ({}) {} (1 / 10 ^ 18)", is, corpus::coq(*exactly));
      else
        says += fmt::format(" /\\\n  recorded ({}) {} {}", is, coq_decimal(value.v), coq_decimal(value.r));
    }
  const char* vectors = found == Class::acute ? "let v := ToolSideCompensation.K1 {0} VT a in\n"
                                                "  let w := ToolSideCompensation.K2 {0} VT b in"
                                              : "let v := ToolSideCompensation.Vi {0} VT a b in";
  const char* by_class = found == Class::inner ? "side_inner" : found == Class::obtuse ? "side_obtuse" : "side_acute";
  lemma.text = fmt::format(
      "Lemma {} :\n  let VT := {} in\n  let a := {} in\n  let b := {} in\n  {}\n"
      "  ToolSideCompensation.group {} VT a b = [{}]{}.\n"
      "Proof. {}; split; [{} |]; {}. Qed.\n",
      lemma.name, corner.tool.text, corpus::coq(corner.former), corpus::coq(corner.latter),
      fmt::format(fmt::runtime(vectors), offset), offset, found == Class::acute ? "v; w" : "v", says,
      corner.tool.exactly ? "cbv zeta" : "side_tool", by_class, computed.value_or("side_by_intervals"));
  return lemma;
}

}  // namespace

// Number by D, values that stay as the setup gives them, no limit of movement.
std::vector<Lemma> tool_side_lemmas(const spec::Case& c) {
  std::vector<Lemma> lemmas;
  const auto blocks = blocks_of(c);
  const auto limit = c.setup.parameter(19630);
  if (!blocks || c.setup.bit(5001, 2) || (limit && value_of(*limit) > 0) || is_beyond_corners(*blocks)) return lemmas;
  for (std::size_t i = 0; i < c.expect.size(); ++i) {
    const auto corner = corner_at(c, *blocks, i);
    if (!corner) continue;
    if (auto lemma = lemma_of(c, *corner)) lemmas.push_back(std::move(*lemma));
  }
  return lemmas;
}

}  // namespace toolcomp::corpus

// Lemmas about compensation vectors of the leading edge offset.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "corpus/proofs/fanuc/tool.h"
#include "corpus/proofs/proofs.h"

namespace toolcomp::corpus {
namespace {

// The offset value in force at the end of an event's block.
std::optional<Rational> radius_of(const spec::Case& c, const Blocks& blocks, std::uint64_t line) {
  std::optional<Rational> radius;
  for (const auto& [number, block] : blocks) {
    if (number > line) break;
    if (const auto d = word(block, 'D')) radius = offset_of(c.setup, 'D', d->digits);
  }
  return radius;
}

// Whether the vector at the end of `event` is made, or kept, by the movement of `next`.
bool is_made_by(const spec::TextEvent& event, const spec::TextEvent& next) {
  const auto is_move = [](const spec::TextEvent& e) { return e.kind == spec::EventKind::move && !e.arc; };
  if (!is_move(event) || !is_move(next) || next.cause != spec::Cause::programmed) return false;
  for (const char* other : {"one-block-without-movement", "two-blocks-without-movement", "kept-without-look-ahead",
                            "kept-at-the-end", "before-cancel", "cancel"})
    if (rests_on(event, std::string("fanuc.leading-edge.") + other)) return false;
  return rests_on(event, "fanuc.leading-edge.sign");
}

enum class Class : std::uint8_t { along, against, square, exactly_square, forward, back };

// To double precision, or nothing where a boundary is too near for that.
std::optional<Class> classify(const Vector3& movement, const Tool& tool, double delta) {
  const double d = dot(movement, tool.about);
  const double lengths2 = dot(movement, movement) * dot(tool.about, tool.about);
  const double cosine2 = std::pow(std::cos(delta * std::acos(-1.0) / 180), 2);
  const double share = d * d / lengths2;
  constexpr double kNear = 1e-9;
  if (std::fabs(share - cosine2) < kNear) return std::nullopt;
  if (share > cosine2) return d > 0 ? Class::along : Class::against;
  if (d == 0 && tool.exactly) return Class::exactly_square;
  if (share < kNear || std::fabs(share - (1 - cosine2)) < kNear) return std::nullopt;
  if (share < 1 - cosine2) return Class::square;
  return d > 0 ? Class::forward : Class::back;
}

// Statement and proof of the class.
std::pair<std::string, std::string> class_lemma(Class found) {
  switch (found) {
    case Class::along:
      return {"along", "apply is_along; by_intervals"};
    case Class::against:
      return {"against", "apply is_against; by_intervals"};
    case Class::square:
      return {"square", "apply is_square_near; by_intervals"};
    case Class::exactly_square:
      return {"square", "apply is_square_exactly; expand; lra"};
    case Class::forward:
      return {"oblique /\\ sense VM VT = 1", "apply is_oblique_forward; by_intervals"};
    case Class::back:
      break;
  }
  return {"oblique /\\ sense VM VT = -1", "apply is_oblique_back; by_intervals"};
}

class Statement {
 public:
  Statement(const spec::Case& c, const spec::TextEvent& event, const spec::TextEvent& next)
      : case_(c), event_(event), next_(next) {}

  std::optional<Lemma> lemma(const Blocks& blocks) {
    const auto tool = tool_of(case_, blocks, event_);
    const auto radius = radius_of(case_, blocks, event_.line);
    const auto range = case_.setup.parameter(19631);
    if (!tool || !radius || !positions()) return std::nullopt;
    Rational delta = range ? value_of(*range) : Rational(1);
    if (delta < 0) delta = 0;
    const auto found = classify(approximate(movement_), *tool, delta.convert_to<double>());
    if (!found) return std::nullopt;

    const auto [name, proof] = class_lemma(*found);
    Lemma lemma;
    lemma.name = fmt::format("{}_line_{}", identifier(case_.id), event_.line);
    lemma.by_intervals = !tool->exactly;
    std::string statement = fmt::format("(classify (degrees {}) VM VT = {})", corpus::coq(delta), name);
    std::string proofs = fmt::format("split; [{} |]", proof);
    if (*found == Class::along || *found == Class::against) {
      statement += " /\\ True";
      proofs += "; exact I";
    } else {
      const int sense = *found == Class::forward ? 1 : *found == Class::back ? -1 : sense_of(*tool, *radius);
      const std::string root = root_of(*tool);
      lemma.by_intervals = lemma.by_intervals || root.empty();
      statement += fmt::format(" /\\\n  let v := VC ({}) {} VM VT in", sense, corpus::coq(*radius));
      std::string separator;
      std::string components;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [says, how] = component(i, root);
        statement += separator + says;
        separator = " /\\";
        components += i == 2 ? how : "split; [" + how + " | ";
      }
      proofs += "; " + components + "]]";
    }
    lemma.text = fmt::format(
        "Lemma {} :\n  let VM := Vec ({}) ({}) ({}) in\n  let VT := {} in\n  {}.\nProof. directions; {}. Qed.\n",
        lemma.name, difference(0), difference(1), difference(2), tool->text, statement, proofs);
    return lemma;
  }

 private:
  // The rational positions; false where there are none.
  bool positions() {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t axis = case_.setup.axes.index("XYZ"[i]);
      if (axis == spec::Axes::kNone || !event_.programmed.has(axis) || !next_.programmed.has(axis)) return false;
      const auto here = fraction_of(event_.programmed[axis]);
      const auto there = fraction_of(next_.programmed[axis]);
      if (!here || !there) return false;
      here_[i] = *here;
      there_[i] = *there;
      movement_[i] = *there - *here;
      point_[i] = event_.point[axis];
    }
    return movement_ != Exact3{};
  }

  [[nodiscard]] std::string difference(std::size_t i) const {
    return corpus::coq(there_[i]) + " - " + corpus::coq(here_[i]);
  }

  // Near 90 degrees the vector before decides the sense; here it is read off the recorded point.
  [[nodiscard]] int sense_of(const Tool& tool, const Rational& radius) const {
    double along = 0;
    const Vector3 movement = approximate(movement_);
    const double d = dot(movement, tool.about);
    const double length2 = dot(tool.about, tool.about);
    for (std::size_t i = 0; i < 3; ++i)
      along += (std::stod(point_[i].v) - here_[i].convert_to<double>()) * (d * tool.about[i] - length2 * movement[i]);
    return (along < 0) == (radius < 0) ? 1 : -1;
  }

  // |V|, where it is rational.
  [[nodiscard]] std::string root_of(const Tool& tool) const {
    if (!tool.exactly) return {};
    const Exact3 v = cross(cross(movement_, *tool.exactly), *tool.exactly);
    const auto root = square_root(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    return root ? corpus::coq(*root) : std::string();
  }

  // What is said of one coordinate, and how it is proved.
  [[nodiscard]] std::pair<std::string, std::string> component(std::size_t i, const std::string& root) const {
    const char letter = "xyz"[i];
    const std::string value = fmt::format("\n    {} + v{} v", corpus::coq(here_[i]), letter);
    const auto exactly = fraction_of(point_[i]);
    if (exactly && !root.empty())
      return {fmt::format("{} = {}", value, corpus::coq(*exactly)), fmt::format("by_computation {}", root)};
    if (exactly) return {fmt::format("{} = {}", value, corpus::coq(*exactly)), "by_zero"};
    return {fmt::format("\n    recorded ({} + v{} v) {} {}", corpus::coq(here_[i]), letter, coq_decimal(point_[i].v),
                        coq_decimal(point_[i].r)),
            "by_intervals"};
  }

  const spec::Case& case_;
  const spec::TextEvent& event_;
  const spec::TextEvent& next_;
  Exact3 here_, there_, movement_;
  std::array<spec::NumberText, 3> point_;
};

}  // namespace

std::vector<Lemma> leading_edge_lemmas(const spec::Case& c) {
  std::vector<Lemma> lemmas;
  const auto blocks = blocks_of(c);
  if (!blocks) return lemmas;
  for (const auto& [line, block] : *blocks)
    if (has(block, "G10") || has(block, "G52") || has(block, "G92")) return lemmas;
  for (std::size_t i = 0; i + 1 < c.expect.size(); ++i) {
    if (!is_made_by(c.expect[i], c.expect[i + 1])) continue;
    if (auto lemma = Statement(c, c.expect[i], c.expect[i + 1]).lemma(*blocks)) lemmas.push_back(std::move(*lemma));
  }
  return lemmas;
}

}  // namespace toolcomp::corpus

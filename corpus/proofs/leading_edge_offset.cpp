// Lemmas about compensation vectors of the leading edge offset.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "corpus/proofs/program.h"
#include "corpus/proofs/proofs.h"

namespace toolcomp::corpus {
namespace {

using Blocks = std::map<std::uint64_t, spec::Block>;
using Vector3 = std::array<double, 3>;
using Exact3 = std::array<Rational, 3>;

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Exact3 cross(const Exact3& a, const Exact3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector3 approximate(const Exact3& v) {
  return {v[0].convert_to<double>(), v[1].convert_to<double>(), v[2].convert_to<double>()};
}

// A tool direction as Coq reads it, to double precision, and exactly where it is rational.
struct Tool {
  std::string text;
  Vector3 about{};
  std::optional<Exact3> exactly;
};

std::string coq(const Exact3& v) {
  return fmt::format("(Vec {} {} {})", corpus::coq(v[0]), corpus::coq(v[1]), corpus::coq(v[2]));
}

Tool fixed(const Exact3& direction) { return {coq(direction), approximate(direction), direction}; }

Vector3 rotated(const Vector3& v, int axis, double degrees) {
  const double angle = degrees * std::acos(-1.0) / 180;
  const auto i = static_cast<std::size_t>(axis % 3);
  const auto j = static_cast<std::size_t>((axis + 1) % 3);  // axis 1 (X) turns Y, component 1, toward Z
  Vector3 turned = v;
  turned[i] = v[i] * std::cos(angle) - v[j] * std::sin(angle);
  turned[j] = v[i] * std::sin(angle) + v[j] * std::cos(angle);
  return turned;
}

// A parameter that is one of the numbers 1, 2, 3; 0 otherwise.
int code(const spec::Setup& setup, std::uint32_t number) {
  const auto value = setup.parameter(number);
  return value && value->is_integer() && !value->negative && value->digits <= 3 ? static_cast<int>(value->digits) : 0;
}

// The direction of a plain tool rotation head (19680 = 2, axes along X Y Z, no tilt, no reversed sense).
std::optional<Tool> of_head(const spec::Setup& setup, const spec::TextEvent& event) {
  constexpr std::array<std::uint32_t, 6> kUsed{19680, 19681, 19682, 19686, 19687, 19697};
  for (const auto& [id, value] : setup.parameters)
    if (id.number >= 19640 && id.number < 19720 && !value.is_zero() &&
        std::ranges::find(kUsed, id.number) == kUsed.end())
      return std::nullopt;
  if (code(setup, 19680) != 2) return std::nullopt;
  const int reference = setup.parameter(19697) ? code(setup, 19697) : 3;
  Tool tool;
  Exact3 start{};
  if (reference == 0) return std::nullopt;
  start[static_cast<std::size_t>(reference) - 1] = 1;
  tool.about = approximate(start);
  constexpr std::array<const char*, 4> kUnit{"", "ex", "ey", "ez"};
  std::array<std::string, 2> turns;
  // The second axis is carried by the first and turns the tool before it.
  constexpr std::array<std::uint32_t, 2> kFirst{19686, 19681};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto axis_number = setup.parameter(kFirst[i]);
    const int direction = code(setup, kFirst[i] + 1);
    if (!axis_number || !axis_number->is_integer() || axis_number->digits < 1 ||
        axis_number->digits > setup.axes.size() || direction == 0)
      return std::nullopt;
    const std::size_t axis = axis_number->digits - 1;
    if (!event.axes.has(axis)) return std::nullopt;
    const auto angle = fraction_of(event.axes[axis]);
    if (!angle) return std::nullopt;
    turns[i] = fmt::format("{} (degrees {})", kUnit.at(static_cast<std::size_t>(direction)), corpus::coq(*angle));
    tool.about = rotated(tool.about, direction, angle->convert_to<double>());
  }
  tool.text =
      fmt::format("(tool_direction {} {} {})", turns[0], turns[1], kUnit.at(static_cast<std::size_t>(reference)));
  return tool;
}

// The direction in force at the end of an event's block.
std::optional<Tool> tool_of(const spec::Case& c, const Blocks& blocks, const spec::TextEvent& event) {
  bool by_words = false;
  std::optional<Exact3> words;
  for (const auto& [line, block] : blocks) {
    if (line > event.line) break;
    if (has(block, "G49") && by_words) return std::nullopt;
    by_words = by_words || has(block, "G43.5");
    if (!by_words || (!word(block, 'I') && !word(block, 'J') && !word(block, 'K'))) continue;
    words.emplace();
    for (std::size_t i = 0; i < 3; ++i)
      if (const auto given = word(block, "IJK"[i])) (*words)[i] = value_of(*given);
  }
  if (words) return fixed(*words);
  if (!event.tool_axis) return fixed({0, 0, 1});
  if (by_words) return std::nullopt;
  return of_head(c.setup, event);
}

// The offset value in force at the end of an event's block.
std::optional<Rational> radius_of(const spec::Case& c, const Blocks& blocks, std::uint64_t line) {
  std::optional<Rational> radius;
  for (const auto& [number, block] : blocks) {
    if (number > line) break;
    if (const auto d = word(block, 'D')) radius = offset_of(c.setup, 'D', d->digits);
  }
  return radius;
}

bool rests_on(const spec::TextEvent& event, std::string_view clause) {
  const auto& list = event.clauses;
  return std::any_of(list.clause.begin(), list.clause.begin() + list.size,
                     [&](spec::Clause c) { return spec::info(c).id == clause; });
}

// Whether the vector at the end of `event` is made, or kept, by the movement of `next`.
bool is_made_by(const spec::TextEvent& event, const spec::TextEvent& next) {
  const auto is_move = [](const spec::TextEvent& e) { return e.kind == spec::EventKind::move && !e.arc; };
  if (!is_move(event) || !is_move(next) || next.cause != spec::Cause::programmed) return false;
  if (event.clauses.size >= spec::ClauseList::kCapacity) return false;  // some may not be listed
  for (const char* other : {"one-block-without-movement", "two-blocks-without-movement", "kept-without-look-ahead",
                            "kept-at-the-end", "before-cancel", "cancel"})
    if (rests_on(event, std::string("fanuc.leading-edge.") + other)) return false;
  return rests_on(event, "fanuc.leading-edge.sign");
}

std::optional<Rational> square_root(const Rational& value) {
  const exact::Integer above = sqrt(exact::Integer(numerator(value)));
  const exact::Integer below = sqrt(exact::Integer(denominator(value)));
  Rational root(above, below);
  if (root * root != value) return std::nullopt;
  return root;
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
    if (has(block, "G10") || has(block, "G92")) return lemmas;
  for (std::size_t i = 0; i + 1 < c.expect.size(); ++i) {
    if (!is_made_by(c.expect[i], c.expect[i + 1])) continue;
    if (auto lemma = Statement(c, c.expect[i], c.expect[i + 1]).lemma(*blocks)) lemmas.push_back(std::move(*lemma));
  }
  return lemmas;
}

}  // namespace toolcomp::corpus

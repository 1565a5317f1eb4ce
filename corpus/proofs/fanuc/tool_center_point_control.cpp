// Lemmas about directions by I J K: the recorded tool axis, rotary positions and control point.
#include <fmt/format.h>

#include "corpus/proofs/fanuc/pose.h"
#include "corpus/proofs/proofs.h"

namespace toolcomp::corpus {
namespace {

const char* const kDecimals = "(4 / 10 ^ 15)";

// The length in force at the end of a line: H, the holder offset.
Rational length_at(const spec::Case& c, const Blocks& blocks, std::uint64_t line) {
  Rational length;
  for (const auto& [number, block] : blocks) {
    if (number > line) break;
    if (const auto h = word(block, 'H')) length = offset_of(c.setup, 'H', h->digits);
  }
  const auto holder = c.setup.parameter(19666);
  return holder ? length + value_of(*holder) : length;
}

std::optional<std::pair<Exact3, Exact3>> points_of(const spec::Case& c, const spec::TextEvent& event) {
  std::pair<Exact3, Exact3> points;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t axis = c.setup.axes.index("XYZ"[i]);
    if (axis == spec::Axes::kNone || !event.point.has(axis)) return std::nullopt;
    points.first[i] = decimal_of(event.point[axis]);
    points.second[i] = decimal_of(event.axes[axis]);
  }
  return points;
}

Rational sum_of_magnitudes(const Exact3& v) { return abs(v[0]) + abs(v[1]) + abs(v[2]); }

// The recorded axis is along I J K; on a head the recorded control point is the length away along it.
std::optional<Lemma> of_decimals(const spec::Case& c, const Blocks& blocks, const spec::TextEvent& event,
                                 const Exact3& direction, const RotaryMachine& machine) {
  const auto points = points_of(c, event);
  if (!points) return std::nullopt;
  const Rational digit(1, exact::Integer("1000000000000000"));
  Lemma lemma;
  lemma.name = fmt::format("{}_line_{}", identifier(c.id), event.line);
  std::string says =
      fmt::format("axis_along {} {} v", coq(Rational(2 * digit * sum_of_magnitudes(direction))), coq(direction));
  if (machine.head) {
    const Rational length = length_at(c, blocks, event.line);
    const Rational error = digit * (2 + abs(length));
    says += fmt::format(" /\\\n  within_vec {} (ToolCenterPointControl.head_control_point {} {} v) {}", coq(error),
                        coq(points->first), coq(length), coq(points->second));
  }
  lemma.text = fmt::format("Lemma {} :\n  let v := {} in\n  {}.\nProof. by_decimals. Qed.\n", lemma.name,
                           coq(decimal_of(*event.tool_axis)), says);
  return lemma;
}

// The recorded rotary positions point along the recorded axis.
Lemma of_positions(const spec::Case& c, const spec::TextEvent& event, const RotaryMachine& machine) {
  Lemma lemma;
  lemma.name = fmt::format("{}_line_{}_positions", identifier(c.id), event.line);
  lemma.by_intervals = true;
  lemma.text = fmt::format(
      "Lemma {} : within_vec {} (ToolCenterPointControl.V {} {} ez (degrees {}) (degrees {}))\n  {}.\n"
      "Proof. by_forward. Qed.\n",
      lemma.name, kDecimals, machine.tool_line, machine.work_line,
      coq(Rational(machine.tool_sense * decimal_of(event.axes[machine.tool_axis]))),
      coq(Rational(machine.work_sense * decimal_of(event.axes[machine.work_axis]))), coq(decimal_of(*event.tool_axis)));
  return lemma;
}

}  // namespace

// Directions by I J K without a lean, on machines with axes along X, Y or Z.
std::vector<Lemma> tool_center_point_lemmas(const spec::Case& c) {
  std::vector<Lemma> lemmas;
  const auto blocks = blocks_of(c);
  const auto machine = rotary_machine(c.setup);
  if (!blocks || !machine) return lemmas;
  for (const auto& [line, block] : *blocks)
    if (has(block, "G10")) return lemmas;
  for (const spec::TextEvent& event : c.expect) {
    if (event.kind != spec::EventKind::move || !event.tool_axis || event.cause == spec::Cause::pre_turn) continue;
    const auto direction = commanded_direction(c, *blocks, event.line);
    if (!direction) continue;
    if (auto lemma = of_decimals(c, *blocks, event, *direction, *machine)) lemmas.push_back(*std::move(lemma));
    lemmas.push_back(of_positions(c, event, *machine));
    break;
  }
  return lemmas;
}

}  // namespace toolcomp::corpus

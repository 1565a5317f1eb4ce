#include "corpus/proofs/fanuc/tool.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace toolcomp::corpus {
namespace {

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
  bool square = true;  // turns by right angles only
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
    square = square && denominator(Rational(*angle / 90)) == 1;
  }
  if (square) return fixed({std::round(tool.about[0]), std::round(tool.about[1]), std::round(tool.about[2])});
  tool.text =
      fmt::format("(tool_direction {} {} {})", turns[0], turns[1], kUnit.at(static_cast<std::size_t>(reference)));
  return tool;
}

}  // namespace

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector3 approximate(const Exact3& v) {
  return {v[0].convert_to<double>(), v[1].convert_to<double>(), v[2].convert_to<double>()};
}

bool has_rotary_zeros(const spec::Case& c, const Blocks& blocks) {
  if (c.setup.rotary_angles != spec::RotaryAngles::machine) return false;
  const auto turns = [](const spec::AxisTable& origin) {
    return std::ranges::any_of(
        origin, [](const auto& zero) { return spec::is_rotary_axis(zero.first) && !zero.second.is_zero(); });
  };
  if (std::ranges::any_of(c.setup.workpiece, turns)) return true;
  if (std::ranges::any_of(c.setup.additional_workpiece, [&](const auto& entry) { return turns(entry.second); }))
    return true;
  return std::ranges::any_of(blocks, [](const auto& numbered) {
    return has(numbered.second, "G92") || has(numbered.second, "G52") || has(numbered.second, "G10");
  });
}

std::optional<Tool> tool_of(const spec::Case& c, const Blocks& blocks, const spec::TextEvent& event) {
  bool by_words = false;
  std::optional<Exact3> words;
  for (const auto& [line, block] : blocks) {
    if (line > event.line) break;
    if (has(block, "G49") && by_words) return std::nullopt;
    if (has(block, "G43.5") && word(block, 'Q')) return std::nullopt;  // leaned
    by_words = by_words || has(block, "G43.5");
    if (!by_words || (!word(block, 'I') && !word(block, 'J') && !word(block, 'K'))) continue;
    words.emplace();
    for (std::size_t i = 0; i < 3; ++i)
      if (const auto given = word(block, "IJK"[i])) (*words)[i] = value_of(*given);
  }
  if (words) return fixed(*words);
  if (!event.tool_axis) return fixed({0, 0, 1});
  if (by_words || has_rotary_zeros(c, blocks)) return std::nullopt;
  return of_head(c.setup, event);
}

bool rests_on(const spec::TextEvent& event, std::string_view clause) {
  return std::ranges::any_of(event.clauses, [&](spec::Clause c) { return spec::info(c).id == clause; });
}

}  // namespace toolcomp::corpus

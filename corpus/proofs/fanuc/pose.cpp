#include "corpus/proofs/fanuc/pose.h"

#include <algorithm>

namespace toolcomp::corpus {
namespace {

// A parameter that is a small whole number; 0 where it is not given.
int whole(const spec::Setup& setup, std::uint32_t number) {
  const auto value = setup.parameter(number);
  if (!value || value->negative || !value->is_integer() || value->digits > 99)
    return value && !value->is_zero() ? -1 : 0;
  return static_cast<int>(value->digits);
}

bool turns_nothing_before(const spec::Case& c, const RotaryMachine& machine, std::uint64_t line) {
  if (machine.head) return true;
  return std::ranges::any_of(c.expect, [&](const spec::TextEvent& event) {
    const auto zero = [&](std::size_t axis) {
      const auto value = fraction_of(event.axes[axis]);
      return value && *value == 0;
    };
    return event.kind == spec::EventKind::move && event.line == line && zero(machine.tool_axis) &&
           zero(machine.work_axis);
  });
}

}  // namespace

std::optional<RotaryMachine> rotary_machine(const spec::Setup& setup) {
  constexpr std::array<std::uint32_t, 12> kUsed{19680, 19681, 19682, 19684, 19686, 19687,
                                                19689, 19697, 19700, 19701, 19702, 19666};
  for (const auto& [id, value] : setup.parameters)
    if (id.number >= 19640 && id.number < 19720 && !value.is_zero() &&
        std::ranges::find(kUsed, id.number) == kUsed.end())
      return std::nullopt;
  const int type = whole(setup, 19680);
  const int reference = whole(setup, 19697);
  if ((type != 2 && type != 12 && type != 21) || (reference != 0 && reference != 3)) return std::nullopt;
  constexpr std::array<const char*, 4> kLine{"", "ex", "ey", "ez"};
  const std::uint32_t tool = type == 2 ? 19686 : 19681;
  const std::uint32_t work = type == 2 ? 19681 : 19686;
  const auto is_line = [&](std::uint32_t first) {
    const int axis = whole(setup, first);
    const int line = whole(setup, first + 1);
    return axis >= 1 && axis <= static_cast<int>(setup.axes.size()) && line >= 1 && line <= 3 &&
           whole(setup, first + 3) >= 0 && whole(setup, first + 3) <= 1;
  };
  if (!is_line(tool) || !is_line(work)) return std::nullopt;
  RotaryMachine machine;
  machine.head = type == 2;
  machine.tool_axis = static_cast<std::size_t>(whole(setup, tool)) - 1;
  machine.work_axis = static_cast<std::size_t>(whole(setup, work)) - 1;
  machine.tool_line = kLine.at(static_cast<std::size_t>(whole(setup, tool + 1)));
  machine.work_line = kLine.at(static_cast<std::size_t>(whole(setup, work + 1)));
  const auto sense = [&](std::uint32_t first) { return whole(setup, first + 3) == 1 ? -1 : 1; };
  machine.tool_sense = type == 12 ? -sense(tool) : sense(tool);
  machine.work_sense = type == 2 ? sense(work) : -sense(work);
  return machine;
}

std::optional<Exact3> commanded_direction(const spec::Case& c, const Blocks& blocks, std::uint64_t line) {
  const auto machine = rotary_machine(c.setup);
  const auto near = c.setup.parameter(19738);
  if (!machine || (near && !near->is_zero()) || has_rotary_zeros(c, blocks)) return std::nullopt;
  bool in_force = false;
  for (const auto& [number, block] : blocks) {
    if (number > line) break;
    if (has(block, "G49") || has(block, "G43.4")) in_force = false;
    if (!has(block, "G43.5")) continue;
    in_force = !word(block, 'Q') && turns_nothing_before(c, *machine, number);
  }
  const auto block = blocks.find(line);
  if (!in_force || block == blocks.end()) return std::nullopt;
  if (!word(block->second, 'I') && !word(block->second, 'J') && !word(block->second, 'K')) return std::nullopt;
  Exact3 direction{};
  for (std::size_t i = 0; i < 3; ++i)
    if (const auto given = word(block->second, "IJK"[i])) direction[i] = value_of(*given);
  return direction;
}

Rational decimal_of(const spec::NumberText& number) {
  if (const auto exactly = fraction_of(number)) return *exactly;
  const bool negative = number.v.starts_with('-');
  exact::Integer digits = 0;
  exact::Integer scale = 1;
  bool behind = false;
  for (const char c : number.v) {
    if (c == '.') behind = true;
    if (c < '0' || c > '9') continue;
    digits = digits * 10 + (c - '0');
    if (behind) scale *= 10;
  }
  const Rational value(digits, scale);
  return negative ? -value : value;
}

Exact3 decimal_of(const std::array<spec::NumberText, 3>& numbers) {
  return {decimal_of(numbers[0]), decimal_of(numbers[1]), decimal_of(numbers[2])};
}

}  // namespace toolcomp::corpus

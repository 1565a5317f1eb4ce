// SPDX-License-Identifier: Apache-2.0
#include "certify/causes/mistakes.h"

#include <fmt/format.h>

#include <cstdint>
#include <set>
#include <string_view>
#include <utility>

#include "judge/oracle/number.h"
#include "spec/language/byte_source.h"
#include "spec/language/fanuc/program_reader.h"

namespace toolcomp::certify {
namespace {

using Offsets = std::map<std::uint32_t, spec::OffsetEntry>;

spec::Decimal negated(spec::Decimal value) {
  value.negative = !value.negative;
  return value;
}

template <class Change>
void for_offsets(spec::Case& c, const Change& change) {
  for (auto* table : {&c.setup.h, &c.setup.d})
    for (auto& [number, entry] : *table) change(entry);
}

void negate(spec::Case& c) {
  for_offsets(c, [](spec::OffsetEntry& e) { e = {negated(e.geometry), negated(e.wear)}; });
}
void leave_offsets(spec::Case& c) {
  for_offsets(c, [](spec::OffsetEntry& e) { e = {}; });
}
void leave_wear(spec::Case& c) {
  for_offsets(c, [](spec::OffsetEntry& e) { e.wear = {}; });
}

// The value of each number is that of the one before.
void shift_numbers(spec::Case& c) {
  for (auto* table : {&c.setup.h, &c.setup.d}) {
    auto before = spec::OffsetEntry{};
    for (auto& [number, entry] : *table) std::swap(before, entry);
  }
}

void exchange_sides(spec::Case& c) {
  const auto replace = [&c](std::string_view from, std::string_view to) {
    for (std::size_t at = c.program.find(from); at != std::string::npos; at = c.program.find(from, at + to.size()))
      c.program.replace(at, from.size(), to);
  };
  const bool fanuc = c.setup.control == spec::Control::fanuc;
  const auto [left, right] = fanuc ? std::pair{"G41", "G42"} : std::pair{"RL", "RR"};
  constexpr const char* kNeither = "\x01";
  replace(left, kNeither);
  replace(right, left);
  replace(kNeither, right);
}

void leave_deltas(spec::Case& c) {
  for (spec::ToolRow& tool : c.setup.tools) tool.dl = tool.dr = tool.dr2 = {};
}

template <std::uint32_t kParameter>
void turn_back(spec::Case& c) {
  if (!c.setup.parameter(19680)) return;
  const auto now = c.setup.parameter(kParameter);
  c.setup.parameters[{kParameter, -1}] = spec::decimal(now && !now->is_zero() ? 0 : 1);
}

struct Called {
  std::set<std::uint32_t> d;
  std::set<std::uint32_t> h;
};

// The numbers behind D and H, as far as the program can be read.
Called called(const spec::Case& c) {
  Called numbers;
  if (c.setup.control != spec::Control::fanuc) return numbers;
  spec::ProgramReader reader(spec::text_source(c.program), c.setup.axes, {"program", c.setup.block_skip});
  spec::Block block;
  while (reader.next(block))
    for (const spec::Word& word : block.words()) {
      if ((word.address != 'D' && word.address != 'H') || !word.value.is_integer() || word.value.is_zero()) continue;
      (word.address == 'D' ? numbers.d : numbers.h).insert(static_cast<std::uint32_t>(word.value.digits));
    }
  return numbers;
}

std::string total(const spec::OffsetEntry& entry) {
  return fmt::format("{:.9g}", judge::approximate(entry.geometry) + judge::approximate(entry.wear));
}

// To the last digit that a setup may have in any increment system.
spec::Decimal sum(const spec::Decimal& value, double by) {
  return spec::parse_decimal(fmt::format("{:.6f}", judge::approximate(value) + by)).value_or(value);
}

spec::Case with(const spec::Case& c, Offsets spec::Setup::* table, std::uint32_t n, const spec::OffsetEntry& entry) {
  spec::Case other = c;
  (other.setup.*table)[n] = entry;
  return other;
}

void add_offsets(const spec::Case& c, Offsets spec::Setup::* table, char letter, const std::set<std::uint32_t>& numbers,
                 std::vector<OtherCase>& others) {
  const Offsets& offsets = c.setup.*table;
  for (const std::uint32_t n : numbers) {
    const auto found = offsets.find(n);
    if (found == offsets.end()) continue;
    const spec::OffsetEntry& entry = found->second;
    const std::string name = fmt::format("{}{} (here {})", letter, n, total(entry));
    others.push_back({name + " is ignored: it counts as 0", with(c, table, n, {})});
    others.push_back(
        {name + " has the opposite sign", with(c, table, n, {negated(entry.geometry), negated(entry.wear)})});
    if (!entry.wear.is_zero())
      others.push_back({name + " is taken without its wear", with(c, table, n, {entry.geometry, {}})});
    for (const auto& [m, value] : offsets)
      if (m != n && !(value == entry))
        others.push_back(
            {fmt::format("{} has the value of {}{}, {}", name, letter, m, total(value)), with(c, table, n, value)});
  }
}

void add_values(const spec::Case& c, Offsets spec::Setup::* table, char letter, const std::set<std::uint32_t>& numbers,
                std::vector<OtherValue>& values) {
  for (const std::uint32_t n : numbers)
    if (const auto found = (c.setup.*table).find(n); found != (c.setup.*table).end()) {
      const spec::OffsetEntry entry = found->second;
      values.push_back({fmt::format("{}{} (here {}) is off", letter, n, total(entry)), false, 2,
                        [=](double by) { return with(c, table, n, {sum(entry.geometry, by), entry.wear}); }});
    }
}

}  // namespace

const std::array<Mistake, 8> kMistakes{
    {{"offsets have the opposite sign", negate},
     {"offsets count as 0", leave_offsets},
     {"offsets are taken without their wear", leave_wear},
     {"each offset number has the value of the number before it", shift_numbers},
     {"left and right are exchanged", exchange_sides},
     {"the delta values of the tool table are ignored", leave_deltas},
     {"a rotary axis turns in the opposite direction (No. 19684)", turn_back<19684>},
     {"a rotary axis turns in the opposite direction (No. 19689)", turn_back<19689>}}};

std::vector<OtherCase> with_mistakes(const spec::Case& c) {
  std::vector<OtherCase> others;
  const Called numbers = called(c);
  add_offsets(c, &spec::Setup::h, 'H', numbers.h, others);
  add_offsets(c, &spec::Setup::d, 'D', numbers.d, others);
  for (const Mistake& mistake : kMistakes)
    if (spec::Case other = mistake.made_in(c); other.setup != c.setup || other.program != c.program)
      others.push_back({mistake.words, std::move(other)});
  return others;
}

std::vector<OtherValue> other_values(const spec::Case& c) {
  std::vector<OtherValue> values;
  const Called numbers = called(c);
  add_values(c, &spec::Setup::h, 'H', numbers.h, values);
  add_values(c, &spec::Setup::d, 'D', numbers.d, values);
  if (!c.setup.parameter(19680)) return values;
  // Positions and distances of the rotary axes, as far as the setup has them; what is off shows by the turn, however
  // little that is.
  for (std::uint32_t parameter = 19700; parameter <= 19714; ++parameter) {
    if (!c.setup.parameter(parameter)) continue;
    const spec::Decimal now = c.setup.parameter(parameter).value_or(spec::Decimal());
    values.push_back({fmt::format("the machine's No. {} (here {}) is off", parameter, spec::to_string(now)), false, 64,
                      [=](double by) {
                        spec::Case other = c;
                        other.setup.parameters[{parameter, -1}] = sum(now, by);
                        return other;
                      }});
  }
  return values;
}

}  // namespace toolcomp::certify

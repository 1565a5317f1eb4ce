// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/changed_program.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "judge/laws/fanuc/changed.h"
#include "judge/laws/heidenhain/changed.h"
#include "spec/language/input_error.h"

namespace toolcomp::judge::laws {
namespace {

// How a law is asked of either control; nothing where it says nothing of one.
using Ask = void (*)(const spec::Case&, std::span<const model::Event>, const Runner&, Holding&);
struct Change {
  std::string_view name;
  Ask fanuc = nullptr;
  Ask klartext = nullptr;
  bool (*always)(const spec::Case&) = nullptr;  // programs that are asked it whatever their share
};
constexpr std::array kChanges{Change{"value-zero", no_offsets, no_deltas},
                              Change{"mirrored", mirrored},
                              Change{"quarter-turn", quarter_turn},
                              Change{"a-tenth", a_tenth},
                              Change{"reversed", reversed},
                              Change{"moved-origins", moved_origins, nullptr, selects_a_system},
                              Change{"cut-at-a-stop", cut_at_a_stop, nullptr, stops_in_compensation}};

std::uint64_t hash(std::string_view text) {
  std::uint64_t h = 0xcbf29ce484222325;  // FNV-1a
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return h ^ h >> 32U;
}

// None where it says nothing of the dialect.
Ask ask_of(const Change& change, const spec::Case& c) {
  return c.setup.control == spec::Control::fanuc ? change.fanuc : change.klartext;
}

LawResult hold(const Change& change, const spec::Case& c, std::span<const model::Event> events, const Runner& run) {
  const Ask ask = ask_of(change, c);
  if (events.empty() || ask == nullptr) return {};
  Holding holding(change.name, events);
  try {
    ask(c, events, run, holding);
  } catch (const exact::Undecided&) {
    return {holding.checks(), holding.violation(), 1};
  } catch (const spec::InputError&) {
    return {holding.checks(), holding.violation()};  // the changed setup is one no control could have
  }
  return {holding.checks(), holding.violation()};
}

}  // namespace

std::span<const std::string_view> changes() {
  static const auto names = [] {
    std::array<std::string_view, kChanges.size()> list;
    std::ranges::transform(kChanges, list.begin(), &Change::name);
    return list;
  }();
  return names;
}

LawResult hold_changed(std::string_view law, const spec::Case& c, std::span<const model::Event> events,
                       const Runner& run) {
  const auto* const found = std::ranges::find(kChanges, law, &Change::name);
  if (found == kChanges.end()) throw std::invalid_argument("no law " + std::string(law));
  return hold(*found, c, events, run);
}

LawResult hold_changed(const spec::Case& c, std::span<const model::Event> events, const Runner& run) {
  constexpr std::uint64_t share = 16;
  const std::uint64_t h = hash(c.program);
  LawResult result;
  for (std::size_t i = 0; i < kChanges.size() && !result.violation; ++i) {
    const Change& change = kChanges.at(i);
    if (ask_of(change, c) == nullptr) continue;
    const bool chosen = h % share == 0 && h / share % kChanges.size() == i;
    if (!chosen && (change.always == nullptr || !change.always(c))) continue;
    const LawResult one = hold(change, c, events, run);
    result.checks += one.checks;
    result.left_open += one.left_open;
    result.violation = one.violation;
  }
  return result;
}

}  // namespace toolcomp::judge::laws

// SPDX-License-Identifier: Apache-2.0
#include "fuzz/laws/changed_program.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "fuzz/laws/fanuc/changed.h"
#include "fuzz/laws/heidenhain/changed.h"
#include "spec/language/input_error.h"

namespace toolcomp::fuzz::laws {
namespace {

// How a law is asked of either control; nothing where it says nothing of one.
using Ask = void (*)(const spec::Case&, std::span<const model::Event>, const Runner&, Holding&);
struct Change {
  std::string_view name;
  Ask fanuc;
  Ask klartext;
};
constexpr std::array kChanges{Change{"value-zero", no_offsets, no_deltas}, Change{"mirrored", mirrored, nullptr},
                              Change{"quarter-turn", quarter_turn, nullptr}, Change{"a-tenth", a_tenth, nullptr},
                              Change{"reversed", reversed, nullptr}};

std::uint64_t hash(std::string_view text) {
  std::uint64_t h = 0xcbf29ce484222325;  // FNV-1a
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return h ^ h >> 32U;
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

Verdict hold_changed(std::string_view law, const spec::Case& c, std::span<const model::Event> events,
                     const Runner& run) {
  const auto* const found = std::ranges::find(kChanges, law, &Change::name);
  if (found == kChanges.end()) throw std::invalid_argument("no law " + std::string(law));
  const Ask ask = c.setup.control == spec::Control::fanuc ? found->fanuc : found->klartext;
  if (events.empty() || ask == nullptr) return {};
  Holding holding(found->name, events);
  try {
    ask(c, events, run, holding);
  } catch (const exact::Undecided&) {
    return {holding.checks(), holding.violation(), 1};
  } catch (const spec::InputError&) {
    return {holding.checks(), holding.violation()};  // the changed setup is one no control could have
  }
  return {holding.checks(), holding.violation()};
}

Verdict hold_changed(const spec::Case& c, std::span<const model::Event> events, const Runner& run) {
  constexpr std::uint64_t share = 16;
  const std::uint64_t h = hash(c.program);
  if (h % share != 0) return {};
  return hold_changed(kChanges.at(h / share % kChanges.size()).name, c, events, run);
}

}  // namespace toolcomp::fuzz::laws

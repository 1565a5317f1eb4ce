// SPDX-License-Identifier: Apache-2.0
// Laws, which do not use clauses. Two engines that follow the same wrong clause agree; a law uses no clause. It
// compares the model's exact events with a definition or a theorem of the section and with geometry, and a violation is
// certain (certainty.h). The declaration of a law says which cases are exempt. A law never gives a false alarm.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "judge/laws/holding.h"
#include "spec/language/case.h"

namespace toolcomp::judge::laws {

struct LawInfo {
  std::string_view name;       // "perpendicular-to-the-tool"
  std::string_view statement;  // one sentence
};
// Every law, in the order in which they are checked.
std::span<const LawInfo> all();

struct LawResult {
  std::uint64_t checks = 0;            // number of checks of all laws
  std::optional<Violation> violation;  // the first
  std::uint64_t left_open = 0;         // number of laws with a check that could not be decided
};

// Checks all laws that need only the events.
LawResult hold(const spec::Case& c, std::span<const model::Event> events);
// Checks one of these laws, by name.
LawResult hold(std::string_view name, const spec::Case& c, std::span<const model::Event> events);

}  // namespace toolcomp::judge::laws

// SPDX-License-Identifier: Apache-2.0
// Laws beside clauses: the third voice. Two engines that follow one wrong clause agree; a law knows no clause. It holds
// the model's exact events against a definition or a theorem of the section and against geometry, and a violation is
// certain (certainty.h). What exempts a case is said where the law is declared; a law never cries wolf.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "fuzz/laws/holding.h"
#include "spec/language/case.h"

namespace toolcomp::fuzz::laws {

struct LawInfo {
  std::string_view name;       // "perpendicular-to-the-tool"
  std::string_view statement;  // one sentence
};
// Every law, by name, in the order they are asked.
std::span<const LawInfo> all();

struct Verdict {
  std::uint64_t checks = 0;            // questions asked, of all laws
  std::optional<Violation> violation;  // the first
  std::uint64_t left_open = 0;         // laws that came to a question without an answer
};

// All laws that ask the events alone.
Verdict hold(const spec::Case& c, std::span<const model::Event> events);
// One of them, by name.
Verdict hold(std::string_view name, const spec::Case& c, std::span<const model::Event> events);

}  // namespace toolcomp::fuzz::laws

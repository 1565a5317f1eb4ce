// SPDX-License-Identifier: Apache-2.0
// What a target must reach for its silence to mean something.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/campaign/counters.h"
#include "fuzz/campaign/target.h"

namespace toolcomp::fuzz {

// Directed cases are made to be judged: a target below this share tests its own generator's mistakes. Unrestricted ones
// are any words, and mostly end in an alarm before the first move.
inline constexpr double kDirectedFloor = 0.85;
inline constexpr double kUnrestrictedFloor = 0.02;
// Questions that laws ask in an accepted execution of a directed target, on average.
inline constexpr double kLawFloor = 1;
// Fewer executions say nothing about a share.
inline constexpr std::uint64_t kEnoughToJudge = 2000;

// Why nothing found by this target means nothing, a sentence each: "acceptance 71.2 %, at least 85 % wanted". Of a
// reader only that it ran.
std::vector<std::string> shortfalls(const Target& target, const Counters& result);

// Seeded faults (fuzz/faults/faults.inc) of a section, and those whose budget is within so many directed executions: a
// search of that length finds them, which the tests hold.
struct FaultsWithin {
  std::size_t all = 0;
  std::size_t within = 0;
  std::uint64_t largest = 0;  // budget of all
};
FaultsWithin faults_within(std::string_view section, std::uint64_t directed_executions);

}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
// The seeded faults of fuzz/faults/faults.inc, with what the harness must say about each.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace toolcomp::fuzz {

struct SeededFault {
  std::string_view name;     // in fuzz/faults/faults.inc
  std::string_view section;  // whose directed generator must find it
  std::string_view clauses;  // ids, separated by spaces: the event of the first divergence rests on one of them; empty
                             // where the clause that is broken leaves no mark
  std::uint64_t budget;      // executions, fresh cases of one seed
};

// In the order of fuzz/faults/faults.inc, every fault once.
std::span<const SeededFault> seeded_faults();

}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
#include "fuzz/faults/faults.h"

namespace toolcomp::fuzz {

std::span<const SeededFault> seeded_faults() {
  static constexpr SeededFault kFaults[] = {
#define TOOLCOMP_FAULT(name, mistake, section, budget, clauses) {#name, section, clauses, budget},
#include "fuzz/faults/faults.inc"
#undef TOOLCOMP_FAULT
  };
  return kFaults;
}

}  // namespace toolcomp::fuzz

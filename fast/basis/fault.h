// SPDX-License-Identifier: Apache-2.0
// Seeded faults: mistakes an engineer could make, switchable in a test build, so that the harness can be measured.
#pragma once

namespace toolcomp::fast {

enum class Fault : unsigned char {
  none,
#define TOOLCOMP_FAULT(name, mistake, section, budget, clauses) name,
#include "fast/basis/faults.inc"
#undef TOOLCOMP_FAULT
#define TOOLCOMP_BATCH_FAULT(name, mistake) name,
#include "fast/basis/array_faults.inc"
#undef TOOLCOMP_BATCH_FAULT
};

#ifdef TOOLCOMP_FAULTS
// The fault in force, for one run of one thread.
inline thread_local Fault active_fault = Fault::none;
inline bool fault(Fault f) { return active_fault == f; }
#else
// In a normal build no fault exists, and the compiler removes this.
constexpr bool fault(Fault) { return false; }
#endif

}  // namespace toolcomp::fast

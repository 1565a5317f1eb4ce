// SPDX-License-Identifier: Apache-2.0
// The seeded faults of the fast engine: mistakes an engineer could make, so that the harness can be measured. They are
// in a copy of the engine only (plant.py).
#pragma once

namespace toolcomp::fast {

enum class Fault : unsigned char {
  none,
#define TOOLCOMP_FAULT(name, mistake, section, budget, clauses) name,
#include "fuzz/faults/faults.inc"
#undef TOOLCOMP_FAULT
#define TOOLCOMP_BATCH_FAULT(name, mistake) name,
#define TOOLCOMP_ROAD_FAULT(name, mistake) name,
#include "fuzz/faults/array_faults.inc"
#undef TOOLCOMP_BATCH_FAULT
#undef TOOLCOMP_ROAD_FAULT
};

// The fault in force, for one run of one thread.
inline thread_local Fault active_fault = Fault::none;
inline bool fault(Fault f) { return active_fault == f; }

}  // namespace toolcomp::fast

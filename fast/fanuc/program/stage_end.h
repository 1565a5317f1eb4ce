// SPDX-License-Identifier: Apache-2.0
// How a stage that holds blocks ends a run.
#pragma once

#include <cstdint>
#include <optional>

#include "fast/basis/alarm.h"
#include "fast/basis/event.h"

namespace toolcomp::fast {

// By an alarm at a block, or by a case the specification leaves open. Usually neither.
struct StageEnd {
  Alarm alarm;
  const char* undecided = nullptr;  // a clause id
  std::uint64_t line = 0;           // the block at fault
  std::optional<std::uint64_t> n;
  explicit operator bool() const { return alarm || undecided != nullptr; }
};

// The alarm at the block of this move.
inline StageEnd end_at(const Event& event, const Alarm& alarm) { return {alarm, nullptr, event.line, event.n}; }

}  // namespace toolcomp::fast

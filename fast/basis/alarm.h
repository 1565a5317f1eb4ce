// SPDX-License-Identifier: Apache-2.0
// The alarm of a block, by its cause (spec/alarms.toml).
#pragma once

#include "spec/parameters/alarm_causes.h"

namespace toolcomp::fast {

using spec::AlarmCause;

// True if there is one.
struct Alarm {
  constexpr Alarm() = default;
  constexpr Alarm(AlarmCause raised) : cause(raised) {}  // NOLINT(google-explicit-constructor): a cause is an alarm
  constexpr explicit operator bool() const { return cause != AlarmCause::none; }

  AlarmCause cause = AlarmCause::none;
};

}  // namespace toolcomp::fast

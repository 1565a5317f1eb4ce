// SPDX-License-Identifier: Apache-2.0
// The number of an alarm on a control of which a setup says nothing.
#pragma once

#include <string>

#include "spec/language/alarm.h"

namespace toolcomp::test {

inline std::string usual_number(spec::AlarmCause cause) {
  return std::string(spec::AlarmNumbers(spec::Setup())(cause).view());
}

}  // namespace toolcomp::test

// SPDX-License-Identifier: Apache-2.0
// Exact values as text.
#pragma once

#include <string>

#include "model/basis/event.h"
#include "spec/language/case.h"

namespace toolcomp::model {

// Appends the value correctly rounded to `digits` decimals, half to even, without trailing zeros and never as -0.
// Throws exact::Undecided where the digits cannot be certified.
void append_number(std::string& out, const Real& value, int digits);

// The value as golden vectors hold it: v correctly rounded to `digits` decimals, r half a unit of the last of them (0
// where v is the value itself), q the fraction where the value is rational. Throws exact::Undecided.
spec::NumberText number_text(const Real& value, int digits);

// The event with every number as number_text gives it.
spec::TextEvent text_event(const Event& event, int digits);

}  // namespace toolcomp::model

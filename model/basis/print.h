// SPDX-License-Identifier: Apache-2.0
// Exact values as text.
#pragma once

#include <string>

#include "model/basis/event.h"
#include "spec/language/case.h"

namespace toolcomp::model {

// Appends the value correctly rounded to `digits` decimals, half to even, without trailing zeros and never as -0.
// Throws exact::Undecided if the digits cannot be certified.
void append_number(std::string& out, const Real& value, int digits);

// The value in the form of golden vectors: v is correctly rounded to `digits` decimals, r is half a unit of the last of
// them (0 if v is the value itself), q is the fraction if the value is rational. Throws exact::Undecided.
spec::NumberText number_text(const Real& value, int digits);

// The event with every number in the form of number_text.
spec::TextEvent text_event(const Event& event, int digits);

}  // namespace toolcomp::model

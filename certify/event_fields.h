// SPDX-License-Identifier: Apache-2.0
// The fields that the model's events have. A controller that announces them has to send them.
#pragma once

#include "judge/oracle/verdict.h"
#include "spec/language/fields.h"

namespace toolcomp::certify {

// The kind of the finding on a field that was announced, was due, and came in no answer at all.
inline constexpr std::string_view kNeverSent = "field never sent";

spec::FieldSet fields_of(const model::Event& event);
// The fields of all events of a run.
spec::FieldSet fields_of(const judge::ModelRun& run);

}  // namespace toolcomp::certify

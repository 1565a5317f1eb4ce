// SPDX-License-Identifier: Apache-2.0
// Alarms of reading, and the clauses that state them.
#pragma once

#include "model/basis/recorder.h"
#include "spec/language/heidenhain/klartext_block.h"

namespace toolcomp::model::klartext {

// Applies the clause of the alarm and raises it.
[[noreturn]] void raise_read_alarm(Recorder& recorder, const spec::klartext::ReadAlarm& alarm);

}  // namespace toolcomp::model::klartext

// SPDX-License-Identifier: Apache-2.0
// The event that ends a run.
#pragma once

#include "spec/language/alarm.h"
#include "spec/language/event.h"

namespace toolcomp::spec {

// An alarm of the control, with its cause and the number that the control shows; or, for not supported and not judged,
// the word of the program. `text` must be static.
template <class Number>
void end_run(Event<Number>& event, AlarmCause cause, const char* text, const AlarmNumbers& numbers) {
  event.message = text;
  if (is_beyond(cause)) {
    event.kind = cause == AlarmCause::not_judged ? EventKind::not_judged : EventKind::not_supported;
    event.alarm = AlarmCause::none;
    event.number = code_of(text);
  } else {
    event.kind = EventKind::alarm;
    event.alarm = cause;
    event.number = numbers(cause);
  }
}

}  // namespace toolcomp::spec

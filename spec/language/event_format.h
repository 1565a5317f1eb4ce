// SPDX-License-Identifier: Apache-2.0
// The formats events are written in.
#pragma once

#include "spec/language/event_csv.h"    // IWYU pragma: export
#include "spec/language/event_gcode.h"  // IWYU pragma: export
#include "spec/language/event_json.h"   // IWYU pragma: export

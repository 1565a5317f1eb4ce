// SPDX-License-Identifier: Apache-2.0
#include "spec/language/event_gcode.h"

namespace toolcomp::spec {

void append_gcode_begin(std::string& out, Units units) {
  out += units == Units::mm ? "%\nG90 G94 G21\n" : "%\nG90 G94 G20\n";
}

void append_gcode_end(std::string& out) { out += "M30\n%\n"; }

}  // namespace toolcomp::spec

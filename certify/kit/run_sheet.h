// SPDX-License-Identifier: Apache-2.0
// The run sheet of a kit: what to set, to check and to record, and what each program shows.
#pragma once

#include <string>

#include "certify/kit/kit.h"

namespace toolcomp::certify::kit {

// An HTML page of its own that prints well.
std::string write_run_sheet(const Kit& kit);

}  // namespace toolcomp::certify::kit

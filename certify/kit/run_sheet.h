// SPDX-License-Identifier: Apache-2.0
// The run sheet of a kit: what to set, what to check, what to record, and what each program shows.
#pragma once

#include <string>

#include "certify/kit/kit.h"

namespace toolcomp::certify::kit {

// A self-contained HTML page, made for printing.
std::string write_run_sheet(const Kit& kit);

}  // namespace toolcomp::certify::kit

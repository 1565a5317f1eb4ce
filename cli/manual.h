// SPDX-License-Identifier: Apache-2.0
// Manual pages in mdoc, made of the definitions of verbs and setups.
#pragma once

#include <string>
#include <string_view>

#include "cli/command_line.h"

namespace toolcomp::cli {

// Writes toolcomp.1, a page toolcomp-VERB.1 for every listed verb and toolcomp-setup.5 into the folder. `date` is
// theirs, as "2026-01-31". Throws spec::InputError for a date or a folder that cannot be.
void write_manual(const CommandLine& line, const std::string& date, const std::string& folder);

}  // namespace toolcomp::cli

// SPDX-License-Identifier: Apache-2.0
// Manual pages, made of the definitions of verbs.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace toolcomp::cli {

// Writes toolcomp.1 and a page toolcomp-VERB.1 for every listed verb into the folder. `date` is theirs, as
// "2026-01-31". Throws std::runtime_error for a folder that cannot be.
void write_manual(const CLI::App& program, const std::string& date, const std::string& folder);

}  // namespace toolcomp::cli

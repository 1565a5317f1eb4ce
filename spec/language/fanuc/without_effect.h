// SPDX-License-Identifier: Apache-2.0
// What a FANUC program says that changes no path (clause fanuc.program.without-effect), for the report of a
// certificate.
#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "spec/language/fanuc/block.h"

namespace toolcomp::spec {

// Of a G code in tenths.
bool code_without_effect(std::uint64_t tenths);

// Adds the words of a block that have none: "G80", "G05.1", "M08", "S", "T".
void add_words_without_effect(const Block& block, std::set<std::string>& words);

}  // namespace toolcomp::spec

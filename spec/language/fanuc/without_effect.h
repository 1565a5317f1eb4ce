// SPDX-License-Identifier: Apache-2.0
// Words of a FANUC program that change no path (clause fanuc.program.without-effect), for the report of a certificate.
#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "spec/language/fanuc/block.h"

namespace toolcomp::spec {

// Whether a G code, given in tenths, has no effect.
bool code_without_effect(std::uint64_t tenths);

// Adds the words of a block that have no effect: "G80", "G05.1", "M08", "S", "T".
void add_words_without_effect(const Block& block, std::set<std::string>& words);

}  // namespace toolcomp::spec

// SPDX-License-Identifier: Apache-2.0
// Columns as editors count them.
#pragma once

#include <cstdint>
#include <string>

#include "spec/language/input_error.h"

namespace toolcomp::cli {

// Readers count bytes (spec/language/document.h); this is the same place in characters. A file that cannot be read
// again, such as standard input, keeps its bytes.
std::uint64_t character_column(const std::string& file, std::uint64_t line, std::uint64_t column);

// The error with its column in characters.
spec::InputError in_characters(const spec::InputError& error);

}  // namespace toolcomp::cli

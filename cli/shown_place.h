// SPDX-License-Identifier: Apache-2.0
// Columns as editors count them.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

#include "spec/language/input_error.h"

namespace toolcomp::cli {

// A line by its number from 1, without its line feed; empty where there is none, and of a file that cannot be read
// again, such as standard input.
std::string line_of(std::istream& text, std::uint64_t number);
std::string line_of(const std::string& file, std::uint64_t number);

// Readers count bytes (spec/language/document.h); this is the same place in characters. A file that cannot be read
// again, such as standard input, keeps its bytes.
std::uint64_t character_column(const std::string& file, std::uint64_t line, std::uint64_t column);

// The error with its column in characters.
spec::InputError in_characters(const spec::InputError& error);

}  // namespace toolcomp::cli

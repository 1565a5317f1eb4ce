// SPDX-License-Identifier: Apache-2.0
// Changes that mutations of all languages make.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fuzz/gen/choices.h"

namespace toolcomp::fuzz {

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

// One digit of a word, from a place on, becomes another, or one is put in or taken out.
void change_digit(Choices& choose, std::string& word, std::size_t from);

enum class LineChange : std::uint8_t { erase, repeat, exchange };

// The line `at` goes, stands twice, or changes places with any other.
void change_line(Choices& choose, std::vector<std::string>& text, std::size_t at, LineChange change);

}  // namespace toolcomp::fuzz

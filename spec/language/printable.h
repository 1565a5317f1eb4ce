// SPDX-License-Identifier: Apache-2.0
// Text from outside, made so that a terminal, a report or a log shows it and obeys none of it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace toolcomp::spec {

// The length of the character that `text` begins with, where it may be shown; 0 where it is a control character (C0,
// DEL, C1), turns the direction of writing, ends a line in Unicode, or is no UTF-8.
std::size_t shown_length(std::string_view text);

// One line: every byte that must not be shown as U+FFFD, at most `most` characters, then "…".
std::string printable(std::string_view text, std::size_t most = 500);
// The same of several lines: line ends and tabs stay.
std::string printable_lines(std::string_view text, std::size_t most = 1'000'000);

}  // namespace toolcomp::spec

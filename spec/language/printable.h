// SPDX-License-Identifier: Apache-2.0
// Makes text from outside safe: a terminal, a report or a log shows it, and obeys nothing in it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace toolcomp::spec {

// The length of the first character of `text`, if it may be shown; 0 if it is a control character (C0, DEL, C1),
// changes the writing direction, ends a line in Unicode, or is not UTF-8.
std::size_t shown_length(std::string_view text);

// One line of text. Every byte that must not be shown becomes U+FFFD. After `most` characters the text ends with "…".
std::string printable(std::string_view text, std::size_t most = 500);
// The same for several lines: line ends and tabs stay.
std::string printable_lines(std::string_view text, std::size_t most = 1'000'000);

}  // namespace toolcomp::spec

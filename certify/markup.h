// SPDX-License-Identifier: Apache-2.0
// Text inside HTML, XML and SVG.
#pragma once

#include <string>
#include <string_view>

namespace toolcomp::certify {

// `text` as character data or as a double-quoted attribute: the five special characters become entities. Characters
// that must not be shown (spec/language/printable.h) or that XML 1.0 does not allow become U+FFFD. Line ends and tabs
// stay.
std::string escape(std::string_view text);

// A double for people: at most `decimals` decimals, no trailing zeros, never "-0"; "—" if it is not finite.
std::string plain(double value, int decimals = 3);

}  // namespace toolcomp::certify

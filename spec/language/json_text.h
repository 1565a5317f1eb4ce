// SPDX-License-Identifier: Apache-2.0
// Writes JSON text.
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace toolcomp::spec {

// The length of the UTF-8 character at the beginning of `text`; 0 if there is none (RFC 3629).
std::size_t utf8_length(std::string_view text);

// Appends `text` in double quotes. Bytes that are not UTF-8, which JSON cannot represent, become U+FFFD. Characters
// that a terminal would obey (printable.h) are escaped.
void append_json_string(std::string& out, std::string_view text);

// Appends to a std::string or TextCursor.
template <class Text>
void append_integer(Text& out, std::uint64_t value) {
  std::array<char, 20> digits;  // as many as 2^64 - 1 has
  char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  out += std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data()));
}

}  // namespace toolcomp::spec

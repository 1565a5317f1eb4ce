// JSON text, written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace toolcomp::spec {

// The length of the UTF-8 character that `text` begins with; 0 where it begins with none (RFC 3629).
std::size_t utf8_length(std::string_view text);

// Appends `text` in double quotes. Bytes that are not UTF-8, which JSON cannot carry, become U+FFFD.
void append_json_string(std::string& out, std::string_view text);
void append_integer(std::string& out, std::uint64_t value);

}  // namespace toolcomp::spec

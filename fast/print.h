// Numbers of the fast engine as text.
#pragma once

#include <cstddef>
#include <string>

namespace toolcomp::fast {

// Room enough for any double write_number() writes, and for the rest of its last word.
inline constexpr std::size_t kNumberText = 48;

// The shortest text that reads back as `value`, without exponent between 1e-7 and 1e21; never -0. Writes at most
// kNumberText characters at `to` and returns the end. `value` must be finite.
char* write_number(char* to, double value);

// The same, appended.
void append_number(std::string& text, double value);

}  // namespace toolcomp::fast

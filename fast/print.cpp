#include "fast/print.h"

#include <charconv>
#include <cmath>

namespace toolcomp::fast {

char* write_number(char* to, double value) {
  if (value == 0) {
    *to = '0';
    return to + 1;
  }
  const double magnitude = std::abs(value);
  // Shortest digits padded with zeros: below 1e21 at most 21 and a sign, above 1e-7 at most 25 behind "0.".
  const auto format = magnitude >= 1e-7 && magnitude < 1e21 ? std::chars_format::fixed : std::chars_format::scientific;
  return std::to_chars(to, to + kNumberText, value, format).ptr;
}

void append_number(std::string& text, double value) {
  char buffer[kNumberText];
  text.append(buffer, write_number(buffer, value));
}

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
#include "spec/language/printable.h"

#include "spec/language/json_text.h"

namespace toolcomp::spec {
namespace {

constexpr std::string_view kInstead = "\xEF\xBF\xBD";

std::string shown(std::string_view text, std::size_t most, std::string_view permitted) {
  std::string out;
  for (std::size_t characters = 0; !text.empty(); ++characters) {
    if (characters == most) return out + "…";
    std::size_t length = shown_length(text);
    if (length == 0 && permitted.find(text.front()) != std::string_view::npos) length = 1;
    out += length == 0 ? kInstead : text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return out;
}

}  // namespace

std::size_t shown_length(std::string_view text) {
  const std::size_t length = utf8_length(text);
  if (length == 0) return 0;
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (length == 1) return byte(0) < 0x20 || byte(0) == 0x7F ? 0 : 1;
  if (length == 2) {
    const bool c1 = byte(0) == 0xC2 && byte(1) < 0xA0;
    const bool arabic_mark = byte(0) == 0xD8 && byte(1) == 0x9C;  // U+061C
    return c1 || arabic_mark ? 0 : length;
  }
  if (length == 3 && byte(0) == 0xE2) {
    // U+200E U+200F, U+2028 to U+202E, U+2066 to U+2069.
    const bool marks = byte(1) == 0x80 && (byte(2) == 0x8E || byte(2) == 0x8F || (byte(2) >= 0xA8 && byte(2) <= 0xAE));
    const bool isolates = byte(1) == 0x81 && byte(2) >= 0xA6 && byte(2) <= 0xA9;
    return marks || isolates ? 0 : length;
  }
  return length;
}

std::string printable(std::string_view text, std::size_t most) { return shown(text, most, ""); }
std::string printable_lines(std::string_view text, std::size_t most) { return shown(text, most, "\n\t"); }

}  // namespace toolcomp::spec

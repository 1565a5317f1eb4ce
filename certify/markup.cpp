// SPDX-License-Identifier: Apache-2.0
#include "certify/markup.h"

#include <fmt/format.h>

#include <cmath>

#include "spec/language/printable.h"

namespace toolcomp::certify {

std::string escape(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const char c = text.front();
    const std::size_t length = c == '\n' || c == '\t' ? 1 : spec::shown_length(text);
    // U+FFFE and U+FFFF are no characters of XML.
    const bool excluded = text.starts_with("\xEF\xBF\xBE") || text.starts_with("\xEF\xBF\xBF");
    if (length == 0 || excluded) {
      if (c != '\r') out += "\xEF\xBF\xBD";
    } else if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else if (c == '\'') {
      out += "&#39;";
    } else {
      out += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return out;
}

std::string plain(double value, int decimals) {
  if (!std::isfinite(value)) return "—";
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

}  // namespace toolcomp::certify

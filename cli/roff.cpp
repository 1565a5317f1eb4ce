// SPDX-License-Identifier: Apache-2.0
#include "cli/roff.h"

#include <fmt/format.h>

#include <cctype>
#include <cstddef>
#include <cstdint>

namespace toolcomp::cli::roff {
namespace {

// The character that begins here, and how many bytes it has.
std::pair<std::uint32_t, std::size_t> character(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  const std::size_t size = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  std::uint32_t code = size == 1 ? lead : lead & (0x7FU >> size);
  for (std::size_t i = 1; i < size && i < text.size(); ++i)
    code = (code << 6U) | (static_cast<unsigned char>(text[i]) & 0x3FU);
  return {code, size};
}

std::string escaped(std::string_view text, bool all_hyphens) {
  std::string out;
  if (!text.empty() && (text.front() == '.' || text.front() == '\'')) out += "\\&";
  for (std::size_t at = 0; at < text.size();) {
    const auto [code, size] = character(text.substr(at));
    const bool option = text[at] == '-' && (all_hyphens || text.substr(at).starts_with("--") ||
                                            (at > 0 && text[at - 1] == '-') || (at > 0 && text[at - 1] == ' '));
    if (text[at] == '\\')
      out += "\\e";
    else if (option)
      out += "\\-";
    else if (all_hyphens && text[at] == '\'')
      out += "\\(aq";
    else if (all_hyphens && text[at] == '`')
      out += "\\(ga";
    else if (code == 0x2026)
      out += "...";
    else if (code > 0x7F)
      out += fmt::format("\\[u{:04X}]", code);
    else
      out += text[at];
    at += size;
  }
  return out;
}

}  // namespace

std::string running(std::string_view text) { return escaped(text, false); }

std::string word(const std::string& text) {
  std::string out = escaped(text, false);
  if (out.find(' ') != std::string::npos) return '"' + out + '"';
  return out;
}

std::string lowered(std::string text) {
  const bool capitals = text.size() > 1 && std::isupper(static_cast<unsigned char>(text[1])) != 0;
  if (!text.empty() && !capitals) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

Page::Page(const std::string& title, int section, const std::string& date) {
  text_ =
      fmt::format(".\\\" Made by the build from the definitions of the command.\n.Dd {}\n.Dt {} {}\n.Os toolcomp {}\n",
                  date, title, section, TOOLCOMP_VERSION);
}

void Page::section(std::string_view title) { text_.append(".Sh ").append(title).append("\n"); }

void Page::line(const std::string& macros) { text_.append(macros).append("\n"); }

void Page::text(std::string_view sentences) {
  while (!sentences.empty()) {
    const std::size_t end = sentences.find(". ");
    const std::string_view sentence = sentences.substr(0, end == std::string_view::npos ? end : end + 1);
    text_.append(running(sentence)).append("\n");
    sentences.remove_prefix(end == std::string_view::npos ? sentences.size() : end + 2);
  }
}

void Page::paragraphs(const std::vector<std::string_view>& texts) {
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (i > 0) line(".Pp");
    text(texts[i]);
  }
}

void Page::literal(std::string_view text) { text_.append(escaped(text, true)).append("\n"); }

}  // namespace toolcomp::cli::roff

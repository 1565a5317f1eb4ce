// SPDX-License-Identifier: Apache-2.0
// What the generators of C++ have in common: clauses/generate.cpp and parameters/.
#pragma once

#include <fmt/format.h>

#include <toml++/toml.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>

namespace toolcomp::spec {

// The text as a C++ string literal.
inline std::string literal(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (c == '\n')
      out += "\\n";
    else
      out += c;
  }
  return out + '"';
}

// Throws std::runtime_error that names file, line and column.
[[noreturn]] inline void fail(const std::filesystem::path& file, const toml::source_region& where,
                              std::string_view what) {
  throw std::runtime_error(fmt::format("{}:{}:{}: {}", file.string(), where.begin.line, where.begin.column, what));
}

// Written only when changed, so that nothing is built again for a comment. Throws std::runtime_error naming the file.
inline void write_changed(const std::filesystem::path& file, const std::string& text) {
  if (std::ifstream old(file, std::ios::binary); old && std::string(std::istreambuf_iterator<char>(old), {}) == text)
    return;
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace toolcomp::spec

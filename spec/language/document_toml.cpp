// SPDX-License-Identifier: Apache-2.0
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <utility>

#include "spec/language/document.h"
#include "spec/language/input_error.h"

namespace toolcomp::spec::document {
namespace {

// toml++ bounds the nesting of brackets but not of dotted keys, and frees tables recursively. No setup comes near this.
constexpr std::ptrdiff_t kMaxDots = 100;

class Converter {
 public:
  Converter(std::string_view text, const std::string& file) : file_(file) {
    for (std::size_t start = 0; start <= text.size();) {
      const std::size_t end = std::min(text.find('\n', start), text.size());
      lines_.push_back(text.substr(start, end - start));
      start = end + 1;
    }
  }

  void check_lines() const {
    for (std::size_t i = 0; i < lines_.size(); ++i)
      if (std::ranges::count(lines_[i], '.') > kMaxDots)
        throw InputError(file_, i + 1, 1, "a line with more than " + std::to_string(kMaxDots) + " points");
  }

  // toml++ counts columns in characters, we in bytes.
  [[nodiscard]] Position position(const toml::source_position& at) const {
    if (at.line == 0 || at.line > lines_.size()) return {lines_.size(), 1};
    const std::string_view line = lines_[at.line - 1];
    // Nodes come mostly in the order of the text: a long line is gone through once.
    if (at.line != last_.line || at.column < last_.column) last_ = {at.line, 1, 0};
    std::size_t& byte = last_.byte;
    for (toml::source_index& column = last_.column; column < at.column && byte < line.size(); ++column) {
      ++byte;
      while (byte < line.size() && (static_cast<unsigned char>(line[byte]) & 0xC0U) == 0x80U) ++byte;
    }
    return {at.line, byte + 1};
  }

  // The number as written, without underscores: toml++ itself has only a double.
  [[nodiscard]] std::string number_text(Position at) const {
    std::string text;
    for (const char c : lines_[at.line - 1].substr(at.column - 1)) {
      const bool part = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '+' ||
                        c == '-' || c == '.' || c == '_';
      if (!part) break;
      if (c != '_') text += c;
    }
    return text;
  }

  // NOLINTNEXTLINE(misc-no-recursion): kMaxDepth
  [[nodiscard]] Node node(const toml::node& source, int depth) const {
    Node result;
    result.at = position(source.source().begin);
    if (depth > kMaxDepth) throw InputError(file_, result.at.line, result.at.column, "nested too deep");
    switch (source.type()) {
      case toml::node_type::table:
        result.kind = Kind::table;
        for (const auto& [key, value] : *source.as_table())
          result.members.push_back({std::string(key.str()), position(key.source().begin), node(value, depth + 1)});
        // toml++ sorts by name; errors are to be found in the order of the text.
        std::ranges::sort(result.members, {}, [](const Member& m) { return std::pair(m.at.line, m.at.column); });
        break;
      case toml::node_type::array:
        result.kind = Kind::array;
        for (const auto& value : *source.as_array()) result.items.push_back(node(value, depth + 1));
        break;
      case toml::node_type::string:
        result.kind = Kind::string;
        result.text = source.as_string()->get();
        break;
      case toml::node_type::integer:
      case toml::node_type::floating_point:
        result.kind = Kind::number;
        result.text = number_text(result.at);
        break;
      case toml::node_type::boolean:
        result.kind = Kind::boolean;
        result.boolean = source.as_boolean()->get();
        break;
      default:
        result.kind = Kind::other;
    }
    return result;
  }

 private:
  // Of the last position asked for.
  struct Last {
    toml::source_index line = 0;
    toml::source_index column = 1;
    std::size_t byte = 0;
  };

  const std::string& file_;
  std::vector<std::string_view> lines_;
  mutable Last last_;
};

}  // namespace

Node parse_toml(std::string_view text, const std::string& file) {
  if (text.size() > kLongestToml)
    throw InputError(file, 0, 0, "is longer than " + std::to_string(kLongestToml) + " bytes");
  const Converter converter(text, file);
  converter.check_lines();
  try {
    const toml::table table = toml::parse(text);
    return converter.node(table, 0);
  } catch (const toml::parse_error& error) {
    const Position at = converter.position(error.source().begin);
    throw InputError(file, at.line, at.column, std::string(error.description()));
  }
}

}  // namespace toolcomp::spec::document

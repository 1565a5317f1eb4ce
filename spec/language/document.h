// SPDX-License-Identifier: Apache-2.0
// A JSON or TOML text as a tree, with the exact texts of numbers and with positions. For the readers of this folder and
// of manifests.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spec/language/decimal.h"

namespace toolcomp::spec::document {

enum class Kind : std::uint8_t { null, boolean, number, string, array, table, other };

// Where a value or a key begins, from 1. Columns count bytes.
struct Position {
  std::uint64_t line = 1;
  std::uint64_t column = 1;
};

struct Member;

// Numbers keep their text: no value passes through double, and -0 and trailing zeros survive.
struct Node {
  Kind kind = Kind::null;
  Position at;
  bool boolean = false;
  std::string text;             // number or string
  std::vector<Node> items;      // array
  std::vector<Member> members;  // table, in the order of the text; no name occurs twice

  [[nodiscard]] const Node* find(std::string_view name) const;
};

struct Member {
  std::string name;
  Position at;
  Node value;
};

// Both throw InputError with the position of the fault. They also throw for nesting deeper than kMaxDepth, and for more
// values than the longest permitted answer can have.
inline constexpr int kMaxDepth = 64;
inline constexpr std::size_t kMaxValues = 5'000'000;
inline constexpr std::size_t kLongestToml = std::size_t{1} << 24;
Node parse_json(std::string_view text, const std::string& file);
Node parse_toml(std::string_view text, const std::string& file);

// Typed access. Errors give the place, what is wrong and what was expected. `name` is the name of the value in
// messages.
class Reader {
 public:
  explicit Reader(std::string file) : file_(std::move(file)) {}

  [[noreturn]] void fail(Position at, const std::string& message) const;

  void expect(const Node& node, Kind kind, std::string_view name) const;
  [[nodiscard]] const std::string& string(const Node& node, std::string_view name) const;
  [[nodiscard]] bool boolean(const Node& node, std::string_view name) const;
  // A number or a quoted number, without exponent, of at most Decimal::kMaxDigits digits.
  [[nodiscard]] Decimal decimal(const Node& node, std::string_view name) const;
  // A number without point, in [least, most].
  [[nodiscard]] std::uint64_t integer(const Node& node, std::string_view name, std::uint64_t least,
                                      std::uint64_t most) const;
  [[nodiscard]] std::vector<std::string> strings(const Node& node, std::string_view name) const;
  // The index of the string among the choices.
  [[nodiscard]] std::size_t choice(const Node& node, std::string_view name,
                                   std::span<const std::string_view> choices) const;
  [[nodiscard]] std::size_t choice(const Node& node, std::string_view name,
                                   std::initializer_list<std::string_view> choices) const {
    return choice(node, name, std::span(choices.begin(), choices.size()));
  }
  // The member of a table. It is an error if the table does not have it.
  [[nodiscard]] const Node& needed(const Node& table, std::string_view key) const;
  // `node` must be a table with no other keys than these.
  void keys(const Node& node, std::string_view name, std::span<const std::string_view> known) const;
  void keys(const Node& node, std::string_view name, std::initializer_list<std::string_view> known) const {
    keys(node, name, std::span(known.begin(), known.size()));
  }

 private:
  std::string file_;
};

// "a decimal number", "a string", … for messages.
std::string_view describe(Kind kind);
// The text in double quotes, shortened if it is long, for messages.
std::string in_quotes(std::string_view text);

}  // namespace toolcomp::spec::document

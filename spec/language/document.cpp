// SPDX-License-Identifier: Apache-2.0
#include "spec/language/document.h"

#include <algorithm>
#include <utility>

#include "spec/language/input_error.h"
#include "spec/language/suggestion.h"

namespace toolcomp::spec::document {
namespace {

std::string joined(std::span<const std::string_view> names) {
  std::string text;
  for (const std::string_view name : names) {
    if (!text.empty()) text += ", ";
    text += name;
  }
  return text;
}

}  // namespace

const Node* Node::find(std::string_view name) const {
  const auto found = std::ranges::find(members, name, &Member::name);
  return found == members.end() ? nullptr : &found->value;
}

std::string_view describe(Kind kind) {
  switch (kind) {
    case Kind::null:
      return "null";
    case Kind::boolean:
      return "true or false";
    case Kind::number:
      return "a number";
    case Kind::string:
      return "a string";
    case Kind::array:
      return "an array";
    case Kind::table:
      return "a table";
    case Kind::other:
      break;
  }
  return "a date or time";
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kShown = 40;
  std::string shown = "\"";
  for (const char c : text.substr(0, kShown)) shown += c >= 0x20 && c < 0x7F ? c : '?';
  return shown + (text.size() > kShown ? "…\"" : "\"");
}

void Reader::fail(Position at, const std::string& message) const {
  throw InputError(file_, at.line, at.column, message);
}

void Reader::expect(const Node& node, Kind kind, std::string_view name) const {
  if (node.kind == kind) return;
  fail(node.at,
       std::string(name) + ": expected " + std::string(describe(kind)) + ", found " + std::string(describe(node.kind)));
}

const std::string& Reader::string(const Node& node, std::string_view name) const {
  expect(node, Kind::string, name);
  return node.text;
}

bool Reader::boolean(const Node& node, std::string_view name) const {
  expect(node, Kind::boolean, name);
  return node.boolean;
}

Decimal Reader::decimal(const Node& node, std::string_view name) const {
  if (node.kind != Kind::number && node.kind != Kind::string)
    fail(node.at, std::string(name) + ": expected a decimal number, found " + std::string(describe(node.kind)));
  if (const std::optional<Decimal> value = parse_decimal(node.text)) return *value;
  const std::string_view text = node.text;
  std::string why = "is not a decimal number such as -4.0";
  if (text.find_first_not_of("0123456789+-.") == std::string_view::npos && text.size() > Decimal::kMaxDigits)
    why = "has more than " + std::to_string(Decimal::kMaxDigits) + " digits";
  else if (node.kind == Kind::number && text.find_first_of("eE") != std::string_view::npos)
    why = "has an exponent; expected a plain decimal number such as 0.001";
  fail(node.at, std::string(name) + ": " + in_quotes(text) + " " + why);
}

std::uint64_t Reader::integer(const Node& node, std::string_view name, std::uint64_t least, std::uint64_t most) const {
  expect(node, Kind::number, name);
  const std::optional<Decimal> value = parse_decimal(node.text);
  if (!value || value->point || value->negative || value->digits < least || value->digits > most)
    fail(node.at, std::string(name) + ": expected an integer from " + std::to_string(least) + " to " +
                      std::to_string(most) + ", found " + in_quotes(node.text));
  return value->digits;
}

std::vector<std::string> Reader::strings(const Node& node, std::string_view name) const {
  expect(node, Kind::array, name);
  std::vector<std::string> list;
  list.reserve(node.items.size());
  for (const Node& item : node.items) list.push_back(string(item, name));
  return list;
}

std::size_t Reader::choice(const Node& node, std::string_view name, std::span<const std::string_view> choices) const {
  const std::string& text = string(node, name);
  const auto found = std::ranges::find(choices, std::string_view(text));
  if (found == choices.end())
    fail(node.at, std::string(name) + ": unknown value " + in_quotes(text) + "; expected one of " + joined(choices) +
                      did_you_mean(text, choices));
  return static_cast<std::size_t>(found - choices.begin());
}

const Node& Reader::needed(const Node& table, std::string_view key) const {
  expect(table, Kind::table, key);
  const Node* const node = table.find(key);
  if (node == nullptr) fail(table.at, "\"" + std::string(key) + "\" is missing");
  return *node;
}

void Reader::keys(const Node& node, std::string_view name, std::span<const std::string_view> known) const {
  expect(node, Kind::table, name);
  for (const Member& member : node.members)
    if (std::ranges::find(known, std::string_view(member.name)) == known.end())
      fail(member.at, std::string(name) + ": unknown key " + in_quotes(member.name) + "; expected one of " +
                          joined(known) + did_you_mean(member.name, known));
}

}  // namespace toolcomp::spec::document

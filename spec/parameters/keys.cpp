// SPDX-License-Identifier: Apache-2.0
// [[key]] of the registry as C++.
#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "spec/generated_source.h"
#include "spec/parameters/registry.h"

namespace toolcomp::spec {
namespace {

constexpr std::string_view kKeys[] = {"id",    "control", "values",  "type", "default", "always",    "letter",
                                      "words", "percent", "clauses", "text", "comment", "heidenhain"};
constexpr std::int64_t kMostPercent = 99;
constexpr std::string_view kOwnTexts[] = {"text", "comment"};
// What else a setup has: no key is called so.
constexpr std::string_view kOtherNames[] = {"control",  "axes",      "parameters",  "alarms", "offsets",    "workpiece",
                                            "position", "reference", "measurement", "tool",   "correction", "dr2table"};
// Of lines of a fuzzed case that are no keys (fuzz/gen/encode.cpp).
constexpr std::string_view kOtherLetters = "abcdefghjmnopqrtwy";

constexpr std::string_view kValuesFile = R"(// Generated from the registry of keys. Do not edit.
#pragma once

#include <cstdint>

namespace toolcomp::spec {{

{}
// What a setup says by key, each with its default (spec/parameters.toml).
struct SetupKeys {{
{}  friend bool operator==(const SetupKeys&, const SetupKeys&) = default;
}};

}}  // namespace toolcomp::spec
)";

constexpr std::string_view kTableFile = R"(// Generated from the registry of keys. Do not edit.
#pragma once

#include <array>
#include <string_view>

#include "spec/language/setup_key.h"

namespace toolcomp::spec {{

{}
inline constexpr std::array<KeyInfo, {}> kKeys{{{{
{}}}}};

}}  // namespace toolcomp::spec
)";

struct Key {
  std::string id, type, letter, text, comment, heidenhain_text, heidenhain_comment;
  bool fanuc = false, heidenhain = false, boolean = false, always = false;
  std::vector<std::string> values, words, clauses;
  std::size_t default_value = 0;
  std::int64_t percent = 0;
};

// IS-B: is_b; 16i of the key series: series_16i.
std::string enumerator(const std::string& key, const std::string& value) {
  std::string name = std::isdigit(static_cast<unsigned char>(value[0])) != 0 ? key + "_" : "";
  for (const char c : value) name += c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

// rotary_angles: RotaryAngles.
std::string type_name(const std::string& id) {
  std::string name;
  bool upper = true;
  for (const char c : id) {
    if (c != '_') name += upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    upper = c == '_';
  }
  return name;
}

class Keys {
 public:
  explicit Keys(const Registry& registry) : registry_(registry) {
    for (const toml::table* entry : registry.entries("key")) list_.push_back(key(*entry));
  }

  [[nodiscard]] const std::vector<Key>& list() const { return list_; }

 private:
  Key key(const toml::table& table) {
    registry_.expect_keys(table, kKeys);
    Key k;
    k.id = id(table);
    const std::string control = text(table, "control");
    k.fanuc = control == "fanuc" || control == "both";
    k.heidenhain = control == "heidenhain" || control == "both";
    if (!k.fanuc && !k.heidenhain) registry_.fail(table, "control must be fanuc, heidenhain or both");
    read_values(table, k);
    k.always = registry_.flag(table, "always");
    read_line(table, k);
    if (const toml::node* percent = table.get("percent")) {
      k.percent = percent->value_or(std::int64_t{0});
      if (k.percent < 1 || k.percent > kMostPercent) registry_.fail(*percent, "percent: 1 to 99 must stand here");
    }
    k.clauses = registry_.clauses(table);
    k.text = text(table, "text");
    k.comment = table.get("comment") == nullptr ? k.text : text(table, "comment");
    read_texts_of_heidenhain(table, k);
    return k;
  }

  // Not empty.
  [[nodiscard]] std::string text(const toml::table& table, std::string_view key) const {
    const std::string value = registry_.text(table, key);
    if (value.empty()) registry_.fail(table, fmt::format("{} must stand here", key));
    return value;
  }

  std::string id(const toml::table& table) {
    const std::string name = text(table, "id");
    if (name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != std::string::npos || name[0] < 'a')
      registry_.fail(*table.get("id"), "id: lower-case letters, digits and _ must stand here");
    if (std::ranges::find(kOtherNames, name) != std::end(kOtherNames) || !ids_.insert(name).second)
      registry_.fail(*table.get("id"), fmt::format("id: there is {} already", name));
    return name;
  }

  void read_values(const toml::table& table, Key& k) const {
    k.values = registry_.strings(table, "values");
    k.boolean = k.values.empty();
    const toml::node* given = table.get("default");
    if (given == nullptr) registry_.fail(table, "default must stand here");
    if (k.boolean) {
      k.type = "bool";
      k.values = {"false", "true"};
      k.default_value = registry_.flag(table, "default") ? 1 : 0;
      return;
    }
    k.type = table.get("type") == nullptr ? type_name(k.id) : text(table, "type");
    if (k.values.size() < 2 || std::set<std::string>(k.values.begin(), k.values.end()).size() != k.values.size())
      registry_.fail(*table.get("values"), "values: two at least must stand here, each once");
    const auto found = std::ranges::find(k.values, registry_.text(table, "default"));
    if (found == k.values.end()) registry_.fail(*given, "default must be one of the values");
    k.default_value = static_cast<std::size_t>(found - k.values.begin());
  }

  void read_line(const toml::table& table, Key& k) {
    k.letter = text(table, "letter");
    const toml::node& at = *table.get("letter");
    if (k.letter.size() != 1 || std::isalpha(static_cast<unsigned char>(k.letter[0])) == 0)
      registry_.fail(at, "letter: one letter must stand here");
    if (kOtherLetters.find(k.letter[0]) != std::string_view::npos || !letters_.insert(k.letter[0]).second)
      registry_.fail(at, fmt::format("letter: {} begins other lines", k.letter));
    k.words = registry_.strings(table, "words");
    if (k.words.empty() ? k.values.size() != 2 : k.words.size() != k.values.size())
      registry_.fail(at, "words: one for each value must stand here; none where there are two");
    if (std::set<std::string>(k.words.begin(), k.words.end()).size() != k.words.size())
      registry_.fail(*table.get("words"), "words: one stands here twice");
  }

  void read_texts_of_heidenhain(const toml::table& table, Key& k) const {
    k.heidenhain_text = k.text;
    k.heidenhain_comment = k.comment;
    const toml::node* own = table.get("heidenhain");
    if (own == nullptr) return;
    if (!own->is_table() || !k.fanuc || !k.heidenhain)
      registry_.fail(*own, "heidenhain: text and comment of a key of both controls");
    registry_.expect_keys(*own->as_table(), kOwnTexts);
    k.heidenhain_text = text(*own->as_table(), "text");
    k.heidenhain_comment = text(*own->as_table(), "comment");
  }

  const Registry& registry_;
  std::vector<Key> list_;
  std::set<std::string> ids_;
  std::set<char> letters_;
};

std::string value_of(const Key& k) {
  return k.boolean ? k.values[k.default_value] : k.type + "::" + enumerator(k.id, k.values[k.default_value]);
}

// An array of texts, where there are any, and what names it.
std::string array(const Key& k, std::string_view what, const std::vector<std::string>& texts, std::string& arrays) {
  if (texts.empty()) return "{}";
  const std::string name = fmt::format("k{}{}", type_name(k.id), what);
  std::vector<std::string> literals;
  literals.reserve(texts.size());
  for (const std::string& text : texts) literals.push_back(literal(text));
  arrays += fmt::format("inline constexpr std::array<std::string_view, {}> {}{{{}}};\n", texts.size(), name,
                        fmt::join(literals, ", "));
  return name;
}

}  // namespace

std::string key_values(const Registry& registry) {
  std::string enumerations;
  std::string members;
  const Keys keys(registry);
  for (const Key& k : keys.list()) {
    std::vector<std::string> names;
    names.reserve(k.values.size());
    for (const std::string& value : k.values) names.push_back(enumerator(k.id, value));
    if (!k.boolean)
      enumerations += fmt::format("enum class {} : std::uint8_t {{ {} }};\n", k.type, fmt::join(names, ", "));
    members += fmt::format("  {} {} = {};\n", k.type, k.id, value_of(k));
  }
  return fmt::format(kValuesFile, enumerations, members);
}

std::string key_table(const Registry& registry) {
  const Keys keys(registry);
  std::string arrays;
  std::string rows;
  for (const Key& k : keys.list()) {
    const std::string values = array(k, "Values", k.values, arrays);
    const std::string words = array(k, "Words", k.words, arrays);
    const std::string clauses = array(k, "Clauses", k.clauses, arrays);
    rows += fmt::format(
        "    KeyInfo{{{}, {{{}, {}}}, {}, {}, {}, {}, '{}', {}, {},\n      {},\n      {{{}, {}}},\n      {{{}, {}}},\n"
        "      [](const SetupKeys& keys) {{ return static_cast<std::size_t>(keys.{}); }},\n"
        "      [](SetupKeys& keys, std::size_t value) {{ keys.{} = {}; }}}},\n",
        literal(k.id), k.fanuc, k.heidenhain, k.boolean, values, k.default_value, k.always, k.letter, words, k.percent,
        clauses, literal(k.text), literal(k.heidenhain_text), literal(k.comment), literal(k.heidenhain_comment), k.id,
        k.id, k.boolean ? std::string("value != 0") : fmt::format("static_cast<{}>(value)", k.type));
  }
  return fmt::format(kTableFile, arrays, keys.list().size(), rows);
}

}  // namespace toolcomp::spec

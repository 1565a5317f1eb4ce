// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "spec/language/alarm.h"
#include "spec/language/json_text.h"
#include "spec/language/setup_format.h"
#include "spec/language/setup_key.h"

namespace toolcomp::spec {
namespace {

constexpr std::array<std::string_view, 2> kControls = {"fanuc", "heidenhain"};
constexpr std::array<std::string_view, 3> kMemories = {"A", "B", "C"};

enum class Format : std::uint8_t { toml, json };
using Pair = std::pair<std::string, std::string>;  // key and value, both as text of the format

template <std::size_t N, class Enum>
std::string name(const std::array<std::string_view, N>& names, Enum value) {
  return '"' + std::string(names[static_cast<std::size_t>(value)]) + '"';
}

// Integers plain, everything else quoted, so that no reader of TOML or JSON makes a double of it.
std::string number(const Decimal& value) {
  std::string text = to_string(value);
  if (value.is_integer() && !value.point && !(value.negative && value.is_zero())) return text;
  const std::size_t first = value.negative ? 1 : 0;
  if (text[first] == '.') text.insert(first, 1, '0');
  return '"' + text + '"';
}

std::string entry(const OffsetEntry& value, Format format) {
  if (value.wear == Decimal{}) return number(value.geometry);
  if (format == Format::json)
    return R"({"geometry":)" + number(value.geometry) + R"(,"wear":)" + number(value.wear) + '}';
  return "{ geometry = " + number(value.geometry) + ", wear = " + number(value.wear) + " }";
}

// A table of the setup. Empty ones are not written.
struct Table {
  std::string group;  // "offsets" of [offsets.H]; empty for [parameters]
  std::string name;
  std::vector<Pair> pairs;
};

std::vector<Table> tables(const Setup& setup, Format format) {
  std::vector<Table> list;
  const auto add = [&list](std::string group, std::string title, std::vector<Pair> pairs) {
    if (!pairs.empty()) list.push_back({std::move(group), std::move(title), std::move(pairs)});
  };
  const auto key = [format](const std::string& text, bool bare) {
    return format == Format::toml && bare ? text : '"' + text + '"';
  };
  const auto entries = [&](const std::map<std::uint32_t, OffsetEntry>& memory) {
    std::vector<Pair> pairs;
    pairs.reserve(memory.size());
    for (const auto& [index, value] : memory)
      pairs.emplace_back(key(std::to_string(index), true), entry(value, format));
    return pairs;
  };
  const auto axes = [&](const AxisTable& table) {
    std::vector<Pair> pairs;
    pairs.reserve(table.size());
    for (const auto& [letter, value] : table) pairs.emplace_back(key(std::string(1, letter), true), number(value));
    return pairs;
  };

  std::vector<Pair> parameters;
  for (const auto& [id, value] : setup.parameters) {
    const std::string bit = id.bit < 0 ? std::string() : '#' + std::to_string(id.bit);
    parameters.emplace_back(key(std::to_string(id.number) + bit, bit.empty()), number(value));
  }
  add("", "parameters", std::move(parameters));
  std::vector<Pair> alarms;
  alarms.reserve(setup.alarms.size());
  for (const auto& [cause, shown] : setup.alarms)
    alarms.emplace_back(key(std::string(info(cause).name), true), '"' + shown + '"');
  add("", "alarms", std::move(alarms));
  add("offsets", "H", entries(setup.h));
  add("offsets", "D", entries(setup.d));
  for (std::size_t i = 0; i < setup.workpiece.size(); ++i)
    add("workpiece", "G5" + std::to_string(4 + i), axes(setup.workpiece[i]));
  for (const auto& [index, table] : setup.additional_workpiece)
    add("workpiece", index == 0 ? "external" : "P" + std::to_string(index), axes(table));
  add("", "position", axes(setup.position));
  for (const auto& [index, table] : setup.reference) add("reference", std::to_string(index), axes(table));
  add("reference", "floating", axes(setup.floating_reference));
  add("", "measurement", axes(setup.measurement));
  return list;
}

// A list of tables: [[tool]] and the like, in the order of the text.
struct Rows {
  std::string group;  // "correction" of [[correction.tcs]]
  std::string name;
  std::vector<std::vector<Pair>> rows;
};

std::string toml_text(std::string_view text) {
  std::string quotes;
  append_json_string(quotes, text);  // what TOML escapes, JSON escapes alike; names have no control characters
  return quotes;
}

std::vector<Pair> tool_row(const ToolRow& tool) {
  const std::string text = std::to_string(tool.number / 10);
  std::vector<Pair> row{
      {"number", tool.number % 10 == 0 ? text : '"' + text + '.' + std::to_string(tool.number % 10) + '"'}};
  if (!tool.name.empty()) row.emplace_back("name", toml_text(tool.name));
  const auto add = [&row](const char* key, const Decimal& value) {
    if (value != Decimal{}) row.emplace_back(key, number(value));
  };
  add("R", tool.r);
  add("R2", tool.r2);
  if (tool.l) row.emplace_back("L", number(*tool.l));
  add("DL", tool.dl);
  add("DR", tool.dr);
  add("DR2", tool.dr2);
  if (!tool.dr2_table.empty()) row.emplace_back("DR2TABLE", toml_text(tool.dr2_table));
  return row;
}

std::vector<Pair> correction_row(std::uint32_t index, const CorrectionRow& correction) {
  std::vector<Pair> row{{"number", std::to_string(index)}};
  if (correction.dl != Decimal{}) row.emplace_back("DL", number(correction.dl));
  if (correction.dr != Decimal{}) row.emplace_back("DR", number(correction.dr));
  if (correction.dr2 != Decimal{}) row.emplace_back("DR2", number(correction.dr2));
  return row;
}

std::vector<Pair> deviation_row(const std::string& name, const DeviationTable& table) {
  std::string points;
  for (const auto& [angle, deviation] : table)
    points += (points.empty() ? "[" : ",[") + number(angle) + ',' + number(deviation) + ']';
  return {{"name", toml_text(name)}, {"points", '[' + points + ']'}};
}

// The tables of Heidenhain; all empty under another control.
std::array<Rows, 3> tool_tables(const Setup& setup) {
  std::array<Rows, 3> lists{{{"", "tool", {}}, {"correction", "tcs", {}}, {"", "dr2table", {}}}};
  for (const ToolRow& tool : setup.tools) lists[0].rows.push_back(tool_row(tool));
  for (const auto& [index, row] : setup.tcs) lists[1].rows.push_back(correction_row(index, row));
  for (const auto& [name, table] : setup.dr2_tables) lists[2].rows.push_back(deviation_row(name, table));
  return lists;
}

std::string axis_list(const Axes& axes) {
  std::string list;
  for (const char letter : axes.letters()) list += (list.empty() ? "\"" : ",\"") + std::string(1, letter) + '"';
  return '[' + list + ']';
}

// A second reading of the manual is written only where it is chosen.
std::vector<Pair> plain_keys(const Setup& setup) {
  std::vector<Pair> pairs{{"control", name(kControls, setup.control)}};
  for (const KeyInfo& key : keys()) {
    if (key.is_of(setup.control) && (key.always || !key.is_default(setup)))
      pairs.emplace_back(key.id, value_text(key, key.get(setup)));
    if (key.id == kKeyBeforeAxes) pairs.emplace_back("axes", axis_list(setup.axes));
  }
  return pairs;
}

// Members of a JSON object, with commas between them.
class Members {
 public:
  void add(std::string_view key, std::string_view value) { add_quoted('"' + std::string(key) + '"', value); }
  void add_quoted(std::string_view key, std::string_view value) {
    if (!text_.empty()) text_ += ',';
    text_.append(key).append(1, ':').append(value);
  }
  [[nodiscard]] std::string object() const { return '{' + text_ + '}'; }

 private:
  std::string text_;
};

}  // namespace

std::string write_setup_toml(const Setup& setup) {
  std::string text;
  const auto write = [&text](const std::vector<Pair>& pairs) {
    for (const auto& [key, value] : pairs) text.append(key).append(" = ").append(value).append(1, '\n');
  };
  write(plain_keys(setup));
  if (setup.control == Control::fanuc) {
    text += "\n[offsets]\nmemory = " + name(kMemories, setup.memory) + '\n';
    text += "count = " + std::to_string(setup.offset_count) + '\n';
  }
  for (const Table& table : tables(setup, Format::toml)) {
    text += "\n[" + table.group + (table.group.empty() ? "" : ".") + table.name + "]\n";
    write(table.pairs);
  }
  for (const Rows& list : tool_tables(setup))
    for (const std::vector<Pair>& row : list.rows) {
      text += "\n[[" + list.group + (list.group.empty() ? "" : ".") + list.name + "]]\n";
      write(row);
    }
  return text;
}

std::string write_setup_json(const Setup& setup) {
  Members root;
  for (const auto& [key, value] : plain_keys(setup)) root.add(key, value);
  const std::vector<Table> all = tables(setup, Format::json);
  const auto object = [](const Table& table) {
    Members members;
    for (const auto& [key, value] : table.pairs) members.add_quoted(key, value);
    return members.object();
  };
  const auto group = [&](std::string_view title, Members members, bool always) {
    bool any = always;
    for (const Table& table : all)
      if (table.group == title) members.add(table.name, object(table)), any = true;
    if (any) root.add(title, members.object());
  };
  const auto single = [&](std::string_view title) {
    for (const Table& table : all)
      if (table.group.empty() && table.name == title) root.add(title, object(table));
  };
  single("parameters");
  single("alarms");
  if (setup.control == Control::fanuc) {
    Members offsets;
    offsets.add("memory", name(kMemories, setup.memory));
    offsets.add("count", std::to_string(setup.offset_count));
    group("offsets", offsets, true);
  }
  group("workpiece", {}, false);
  single("position");
  group("reference", {}, false);
  single("measurement");
  for (const Rows& list : tool_tables(setup)) {
    if (list.rows.empty()) continue;
    std::string items;
    for (const std::vector<Pair>& row : list.rows) {
      Members members;
      for (const auto& [key, value] : row) members.add(key, value);
      items += (items.empty() ? "" : ",") + members.object();
    }
    const std::string rows = '[' + items + ']';
    if (list.group.empty()) {
      root.add(list.name, rows);
    } else {
      Members members;
      members.add(list.name, rows);
      root.add(list.group, members.object());
    }
  }
  return root.object();
}

}  // namespace toolcomp::spec

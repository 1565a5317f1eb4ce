// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>

#include "spec/language/decimal_order.h"
#include "spec/language/setup_document.h"

namespace toolcomp::spec {
namespace {

using document::in_quotes;
using document::Kind;
using document::Node;
using document::Reader;

constexpr std::uint64_t kMostTool = 32767;
constexpr std::uint64_t kMostRow = 999'999'999;
constexpr std::size_t kLongestName = 32;

const Node& required(const Node& node, std::string_view name, std::string_view key, const Reader& read) {
  const Node* found = node.find(key);
  if (found == nullptr) read.fail(node.at, std::string(name) + ": without " + std::string(key));
  return *found;
}

Decimal optional_decimal(const Node& node, const std::string& name, std::string_view key, const Reader& read) {
  const Node* found = node.find(key);
  return found == nullptr ? Decimal{} : read.decimal(*found, name + "." + std::string(key));
}

// What a program can write in quotes.
const std::string& name_from(const Node& node, const std::string& name, const Reader& read) {
  const std::string& text = read.string(node, name);
  const auto never_in_quotes = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7F || c == '"';
  };
  if (text.empty() || text.size() > kLongestName || std::ranges::any_of(text, never_in_quotes))
    read.fail(node.at, name + ": expected 1 to " + std::to_string(kLongestName) +
                           " characters without quotes and control characters, found " + in_quotes(text));
  return text;
}

// In tenths: a tool number, or one with an index from .1 to .9.
std::uint32_t tool_number(const Node& node, const Reader& read) {
  const Decimal value = read.decimal(node, "tool.number");
  const std::uint64_t tenths = value.point ? value.digits : value.digits * 10;
  const bool index = value.point && value.decimals == 1 && tenths % 10 != 0;
  if (value.negative || value.point != index || value.digits > kMostTool * 10 + 9 || tenths < 10 ||
      tenths > kMostTool * 10 + 9)
    read.fail(node.at, "tool.number: expected a number from 1 to " + std::to_string(kMostTool) +
                           R"(, or one with an index such as "5.1", found )" + in_quotes(node.text));
  return static_cast<std::uint32_t>(tenths);
}

ToolRow tool_from(const Node& node, const Reader& read) {
  read.keys(node, "tool", {"number", "name", "R", "R2", "L", "DL", "DR", "DR2", "DR2TABLE"});
  ToolRow row;
  row.number = tool_number(required(node, "tool", "number", read), read);
  if (const Node* name = node.find("name")) row.name = name_from(*name, "tool.name", read);
  row.r = optional_decimal(node, "tool", "R", read);
  row.r2 = optional_decimal(node, "tool", "R2", read);
  if (const Node* length = node.find("L")) row.l = read.decimal(*length, "tool.L");
  row.dl = optional_decimal(node, "tool", "DL", read);
  row.dr = optional_decimal(node, "tool", "DR", read);
  row.dr2 = optional_decimal(node, "tool", "DR2", read);
  if (const Node* table = node.find("DR2TABLE")) row.dr2_table = name_from(*table, "tool.DR2TABLE", read);
  return row;
}

void read_tools(const Node& node, const Reader& read, Setup& setup) {
  read.expect(node, Kind::array, "tool");
  std::set<std::uint32_t> numbers;
  std::set<std::string> names;
  for (const Node& item : node.items) {
    ToolRow row = tool_from(item, read);
    if (!numbers.insert(row.number).second)
      read.fail(item.find("number")->at, "tool.number: tool " + item.find("number")->text + " is given twice");
    if (!row.name.empty() && !names.insert(row.name).second)
      read.fail(item.find("name")->at, "tool.name: the name " + in_quotes(row.name) + " is given twice");
    if (!row.dr2_table.empty() && !setup.dr2_tables.contains(row.dr2_table))
      read.fail(item.find("DR2TABLE")->at, "tool.DR2TABLE: there is no [[dr2table]] named " + in_quotes(row.dr2_table));
    setup.tools.push_back(std::move(row));
  }
}

void read_corrections(const Node& node, const Reader& read, Setup& setup) {
  read.keys(node, "correction", {"tcs"});
  const Node* rows = node.find("tcs");
  if (rows == nullptr) return;
  read.expect(*rows, Kind::array, "correction.tcs");
  for (const Node& item : rows->items) {
    read.keys(item, "correction.tcs", {"number", "DL", "DR", "DR2"});
    const Node& number = required(item, "correction.tcs", "number", read);
    const auto key = static_cast<std::uint32_t>(read.integer(number, "correction.tcs.number", 0, kMostRow));
    const CorrectionRow row{optional_decimal(item, "correction.tcs", "DL", read),
                            optional_decimal(item, "correction.tcs", "DR", read),
                            optional_decimal(item, "correction.tcs", "DR2", read)};
    if (!setup.tcs.emplace(key, row).second)
      read.fail(number.at, "correction.tcs.number: row " + number.text + " is given twice");
  }
}

DeviationTable deviations_from(const Node& node, const Reader& read) {
  read.expect(node, Kind::array, "dr2table.points");
  if (node.items.empty()) read.fail(node.at, "dr2table.points: expected at least one point");
  DeviationTable table;
  for (const Node& item : node.items) {
    read.expect(item, Kind::array, "dr2table.points");
    if (item.items.size() != 2) read.fail(item.at, "dr2table.points: expected [angle, deviation]");
    const Decimal angle = read.decimal(item.items[0], "dr2table.points");
    if (compare(angle, decimal(0)) < 0 || compare(angle, decimal(180)) > 0)
      read.fail(item.at,
                "dr2table.points: expected an angle from 0 to 180 degrees, found " + in_quotes(item.items[0].text));
    if (!table.empty() && compare(angle, table.back().first) <= 0)
      read.fail(item.at, "dr2table.points: the angles must ascend; they do not at " + in_quotes(item.items[0].text));
    table.emplace_back(angle, read.decimal(item.items[1], "dr2table.points"));
  }
  return table;
}

void read_deviations(const Node& node, const Reader& read, Setup& setup) {
  read.expect(node, Kind::array, "dr2table");
  for (const Node& item : node.items) {
    read.keys(item, "dr2table", {"name", "points"});
    const Node& key = required(item, "dr2table", "name", read);
    const std::string& name = name_from(key, "dr2table.name", read);
    if (!setup.dr2_tables.emplace(name, deviations_from(required(item, "dr2table", "points", read), read)).second)
      read.fail(key.at, "dr2table.name: the table " + in_quotes(name) + " is given twice");
  }
}

}  // namespace

void read_tool_tables(const Node& node, const Reader& read, Setup& setup) {
  if (const Node* tables = node.find("dr2table")) read_deviations(*tables, read, setup);  // tools name them
  if (const Node* tools = node.find("tool")) read_tools(*tools, read, setup);
  if (const Node* corrections = node.find("correction")) read_corrections(*corrections, read, setup);
}

}  // namespace toolcomp::spec

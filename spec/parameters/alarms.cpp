// SPDX-License-Identifier: Apache-2.0
#include "spec/parameters/alarms.h"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <iterator>
#include <string_view>

#include "spec/generated_source.h"

namespace toolcomp::spec {
namespace {

constexpr std::string_view kKeys[] = {"number", "16i", "30i", "text", "source"};

constexpr std::string_view kCausesFile = R"(// Generated from the table of alarms. Do not edit.
#pragma once

#include <cstdint>

namespace toolcomp::spec {{

// Why a control raises an alarm (spec/alarms.toml); none: no alarm.
enum class AlarmCause : std::uint8_t {{
  none,
{}}};

}}  // namespace toolcomp::spec
)";

constexpr std::string_view kTableFile = R"(// Generated from the table of alarms. Do not edit.
#pragma once

#include <array>

#include "spec/language/alarm.h"

namespace toolcomp::spec {{

inline constexpr std::array<AlarmInfo, {}> kAlarms{{{{
{}}}}};

}}  // namespace toolcomp::spec
)";

// arc-without-center: arc_without_center.
std::string enumerator(std::string cause) {
  std::ranges::replace(cause, '-', '_');
  return cause;
}

}  // namespace

AlarmTable::AlarmTable(const std::filesystem::path& file) {
  const toml::table root = toml::parse_file(file.string());
  for (const auto& [cause, node] : root) {
    const toml::table* entry = node.as_table();
    if (entry == nullptr) fail(file, node.source(), "a table of a cause must stand here");
    if (cause.str().find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") != std::string_view::npos ||
        cause.str()[0] < 'a' || cause.str() == "none")
      fail(file, cause.source(), "a cause is a word of lower-case letters, digits and -");
    for (const auto& [key, value] : *entry)
      if (std::ranges::find(kKeys, key.str()) == std::end(kKeys) || !value.is_string() ||
          value.value_or(std::string()).empty())
        fail(file, value.source(), "number, 16i, 30i, text and source are texts");
    const auto text = [&](std::string_view key, const std::string& otherwise) {
      return (*entry)[key].value_or(otherwise);
    };
    const std::string number = text("number", "");
    Row row{std::string(cause.str()), text("16i", number), text("30i", number),
            text("text", ""),         text("source", ""),  node.source().begin.line};
    if (row.number_16i.empty() && row.number_30i.empty())
      fail(file, node.source(), "number, 16i or 30i must stand here");
    if (row.text.empty() || row.source.empty()) fail(file, node.source(), "text and source must stand here");
    rows_.push_back(std::move(row));
  }
  std::ranges::sort(rows_, {}, &Row::line);
}

std::string AlarmTable::causes() const {
  std::string names;
  for (const Row& row : rows_) names += fmt::format("  {},\n", enumerator(row.cause));
  return fmt::format(kCausesFile, names);
}

std::string AlarmTable::table() const {
  std::string rows;
  for (const Row& row : rows_)
    rows +=
        fmt::format("    AlarmInfo{{AlarmCause::{}, {}, {}, {}, {}, {}}},\n", enumerator(row.cause), literal(row.cause),
                    literal(row.number_16i), literal(row.number_30i), literal(row.text), literal(row.source));
  return fmt::format(kTableFile, rows_.size(), rows);
}

}  // namespace toolcomp::spec

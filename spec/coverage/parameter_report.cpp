// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <utility>

#include "spec/coverage/report.h"
#include "spec/language/alarm.h"
#include "spec/language/json_text.h"
#include "spec/language/parameter.h"
#include "spec/language/setup_key.h"

namespace toolcomp::spec {
namespace {

constexpr std::array<std::string_view, 6> kTypes{"bit", "integer", "decimal", "length", "angle", "axis"};

std::string_view type_name(ParameterType type) { return kTypes.at(static_cast<std::size_t>(type)); }

// A list with one separator, as one with another.
std::string joined(std::string_view list, char separator, std::string_view with) {
  std::string text;
  for (const char c : list) c == separator ? text += with : text += c;
  return text;
}

// What a value may be, for people.
std::string values_text(const ParameterInfo& p) {
  if (p.type == ParameterType::bit) return is_not_supported(p) ? "0" : "0, 1";
  if (p.type == ParameterType::axis) return "0 to the number of axes";
  return p.values.empty() ? fmt::format("{} to {}", to_string(p.least), to_string(p.greatest))
                          : joined(p.values, ' ', ", ");
}

// Keys and what rules them, of both controls.
std::string keys_markdown() {
  std::string out = "| key | control | values | default | meaning | clauses |\n|---|---|---|---|---|---|\n";
  for (const KeyInfo& key : keys()) {
    const bool both = key.is_of(Control::fanuc) && key.is_of(Control::heidenhain);
    const std::string_view control = both ? "both" : key.is_of(Control::fanuc) ? "fanuc" : "heidenhain";
    const bool other_text = key.text[0] != key.text[1];
    out += fmt::format("| `{}` | {} | {} | {} | {}{} | `{}` |\n", key.id, control, fmt::join(key.values, ", "),
                       key.values[key.default_value], key.text[0],
                       other_text ? fmt::format(" Heidenhain: {}", key.text[1]) : std::string(),
                       fmt::join(key.clauses, "`, `"));
  }
  return out;
}

std::string keys_json() {
  std::string out = "[";
  for (const KeyInfo& key : keys()) {
    std::string values;
    for (std::size_t i = 0; i < key.values.size(); ++i) values += (i == 0 ? "" : ",") + value_text(key, i);
    std::string text;
    append_json_string(text, key.text[key.is_of(Control::fanuc) ? 0 : 1]);
    out += fmt::format(
        R"({}{{"id":"{}","fanuc":{},"heidenhain":{},"values":[{}],"default":{},"text":{},"clauses":["{}"]}})",
        out.size() == 1 ? "\n" : ",\n", key.id, key.is_of(Control::fanuc), key.is_of(Control::heidenhain), values,
        value_text(key, key.default_value), text, fmt::join(key.clauses, "\",\""));
  }
  return out + "]\n";
}

std::string markdown() {
  std::string out = "| parameter | type | values | default | meaning | clauses |\n|---|---|---|---|---|---|\n";
  for (const ParameterInfo& p : parameters()) {
    const std::string type =
        p.unit.empty() ? std::string(type_name(p.type)) : fmt::format("{}, {}", type_name(p.type), p.unit);
    out += fmt::format("| {} | {} | {} | {} | {} | `{}` |\n", to_string(p.id), type, values_text(p),
                       p.default_value ? to_string(*p.default_value) : "", p.text, joined(p.clauses, '\n', "`, `"));
  }
  return out;
}

std::string json() {
  std::string out = "[";
  const auto member = [&out](std::string_view key, std::string_view text) {
    if (text.empty()) return;
    out += fmt::format("{}\"{}\":", out.back() == '{' ? "" : ",", key);
    append_json_string(out, text);
  };
  const auto list = [&out](std::string_view key, std::string_view items, char separator, std::string_view quote) {
    if (!items.empty())
      out +=
          fmt::format(",\"{}\":[{}{}{}]", key, quote, joined(items, separator, fmt::format("{0},{0}", quote)), quote);
  };
  for (const ParameterInfo& p : parameters()) {
    out += out.size() == 1 ? "\n{" : ",\n{";
    member("id", to_string(p.id));
    member("type", type_name(p.type));
    if (p.values.empty()) {
      member("least", to_string(p.least));
      member("greatest", to_string(p.greatest));
    }
    list("values", p.values, ' ', "");
    if (p.default_value) member("default", to_string(*p.default_value));
    member("unit", p.unit);
    member("text", p.text);
    list("clauses", p.clauses, '\n', "\"");
    out += '}';
  }
  return out + "]\n";
}

std::string alarms_markdown() {
  std::string out = "| cause | 16i | 30i | text | source |\n|---|---|---|---|---|\n";
  for (const AlarmInfo& a : alarms())
    out += fmt::format("| `{}` | {} | {} | {} | {} |\n", a.name, a.number_16i, a.number_30i, a.text, a.source);
  return out;
}

std::string alarms_json() {
  std::string out = "[";
  for (const AlarmInfo& a : alarms()) {
    out += fmt::format(R"({}{{"cause":"{}")", out.size() == 1 ? "\n" : ",\n", a.name);
    for (const auto& [key, text] : {std::pair<std::string_view, std::string_view>{"16i", a.number_16i},
                                    {"30i", a.number_30i},
                                    {"text", a.text},
                                    {"source", a.source}}) {
      if (text.empty()) continue;
      out += fmt::format(",\"{}\":", key);
      append_json_string(out, text);
    }
    out += '}';
  }
  return out + "]\n";
}

}  // namespace

std::string list_keys(ReportFormat format) { return format == ReportFormat::json ? keys_json() : keys_markdown(); }

std::string list_parameters(ReportFormat format) { return format == ReportFormat::json ? json() : markdown(); }

std::string list_alarms(ReportFormat format) {
  return format == ReportFormat::json ? alarms_json() : alarms_markdown();
}

}  // namespace toolcomp::spec

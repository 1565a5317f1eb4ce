// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <string>

#include "spec/language/alarm.h"
#include "spec/language/json_text.h"
#include "spec/language/parameter.h"
#include "spec/language/setup_format.h"
#include "spec/language/setup_key.h"

namespace toolcomp::spec {
namespace {

constexpr std::string_view kSchemaHead = R"schema({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "$id": "setup.schema.json",
  "title": "Setup of a control",
  "description": "A TOML file, or the setup of a case. Decimals are exact. Write them as numbers or in quotes, without exponent and with at most 18 digits.",
  "oneOf": [{ "$ref": "#/$defs/fanuc" }, { "$ref": "#/$defs/heidenhain" }],
  "$defs": {
)schema";

constexpr std::string_view kSchemaFanucHead = R"schema(    "fanuc": {
      "description": "A FANUC control.",
      "type": "object",
      "additionalProperties": false,
      "properties": {
        "control": { "description": "The control whose rules apply.", "const": "fanuc", "default": "fanuc" },
)schema";

constexpr std::string_view kSchemaAlarmsTail = R"schema(] },
      "additionalProperties": { "type": "string", "pattern": "^[A-Za-z0-9_/.-]{1,32}$" }
    },
)schema";

constexpr std::string_view kSchemaFanucAxes = R"schema(        "axes": {
          "description": "Controlled axes 1, 2, 3, … in order. Parameters such as 19681 use these numbers.",
          "type": "array", "items": { "enum": ["A", "B", "C", "U", "V", "W", "X", "Y", "Z"] },
          "minItems": 1, "maxItems": 9, "uniqueItems": true, "default": ["X", "Y", "Z"]
        },
)schema";

constexpr std::string_view kSchemaParameters = R"schema(        "parameters": {
          "description": "Parameters by number, bits by number#bit.",
          "type": "object", "additionalProperties": false,
          "properties": {
)schema";

constexpr std::string_view kSchemaFanucTables = R"schema(
          }
        },
        "alarms": { "$ref": "#/$defs/alarms" },
        "offsets": {
          "description": "Tool offset memory.",
          "type": "object", "additionalProperties": false,
          "properties": {
            "memory": { "description": "A: one value for each entry. B: geometry and wear. C: as B, separate for H and D. Default: A if all entries are plain numbers, else C.", "enum": ["A", "B", "C"] },
            "count": { "description": "Number of entries.", "type": "integer", "minimum": 1, "maximum": 999, "default": 400 },
            "H": { "$ref": "#/$defs/entries" },
            "D": { "$ref": "#/$defs/entries" }
          }
        },
        "workpiece": {
          "description": "Workpiece origins in machine coordinates.",
          "type": "object", "additionalProperties": false,
          "patternProperties": { "^P([1-9]|[1-3][0-9]|4[0-8])$": { "description": "G54.1 P1 to P48.", "$ref": "#/$defs/axis_values" } },
          "properties": {
            "external": { "description": "Added to all workpiece origins.", "$ref": "#/$defs/axis_values" },
            "G54": { "$ref": "#/$defs/axis_values" }, "G55": { "$ref": "#/$defs/axis_values" }, "G56": { "$ref": "#/$defs/axis_values" },
            "G57": { "$ref": "#/$defs/axis_values" }, "G58": { "$ref": "#/$defs/axis_values" }, "G59": { "$ref": "#/$defs/axis_values" }
          }
        },
        "position": { "description": "Position at which the program starts: workpiece coordinates without offsets. Default: 0.", "$ref": "#/$defs/axis_values" },
        "reference": {
          "description": "Reference points 1 to 4 (G28, G30) and the floating reference point (G30.1), in machine coordinates.",
          "type": "object", "additionalProperties": false,
          "properties": {
            "1": { "$ref": "#/$defs/axis_values" }, "2": { "$ref": "#/$defs/axis_values" }, "3": { "$ref": "#/$defs/axis_values" },
            "4": { "$ref": "#/$defs/axis_values" }, "floating": { "$ref": "#/$defs/axis_values" }
          }
        },
        "measurement": { "description": "G37: axis positions at which the approach-end signal comes on, in workpiece coordinates without offsets. Without them the signal never comes.", "$ref": "#/$defs/axis_values" }
      }
    },
    "heidenhain": {
      "description": "A Heidenhain control. Its programs are Klartext.",
      "type": "object",
      "additionalProperties": false,
      "required": ["control"],
      "properties": {
        "control": { "description": "The control whose rules apply.", "const": "heidenhain" },
)schema";

constexpr std::string_view kSchemaHeidenhainAxes = R"schema(        "axes": {
          "description": "Axes that a program may name. X, Y and Z must be among them.",
          "type": "array", "items": { "enum": ["A", "B", "C", "U", "V", "W", "X", "Y", "Z"] },
          "allOf": [{ "contains": { "const": "X" } }, { "contains": { "const": "Y" } }, { "contains": { "const": "Z" } }],
          "maxItems": 9, "uniqueItems": true, "default": ["X", "Y", "Z", "A", "B", "C"]
        },
)schema";

constexpr std::string_view kSchemaHeidenhainTables =
    R"schema(        "alarms": { "$ref": "#/$defs/alarms" },
        "position": { "description": "Position at which the program starts, in workpiece coordinates. Default: 0.", "$ref": "#/$defs/axis_values" },
        "tool": {
          "description": "Rows of the tool table, in mm. Each number and each name occurs once.",
          "type": "array",
          "items": {
            "type": "object", "additionalProperties": false, "required": ["number"],
            "properties": {
              "number": {
                "description": "1 to 32767. An index from .1 to .9 may follow.",
                "oneOf": [
                  { "type": "number", "minimum": 1, "maximum": 32767.9 },
                  { "type": "string", "pattern": "^([1-9][0-9]{0,3}|[12][0-9]{4}|3[01][0-9]{3}|32[0-6][0-9]{2}|327[0-5][0-9]|3276[0-7])(\\.[1-9])?$" }
                ]
              },
              "name": { "$ref": "#/$defs/name" },
              "R": { "description": "Tool radius.", "$ref": "#/$defs/decimal" },
              "R2": { "description": "Corner radius.", "$ref": "#/$defs/decimal" },
              "L": { "description": "Overall length up to the tip. Default: unknown.", "$ref": "#/$defs/decimal" },
              "DL": { "$ref": "#/$defs/decimal" }, "DR": { "$ref": "#/$defs/decimal" }, "DR2": { "$ref": "#/$defs/decimal" },
              "DR2TABLE": { "description": "The name of a dr2table.", "$ref": "#/$defs/name" }
            }
          }
        },
        "correction": {
          "description": "Compensation tables.",
          "type": "object", "additionalProperties": false,
          "properties": {
            "tcs": {
              "description": "Rows of the compensation table in the tool system (.tco), in mm. Each number occurs once.",
              "type": "array",
              "items": {
                "type": "object", "additionalProperties": false, "required": ["number"],
                "properties": {
                  "number": { "type": "integer", "minimum": 0, "maximum": 999999999 },
                  "DL": { "$ref": "#/$defs/decimal" }, "DR": { "$ref": "#/$defs/decimal" }, "DR2": { "$ref": "#/$defs/decimal" }
                }
              }
            }
          }
        },
        "dr2table": {
          "description": "Deviations of the corner radius for each contact angle (3D-ToolComp). Each name occurs once.",
          "type": "array",
          "items": {
            "type": "object", "additionalProperties": false, "required": ["name", "points"],
            "properties": {
              "name": { "$ref": "#/$defs/name" },
              "points": {
                "description": "Pairs of angle (0 to 180 degrees, strictly ascending) and deviation (mm).",
                "type": "array", "minItems": 1,
                "items": {
                  "type": "array", "minItems": 2, "items": false,
                  "prefixItems": [{ "$ref": "#/$defs/decimal", "minimum": 0, "maximum": 180 }, { "$ref": "#/$defs/decimal" }]
                }
              }
            }
          }
        }
      }
    },
    "name": { "description": "At most 32 bytes.", "type": "string", "minLength": 1, "maxLength": 32, "pattern": "^[^\"\\u0000-\\u001F\\u007F]*$" },
    "decimal": {
      "oneOf": [
        { "type": "number" },
        { "type": "string", "pattern": "^[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)$" }
      ]
    },
    "whole": {
      "description": "A number without decimals. In quotes it has at most seven digits, because eight digits would be a row of bits.",
      "oneOf": [{ "type": "integer" }, { "type": "string", "pattern": "^[+-]?[0-9]{1,7}(\\.0*)?$" }]
    },
    "entries": {
      "description": "Entries by offset number, in the units of the setup.",
      "type": "object", "additionalProperties": false,
      "patternProperties": {
        "^[1-9][0-9]{0,2}$": {
          "oneOf": [
            { "$ref": "#/$defs/decimal" },
            {
              "type": "object", "additionalProperties": false,
              "properties": { "geometry": { "$ref": "#/$defs/decimal" }, "wear": { "$ref": "#/$defs/decimal" } }
            }
          ]
        }
      }
    },
    "axis_values": {
      "description": "Values by axis letter, in the units of the setup; degrees for A, B and C.",
      "type": "object", "additionalProperties": false,
      "patternProperties": { "^[ABCUVWXYZ]$": { "$ref": "#/$defs/decimal" } }
    }
  }
}
)schema";

// The only values, as numbers and in quotes.
std::string enumeration(std::string_view values) {
  std::string numbers;
  std::string texts;
  while (!values.empty()) {
    const std::size_t end = values.find(' ');
    const std::string value(values.substr(0, end));
    numbers += value + ", ";
    texts += (texts.empty() ? "\"" : ", \"") + value + '"';
    values.remove_prefix(end == std::string_view::npos ? values.size() : end + 1);
  }
  return "\"enum\": [" + numbers + texts + ']';
}

std::string bounds(const ParameterInfo& p) {
  const std::string type = p.type == ParameterType::integer || p.type == ParameterType::axis ? "whole" : "decimal";
  return R"("$ref": "#/$defs/)" + type + R"(", "minimum": )" + to_string(p.least) + R"(, "maximum": )" +
         to_string(p.greatest);
}

std::string description(const ParameterInfo& p) {
  std::string text;
  append_json_string(text, std::string(p.text) + (p.unit.empty() ? std::string() : " In " + std::string(p.unit) + '.'));
  return R"({ "description": )" + text + ", ";
}

// The text, and behind it the clauses of that control.
std::string description(const KeyInfo& key, Control control) {
  std::string text(key.text[static_cast<std::size_t>(control)]);
  text.pop_back();  // the point
  std::string ids;
  for (const std::string_view id : key.clauses)
    if (id.starts_with(control == Control::fanuc ? "fanuc." : "heidenhain."))
      ids.append(ids.empty() ? "" : ", ").append(id);
  std::string json;
  append_json_string(json, text + " (" + ids + ").");
  return json;
}

std::string key_property(const KeyInfo& key, Control control) {
  std::string values;
  for (std::size_t i = 0; i < key.values.size(); ++i) values += (i == 0 ? "" : ", ") + value_text(key, i);
  return "        \"" + std::string(key.id) + R"(": { "description": )" + description(key, control) +
         (key.boolean ? R"(, "type": "boolean")" : R"(, "enum": [)" + values + ']') + R"(, "default": )" +
         value_text(key, key.default_value) + " },\n";
}

// The keys of a control, with its axes among them.
std::string key_properties(Control control, std::string_view axes) {
  std::string text;
  for (const KeyInfo& key : keys()) {
    if (key.is_of(control)) text += key_property(key, control);
    if (key.id == kKeyBeforeAxes) text += axes;
  }
  return text;
}

// Numbers of which bits are known may be given as a whole; parameters ascend, so their bits stand together.
std::string parameter_properties() {
  std::string text;
  std::uint32_t last = 0;
  const auto add = [&text](ParameterId id, const std::string& schema) {
    text.append(text.empty() ? "" : ",\n").append(12, ' ');
    text.append(1, '"').append(to_string(id)).append("\": ").append(schema).append(" }");
  };
  for (const ParameterInfo& p : parameters()) {
    if (p.id.bit >= 0 && p.id.number != last)
      add({p.id.number, -1},
          R"({ "description": "All bits of this number, as one number.", "$ref": "#/$defs/whole", "minimum": 0, "maximum": )" +
              std::to_string(free_bits(p.id.number)));
    last = p.id.number;
    std::string schema = description(p);
    schema += is_not_supported(p)            ? R"("enum": [0, "0", false])"
              : p.type == ParameterType::bit ? R"("enum": [0, 1, "0", "1", false, true])"
              : p.values.empty()             ? bounds(p)
                                             : enumeration(p.values);
    if (p.default_value) schema.append(R"(, "default": )").append(to_string(*p.default_value));
    add(p.id, schema);
  }
  return text;
}

std::string alarms_definition() {
  std::string text = R"(    "alarms": {
      "description": "Alarm numbers or names that this control shows, by cause, if they differ from those of its series.",
      "type": "object", "propertyNames": { "enum": [)";
  for (const AlarmInfo& alarm : alarms()) {
    if (alarm.cause != alarms().front().cause) text += ", ";
    text.append(1, '"').append(alarm.name).append(1, '"');
  }
  return text.append(kSchemaAlarmsTail);
}

}  // namespace

std::string_view setup_schema() {
  static const std::string schema = std::string(kSchemaHead) + alarms_definition() + std::string(kSchemaFanucHead) +
                                    key_properties(Control::fanuc, kSchemaFanucAxes) + std::string(kSchemaParameters) +
                                    parameter_properties() + std::string(kSchemaFanucTables) +
                                    key_properties(Control::heidenhain, kSchemaHeidenhainAxes) +
                                    std::string(kSchemaHeidenhainTables);
  return schema;
}

}  // namespace toolcomp::spec

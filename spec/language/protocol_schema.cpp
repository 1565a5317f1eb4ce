// SPDX-License-Identifier: Apache-2.0
#include "spec/language/case_format.h"

namespace toolcomp::spec {

std::string_view hello_schema() {
  return R"schema({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "$id": "hello.schema.json",
  "title": "Hello",
  "description": "The answer of a controller to {\"hello\":1}: its capabilities (docs/protocol.md).",
  "type": "object",
  "additionalProperties": false,
  "required": ["protocol", "sections", "fields"],
  "properties": {
    "name": { "type": "string" },
    "version": { "type": "string" },
    "protocol": { "const": 1 },
    "sections": { "description": "The manual sections that the controller implements.", "type": "array", "items": { "type": "string", "pattern": "^(fanuc|heidenhain)/[a-z-]+$" } },
    "fields": {
      "description": "The fields of events that the controller gives. Nothing is judged without kind, line, and one of point and axes.",
      "type": "array",
      "items": { "enum": [
        "kind", "line", "n", "type", "cause", "programmed", "point", "axes", "machine", "unknown", "tool_axis", "center", "plane", "direction",
        "sweep", "radius", "tool_center", "contact", "normal", "shift", "tool_shift", "carrier", "angle", "flat", "feed", "r", "bottom", "return",
        "number", "message", "name", "value", "t", "code", "clause", "permitted", "reason", "clauses"
      ] }
    },
    "resolution": {
      "description": "Least increments of the numbers. Default: double precision. A single number r means r mm, r degrees, r for unit vectors and r/10 inches.",
      "oneOf": [
        { "$ref": "#/$defs/increment" },
        {
          "type": "object", "additionalProperties": false,
          "properties": {
            "mm": { "$ref": "#/$defs/increment" }, "inch": { "$ref": "#/$defs/increment" },
            "degrees": { "$ref": "#/$defs/increment" }, "vectors": { "$ref": "#/$defs/increment" }
          }
        }
      ]
    },
    "rounding": { "description": "How the controller rounds to these increments. Default: any rounding passes.", "enum": ["nearest", "down", "toward zero"] },
    "setup": { "description": "The settings that the controller cannot change.", "$ref": "setup.schema.json" }
  },
  "$defs": { "increment": { "type": "string", "pattern": "^[0-9]*\\.?[0-9]+$" } }
}
)schema";
}

std::string_view answer_schema() {
  return R"schema({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "$id": "answer.schema.json",
  "title": "Answer",
  "description": "The answer of a controller to a case (docs/protocol.md).",
  "type": "object",
  "required": ["id"],
  "oneOf": [{ "$ref": "#/$defs/events" }, { "$ref": "#/$defs/not_applicable" }, { "$ref": "#/$defs/error" }],
  "$defs": {
    "events": {
      "type": "object", "additionalProperties": false, "required": ["id", "events"],
      "properties": {
        "id": { "type": "string" },
        "events": { "description": "The events of a run of the program, in order.", "type": "array", "items": { "$ref": "event.schema.json" } }
      }
    },
    "not_applicable": {
      "type": "object", "additionalProperties": false, "required": ["id", "not_applicable"],
      "properties": {
        "id": { "type": "string" },
        "not_applicable": { "description": "Why the case does not apply: what the control does not have.", "type": "string", "minLength": 1 },
        "known_difference": { "description": "Name of the difference, if the control does this otherwise by design.", "type": "string", "pattern": "^[a-z0-9][a-z0-9-]{0,63}$" }
      }
    },
    "error": {
      "type": "object", "additionalProperties": false, "required": ["id", "error"],
      "properties": {
        "id": { "type": "string" },
        "error": { "description": "Why the controller could not run the case. This counts as a finding.", "type": "string", "minLength": 1 }
      }
    }
  }
}
)schema";
}

}  // namespace toolcomp::spec

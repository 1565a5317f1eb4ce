// SPDX-License-Identifier: Apache-2.0
#include "spec/language/case_format.h"

namespace toolcomp::spec {

std::string_view hello_schema() {
  return R"schema({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "$id": "hello.schema.json",
  "title": "Hello",
  "description": "What a controller answers to {\"hello\":1}: what it is and what it gives (docs/protocol.md).",
  "type": "object",
  "additionalProperties": false,
  "required": ["protocol", "sections", "fields"],
  "properties": {
    "name": { "type": "string" },
    "version": { "type": "string" },
    "protocol": { "const": 1 },
    "sections": { "description": "The manual sections it has.", "type": "array", "items": { "type": "string", "pattern": "^(fanuc|heidenhain)/[a-z-]+$" } },
    "fields": {
      "description": "The fields of events it gives. With less than kind, line and one of point and axes, nothing is judged.",
      "type": "array",
      "items": { "enum": [
        "kind", "line", "n", "type", "cause", "programmed", "point", "axes", "machine", "unknown", "tool_axis", "center", "plane", "direction",
        "sweep", "radius", "tool_center", "contact", "normal", "shift", "tool_shift", "carrier", "angle", "flat", "feed", "r", "bottom", "return",
        "number", "message", "name", "value", "t", "code", "clause", "permitted", "reason", "clauses"
      ] }
    },
    "resolution": {
      "description": "Least increments of its numbers. Left out: double precision. One number r is r mm, r degrees, r of unit vectors and r/10 inches.",
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
    "rounding": { "description": "How it makes them. Left out: any way passes.", "enum": ["nearest", "down", "toward zero"] },
    "setup": { "description": "What it cannot change.", "$ref": "setup.schema.json" }
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
  "description": "What a controller answers to a case (docs/protocol.md).",
  "type": "object",
  "required": ["id"],
  "oneOf": [{ "$ref": "#/$defs/events" }, { "$ref": "#/$defs/not_applicable" }, { "$ref": "#/$defs/error" }],
  "$defs": {
    "events": {
      "type": "object", "additionalProperties": false, "required": ["id", "events"],
      "properties": {
        "id": { "type": "string" },
        "events": { "description": "What a run of the program yields, in order.", "type": "array", "items": { "$ref": "event.schema.json" } }
      }
    },
    "not_applicable": {
      "type": "object", "additionalProperties": false, "required": ["id", "not_applicable"],
      "properties": {
        "id": { "type": "string" },
        "not_applicable": { "description": "What the control does not have.", "type": "string", "minLength": 1 },
        "known_difference": { "description": "The name of what the control does otherwise by design, where that is why.", "type": "string", "pattern": "^[a-z0-9][a-z0-9-]{0,63}$" }
      }
    },
    "error": {
      "type": "object", "additionalProperties": false, "required": ["id", "error"],
      "properties": {
        "id": { "type": "string" },
        "error": { "description": "Why the case could not be run: a finding.", "type": "string", "minLength": 1 }
      }
    }
  }
}
)schema";
}

}  // namespace toolcomp::spec

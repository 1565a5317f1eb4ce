// SPDX-License-Identifier: Apache-2.0
#include "spec/language/case_format.h"

namespace toolcomp::spec {

std::string_view case_schema() {
  return R"schema({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "$id": "case.schema.json",
  "title": "Case",
  "description": "A program with its setup and the events that a run of it must yield. Golden vectors, findings and requests to controllers are cases.",
  "type": "object",
  "additionalProperties": false,
  "required": ["case", "setup", "program"],
  "properties": {
    "case": { "description": "Version of this format.", "const": 1 },
    "id": { "type": "string" },
    "section": { "description": "The manual section, such as fanuc/leading-edge-offset.", "type": "string" },
    "comment": { "type": "string" },
    "clauses": { "description": "Ids of the clauses that the case is about.", "type": "array", "items": { "type": "string" } },
    "flags": { "description": "What is special about the case.", "type": "array", "items": { "type": "string" } },
    "dialect": { "description": "Language of the program. It must be the language of setup.control: klartext for heidenhain. Default: that language.", "enum": ["fanuc", "klartext"] },
    "setup": { "$ref": "setup.schema.json" },
    "program": { "description": "Text of the program, with its line feeds.", "type": "string" },
    "samples": { "description": "Samples of each block under tool center point control, at t = 1/samples, 2/samples, …", "type": "integer", "minimum": 0, "maximum": 1000000, "default": 0 },
    "source": {
      "description": "The generator that made the case.",
      "type": "object", "additionalProperties": false,
      "properties": { "generator": { "type": "string" }, "version": { "type": "string" }, "seed": { "type": "string" } }
    },
    "expect": { "description": "The events, in order.", "type": "array", "items": { "$ref": "event.schema.json" } }
  }
}
)schema";
}

std::string_view event_schema() {
  return R"schema({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "$id": "event.schema.json",
  "title": "Event",
  "description": "One event of a run. Lengths are in the units of the setup, angles in degrees.",
  "type": "object",
  "required": ["kind", "line"],
  "oneOf": [
    { "$ref": "#/$defs/move" }, { "$ref": "#/$defs/sample" }, { "$ref": "#/$defs/alarm" },
    { "$ref": "#/$defs/setting" }, { "$ref": "#/$defs/undecided" },
    { "$ref": "#/$defs/beyond" }, { "$ref": "#/$defs/hole" }
  ],
  "$defs": {
    "move": {
      "type": "object", "additionalProperties": false,
      "required": ["kind", "line", "type", "cause"],
      "dependentRequired": {
        "center": ["plane", "direction"], "plane": ["center"], "direction": ["center"], "sweep": ["center"], "radius": ["center"],
        "tool_center": ["shift", "tool_shift"], "shift": ["tool_center"], "tool_shift": ["tool_center"], "carrier": ["tool_center"],
        "contact": ["tool_center", "normal"], "normal": ["contact"], "angle": ["contact"], "flat": ["contact"]
      },
      "properties": {
        "kind": { "const": "move" },
        "line": { "$ref": "#/$defs/count" },
        "n": { "$ref": "#/$defs/count" },
        "type": { "enum": ["rapid", "linear", "arc"] },
        "cause": { "enum": ["programmed", "start-up", "corner", "cancel", "pre-turn", "post-turn", "reference", "measure"] },
        "programmed": { "description": "The programmed end point, absolute, in workpiece coordinates.", "$ref": "#/$defs/axis_values" },
        "point": { "description": "The compensated tool point, before length offset.", "$ref": "#/$defs/axis_values" },
        "axes": { "description": "Positions that the axes are sent to, in workpiece coordinates.", "$ref": "#/$defs/axis_values" },
        "machine": { "description": "The positions of axes, in machine coordinates.", "$ref": "#/$defs/axis_values" },
        "tool_axis": { "description": "Unit vector from the tip to the holder.", "$ref": "#/$defs/vector" },
        "center": { "$ref": "#/$defs/axis_values" },
        "plane": { "enum": ["XY", "ZX", "YZ"] },
        "direction": { "enum": ["cw", "ccw"] },
        "sweep": { "description": "Angle of the arc that the tool runs: above 0, at most 360.", "$ref": "#/$defs/number" },
        "radius": { "description": "Radius at the start and at the end, if they differ.", "type": "array", "items": { "$ref": "#/$defs/number" }, "minItems": 2, "maxItems": 2 },
        "tool_center": { "description": "Heidenhain: centre of the effective tool.", "$ref": "#/$defs/vector_by_letter" },
        "contact": { "description": "Blocks with a surface normal: the point at which the tool touches the workpiece.", "$ref": "#/$defs/vector_by_letter" },
        "normal": { "description": "Unit vector of the surface normal, from the workpiece into the tool.", "$ref": "#/$defs/vector" },
        "shift": { "description": "Heidenhain: tip of the effective tool less tip of the nominal tool.", "$ref": "#/$defs/vector_by_letter" },
        "tool_shift": { "description": "Heidenhain: shift of the real tool against a tool without deltas.", "$ref": "#/$defs/vector_by_letter" },
        "carrier": { "description": "Heidenhain: tool carrier reference point, if the tool table gives the overall length.", "$ref": "#/$defs/vector_by_letter" },
        "angle": { "description": "Angle between normal and tool, for tools with a table of deviations.", "$ref": "#/$defs/number" },
        "flat": { "description": "The normal is along the tool.", "type": "boolean", "default": false },
        "unknown": { "description": "Heidenhain: axes whose positions are unknown. No other field has them.", "type": "array", "items": { "type": "string", "pattern": "^[XYZ]$" } },
        "feed": { "$ref": "#/$defs/number" },
        "clauses": { "$ref": "#/$defs/clauses" }
      }
    },
    "hole": {
      "description": "A hole of a canned cycle. All fields except axes are before length offset. r, bottom and return are coordinates along the drilling axis.",
      "type": "object", "additionalProperties": false,
      "required": ["kind", "line", "point", "r", "bottom", "return", "axes"],
      "properties": {
        "kind": { "const": "hole" },
        "line": { "$ref": "#/$defs/count" },
        "n": { "$ref": "#/$defs/count" },
        "point": { "description": "The linear axes, without the drilling axis.", "$ref": "#/$defs/axis_values" },
        "r": { "description": "Point R.", "$ref": "#/$defs/number" },
        "bottom": { "$ref": "#/$defs/number" },
        "return": { "description": "The level to which the tool returns.", "$ref": "#/$defs/number" },
        "axes": { "description": "Positions of the axes after the hole.", "$ref": "#/$defs/axis_values" },
        "clauses": { "$ref": "#/$defs/clauses" }
      }
    },
    "sample": {
      "type": "object", "additionalProperties": false,
      "required": ["kind", "line", "t"],
      "properties": {
        "kind": { "const": "sample" },
        "line": { "$ref": "#/$defs/count" },
        "n": { "$ref": "#/$defs/count" },
        "t": { "description": "Fraction of the move, 0 at its start and 1 at its end.", "type": "string", "pattern": "^[0-9]+/[1-9][0-9]*$" },
        "point": { "$ref": "#/$defs/axis_values" },
        "axes": { "$ref": "#/$defs/axis_values" },
        "machine": { "$ref": "#/$defs/axis_values" },
        "tool_axis": { "$ref": "#/$defs/vector" },
        "clauses": { "$ref": "#/$defs/clauses" }
      }
    },
    "alarm": {
      "type": "object", "additionalProperties": false,
      "required": ["kind", "number", "line"],
      "properties": {
        "kind": { "enum": ["alarm", "warning"] },
        "number": { "description": "The number or name that the control shows, such as PS0041.", "type": "string", "maxLength": 63 },
        "cause": { "description": "Cause of an alarm, the same for all series (toolcomp spec alarms lists them). If it is given, it is judged instead of the number.", "type": "string" },
        "line": { "$ref": "#/$defs/count" },
        "n": { "$ref": "#/$defs/count" },
        "message": { "type": "string" },
        "clauses": { "$ref": "#/$defs/clauses" }
      }
    },
    "setting": {
      "type": "object", "additionalProperties": false,
      "required": ["kind", "name", "value", "line"],
      "properties": {
        "kind": { "const": "setting" },
        "name": { "description": "The value that was set, such as H1 or H1.wear.", "type": "string", "maxLength": 63 },
        "value": { "$ref": "#/$defs/number" },
        "line": { "$ref": "#/$defs/count" },
        "n": { "$ref": "#/$defs/count" },
        "clauses": { "$ref": "#/$defs/clauses" }
      }
    },
    "undecided": {
      "type": "object", "additionalProperties": false,
      "required": ["kind", "line", "clause"],
      "properties": {
        "kind": { "const": "undecided" },
        "line": { "$ref": "#/$defs/count" },
        "n": { "$ref": "#/$defs/count" },
        "clause": { "type": "string", "maxLength": 63 },
        "permitted": { "type": "array", "items": { "enum": ["positive", "negative", "tie"] } },
        "reason": { "description": "The model does not cover what the program asks for. The run goes on.", "const": "OUT_OF_SCOPE" },
        "clauses": { "$ref": "#/$defs/clauses" }
      }
    },
    "beyond": {
      "description": "The run ends here, without an alarm of the control. not_supported: a control may run this word, and toolcomp does not. not_judged: toolcomp cannot compute positions from here on.",
      "type": "object", "additionalProperties": false,
      "required": ["kind", "line", "code"],
      "properties": {
        "kind": { "enum": ["not_supported", "not_judged"] },
        "line": { "$ref": "#/$defs/count" },
        "n": { "$ref": "#/$defs/count" },
        "code": { "description": "The word of the program, such as G81 or PLANE SPATIAL.", "type": "string", "maxLength": 63 },
        "message": { "type": "string" },
        "clauses": { "$ref": "#/$defs/clauses" }
      }
    },
    "count": { "type": "integer", "minimum": 0 },
    "clauses": { "type": "array", "items": { "type": "string" } },
    "number": {
      "oneOf": [
        { "type": "number" },
        { "$ref": "#/$defs/digits" },
        {
          "description": "The exact result lies in [v - r, v + r]. q is the result itself, if it is rational.",
          "type": "object", "additionalProperties": false, "required": ["v"],
          "properties": {
            "v": { "oneOf": [{ "type": "number" }, { "$ref": "#/$defs/digits" }] },
            "r": { "oneOf": [{ "type": "number", "minimum": 0 }, { "$ref": "#/$defs/digits" }] },
            "q": { "type": "string", "pattern": "^-?[0-9]+(/0*[1-9][0-9]*)?$" }
          }
        }
      ]
    },
    "digits": { "type": "string", "pattern": "^[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)?$" },
    "axis_values": {
      "description": "Values by axis letter.",
      "type": "object", "additionalProperties": false,
      "patternProperties": { "^[ABCUVWXYZ]$": { "$ref": "#/$defs/number" } }
    },
    "vector_by_letter": {
      "type": "object", "additionalProperties": false, "required": ["X", "Y", "Z"],
      "properties": { "X": { "$ref": "#/$defs/number" }, "Y": { "$ref": "#/$defs/number" }, "Z": { "$ref": "#/$defs/number" } }
    },
    "vector": { "type": "array", "items": { "$ref": "#/$defs/number" }, "minItems": 3, "maxItems": 3 }
  }
}
)schema";
}

}  // namespace toolcomp::spec

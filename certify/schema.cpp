// SPDX-License-Identifier: Apache-2.0
#include "certify/schema.h"

namespace toolcomp::certify {

std::string_view finding_schema() {
  return R"schema({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "$id": "finding.schema.json",
  "title": "Finding",
  "description": "The smallest case found that shows a difference, with all that is needed to judge it again (docs/mismatch.md).",
  "type": "object",
  "additionalProperties": false,
  "required": ["finding", "case"],
  "properties": {
    "finding": { "const": 1 },
    "kind": { "description": "What differs: \"coordinate\", \"missing event\", \"hang\", …", "$ref": "#/$defs/text" },
    "clause": { "description": "The clause to which the difference is attributed.", "$ref": "#/$defs/text" },
    "known": { "description": "How well that clause is known.", "enum": ["manual", "sister", "recollection", "ours", null] },
    "source": { "description": "How well that clause is known, with document and page.", "$ref": "#/$defs/text" },
    "judged": { "description": "Only events that rest on clauses of these kinds were judged (certify --known). Null: all events were judged.", "type": ["array", "null"], "minItems": 1, "items": { "enum": ["manual", "sister", "recollection", "ours"] } },
    "line": { "description": "The program line at which the two sides first differ.", "$ref": "#/$defs/count" },
    "field": { "description": "The field that differs, such as \"point.X\".", "$ref": "#/$defs/text" },
    "expected": { "$ref": "#/$defs/text" },
    "actual": { "$ref": "#/$defs/text" },
    "deviation_um": { "$ref": "#/$defs/number" },
    "status": { "description": "How the controller's process ended.", "$ref": "#/$defs/text" },
    "errors": { "description": "The last lines of the standard error of that process.", "$ref": "#/$defs/text" },
    "alone": { "description": "Which of model, engine and formal specification differs from the other two.", "$ref": "#/$defs/text" },
    "controller": { "description": "The command of the controller. toolcomp runs it only after the user agrees.", "$ref": "#/$defs/text" },
    "directory": { "description": "The folder in which the command was run.", "$ref": "#/$defs/text" },
    "capabilities": { "description": "The answer of the controller to hello.", "type": ["object", "null"], "required": ["protocol"] },
    "seed": { "$ref": "#/$defs/text" },
    "target": { "description": "The fuzz target, if a campaign found the difference.", "$ref": "#/$defs/text" },
    "executions": { "$ref": "#/$defs/count" },
    "seconds": { "$ref": "#/$defs/number" },
    "tool": { "description": "Name and version of the program that found the difference.", "$ref": "#/$defs/text" },
    "first_case": { "description": "The case from which this case was shrunk.", "$ref": "#/$defs/text" },
    "occurrences": { "description": "Number of cases with the same kind and clause.", "$ref": "#/$defs/count" },
    "seen": { "description": "Number of attempts in which the difference came again.", "$ref": "#/$defs/count" },
    "tried": { "description": "Number of attempts to reproduce the difference.", "$ref": "#/$defs/count" },
    "not_settled": { "description": "Why the difference was neither tried again nor shrunk.", "$ref": "#/$defs/text" },
    "before": { "description": "Requests that the same process must get before this case.", "type": ["array", "null"], "items": { "$ref": "case.schema.json" } },
    "case": { "$ref": "case.schema.json" }
  },
  "$defs": {
    "text": { "type": ["string", "null"] },
    "number": { "type": ["number", "null"] },
    "count": { "type": ["integer", "null"], "minimum": 0, "maximum": 1000000000000 }
  }
}
)schema";
}

std::string_view manifest_schema() {
  return R"schema({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "$id": "manifest.schema.json",
  "title": "Manifest",
  "description": "manifest.json of a bundle of evidence: its files, and the command that made the certificate (docs/evidence.md).",
  "type": "object",
  "additionalProperties": false,
  "required": ["evidence", "tool", "made", "command", "directory", "sections", "adapter", "interrupted", "cases", "inputs", "files"],
  "properties": {
    "evidence": { "description": "Version of this format.", "const": 1 },
    "tool": { "description": "Name and version of the tool.", "type": "string" },
    "made": { "description": "Date and time in UTC.", "type": "string" },
    "command": { "description": "The command line, one word each.", "$ref": "#/$defs/texts" },
    "directory": { "description": "The folder in which the command was run.", "type": "string" },
    "sections": { "description": "The sections that the user asked for. Empty: all sections.", "$ref": "#/$defs/texts" },
    "adapter": { "description": "Name of the adapter. Empty: the controller is a command.", "type": "string" },
    "interrupted": { "description": "Why not all cases were run. Empty: all were run.", "type": "string" },
    "cases": { "description": "Number of lines of cases.jsonl.", "$ref": "#/$defs/count" },
    "inputs": {
      "description": "Programs, cases and setups that the user gave.",
      "type": "array",
      "items": {
        "type": "object", "additionalProperties": false, "required": ["given", "file"],
        "properties": { "given": { "type": "string" }, "file": { "type": "string" } }
      }
    },
    "files": {
      "description": "All files except the manifest itself.",
      "type": "array",
      "items": {
        "type": "object", "additionalProperties": false, "required": ["file", "size", "sha256"],
        "properties": { "file": { "type": "string" }, "size": { "$ref": "#/$defs/count" }, "sha256": { "type": "string" } }
      }
    }
  },
  "$defs": {
    "texts": { "type": "array", "items": { "type": "string" } },
    "count": { "type": "integer", "minimum": 0, "maximum": 1000000000000 }
  }
}
)schema";
}

}  // namespace toolcomp::certify

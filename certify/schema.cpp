// SPDX-License-Identifier: Apache-2.0
#include "certify/schema.h"

namespace toolcomp::certify {

std::string_view finding_schema() {
  return R"schema({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "$id": "finding.schema.json",
  "title": "Finding",
  "description": "The smallest case that shows a difference, with what is needed to judge it again (docs/mismatch.md).",
  "type": "object",
  "additionalProperties": false,
  "required": ["finding", "case"],
  "properties": {
    "finding": { "const": 1 },
    "kind": { "description": "What differs: \"coordinate\", \"missing event\", \"hang\", …", "$ref": "#/$defs/text" },
    "clause": { "description": "The clause of the rule that it is laid to.", "$ref": "#/$defs/text" },
    "known": { "description": "How well that clause is known.", "enum": ["manual", "sister", "recollection", "ours", null] },
    "source": { "description": "The same with document and page.", "$ref": "#/$defs/text" },
    "judged": { "description": "Only what rests on clauses known so well was judged (certify --known); none: all.", "type": ["array", "null"], "minItems": 1, "items": { "enum": ["manual", "sister", "recollection", "ours"] } },
    "line": { "description": "Of the program, where they part.", "$ref": "#/$defs/count" },
    "field": { "description": "\"point.X\"", "$ref": "#/$defs/text" },
    "expected": { "$ref": "#/$defs/text" },
    "actual": { "$ref": "#/$defs/text" },
    "deviation_um": { "$ref": "#/$defs/number" },
    "status": { "description": "How the controller's process ended.", "$ref": "#/$defs/text" },
    "errors": { "description": "The last of its standard error.", "$ref": "#/$defs/text" },
    "alone": { "description": "Who stands alone among model, engine and formal specification.", "$ref": "#/$defs/text" },
    "controller": { "description": "The command. Nothing runs it unasked.", "$ref": "#/$defs/text" },
    "directory": { "description": "Where it was run.", "$ref": "#/$defs/text" },
    "capabilities": { "description": "What the controller answered to hello.", "type": ["object", "null"], "required": ["protocol"] },
    "seed": { "$ref": "#/$defs/text" },
    "target": { "description": "Of a campaign: which of its targets.", "$ref": "#/$defs/text" },
    "executions": { "$ref": "#/$defs/count" },
    "seconds": { "$ref": "#/$defs/number" },
    "tool": { "description": "Name and version of what found it.", "$ref": "#/$defs/text" },
    "first_case": { "description": "The case it was shrunk from.", "$ref": "#/$defs/text" },
    "occurrences": { "description": "Cases with the same kind and clause.", "$ref": "#/$defs/count" },
    "seen": { "description": "It came so many times", "$ref": "#/$defs/count" },
    "tried": { "description": "of so many.", "$ref": "#/$defs/count" },
    "not_settled": { "description": "Why it was neither tried again nor shrunk.", "$ref": "#/$defs/text" },
    "before": { "description": "What the same process has to be asked before.", "type": ["array", "null"], "items": { "$ref": "case.schema.json" } },
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
  "description": "manifest.json of a bundle of evidence: what is in it, and how the certificate was asked for (docs/evidence.md).",
  "type": "object",
  "additionalProperties": false,
  "required": ["evidence", "tool", "made", "command", "directory", "sections", "adapter", "interrupted", "cases", "inputs", "files"],
  "properties": {
    "evidence": { "description": "The format.", "const": 1 },
    "tool": { "description": "Name and version.", "type": "string" },
    "made": { "description": "UTC.", "type": "string" },
    "command": { "description": "The words of the command line.", "$ref": "#/$defs/texts" },
    "directory": { "description": "Where it was given.", "type": "string" },
    "sections": { "description": "Asked for; none: all.", "$ref": "#/$defs/texts" },
    "adapter": { "description": "Its name; empty: the controller is a command.", "type": "string" },
    "interrupted": { "description": "Why not all was run; empty: all was.", "type": "string" },
    "cases": { "description": "Lines of cases.jsonl.", "$ref": "#/$defs/count" },
    "inputs": {
      "description": "Programs, cases and setups as they were given.",
      "type": "array",
      "items": {
        "type": "object", "additionalProperties": false, "required": ["given", "file"],
        "properties": { "given": { "type": "string" }, "file": { "type": "string" } }
      }
    },
    "files": {
      "description": "All but the manifest itself.",
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

// SPDX-License-Identifier: Apache-2.0
// Cases as JSON (corpus/schema/case.schema.json), read and written in a stable form, and the answers of controllers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "spec/language/case.h"
#include "spec/language/fields.h"

namespace toolcomp::spec {

// Throws InputError, with the position of the fault, for anything that is not a case: unknown fields, missing ones,
// wrong types, numbers that are none. The `message` of an event is for people and is not kept. `file` is for messages.
Case read_case(std::string_view text, const std::string& file);

// The case as the reader reads it back, keys in the order that golden vectors have: a line for every key and every
// event …
std::string write_case(const Case& c);
// … or all in one line without a line feed.
std::string write_case_line(const Case& c);

// What a controller answers to a case (docs/protocol.md).
struct Reply {
  std::string id;
  std::vector<TextEvent> events;
  std::vector<FieldSet> fields;  // of each event: which fields the answer gives
  std::string not_applicable;    // instead of events: what the controller does not have; empty: it has
  std::string known_difference;  // with not_applicable: the name of what it does otherwise by design; empty: none
  std::string error;             // instead of events: why it could not run the case; empty: it could
};

// Reads such an answer, one line. Unknown fields are ignored; `id`, one of `events`, `not_applicable` and `error`, and
// in each event `kind` and `line` must be there; with `error`, the id of what cannot be read may be missing. Throws
// InputError that says what is malformed. `file` is for messages.
Reply read_reply(std::string_view line, const Axes& axes, const std::string& file);

// JSON Schemas (draft 2020-12) of cases, events and what controllers answer: corpus/schema.
std::string_view case_schema();
std::string_view event_schema();
std::string_view hello_schema();
std::string_view answer_schema();

}  // namespace toolcomp::spec

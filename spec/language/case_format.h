// SPDX-License-Identifier: Apache-2.0
// Reads and writes cases as JSON in a stable form (corpus/schema/case.schema.json), and reads the answers of
// controllers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "spec/language/case.h"
#include "spec/language/fields.h"

namespace toolcomp::spec {

// Throws InputError, with the position of the fault, for anything that is not a case: unknown fields, missing fields,
// wrong types, malformed numbers. The `message` of an event is for people and is not kept. `file` is for messages.
Case read_case(std::string_view text, const std::string& file);

// The case as text that the reader reads back, with keys in the order of golden vectors: one line for each key and each
// event …
std::string write_case(const Case& c);
// … or everything in one line, without a line feed.
std::string write_case_line(const Case& c);

// The answer of a controller to a case (docs/protocol.md).
struct Reply {
  std::string id;
  std::vector<TextEvent> events;
  std::vector<FieldSet> fields;  // for each event, the fields that the answer gives
  std::string not_applicable;    // instead of events: what the controller does not have; otherwise empty
  std::string known_difference;  // with not_applicable: the name of what it does otherwise by design; otherwise empty
  std::string error;             // instead of events: why it could not run the case; otherwise empty
};

// Reads such an answer, one line. Unknown fields are ignored. `id`, one of `events`, `not_applicable` and `error`, and
// in each event `kind` and `line` are required. With `error` the id may be missing, because the request may have been
// unreadable. Throws InputError that says what is malformed. `file` is for messages.
Reply read_reply(std::string_view line, const Axes& axes, const std::string& file);

// JSON Schemas (draft 2020-12) of cases, events and the answers of controllers: corpus/schema.
std::string_view case_schema();
std::string_view event_schema();
std::string_view hello_schema();
std::string_view answer_schema();

}  // namespace toolcomp::spec

// Cases as JSON (contract, "Case"): read, and written in a stable form.
#pragma once

#include <string>
#include <string_view>

#include "spec/language/case.h"

namespace toolcomp::spec {

// Throws InputError, with the position of the fault, for anything that is not a case: unknown fields, missing ones,
// wrong types, numbers that are none. The `message` of an event is for people and is not kept. `file` is for messages.
Case read_case(std::string_view text, const std::string& file);

// The case as the reader reads it back, keys in the order of the contract: a line for every key and every event …
std::string write_case(const Case& c);
// … or all in one line without a line feed.
std::string write_case_line(const Case& c);

// JSON Schemas (draft 2020-12) of cases and of events: corpus/schema.
std::string_view case_schema();
std::string_view event_schema();

}  // namespace toolcomp::spec

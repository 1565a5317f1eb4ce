// SPDX-License-Identifier: Apache-2.0
// Reads and writes setups as text: TOML files, the JSON inside cases, their schema, and an example.
#pragma once

#include <string>
#include <string_view>

#include "spec/language/setup.h"

namespace toolcomp::spec {

// Both read the same keys with the same meaning (corpus/schema/setup.schema.json) and throw InputError, with the
// position of the fault, for anything else: unknown keys, wrong types, numbers with an exponent or more than
// Decimal::kMaxDigits digits. Keys that are not given keep the defaults of Setup. `file` is for messages.
Setup read_setup_toml(std::string_view text, const std::string& file);
Setup read_setup_json(std::string_view text, const std::string& file);

// The setup as text that the reader of the same format reads back to an equal setup. Equal setups give equal text. JSON
// is one line without a line feed.
std::string write_setup_toml(const Setup& setup);
std::string write_setup_json(const Setup& setup);

// JSON Schema (draft 2020-12) of setups: corpus/schema/setup.schema.json.
std::string_view setup_schema();
// A commented TOML setup of this control, which reads without error.
std::string_view setup_example(Control control);

}  // namespace toolcomp::spec

// SPDX-License-Identifier: Apache-2.0
// JSON that strangers wrote, as a tree of the library.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "spec/language/document.h"

namespace toolcomp::spec {

// Read within the bounds of document.h (depth, values, names given once, UTF-8), so that no tree of the library is too
// deep to be freed or too large to be held. Throws InputError with the place of the fault, also for a number that no
// double holds.
nlohmann::json read_outside_json(std::string_view text, const std::string& file);

// The same of a value that was read.
nlohmann::json tree_of(const document::Node& node, const document::Reader& read);

}  // namespace toolcomp::spec

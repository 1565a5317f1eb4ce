// SPDX-License-Identifier: Apache-2.0
// Reads JSON from outside into a tree of the JSON library.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "spec/language/document.h"

namespace toolcomp::spec {

// Reads within the limits of document.h (depth, number of values, names given once, UTF-8), so that no tree is too deep
// to be freed or too large for the memory. Throws InputError with the place of the fault, also for a number outside the
// range of a double.
nlohmann::json read_outside_json(std::string_view text, const std::string& file);

// The same for a value that was read already.
nlohmann::json tree_of(const document::Node& node, const document::Reader& read);

}  // namespace toolcomp::spec

// SPDX-License-Identifier: Apache-2.0
// JSON that strangers wrote, as a tree of the library.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace toolcomp::spec {

// Read first within the bounds of document.h (depth, values, names given once, UTF-8), so that no tree of the library
// is too deep to be freed or too large to be held. Throws InputError with the place of the fault.
nlohmann::json read_outside_json(std::string_view text, const std::string& file);

}  // namespace toolcomp::spec

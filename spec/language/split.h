// SPDX-License-Identifier: Apache-2.0
// Lists written with a separator.
#pragma once

#include <string_view>
#include <vector>

namespace toolcomp::spec {

// "a|b" at '|': a, b. Nothing in nothing, and nothing behind a separator at the end.
std::vector<std::string_view> split(std::string_view list, char separator);

}  // namespace toolcomp::spec

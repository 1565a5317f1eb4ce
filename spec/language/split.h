// SPDX-License-Identifier: Apache-2.0
// Lists written with a separator.
#pragma once

#include <string_view>
#include <vector>

namespace toolcomp::spec {

// Splits "a|b" at '|' into a and b. An empty text has no items, and there is no item after a separator at the end.
std::vector<std::string_view> split(std::string_view list, char separator);

}  // namespace toolcomp::spec

// SPDX-License-Identifier: Apache-2.0
// The distance of two texts, for messages that suggest the nearest known name.
#pragma once

#include <cstddef>
#include <string_view>

namespace toolcomp::spec {

// The number of characters that are inserted, left out, replaced, or exchanged with their neighbour.
std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace toolcomp::spec

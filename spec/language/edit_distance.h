// SPDX-License-Identifier: Apache-2.0
// How far two texts are apart, for messages that name the nearest known one.
#pragma once

#include <cstddef>
#include <string_view>

namespace toolcomp::spec {

// The number of characters put in, left out, replaced or exchanged with their neighbour.
std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace toolcomp::spec

// SPDX-License-Identifier: Apache-2.0
// Whole-number arithmetic for the makers of long programs. It gives the same bytes on every compiler.
#pragma once

#include <cstdint>
#include <string>

namespace toolcomp::corpus {

__extension__ typedef __int128 Wide;  // NOLINT(modernize-use-using): the attribute needs a typedef

// n / d to the nearest whole number, d > 0.
std::int64_t nearest(Wide n, Wide d);

// `count` of 10^-places as a decimal with a point and no zeros at its end: "12.5", "-3.".
std::string decimal(std::int64_t count, int places);

}  // namespace toolcomp::corpus
